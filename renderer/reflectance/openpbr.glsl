// Evaluates the reflection of OpenPBR 1.1 (Academy Software Foundation 2025): fibres over a coat over a mixture of a
// metal and of a dielectric over a rough diffuse base, the last two perhaps under a thin film. Where the
// specification scales what is below a layer by an albedo for the view, here it is the same for both directions.

// What depends on the parameters alone. Weights are from 0 to 1.
struct OpenPbrSurface {
  real metalness;
  vec3 base;             // reflectance of the metal at normal incidence, and albedo of the diffuse base
  real diffuse_roughness;
  vec3 rough;            // of the facets, along and across the tangent, and its quadratic mean
  real rotation;
  vec3 tint;             // of the dielectric's reflection
  real excess;           // n^2 - 1, n the index of refraction of the dielectric, relative to what is above
  real index;            // n, but under a film not nearly 1, where float has too few digits for the reflectance
  vec3 dip;              // of the metal's reflectance near 82 degrees
  real metal_weight;
  vec3 metal_real;       // index of refraction of the metal, under a film
  vec3 metal_imaginary;
  real film_weight;
  real film_nanometres;
  real film_index;
  vec3 further;          // factor of the lobe of light between facets
  vec3 between;          // part of the light between the dielectric's facets that leaves
  vec3 transmitted;      // mean over the hemisphere of what the dielectric transmits
  vec3 normal;           // reflectance of the facets at normal incidence
  real coat_weight;
  real coat_index;
  vec3 coat_rough;
  vec3 coat_absorption;  // optical depth of the coat, in and out at normal incidence
  vec3 below_coat;       // albedo at normal incidence of what is below the coat
  real coat_inside;      // part of diffuse light in the coat that its surface reflects
  real coat_diffuse;     // how diffuse the light in the coat is, 0 to 1
  real coat_darkening;
  real fuzz_weight;
  vec3 fuzz;
  real fuzz_roughness;
};

// Returns the root of the reflectance of the dielectric at normal incidence: |n - 1|/(n + 1) times the root of the
// weight, and at most 0.95, since what transmits less has too few digits in float. n is relative to what is above,
// where a coat covers a part of it. If the coat's index is the larger one, the inverse of n has the same value, and no
// total reflection, which light that comes through the coat cannot have.
real openpbr_root(real index, real weight, real coat_weight, real coat_index) {
  real difference = index - 1 - index * coat_weight * (coat_index - 1) / coat_index;
  return min(real(0.95f), abs(difference) / (difference + 2) * sqrt(weight));
}

// Returns the real part of the index of refraction of a metal with this reflectance at normal incidence, where the
// tint near grazing selects one of those that are possible (Gulbrandsen 2014, "Artist Friendly Metallic Fresnel").
real openpbr_metal_real(real root, real tint) {
  return (1 - root * root) / (1 + root * root) * tint + (1 + root) / (1 - root) * (1 - tint);
}

// Returns the imaginary part, from the same without differences that cancel.
real openpbr_metal_imaginary(real n, real root, real tint) {
  real least = max(real(0), n * (1 + root) - (1 - root));
  return sqrt(2 * tint * root * least / ((1 + root * root) * (1 - root)));
}

// Returns the reflectance of the facets of the metal, or of the dielectric without tint, at an angle of this cosine and
// squared sine.
vec3 openpbr_reflectance(bool is_metal, real c, real s2, OpenPbrSurface s) {
  vec3 value = is_metal ? ggx_tinted(s.base, s.dip, c) : vec3(fresnel_of_excess(c, s2, s.excess));
  if (s.film_weight > 0) {
    vec3 covered = film_reflectance(c, s2, s.film_nanometres, s.film_index, is_metal ? s.metal_real : vec3(s.index),
                                    is_metal ? s.metal_imaginary : vec3(0));
    value = mixed(value, covered, s.film_weight);
  }
  return is_metal ? value * s.metal_weight : value;
}

// Returns the mean of that over the hemisphere, weighted by the cosine.
vec3 openpbr_mean_reflectance(bool is_metal, OpenPbrSurface s) {
  vec3 normal = vec3(fresnel_of_excess(real(1), real(0), s.excess));
  vec3 at_82 = vec3(fresnel_of_excess(real(1) / 7, real(48) / 49, s.excess));
  vec3 value = is_metal ? ggx_mean_tinted(s.base, s.dip) : ggx_mean_tinted(normal, ggx_dip(normal, at_82));
  if (s.film_weight > 0) {
    vec3 covered = film_mean(s.film_nanometres, s.film_index, is_metal ? s.metal_real : vec3(s.index),
                             is_metal ? s.metal_imaginary : vec3(0));
    value = mixed(value, covered, s.film_weight);
  }
  return is_metal ? value * s.metal_weight : value;
}

// Values for the facets of the metal and for those of the dielectric.
struct OpenPbrFacets {
  vec3 metal;
  vec3 dielectric;
};

// Returns the reflectances at an angle of this cosine and squared sine; 0 for what the surface has nothing of.
OpenPbrFacets openpbr_reflectances(real c, real s2, OpenPbrSurface s) {
  OpenPbrFacets facets;
  facets.metal = vec3(0);
  facets.dielectric = vec3(0);
  for (int i = 0; i < 2; ++i) {
    bool is_metal = i == 0;
    if (s.metalness == (is_metal ? real(0) : real(1))) continue;
    vec3 value = openpbr_reflectance(is_metal, c, s2, s);
    if (is_metal) facets.metal = value;
    if (!is_metal) facets.dielectric = value;
  }
  return facets;
}

// Returns their means over the hemisphere, weighted by the cosine.
OpenPbrFacets openpbr_mean_reflectances(OpenPbrSurface s) {
  OpenPbrFacets facets;
  facets.metal = vec3(0);
  facets.dielectric = vec3(0);
  for (int i = 0; i < 2; ++i) {
    bool is_metal = i == 0;
    vec3 value = openpbr_mean_reflectance(is_metal, s);
    if (is_metal) facets.metal = value;
    if (!is_metal) facets.dielectric = value;
  }
  return facets;
}

// Returns what the dielectric's facets transmit of light from this angle, 1 less their albedo.
vec3 openpbr_transmitted(real c, OpenPbrSurface s) {
  real alpha = s.rough.z;
  real missing = ggx_missing(c, alpha);
  real facet = ggx_fresnel_cosine(c, alpha);
  vec3 reflected = openpbr_reflectance(false, facet, (1 - facet) * (1 + facet), s);
  return max(vec3(1) - reflected * (1 - missing) - s.between * missing, real(0));
}

// Returns the mean of that over the hemisphere, weighted by the cosine.
vec3 openpbr_mean_transmitted(OpenPbrSurface s) {
  vec3 cosines = hemisphere_cosines();
  vec3 weights = hemisphere_weights();
  vec3 sum = vec3(0);
  for (int i = 0; i < 3; ++i) sum = sum + openpbr_transmitted(cosines[i], s) * weights[i];
  return sum;
}

// Returns the albedo of the coat's facets.
real openpbr_coat_albedo(real c, vec3 coat_rough, real coat_index) {
  return fresnel(ggx_fresnel_cosine(c, coat_rough.z), coat_index, real(0)) * (1 - ggx_missing(c, coat_rough.z));
}

// Returns the optical path in the coat, over that at normal incidence.
real openpbr_coat_path(real c, real index) {
  return index / sqrt(max(real(1e-6f), (index - 1) * (index + 1) + c * c));
}

// Returns the part of diffuse light in the coat that its surface reflects inside.
real openpbr_coat_inside(real index) {
  real outside = ggx_mean_reflectance(vec3(index), vec3(0), vec3(0), vec3(1)).x;
  return 1 - (1 - outside) / (index * index);
}

// Returns the roughness along and across the tangent, and its quadratic mean.
vec3 openpbr_rough(real roughness, real anisotropy) {
  real alpha = max(real(1e-4f), roughness * roughness);
  vec3 rough = ggx_roughness(alpha, alpha, anisotropy);
  return vec3(rough.x, rough.y, sqrt((rough.x * rough.x + rough.y * rough.y) / 2));
}

// Returns the roughness of the base as it is seen through the rough surface of a coat.
real openpbr_roughened(real roughness, real coat_weight, real coat_roughness) {
  real alpha = roughness * roughness;
  real coat_alpha = coat_roughness * coat_roughness;
  real both = sqrt(sqrt(min(real(1), alpha * alpha + 2 * coat_alpha * coat_alpha)));
  return roughness * (1 - coat_weight) + both * coat_weight;
}

OpenPbrSurface openpbr_surface(real base_weight, vec3 base_colour, real metalness, real diffuse_roughness,
                               real specular_weight, vec3 specular_colour, real roughness, real anisotropy,
                               real rotation, real index, real coat_weight, vec3 coat_colour, real coat_roughness,
                               real coat_anisotropy, real coat_index, real coat_darkening, real fuzz_weight,
                               vec3 fuzz_colour, real fuzz_roughness, real film_weight, real film_thickness,
                               real film_index) {
  OpenPbrSurface s;
  s.metalness = metalness;
  s.base = base_colour * base_weight;
  s.diffuse_roughness = diffuse_roughness;
  s.rough = openpbr_rough(openpbr_roughened(roughness, coat_weight, coat_roughness), anisotropy);
  s.rotation = rotation;
  s.tint = specular_colour;
  real normal = openpbr_root(index, specular_weight, coat_weight, coat_index);
  s.excess = 4 * normal / ((1 - normal) * (1 - normal));
  s.index = max(real(1.02f), (1 + normal) / (1 - normal));
  s.dip = ggx_dip(s.base, specular_colour * ggx_schlick_at_82(s.base));
  s.metal_weight = min(real(1), specular_weight);
  s.film_weight = film_weight;
  s.film_nanometres = film_thickness * 1000;
  s.film_index = film_index;
  vec3 root = vec3(sqrt(s.base.x), sqrt(s.base.y), sqrt(s.base.z));
  root = min(max(root, real(0.01f)), real(0.995f));
  s.metal_real = vec3(openpbr_metal_real(root.x, specular_colour.x), openpbr_metal_real(root.y, specular_colour.y),
                      openpbr_metal_real(root.z, specular_colour.z));
  s.metal_imaginary = vec3(openpbr_metal_imaginary(s.metal_real.x, root.x, specular_colour.x),
                           openpbr_metal_imaginary(s.metal_real.y, root.y, specular_colour.y),
                           openpbr_metal_imaginary(s.metal_real.z, root.z, specular_colour.z));
  real missing = ggx_mean_missing(s.rough.z);
  OpenPbrFacets means = openpbr_mean_reflectances(s);
  s.further = mixed(ggx_further(means.dielectric * s.tint, s.rough.z), ggx_further(means.metal, s.rough.z), metalness);
  s.between = means.dielectric * means.dielectric * (1 - missing) / (vec3(1) - means.dielectric * missing);
  s.transmitted = openpbr_mean_transmitted(s);
  OpenPbrFacets facets = openpbr_reflectances(real(1), real(0), s);
  s.normal = mixed(facets.dielectric * s.tint, facets.metal, metalness);
  s.coat_weight = coat_weight;
  s.coat_index = coat_index;
  s.coat_rough = openpbr_rough(coat_roughness, coat_anisotropy);
  vec3 clear = max(coat_colour, real(1e-30f));
  s.coat_absorption = vec3(-log(clear.x), -log(clear.y), -log(clear.z));
  s.below_coat = mixed(facets.dielectric * s.tint + (vec3(1) - facets.dielectric) * s.base, facets.metal, metalness);
  s.coat_inside = openpbr_coat_inside(coat_index);
  s.coat_diffuse = (1 + (roughness - 1) * normal * normal) * (1 - metalness) + roughness * metalness;
  s.coat_darkening = coat_darkening;
  s.fuzz_weight = fuzz_weight;
  s.fuzz = fuzz_colour;
  s.fuzz_roughness = fuzz_roughness;
  return s;
}

// Evaluates the base: facets, the light between them, and the diffuse part below those of the dielectric.
vec3 openpbr_base(vec3 u, vec3 v, OpenPbrSurface s) {
  OpenPbrFacets facets = openpbr_reflectances(cosine_at_half(u, v), squared_sine_at_half(u, v), s);
  vec3 value = mixed(facets.dielectric * s.tint, facets.metal, s.metalness) * ggx_facets(u, v, s.rough, s.rotation) +
               s.further * ggx_further_lobe(u, v, s.rough.z);
  if (s.metalness == 1 || largest_channel(s.base) == 0) return value;
  vec3 transmitted = vec3(1) / max(s.transmitted, real(1e-4f));
  for (int i = 0; i < 2; ++i) transmitted = transmitted * openpbr_transmitted(i == 0 ? u.z : v.z, s);
  return value + eon_value(u, v, s.diffuse_roughness, s.base) * transmitted * (1 - s.metalness);
}

// Returns what a coat leaves of the light that is reflected below it: what it does not reflect itself, does not
// absorb, and what its inside reflects back to a base that absorbs some of it again.
vec3 openpbr_below_coat(vec3 u, vec3 v, OpenPbrSurface s, real reflected) {
  real below = layer_below(openpbr_coat_albedo(u.z, s.coat_rough, s.coat_index),
                           openpbr_coat_albedo(v.z, s.coat_rough, s.coat_index));
  real path = (openpbr_coat_path(u.z, s.coat_index) + openpbr_coat_path(v.z, s.coat_index)) / 2;
  vec3 clear = vec3(exp(-s.coat_absorption.x * path), exp(-s.coat_absorption.y * path),
                    exp(-s.coat_absorption.z * path));
  real inside = reflected * (1 - s.coat_diffuse) + s.coat_inside * s.coat_diffuse;
  vec3 dark = vec3(1 - inside) / (vec3(1) - s.below_coat * inside);
  return mixed(vec3(1), dark, s.coat_weight * s.coat_darkening) * mixed(vec3(1), clear * below, s.coat_weight);
}

// Evaluates the BRDF from what depends on the parameters alone.
vec3 openpbr_prepared(vec3 u, vec3 v, OpenPbrSurface s) {
  if (below_horizon(u, v)) return vec3(0);
  vec3 value = openpbr_base(u, v, s);
  if (s.coat_weight > 0) {
    real reflected = fresnel_at_half(u, v, s.coat_index, real(0));
    value = value * openpbr_below_coat(u, v, s, reflected) +
            vec3(s.coat_weight * reflected * ggx_facets(u, v, s.coat_rough, s.rotation));
  }
  if (s.fuzz_weight > 0) {
    real fibres = sheen_albedo(u.z, s.fuzz_roughness);
    value = value * layer_below(s.fuzz_weight * fibres, s.fuzz_weight * sheen_albedo(v.z, s.fuzz_roughness)) +
            s.fuzz * (s.fuzz_weight * fibres * sheen_lobe(u, v, s.fuzz_roughness));
  }
  return bounded(value);
}

vec3 openpbr(vec3 u, vec3 v, real base_weight, vec3 base_colour, real metalness, real diffuse_roughness,
             real specular_weight, vec3 specular_colour, real roughness, real anisotropy, real rotation, real index,
             real coat_weight, vec3 coat_colour, real coat_roughness, real coat_anisotropy, real coat_index,
             real coat_darkening, real fuzz_weight, vec3 fuzz_colour, real fuzz_roughness, real film_weight,
             real film_thickness, real film_index) {
  return openpbr_prepared(
      u, v,
      openpbr_surface(base_weight, base_colour, metalness, diffuse_roughness, specular_weight, specular_colour,
                      roughness, anisotropy, rotation, index, coat_weight, coat_colour, coat_roughness,
                      coat_anisotropy, coat_index, coat_darkening, fuzz_weight, fuzz_colour, fuzz_roughness,
                      film_weight, film_thickness, film_index));
}
