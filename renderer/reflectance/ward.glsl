// The exponent is tan^2(delta) (cos^2(phi_h)/sx^2 + sin^2(phi_h)/sy^2), without trigonometry. The printed
// alternative exp(-2 (...)/(1 + h.n)) is Ward's approximation for small delta, which his sampling does not match.
vec3 ward(vec3 u, vec3 v, real sx, real sy, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  vec3 h = u + v;
  real x = h.x / (sx * h.z);
  real y = h.y / (sy * h.z);
  real lobe = exp(-(x * x + y * y)) / (4 * PI * sx * sy * sqrt(u.z) * sqrt(v.z));
  return bounded(kd / PI + ks * lobe);
}
