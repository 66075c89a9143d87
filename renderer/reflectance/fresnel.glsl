// Computes the Fresnel reflectance of unpolarised light from air at n + ik; k = 0 is a dielectric, n = 0 a
// perfect conductor. c is the cosine of incidence and s2 the squared sine. With a + ib = sqrt((n + ik)^2 -
// s2), every term is a sum of squares. a - c comes from a^2 - c^2 = m + b^2 and t = n^2 - k^2 - s2 from m +
// c^2, since near n = 1 the differences cancel.
real fresnel(real c, real s2, real n, real k) {
  if (n == 1 && k == 0) return real(0);
  if (n <= 0 || c <= 0) return real(1);
  real m = (n - 1) * (n + 1) - k * k;
  real t = n < real(0.5) ? n * n - (k * k + s2) : m + c * c;
  real nk = n * k;
  real q = sqrt(t * t + 4 * nk * nk);
  real a = sqrt((q + t) / 2);
  real b = a > 0 ? nk / a : real(0);
  if (t < 0) {
    b = sqrt((q - t) / 2);
    a = nk / b;
  }
  real b2 = b * b;
  real difference = (m + b2) / (a + c);
  real sum = a + c;
  real perpendicular = (difference * difference + b2) / (sum * sum + b2);
  real below = a * c - s2;
  real above = a * c + s2;
  real outer = b2 * c * c;
  real parallel = above + outer > 0 ? (below * below + outer) / (above * above + outer) : real(1);
  return min(real(1), perpendicular * (1 + parallel) / 2);
}
real fresnel(real c, real n, real k) { return fresnel(c, (1 - c) * (1 + c), n, k); }

// Computes Fresnel at the microfacet that reflects v to u. u - v gives the sine without cancellation.
real fresnel_at_half(vec3 u, vec3 v, real n, real k) {
  vec3 e = u - v;
  return fresnel(cosine_at_half(u, v), min(real(1), (e.x * e.x + e.y * e.y + e.z * e.z) / 4), n, k);
}

// Computes Schlick's approximation from the reflectance at normal incidence and 1 - c.
vec3 schlick_fresnel(vec3 normal, real one_minus_cos) {
  return normal + (vec3(1) - normal) * fifth_power(one_minus_cos);
}

// Computes 1 minus Schlick's approximation from c, without the difference, which cancels at grazing.
vec3 schlick_transmittance(vec3 normal, real c) { return (vec3(1) - normal) * one_minus_fifth_power(c); }

real schlick_fresnel(real normal, real one_minus_cos) {
  return normal + (1 - normal) * fifth_power(one_minus_cos);
}
