// (n2 . h)^n with n2 = (sin(tilt), 0, cos(tilt)) and h along u + v, from the tangent, as half_power.
real tilted_power(vec3 u, vec3 v, real n, real tilt) {
  vec3 h = u + v;
  real x = h.x * cos(tilt) - h.z * sin(tilt);
  real z = h.x * sin(tilt) + h.z * cos(tilt);
  return z > 0 ? exp(-n / 2 * log1p((x * x + h.y * h.y) / (z * z))) : real(0);
}

// 1 - (1 - c)^5
real below_schlick(real c) { return c * (5 + c * (-10 + c * (10 + c * (-5 + c)))); }

// |sqrt(r) + exp(i 2 pi order) sqrt(t)|^2, as a sum that cannot cancel. Fringes of an order over 20 fade, and
// are averaged from 100 on: three wavelengths cannot show them, and a float has no phase left.
real two_beams(real r, real t, real order) {
  real a = sqrt(r);
  real b = sqrt(t);
  real place = order - floor(order) - real(0.5);
  real s = sin(PI * place);
  real fringes = (a - b) * (a - b) + 4 * a * b * s * s;
  real seen = min(real(1), max(real(0), (100 - order) / 80));
  return seen * fringes + (1 - seen) * (r + t);
}

// One channel. `outer` is the outer lobe, d is in wavelengths, below_one = 1 - u.h and hz = n.h.
real film(vec3 u, vec3 v, real below_one, real hz, real outer, real nreal, real d, real m, real tilt, real ks,
          real kt) {
  real f0 = (nreal - 1) / (nreal + 1);
  f0 *= f0;
  real entering = 4 * nreal / ((nreal + 1) * (nreal + 1));
  real transmitted = entering * entering * below_schlick(u.z) * below_schlick(v.z);
  real inner = half_power_scale(m) * tilted_power(refracted(u, nreal), refracted(v, nreal), m, tilt);
  real reflected = ks * schlick_fresnel(f0, below_one) * outer;
  return two_beams(reflected, kt * transmitted * inner / (nreal * nreal), 2 * nreal * d * hz);
}

vec3 granier(vec3 u, vec3 v, vec3 nreal, real d, real n, real m, real tilt, vec3 ks, vec3 kt, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  real c = cosine_at_half(u, v);
  vec3 e = u - v;
  real below_one = (e.x * e.x + e.y * e.y + e.z * e.z) / (4 * (1 + c));
  real hz = min(real(1), (u.z + v.z) / (2 * c));
  real outer = half_power_scale(n) * half_power(u, v, n);
  return bounded(kd / PI + vec3(film(u, v, below_one, hz, outer, nreal.x, d / 645, m, tilt, ks.x, kt.x),
                                film(u, v, below_one, hz, outer, nreal.y, d / 525, m, tilt, ks.y, kt.y),
                                film(u, v, below_one, hz, outer, nreal.z, d / 445, m, tilt, ks.z, kt.z)));
}
