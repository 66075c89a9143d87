// Evaluates what single facets reflect: a dielectric or a conductor, or a colour at normal incidence with a tint
// near grazing. The models of GGX microfacets share it.

// Returns Schlick's approximation at this angle, less than that by `dip` near 82 degrees (Hoffman 2023,
// "Generalization of Adobe's Fresnel model").
vec3 ggx_tinted(vec3 normal, vec3 dip, real c) {
  real rest = 1 - c;
  real power5 = fifth_power(rest);
  return max(normal + (vec3(1) - normal) * power5 - dip * (c * power5 * rest), real(0));
}

// Returns Schlick's approximation at acos(1/7), 82 degrees.
vec3 ggx_schlick_at_82(vec3 normal) { return normal + (vec3(1) - normal) * (real(7776) / 16807); }

// Returns the dip with which Schlick's approximation has the value `at_82` there.
vec3 ggx_dip(vec3 normal, vec3 at_82) {
  return (ggx_schlick_at_82(normal) - at_82) * (real(823543) / 46656);
}

// Returns true if the reflectance at normal incidence is given.
bool ggx_has_colour(vec3 f0) { return f0.x > 0 || f0.y > 0 || f0.z > 0; }

// Returns the reflectance at normal incidence, by the index of refraction if none is given.
vec3 ggx_at_normal(vec3 n, vec3 k, vec3 f0) {
  if (ggx_has_colour(f0)) return f0;
  vec3 k2 = k * k;
  vec3 less = n - vec3(1);
  vec3 more = n + vec3(1);
  return (less * less + k2) / (more * more + k2);
}

// Returns Fresnel's reflectance, one channel at a time if they differ.
vec3 ggx_fresnel(real c, real s2, vec3 n, vec3 k) {
  real red = fresnel(c, s2, n.x, k.x);
  if (n.x == n.y && n.x == n.z && k.x == k.y && k.x == k.z) return vec3(red);
  return vec3(red, fresnel(c, s2, n.y, k.y), fresnel(c, s2, n.z, k.z));
}

// Returns the reflectance of a facet that reflects v to u.
vec3 ggx_reflectance(vec3 u, vec3 v, vec3 n, vec3 k, vec3 f0, vec3 f82) {
  real c = cosine_at_half(u, v);
  if (ggx_has_colour(f0)) return ggx_tinted(f0, ggx_dip(f0, f82 * ggx_schlick_at_82(f0)), c);
  return ggx_fresnel(c, squared_sine_at_half(u, v), n, k);
}

// Returns the mean over the hemisphere, weighted by the cosine, of Schlick's approximation with its dip.
vec3 ggx_mean_tinted(vec3 normal, vec3 dip) {
  vec3 mean_value = normal + (vec3(1) - normal) / real(21) - dip / real(126);
  return min(max(mean_value, real(0)), real(1));
}

// Returns the mean reflectance of facets over the hemisphere, weighted by the cosine, by that approximation.
vec3 ggx_mean_reflectance(vec3 n, vec3 k, vec3 f0, vec3 f82) {
  vec3 normal = ggx_at_normal(n, k, f0);
  vec3 at_82 = ggx_has_colour(f0) ? f82 * ggx_schlick_at_82(f0) : ggx_fresnel(real(1) / 7, real(48) / 49, n, k);
  return ggx_mean_tinted(normal, ggx_dip(normal, at_82));
}
