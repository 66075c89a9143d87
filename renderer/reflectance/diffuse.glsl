vec3 diffuse(vec3 u, vec3 v, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  return bounded(kd / PI);
}
