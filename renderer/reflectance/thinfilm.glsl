// Evaluates GGX microfacets under a thin film.

// Evaluates the BRDF from what depends on the parameters alone, as `ggx_prepared`.
vec3 thinfilm_prepared(vec3 u, vec3 v, vec3 rough, real alpha, real thickness, real film, vec3 n, vec3 k,
                       vec3 ks, vec3 further) {
  if (below_horizon(u, v)) return vec3(0);
  vec3 reflectance = film_at_half(u, v, thickness, film, n, k);
  vec3 lobe = reflectance * ggx_facets(u, v, rough, real(0)) + further * ggx_further_lobe(u, v, alpha);
  return bounded(ks * lobe);
}

vec3 thinfilm(vec3 u, vec3 v, real along, real across, real thickness, real film, vec3 n, vec3 k, vec3 ks) {
  vec3 rough = vec3(along, across, 0);
  real alpha = sqrt((along * along + across * across) / 2);
  return thinfilm_prepared(u, v, rough, alpha, thickness, film, n, k, ks,
                           ggx_further(film_mean(thickness, film, n, k), alpha));
}
