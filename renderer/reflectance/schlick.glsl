// Clamps a layer's roughness or isotropy to where the lobe is representable.
real schlick_roughness(real r) { return max(r, real(1e-8f)); }
real schlick_isotropy(real p) { return max(p, real(1e-4f)); }

// Returns Z, the distribution of microfacet normals h: GGX with alpha^2 = r, without its 1/pi.
real schlick_zenith(vec3 h, real r) {
  real planar2 = h.x * h.x + h.y * h.y;
  real ratio = (planar2 + h.z * h.z) / (planar2 + r * (h.z * h.z));
  return r * ratio * ratio;
}

// Returns A, the azimuthal factor: the argument is the cosine of h's projection with x, not its angle as the
// print has it.
real schlick_azimuth(vec3 h, real p) {
  real planar2 = h.x * h.x + h.y * h.y;
  if (planar2 <= real(1e-24f) * (h.z * h.z)) return real(1);
  return sqrt(p * planar2 / (p * p * (h.y * h.y) + h.x * h.x));
}

// Returns c/G(c), where G is the masking of facets.
real schlick_visible(real r, real c) { return r + (1 - r) * c; }

// Returns (1 - G(cu) G(cv))/(G(cu) G(cv)), the light scattered between facets, without the difference.
real schlick_between_facets(vec3 u, vec3 v, real r) {
  return r * ((1 - u.z) * schlick_visible(r, v.z) + u.z * (1 - v.z)) / (u.z * v.z);
}

// Returns D(r, p) of one layer; a layer of roughness 0 is a mirror, which is not part of f.
real schlick_layer(vec3 u, vec3 v, real roughness, real isotropy) {
  if (!(roughness > 0)) return real(0);
  real r = schlick_roughness(roughness);
  vec3 h = u + v;
  real facets = schlick_zenith(h, r) * schlick_azimuth(h, schlick_isotropy(isotropy));
  return (facets + schlick_between_facets(u, v, r)) /
         (4 * PI * schlick_visible(r, u.z) * schlick_visible(r, v.z));
}

// The second layer receives what the first does not reflect; the print weights it with 1 - S'.
vec3 schlick_second(real c, vec3 sc, vec3 dc) { return schlick_transmittance(sc, c) * schlick_fresnel(dc, 1 - c); }

vec3 schlick(vec3 u, vec3 v, vec3 sc, real sr, real sp, bool ly, vec3 dc, real dr, real dp) {
  if (below_horizon(u, v)) return vec3(0);
  real c = cosine_at_half(u, v);
  vec3 f = schlick_fresnel(sc, 1 - c) * schlick_layer(u, v, sr, sp);
  if (ly) f += schlick_second(c, sc, dc) * schlick_layer(u, v, dr, dp);
  return bounded(f);
}

// Returns the weight of the delta part.
vec3 schlick_specular(vec3 u, vec3 sc, real sr, bool ly, vec3 dc, real dr) {
  vec3 weight = sr > 0 ? vec3(0) : schlick_fresnel(sc, 1 - u.z);
  if (ly && !(dr > 0)) weight += schlick_second(u.z, sc, dc);
  return weight;
}
