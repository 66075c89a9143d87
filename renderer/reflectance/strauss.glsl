// Evaluates Strauss' reflectivity curves F and G of the angle x = theta/(pi/2) and y = 1 - x: F rises from 0
// to 1 with x, G with y. His constants are kf = 1.12 and kg = 1.01; differences of squares are avoided.
real strauss_fresnel(real x) {
  real kf = real(1.12);
  real ratio = (kf - 1) / (kf - x);
  return x * (2 * kf - x) / (2 * kf - 1) * (ratio * ratio);
}
real strauss_shadowing(real y) {
  real kg = real(1.01);
  real ratio = kg / (kg - 1 + y);
  return y * (2 * (kg - 1) + y) / (2 * kg - 1) * (ratio * ratio);
}

// Returns a direction's angle from the normal and its elevation, in right angles. Each is accurate where it
// is small.
real strauss_angle(vec3 w) { return atan2(sqrt(w.x * w.x + w.y * w.y), w.z) * (2 / PI); }
real strauss_elevation(vec3 w) { return atan2(w.z, sqrt(w.x * w.x + w.y * w.y)) * (2 / PI); }

real strauss_exponent(real s) { return 1 - s > real(3e-5f) ? 3 / (1 - s) : real(1e5f); }

// Returns the lobe's reflectivity in RGB: a metal has the colour C = kd/max(kd) unless light grazes. Specular
// is s^3, so that with the diffuse 1 - s^3 they sum to 1.
vec3 strauss_reflectivity(vec3 u, vec3 v, real s, real m, vec3 kd) {
  real f = strauss_fresnel(strauss_angle(v));
  real j = f * strauss_shadowing(strauss_elevation(v)) * strauss_shadowing(strauss_elevation(u));
  real rn = s * s * s;
  real rj = min(real(1), rn + (rn + real(0.1)) * j);
  real brightest = max(kd.x, max(kd.y, kd.z));
  vec3 colour = brightest > 0 ? kd / brightest : vec3(1);
  return (vec3(1 - m + m * f) + colour * (m * (1 - f))) * rj;
}

// Returns the factor of kd in the albedo of the diffuse part.
real strauss_diffuse(real s, real m) { return (1 - m * s) * (1 - s) * (1 + s + s * s); }

// The lobe is normalised by (e + 2)/(2 pi). Strauss' own is not, and vanishes as s approaches 1, where his
// text has a mirror; his diffuse term is a ratio of radiances that includes the light's cosine.
vec3 strauss(vec3 u, vec3 v, real s, real m, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  real e = strauss_exponent(s);
  real lobe = (e + 2) / (2 * PI) * mirror_power(u, v, e);
  return bounded(kd * (strauss_diffuse(s, m) / PI) + ks * strauss_reflectivity(u, v, s, m, kd) * lobe);
}
