// Evaluates the metallic-roughness material of glTF 2.0, with the extensions for the index of refraction, the
// specular reflection, anisotropy, sheen and clear coats: a coat over fibres over GGX facets over a diffuse base.

// Returns Schlick's approximation between the reflectances at normal incidence and at grazing.
vec3 gltf_schlick(vec3 normal, vec3 grazing, real c) { return normal + (grazing - normal) * fifth_power(1 - c); }

// Returns the mean of that over the hemisphere, weighted by the cosine.
vec3 gltf_mean_schlick(vec3 normal, vec3 grazing) { return normal + (grazing - normal) / real(21); }

// Returns what is between the dielectric and the metal. At a metal, no digits of a dark colour are lost.
vec3 gltf_mixed(vec3 of_dielectric, vec3 of_metal, real metallic) {
  return of_dielectric * (1 - metallic) + of_metal * metallic;
}

real gltf_largest(vec3 colour) { return max(colour.x, max(colour.y, colour.z)); }

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

// Returns what depends on the parameters alone: the factor of the lobe of light between facets.
vec3 gltf_further(vec3 base, real metallic, vec3 normal, real specular, real alpha) {
  vec3 of_metal = ggx_further(gltf_mean_schlick(base, vec3(1)), alpha);
  vec3 of_dielectric = ggx_further(gltf_mean_schlick(normal, vec3(specular)), alpha);
  return gltf_mixed(of_dielectric, of_metal, metallic);
}

// Returns the dielectric's largest reflectance at normal incidence, the part of light between its facets that
// leaves, and the mean over the hemisphere of what it transmits.
vec3 gltf_dielectric(vec3 normal, real specular, real alpha) {
  real largest = gltf_largest(normal);
  real missing = ggx_mean_missing(alpha);
  real mean_value = largest + (specular - largest) / real(21);
  real further = mean_value * mean_value * (1 - missing) / (1 - mean_value * missing);
  real albedo = largest * (1 - missing) + (specular - largest) * ggx_mean_grazing(alpha) + further * missing;
  return vec3(largest, further, 1 - albedo);
}

// Returns the part of light that a layer transmits to what is below it, by its albedos at u and at v: the same
// for both directions, and never more than what it does not reflect.
real gltf_below(real albedo_u, real albedo_v) { return 1 - min(real(1), max(albedo_u, albedo_v)); }

// Evaluates the base: facets, the light between them, and the diffuse part below those of the dielectric.
vec3 gltf_base(vec3 u, vec3 v, vec3 rough, real rotation, vec3 base, real metallic, vec3 normal, real specular,
               vec3 further, vec3 dielectric) {
  real alpha = rough.z;
  real c = cosine_at_half(u, v);
  vec3 of_metal = gltf_schlick(base, vec3(1), c);
  vec3 of_dielectric = gltf_schlick(normal, vec3(specular), c);
  vec3 value = gltf_mixed(of_dielectric, of_metal, metallic) * ggx_facets(u, v, rough, rotation);
  value = value + further * ggx_further_lobe(u, v, alpha);
  if (metallic == 1) return value;
  real transmitted = max(real(0), 1 - gltf_albedo(u.z, alpha, dielectric.x, specular, dielectric.y)) *
                     max(real(0), 1 - gltf_albedo(v.z, alpha, dielectric.x, specular, dielectric.y));
  return value + base * ((1 - metallic) * transmitted / (PI * max(real(1e-4f), dielectric.z)));
}

// Evaluates the material from what depends on the parameters alone: the roughness of the facets and of the coat,
// and what the functions above return.
vec3 gltf_prepared(vec3 u, vec3 v, vec3 rough, real rotation, vec3 base, real metallic, vec3 normal, real specular,
                   real clearcoat, vec3 coat, vec3 sheen_colour, real sheen_roughness, vec3 further,
                   vec3 dielectric) {
  if (below_horizon(u, v)) return vec3(0);
  vec3 value = gltf_base(u, v, rough, rotation, base, metallic, normal, specular, further, dielectric);
  real sheen_strength = gltf_largest(sheen_colour);
  if (sheen_strength > 0) {
    real fibres = sheen_albedo(u.z, sheen_roughness);
    value = value * gltf_below(sheen_strength * fibres, sheen_strength * sheen_albedo(v.z, sheen_roughness)) +
            sheen_colour * (fibres * sheen_lobe(u, v, sheen_roughness));
  }
  if (clearcoat > 0) {
    real below = gltf_below(clearcoat * gltf_coat_albedo(u.z, coat.z), clearcoat * gltf_coat_albedo(v.z, coat.z));
    value = value * below + gltf_schlick(vec3(0.04f), vec3(1), cosine_at_half(u, v)) *
                                (clearcoat * ggx_facets(u, v, coat, real(0)));
  }
  return bounded(value);
}

vec3 gltf(vec3 u, vec3 v, vec3 base, real metallic, real roughness, real ior, real specular, vec3 specular_colour,
          real anisotropy, real rotation, real clearcoat, real coat_roughness, vec3 sheen_colour,
          real sheen_roughness) {
  vec3 rough = gltf_rough(roughness, anisotropy);
  vec3 normal = gltf_normal(ior, specular, specular_colour);
  return gltf_prepared(u, v, rough, rotation, base, metallic, normal, specular, clearcoat,
                       gltf_rough(coat_roughness, real(0)), sheen_colour, sheen_roughness,
                       gltf_further(base, metallic, normal, specular, rough.z),
                       gltf_dielectric(normal, specular, rough.z));
}
