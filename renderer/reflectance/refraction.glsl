// Returns the refracted direction inside, of light that comes along w. It points up as w does.
vec3 refracted(vec3 w, real n) { return vec3(w.x / n, w.y / n, sqrt((n - 1) * (n + 1) + w.z * w.z) / n); }

// Returns the transmittance of a smooth dielectric, 1 - fresnel(c, n, 0), without cancellation.
real transmittance(real c, real n) {
  real a = sqrt((n - 1) * (n + 1) + c * c);
  real s = a + c;
  real p = n * c + a / n;
  return 2 * a * c * (1 / (s * s) + 1 / (p * p));
}
