// Evaluates a layer of fibres alone.
vec3 sheen(vec3 u, vec3 v, real rough, vec3 ks) {
  if (below_horizon(u, v)) return vec3(0);
  return bounded(ks * (sheen_albedo(u.z, rough) * sheen_lobe(u, v, rough)));
}
