// (n + 2) / (2 pi) makes the lobe reflect exactly 1 at normal incidence.
vec3 lewis(vec3 u, vec3 v, real n, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  return bounded(kd / PI + ks * ((n + 2) / (2 * PI) * mirror_power(u, v, n)));
}
