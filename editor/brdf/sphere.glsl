// Shades a sphere under a light and a sky, in the common subset of GLSL and C++: see sphere_shading.h. World
// frame: x to the right, y up, z to the eye, which is far away. `brdf_value` and `brdf_specular` are the
// BRDF's.

// A dim studio environment: brighter from above, with a soft window at the upper left.
vec3 sky_radiance(vec3 d) {
  real up = real(0.5f) + real(0.5f) * d.y;
  real window = exp(real(30.0f) * ((-d.x * real(0.55f) + d.y * real(0.65f) + d.z * real(0.524f)) - real(1.0f)));
  vec3 ground = vec3(real(0.10f), real(0.10f), real(0.11f));
  vec3 above = vec3(real(0.42f), real(0.47f), real(0.55f));
  return ground * (1 - up) + above * up + vec3(real(2.5f)) * window;
}

// The tangent goes around the vertical axis.
vec3 sphere_tangent(vec3 n) {
  real length2 = n.x * n.x + n.z * n.z;
  return length2 > 0 ? vec3(n.z, real(0), -n.x) / sqrt(length2) : vec3(real(1), real(0), real(0));
}
vec3 sphere_bitangent(vec3 n) {
  vec3 t = sphere_tangent(n);
  return vec3(n.y * t.z - n.z * t.y, n.z * t.x - n.x * t.z, n.x * t.y - n.y * t.x);
}
real along(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
vec3 to_local(vec3 n, vec3 d) { return vec3(along(d, sphere_tangent(n)), along(d, sphere_bitangent(n)), along(d, n)); }
vec3 to_world(vec3 n, vec3 d) { return sphere_tangent(n) * d.x + sphere_bitangent(n) * d.y + n * d.z; }

// Directions are sampled about the normal by cosine, and about the specular direction from three lobes, wide
// to narrow, in turn, so that both diffuse and glossy BRDFs are sampled well. The pdf is that of the mixture
// of all four.
real lobe_exponent(int lobe) { return lobe == 1 ? real(8.0f) : lobe == 2 ? real(150.0f) : real(4000.0f); }
real lobe_pdf(real cosine, real n) {
  return cosine > 0 ? (n + 1) / (2 * PI) * exp(n * log(max(cosine, real(1e-6f)))) : real(0);
}
real drawn_pdf(vec3 u, vec3 v) {
  real cosine = v.z * u.z - v.x * u.x - v.y * u.y;
  real sum = max(v.z, real(0)) / PI;
  for (int lobe = 1; lobe < 4; ++lobe) sum += lobe_pdf(cosine, lobe_exponent(lobe));
  return sum / 4;
}
real part_above_floor(real x) { return x - floor(x); }
// The i-th point of the R2 sequence, which fills the plane evenly, as cosine and azimuth about an axis.
vec3 drawn_about(vec3 axis, real n, int i) {
  real a = part_above_floor(real(0.5f) + real(0.7548776662f) * real(i));
  real b = 2 * PI * part_above_floor(real(0.5f) + real(0.5698402910f) * real(i));
  real cosine = exp(log(max(1 - a, real(1e-6f))) / (n + 1));
  real sine = sqrt(max(real(0), 1 - cosine * cosine));
  real s = axis.z < 0 ? real(-1) : real(1);
  real p = -1 / (s + axis.z);
  real q = axis.x * axis.y * p;
  vec3 x = vec3(1 + s * axis.x * axis.x * p, s * q, -s * axis.x);
  vec3 y = vec3(q, s + axis.y * axis.y * p, -axis.y);
  return x * (sine * cos(b)) + y * (sine * sin(b)) + axis * cosine;
}
vec3 drawn_direction(vec3 u, int i) {
  int lobe = i - i / 4 * 4;
  // A cosine lobe of exponent 1 about the normal.
  if (lobe == 0) return drawn_about(vec3(real(0), real(0), real(1)), real(1), i / 4);
  return drawn_about(vec3(-u.x, -u.y, u.z), lobe_exponent(lobe), i / 4);
}

// The radiance due to a light of irradiance `strength` from direction `light`, and the specular reflection of
// the sky.
vec3 direct_radiance(vec3 n, vec3 light, real strength) {
  vec3 u = to_local(n, vec3(real(0), real(0), real(1)));
  vec3 v = to_local(n, light);
  vec3 sum = v.z > 0 ? brdf_value(u, v) * (strength * v.z) : vec3(real(0));
  return sum + brdf_specular(u) * sky_radiance(to_world(n, vec3(-u.x, -u.y, u.z)));
}

// The sum of `count` Monte Carlo estimates of the radiance due to the sky.
vec3 sky_sum(vec3 n, int first, int count) {
  vec3 u = to_local(n, vec3(real(0), real(0), real(1)));
  vec3 sum = vec3(real(0));
  for (int i = first; i < first + count; ++i) {
    vec3 v = drawn_direction(u, i);
    if (v.z > 0) sum += brdf_value(u, v) * sky_radiance(to_world(n, v)) * (v.z / drawn_pdf(u, v));
  }
  return sum;
}
