// Returns a and b of a + ib = sqrt((n + ik)^2 - s2), from the cosine c and the squared sine s2. t = n^2 - k^2
// - s2 comes from m + c^2, since near n = 1 the difference cancels.
vec3 fresnel_root(real c, real s2, real n, real k) {
  real m = (n - 1) * (n + 1) - k * k;
  real t = n < real(0.5) ? n * n - (k * k + s2) : m + c * c;
  real nk = n * k;
  real q = sqrt(t * t + 4 * nk * nk);
  if (t < 0) {
    real b = sqrt((q - t) / 2);
    return vec3(nk / b, b, 0);
  }
  real a = sqrt((q + t) / 2);
  return vec3(a, a > 0 ? nk / a : real(0), 0);
}

// Computes the Fresnel reflectance of unpolarised light from air at n + ik; k = 0 is a dielectric, n = 0 a
// perfect conductor. c is the cosine of incidence and s2 the squared sine. With a + ib of `fresnel_root`,
// every term is a sum of squares. a - c comes from a^2 - c^2 = m + b^2, since near n = 1 the difference
// cancels.
real fresnel(real c, real s2, real n, real k) {
  if (n == 1 && k == 0) return real(0);
  if (n <= 0 || c <= 0) return real(1);
  real m = (n - 1) * (n + 1) - k * k;
  vec3 root = fresnel_root(c, s2, n, k);
  real a = root.x;
  real b2 = root.y * root.y;
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

// Computes the same for a dielectric from n^2 - 1, which keeps more digits where n is nearly 1 than n itself.
real fresnel_of_excess(real c, real s2, real excess) {
  if (excess == 0) return real(0);
  real a = sqrt(excess + c * c);
  real perpendicular = excess / ((a + c) * (a + c));
  real parallel = (a * c - s2) / (a * c + s2);
  return min(real(1), perpendicular * perpendicular * (1 + parallel * parallel) / 2);
}

// Returns the squared sine of incidence at the microfacet that reflects v to u. u - v gives it without
// cancellation.
real squared_sine_at_half(vec3 u, vec3 v) {
  vec3 e = u - v;
  return min(real(1), (e.x * e.x + e.y * e.y + e.z * e.z) / 4);
}

// Computes Fresnel at the microfacet that reflects v to u.
real fresnel_at_half(vec3 u, vec3 v, real n, real k) {
  return fresnel(cosine_at_half(u, v), squared_sine_at_half(u, v), n, k);
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
