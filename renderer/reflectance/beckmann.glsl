// Beckmann's microfacet distribution (Gaussian slopes) with Smith's masking-shadowing.

// Returns Smith's masking over the cosine, S(w) / w.z, which is never 0/0 at grazing.
real smith_over_cosine(vec3 w, real ax, real ay) {
  real x = ax * w.x;
  real y = ay * w.y;
  real s = sqrt(x * x + y * y);
  real a = min(w.z / max(s, real(1e-30f)), real(30));
  return 1 / (w.z * (1 - erfc(a) / 2) + s * exp(-a * a) / (2 * sqrt(PI)));
}

// Returns D S(u) S(v) / (4 cos(theta_u) cos(theta_v)); rms slopes are ax / sqrt(2) and ay / sqrt(2).
real beckmann(vec3 u, vec3 v, real ax, real ay) {
  vec3 h = u + v;
  real x = h.x / (ax * h.z);
  real y = h.y / (ay * h.z);
  real facets = exp(2 * log1p(tan2_of_half(h)) - (x * x + y * y)) / (PI * ax * ay);
  return facets / 4 * (smith_over_cosine(u, ax, ay) * smith_over_cosine(v, ax, ay));
}
