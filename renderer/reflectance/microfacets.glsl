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

// Returns what leaves after several bounces on white facets, relative to what leaves after one (Turquin
// 2019). The fit above is kept low by about 0.0025 on purpose; here that is made up for.
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

// Returns the cosine at which a single facet reflects (1 - u.h)^5, the second part of Schlick's approximation, as
// much as facets do that are seen at c: a fit, for which `ggx_grazing` is at most 0.017 from the quadrature of
// scripts/fit_ggx_albedo.
real ggx_schlick_cosine(real c, real alpha) {
  real root = sqrt(alpha);
  real rest = real(0.3781f) + root * (real(-2.2341f) + root * real(1.3077f));
  real least = root * sqrt(root) * (real(1.0165f) + root * rest);
  real a0 = real(-1.366f) + root * (real(4.6269f) - root * real(2.7931f));
  real a1 = real(7.0018f) + root * (real(-26.2794f) + root * real(18.4785f));
  real a2 = real(-8.7116f) + root * (real(30.7108f) - root * real(22.2822f));
  real place = sqrt(c * c + least * least) + c * root * (a0 + c * (a1 + c * a2));
  return min(real(1), max(real(0), place));
}

// Returns the directional albedo of facets that reflect (1 - u.h)^5.
real ggx_grazing(real c, real alpha) {
  return fifth_power(1 - ggx_schlick_cosine(c, alpha)) * (1 - ggx_missing(c, alpha));
}

// Returns the mean of u.h over what white facets reflect: a fit, at most 0.016 from the quadrature of
// scripts/fit_facet_cosines.
real ggx_mean_cosine(real c, real alpha) {
  real root = sqrt(alpha);
  real level = real(4.5399f) + root * (real(-6.5855f) + root * real(2.7786f));
  real slope = real(10.1567f) + root * (real(-8.4211f) + root * real(1.9925f));
  real curve = real(-17.4517f) + root * (real(19.2256f) - root * real(6.5784f));
  level = real(0.0047f) + root * (real(-0.2894f) + root * level);
  slope = real(0.1532f) + root * (real(-3.5316f) + root * slope);
  curve = real(-0.1155f) + root * (real(3.9313f) + root * curve);
  return sqrt(min(real(1), max(c * c + root * (level + c * (slope + c * curve)), real(0))));
}

// Returns the cosine at which a single facet reflects, by Fresnel's equations, about as much as facets do that are
// seen at c. Towards grazing it is less than their mean, since the steeper ones reflect more.
real ggx_fresnel_cosine(real c, real alpha) {
  real mean_value = ggx_mean_cosine(c, alpha);
  return mean_value + (ggx_schlick_cosine(c, alpha) - mean_value) * ((1 - c) * (1 + c));
}

// Returns the mean of `ggx_grazing` over the hemisphere, weighted by the cosine.
real ggx_mean_grazing(real alpha) {
  return 1 / (21 * (1 + alpha * (real(2.603f) + alpha * (real(14.151f) - alpha * real(0.653f)))));
}

// Returns the factor of the lobe of what facets scatter to each other, given their mean reflectance (Kulla
// and Conty 2017).
vec3 ggx_further(vec3 reflectance, real alpha) {
  real missing = ggx_mean_missing(alpha);
  return reflectance * reflectance * ((1 - missing) / (PI * missing)) / (vec3(1) - reflectance * missing);
}

// Returns the lobe of what facets scatter to each other.
real ggx_further_lobe(vec3 u, vec3 v, real alpha) {
  return ggx_missing(u.z, alpha) * ggx_missing(v.z, alpha);
}
