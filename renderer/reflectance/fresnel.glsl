// Reflectance of a smooth surface for unpolarised light from air, c the cosine of incidence and n + ik the
// surface's index of refraction; k = 0 is a dielectric, n = 0 a perfect conductor. Exact. All terms are sums
// of squares, so large k and grazing c lose no digits.
real fresnel(real c, real n, real k) {
  if (n == 1 && k == 0) return real(0);
  if (n == 0 || c <= 0) return real(1);
  real s2 = (1 - c) * (1 + c);
  real t = (n - 1) * (n + 1) - k * k + c * c;
  real q = sqrt(t * t + 4 * n * n * k * k);
  real a = sqrt((q + abs(t)) / 2);
  real b = a > 0 ? n * k / a : real(0);
  if (t < 0) {
    real swapped = a;
    a = b;
    b = swapped;
  }
  real b2 = b * b;
  real rs = ((a - c) * (a - c) + b2) / ((a + c) * (a + c) + b2);
  real below = a * c - s2;
  real above = a * c + s2;
  real ratio = (below * below + b2 * c * c) / (above * above + b2 * c * c);
  return rs * (1 + ratio) / 2;
}

// Schlick's approximation, from the reflectance at normal incidence and 1 - c.
real schlick_fresnel(real normal, real below_one) {
  real x2 = below_one * below_one;
  return normal + (1 - normal) * (x2 * x2 * below_one);
}
