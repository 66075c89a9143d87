vec3 phong(vec3 u, vec3 v, real n, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  return bounded(kd / PI + ks * mirror_power(u, v, n));
}
