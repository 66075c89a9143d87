vec3 minnaert(vec3 u, vec3 v, real k, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  return bounded(kd / PI * exp((k - 1) * (log(u.z) + log(v.z))));
}
