// Returns (n . h)^e, e = ex cos^2(phi_h) + ey sin^2(phi_h), which ex and ey bound also at the pole.
real ashikhmin_power(vec3 h, real ex, real ey) {
  real x2 = h.x * h.x;
  real y2 = h.y * h.y;
  if (x2 + y2 <= real(1e-24f) * (h.z * h.z)) return real(1);
  return exp((ex * x2 + ey * y2) / (x2 + y2) * log1p(tan2_of_half(h)) / -2);
}

vec3 ashikhmin_diffuse(vec3 u, vec3 v, vec3 rs, vec3 rd) {
  real brackets = one_minus_fifth_power(u.z / 2) * one_minus_fifth_power(v.z / 2);
  return rd * (vec3(1) - rs) * (28 * brackets / (23 * PI));
}

// Fresnel is evaluated at the microfacet, at the angle of u and h; the print has the light's angle.
vec3 ashikhmin(vec3 u, vec3 v, real ex, real ey, vec3 rs, vec3 rd) {
  if (below_horizon(u, v)) return vec3(0);
  real c = cosine_at_half(u, v);
  real lobe = sqrt((ex + 1) * (ey + 1)) / (8 * PI) * ashikhmin_power(u + v, ex, ey) / (c * max(u.z, v.z));
  return bounded(schlick_fresnel(rs, 1 - c) * lobe + ashikhmin_diffuse(u, v, rs, rd));
}
