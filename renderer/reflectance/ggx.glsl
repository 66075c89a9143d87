// Evaluates GGX microfacets of a dielectric, a conductor, or a colour.

// Evaluates the BRDF from the roughness along both axes and its quadratic mean, the reflectance at normal
// incidence, and the factor of the further lobe, which depend on the parameters alone.
vec3 ggx_prepared(vec3 u, vec3 v, vec3 rough, real alpha, real rotation, vec3 n, vec3 k, vec3 f0, vec3 f82,
                  vec3 ks, int scattering, vec3 normal, vec3 further) {
  if (below_horizon(u, v)) return vec3(0);
  vec3 lobe = ggx_reflectance(u, v, n, k, f0, f82) * ggx_facets(u, v, rough, rotation);
  if (scattering == 1) lobe = lobe * (vec3(1) + normal * ggx_several_over_one(u.z, alpha));
  if (scattering == 0) lobe = lobe + further * ggx_further_lobe(u, v, alpha);
  return bounded(ks * lobe);
}

vec3 ggx(vec3 u, vec3 v, real along, real across, real anisotropy, real rotation, vec3 n, vec3 k, vec3 f0,
         vec3 f82, vec3 ks, int scattering) {
  vec3 rough = ggx_roughness(along, across, anisotropy);
  real alpha = sqrt((rough.x * rough.x + rough.y * rough.y) / 2);
  return ggx_prepared(u, v, rough, alpha, rotation, n, k, f0, f82, ks, scattering, ggx_at_normal(n, k, f0),
                      ggx_further(ggx_mean_reflectance(n, k, f0, f82), alpha));
}
