// Evaluates microfacets of Trowbridge and Reitz's distribution (GGX; Walter, Marschner, Li and Torrance 2007)
// with Smith's height-correlated masking-shadowing (Heitz 2014), and what facets scatter to each other.

// Turns a direction about the normal, clockwise.
vec3 ggx_turned(vec3 u, real angle) {
  if (angle == 0) return u;
  real c = cos(angle);
  real s = sin(angle);
  return vec3(c * u.x + s * u.y, c * u.y - s * u.x, u.z);
}

// Returns the roughness along and across the tangent that an anisotropy makes of two that are given (OpenPBR
// 1.1): their quadratic mean stays.
vec3 ggx_roughness(real along, real across, real anisotropy) {
  real less = 1 - anisotropy;
  real scale = sqrt(2 / (1 + less * less));
  return vec3(along * scale, max(real(1e-4f), across * less * scale), 0);
}

// Returns the length of a direction that is stretched by the roughness: c (1 + 2 Lambda) of Smith's masking.
real ggx_stretched(vec3 u, vec3 rough) {
  real x = rough.x * u.x;
  real y = rough.y * u.y;
  return sqrt(x * x + y * y + u.z * u.z);
}

// Returns the distribution of normals at h, which need not have unit length. It is turned, and not u and v,
// for their sum is the more exact the nearer they are to opposite.
real ggx_distribution(vec3 h, vec3 rough) {
  real area = rough.x * rough.y;
  real x = h.x * rough.y;
  real y = h.y * rough.x;
  real z = h.z * area;
  real slope = (x * x + y * y + z * z) / (h.x * h.x + h.y * h.y + h.z * h.z);
  return area * area * area / (PI * slope * slope);
}

// Returns D G/(4 cu cv). G/(4 cu cv) has no 0/0.
real ggx_facets(vec3 u, vec3 v, vec3 rough, real rotation) {
  real length_u = ggx_stretched(ggx_turned(u, rotation), rough);
  real length_v = ggx_stretched(ggx_turned(v, rotation), rough);
  return ggx_distribution(ggx_turned(u + v, rotation), rough) / (2 * (v.z * length_u + u.z * length_v));
}

// Returns what white facets do not reflect of light from this angle, 1 less their directional albedo: a fit
// to the quadrature of scripts/fit_ggx_albedo, which makes these numbers. It is at most 0.005 from it. For
// anisotropic roughness, alpha is the quadratic mean.
real ggx_missing(real c, real alpha) {
  real scale = 1 / (alpha + c);
  real s = alpha * scale;
  real a0 = alpha * (real(2.378f) + alpha * (real(49.321f) + alpha * real(8.092f)));
  real a1 = real(10.432f) + alpha * (real(-24.078f) + alpha * (real(-150.165f) + alpha * real(-112.998f)));
  real a2 = real(-29.369f) + alpha * (real(60.822f) + alpha * (real(186.681f) + alpha * real(315.358f)));
  real a3 = real(28.639f) + alpha * (real(-56.561f) + alpha * (real(-108.613f) + alpha * real(-338.756f)));
  real a4 = real(-9.438f) + alpha * (real(16.757f) + alpha * (real(27.192f) + alpha * real(128.04f)));
  real rest = c * scale;
  real smooth_part = rest * (a0 + s * (a1 + s * (a2 + s * (a3 + s * a4))));
  real grazing = real(0.084f) * alpha * (sqrt(rest) - rest);
  return max(real(0), s * s * (smooth_part + grazing));
}

// Returns what leaves after several bounces on white facets, relative to what leaves after one (Turquin 2019). The
// fit above is kept low by about 0.0025 on purpose; here that is made up for.
real ggx_several_over_one(real c, real alpha) {
  real fit = ggx_missing(c, alpha);
  real missing = fit + real(0.0025f) * fit / (fit + real(0.02f));
  return missing / (1 - missing);
}

// Returns the mean of `ggx_missing` over the hemisphere, weighted by the cosine.
real ggx_mean_missing(real alpha) {
  real cubic = real(-0.40785f) + alpha * (real(1.06386f) + alpha * real(-0.32809f));
  return alpha * alpha / (real(0.2721f) + alpha * (real(1.10382f) + alpha * cubic));
}

// Returns Schlick's approximation at this angle, less than that by `dip` near 82 degrees (Hoffman 2023,
// "Generalization of Adobe's Fresnel model").
vec3 ggx_tinted(vec3 normal, vec3 dip, real c) {
  real rest = 1 - c;
  real power5 = fifth_power(rest);
  return max(normal + (vec3(1) - normal) * power5 - dip * (c * power5 * rest), real(0));
}

// Returns the dip with which Schlick's approximation has the value `at_82` at acos(1/7), 82 degrees.
vec3 ggx_dip(vec3 normal, vec3 at_82) {
  real power5 = real(7776) / 16807;
  return (normal + (vec3(1) - normal) * power5 - at_82) * (real(823543) / 46656);
}

// Returns the reflectance at normal incidence, by the index of refraction if none is given.
vec3 ggx_at_normal(vec3 n, vec3 k, vec3 f0) {
  if (f0.x > 0 || f0.y > 0 || f0.z > 0) return f0;
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
  if (f0.x > 0 || f0.y > 0 || f0.z > 0) {
    vec3 schlick = f0 + (vec3(1) - f0) * (real(7776) / 16807);
    return ggx_tinted(f0, ggx_dip(f0, f82 * schlick), c);
  }
  vec3 e = u - v;
  return ggx_fresnel(c, min(real(1), (e.x * e.x + e.y * e.y + e.z * e.z) / 4), n, k);
}

// Returns the mean reflectance of facets over the hemisphere, weighted by the cosine, by Schlick's
// approximation with its dip at 82 degrees.
vec3 ggx_mean_reflectance(vec3 n, vec3 k, vec3 f0, vec3 f82) {
  vec3 normal = ggx_at_normal(n, k, f0);
  vec3 at_82 = f82 * (normal + (vec3(1) - normal) * (real(7776) / 16807));
  if (!(f0.x > 0 || f0.y > 0 || f0.z > 0)) at_82 = ggx_fresnel(real(1) / 7, real(48) / 49, n, k);
  vec3 mean_value = normal + (vec3(1) - normal) / real(21) - ggx_dip(normal, at_82) / real(126);
  return min(max(mean_value, real(0)), real(1));
}

// Returns the part of light that facets scatter to each other which leaves in the end (Kulla and Conty 2017).
vec3 ggx_further(vec3 reflectance, real missing) {
  return reflectance * reflectance * (1 - missing) / (vec3(1) - reflectance * missing);
}

// Returns the factor of the reciprocal lobe of what facets scatter to each other.
vec3 ggx_further_factor(real alpha, vec3 n, vec3 k, vec3 f0, vec3 f82) {
  real missing = ggx_mean_missing(alpha);
  return ggx_further(ggx_mean_reflectance(n, k, f0, f82), missing) / (PI * missing);
}

// Evaluates the BRDF from the roughness along both axes and its quadratic mean, the reflectance at normal
// incidence, and the factor above, which depend on the parameters alone.
vec3 ggx_prepared(vec3 u, vec3 v, vec3 rough, real alpha, real rotation, vec3 n, vec3 k, vec3 f0, vec3 f82,
                  vec3 ks, int scattering, vec3 normal, vec3 further) {
  if (below_horizon(u, v)) return vec3(0);
  vec3 lobe = ggx_reflectance(u, v, n, k, f0, f82) * ggx_facets(u, v, rough, rotation);
  if (scattering == 1) lobe = lobe * (vec3(1) + normal * ggx_several_over_one(u.z, alpha));
  if (scattering == 0) lobe = lobe + further * (ggx_missing(u.z, alpha) * ggx_missing(v.z, alpha));
  return bounded(ks * lobe);
}

vec3 ggx(vec3 u, vec3 v, real along, real across, real anisotropy, real rotation, vec3 n, vec3 k, vec3 f0,
         vec3 f82, vec3 ks, int scattering) {
  vec3 rough = ggx_roughness(along, across, anisotropy);
  real alpha = sqrt((rough.x * rough.x + rough.y * rough.y) / 2);
  return ggx_prepared(u, v, rough, alpha, rotation, n, k, f0, f82, ks, scattering, ggx_at_normal(n, k, f0),
                      ggx_further_factor(alpha, n, k, f0, f82));
}
