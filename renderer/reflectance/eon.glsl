// Evaluates a rough diffuse surface alone.
vec3 eon(vec3 u, vec3 v, real rough, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  return bounded(eon_value(u, v, rough, kd));
}
