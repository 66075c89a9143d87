// Evaluates the metallic-roughness material of glTF 2.0, with the extensions for the index of refraction, the
// specular reflection, anisotropy, iridescence, sheen and clear coats: a coat over fibres over GGX facets, perhaps under
// a thin film, over a diffuse base. `film` is the film's strength, index of refraction, and thickness in nanometres.

// Returns Schlick's approximation between the reflectances at normal incidence and at grazing.
vec3 gltf_schlick(vec3 normal, vec3 grazing, real c) { return normal + (grazing - normal) * fifth_power(1 - c); }

// Returns the mean of that over the hemisphere, weighted by the cosine.
vec3 gltf_mean_schlick(vec3 normal, vec3 grazing) { return normal + (grazing - normal) / real(21); }

// Returns the index of refraction of a dielectric with this reflectance at normal incidence, which is what
// KHR_materials_iridescence makes of a metal, too. Float has too few digits for films on
// air and on perfect mirrors.
real gltf_index(real normal) {
  real root = min(real(0.995f), max(real(0.01f), sqrt(normal)));
  return (1 + root) / (1 - root);
}
vec3 gltf_indices(vec3 normal) { return vec3(gltf_index(normal.x), gltf_index(normal.y), gltf_index(normal.z)); }

// Returns the reflectance of facets at an angle of this cosine and squared sine.
vec3 gltf_reflectance(vec3 normal, real grazing, real c, real s2, vec3 film) {
  vec3 bare = gltf_schlick(normal, vec3(grazing), c);
  if (film.x == 0 || grazing == 0) return bare;
  vec3 covered = film_reflectance(c, s2, film.z, film.y, gltf_indices(normal / grazing), vec3(0)) * grazing;
  return mixed(bare, covered, film.x);
}

// Returns the mean of that over the hemisphere, weighted by the cosine.
vec3 gltf_mean_reflectance(vec3 normal, real grazing, vec3 film) {
  vec3 bare = gltf_mean_schlick(normal, vec3(grazing));
  if (film.x == 0 || grazing == 0) return bare;
  return mixed(bare, film_mean(film.z, film.y, gltf_indices(normal / grazing), vec3(0)) * grazing, film.x);
}

// Returns the reflectance of the dielectric at normal incidence.
vec3 gltf_normal(real ior, real specular, vec3 specular_colour) {
  real root = (ior - 1) / (ior + 1);
  return min(specular_colour * (root * root), real(1)) * specular;
}

// Returns the roughness along and across the tangent, as KHR_materials_anisotropy has it, and the quadratic
// mean.
vec3 gltf_rough(real roughness, real anisotropy) {
  real across = max(real(1e-4f), roughness * roughness);
  real along = across + (1 - across) * anisotropy * anisotropy;
  return vec3(along, across, sqrt((along * along + across * across) / 2));
}

// Returns the albedo of the dielectric's facets in its largest channel; `further` is the part of light between
// facets that leaves.
real gltf_albedo(real c, real alpha, real normal, real grazing, real further) {
  real missing = ggx_missing(c, alpha);
  return normal * (1 - missing) + (grazing - normal) * ggx_grazing(c, alpha) + further * missing;
}

real gltf_coat_albedo(real c, real alpha) { return gltf_albedo(c, alpha, real(0.04f), real(1), real(0)); }

// Values for the facets of the metal and for those of the dielectric.
struct GltfFacets {
  vec3 metal;
  vec3 dielectric;
};

// Returns the reflectances at an angle of this cosine and squared sine.
GltfFacets gltf_reflectances(vec3 base, vec3 normal, real specular, real c, real s2, vec3 film) {
  GltfFacets facets;
  facets.metal = vec3(0);
  facets.dielectric = vec3(0);
  for (int i = 0; i < 2; ++i) {
    bool is_metal = i == 0;
    vec3 value = gltf_reflectance(is_metal ? base : normal, is_metal ? real(1) : specular, c, s2, film);
    if (is_metal) facets.metal = value;
    if (!is_metal) facets.dielectric = value;
  }
  return facets;
}

// Returns their means over the hemisphere, weighted by the cosine.
GltfFacets gltf_mean_reflectances(vec3 base, vec3 normal, real specular, vec3 film) {
  GltfFacets facets;
  facets.metal = vec3(0);
  facets.dielectric = vec3(0);
  for (int i = 0; i < 2; ++i) {
    bool is_metal = i == 0;
    vec3 value = gltf_mean_reflectance(is_metal ? base : normal, is_metal ? real(1) : specular, film);
    if (is_metal) facets.metal = value;
    if (!is_metal) facets.dielectric = value;
  }
  return facets;
}

// Returns the factor of the lobe of light between facets, by their mean reflectances.
vec3 gltf_further(GltfFacets means, real metallic, real alpha) {
  return mixed(ggx_further(means.dielectric, alpha), ggx_further(means.metal, alpha), metallic);
}

// Returns what the dielectric's facets transmit of light from this angle, 1 less their albedo in its largest channel.
real gltf_transmitted(real c, real alpha, vec3 normal, real specular, vec3 dielectric, vec3 film) {
  if (film.x == 0) return max(real(0), 1 - gltf_albedo(c, alpha, dielectric.x, specular, dielectric.y));
  real missing = ggx_missing(c, alpha);
  real facet = ggx_fresnel_cosine(c, alpha);
  real reflected = largest_channel(gltf_reflectance(normal, specular, facet, (1 - facet) * (1 + facet), film));
  return max(real(0), 1 - reflected * (1 - missing) - dielectric.y * missing);
}

// Returns the dielectric's largest reflectance at normal incidence, the part of light between its facets that
// leaves, and the mean over the hemisphere of what it transmits. `mean_reflectance` is that of its facets.
vec3 gltf_dielectric(vec3 normal, real specular, vec3 mean_reflectance, real alpha, vec3 film) {
  real largest = largest_channel(normal);
  real missing = ggx_mean_missing(alpha);
  real mean_value = largest + (specular - largest) / real(21);
  if (film.x > 0) mean_value = largest_channel(mean_reflectance);
  real further = mean_value * mean_value * (1 - missing) / (1 - mean_value * missing);
  if (film.x == 0) {
    real albedo = largest * (1 - missing) + (specular - largest) * ggx_mean_grazing(alpha) + further * missing;
    return vec3(largest, further, 1 - albedo);
  }
  vec3 partial = vec3(largest, further, 1);
  vec3 cosines = hemisphere_cosines();
  vec3 weights = hemisphere_weights();
  real transmitted = real(0);
  for (int i = 0; i < 3; ++i) {
    transmitted += gltf_transmitted(cosines[i], alpha, normal, specular, partial, film) * weights[i];
  }
  return vec3(largest, further, transmitted);
}

// Evaluates the base: facets, the light between them, and the diffuse part below those of the dielectric.
vec3 gltf_base(vec3 u, vec3 v, vec3 rough, real rotation, vec3 base, real metallic, vec3 normal, real specular,
               vec3 film, vec3 further, vec3 dielectric) {
  real alpha = rough.z;
  GltfFacets facets = gltf_reflectances(base, normal, specular, cosine_at_half(u, v), squared_sine_at_half(u, v), film);
  vec3 value = mixed(facets.dielectric, facets.metal, metallic) * ggx_facets(u, v, rough, rotation);
  value = value + further * ggx_further_lobe(u, v, alpha);
  if (metallic == 1) return value;
  real transmitted = real(1);
  for (int i = 0; i < 2; ++i) {
    transmitted *= gltf_transmitted(i == 0 ? u.z : v.z, alpha, normal, specular, dielectric, film);
  }
  return value + base * ((1 - metallic) * transmitted / (PI * max(real(1e-4f), dielectric.z)));
}

// Evaluates the material from what depends on the parameters alone: the roughness of the facets and of the coat,
// and what the functions above return.
vec3 gltf_prepared(vec3 u, vec3 v, vec3 rough, real rotation, vec3 base, real metallic, vec3 normal, real specular,
                   real clearcoat, vec3 coat, vec3 sheen_colour, real sheen_roughness, vec3 film, vec3 further,
                   vec3 dielectric) {
  if (below_horizon(u, v)) return vec3(0);
  vec3 value = gltf_base(u, v, rough, rotation, base, metallic, normal, specular, film, further, dielectric);
  real sheen_strength = largest_channel(sheen_colour);
  if (sheen_strength > 0) {
    real fibres = sheen_albedo(u.z, sheen_roughness);
    value = value * layer_below(sheen_strength * fibres, sheen_strength * sheen_albedo(v.z, sheen_roughness)) +
            sheen_colour * (fibres * sheen_lobe(u, v, sheen_roughness));
  }
  if (clearcoat > 0) {
    real below = layer_below(clearcoat * gltf_coat_albedo(u.z, coat.z), clearcoat * gltf_coat_albedo(v.z, coat.z));
    value = value * below + gltf_schlick(vec3(0.04f), vec3(1), cosine_at_half(u, v)) *
                                (clearcoat * ggx_facets(u, v, coat, real(0)));
  }
  return bounded(value);
}

vec3 gltf(vec3 u, vec3 v, vec3 base, real metallic, real roughness, real ior, real specular, vec3 specular_colour,
          real anisotropy, real rotation, real clearcoat, real coat_roughness, vec3 sheen_colour,
          real sheen_roughness, real iridescence, real film_index, real film_nanometres) {
  vec3 rough = gltf_rough(roughness, anisotropy);
  vec3 normal = gltf_normal(ior, specular, specular_colour);
  vec3 film = vec3(iridescence, film_index, film_nanometres);
  GltfFacets means = gltf_mean_reflectances(base, normal, specular, film);
  return gltf_prepared(u, v, rough, rotation, base, metallic, normal, specular, clearcoat,
                       gltf_rough(coat_roughness, real(0)), sheen_colour, sheen_roughness, film,
                       gltf_further(means, metallic, rough.z),
                       gltf_dielectric(normal, specular, means.dielectric, rough.z, film));
}
