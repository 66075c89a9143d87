// Returns Beckmann's D without its 1/pi.
real torrance_beckmann(vec3 u, vec3 v, real m) {
  real t2 = tan2_of_half(u + v);
  return exp(2 * log1p(t2) - t2 / (m * m)) / (m * m);
}

// Returns the V-groove masking-shadowing G/(cu cv). With the cosines lo <= hi it is min(1/(cu cv), (1 +
// lo/hi)/(u.h)^2), which has no 0/0.
real torrance_grooves(vec3 u, vec3 v, real c) {
  return min(1 / (u.z * v.z), (1 + min(u.z, v.z) / max(u.z, v.z)) / (c * c));
}

vec3 torrance(vec3 u, vec3 v, real rough, real nreal, real nimag, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  real c = cosine_at_half(u, v);
  real facets = torrance_beckmann(u, v, rough) * torrance_grooves(u, v, c) / (4 * PI);
  return bounded(kd / PI + ks * (facets * fresnel_at_half(u, v, nreal, nimag)));
}
