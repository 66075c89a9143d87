// Functions shared by the models. All directions are unit vectors in the local frame, z along the normal, u
// towards the eye and v towards the light.

// Treats a cosine this small as the horizon, so that no denominator of a formula can overflow.
bool below_horizon(vec3 u, vec3 v) { return !(u.z > 1e-12f && v.z > 1e-12f); }

// Clamps a result to finite values >= 0; NaN becomes 0. It is the last step of every model.
real bounded_channel(real f) { return f > 0 ? min(f, real(1e30f)) : real(0); }
vec3 bounded(vec3 f) { return vec3(bounded_channel(f.x), bounded_channel(f.y), bounded_channel(f.z)); }

// Returns tan^2 of the angle between the normal and h = u + v, which need not have unit length.
real tan2_of_half(vec3 h) { return (h.x * h.x + h.y * h.y) / (h.z * h.z); }

// Returns (u . r)^n, r the mirror direction of v. It uses the distance of u and r, since the cosine has lost
// the digits that a large n needs.
real mirror_power(vec3 u, vec3 v, real n) {
  real x = u.x + v.x;
  real y = u.y + v.y;
  real z = u.z - v.z;
  real d2 = x * x + y * y + z * z;
  return d2 >= 2 ? real(0) : exp(n * log1p(-d2 / 2));
}

// Returns (n . h)^n.
real half_power(vec3 u, vec3 v, real n) { return exp(-n / 2 * log1p(tan2_of_half(u + v))); }

// Returns u . h = v . h, where h has unit length.
real cosine_at_half(vec3 u, vec3 v) {
  vec3 h = u + v;
  return min(real(1), sqrt(h.x * h.x + h.y * h.y + h.z * h.z) / 2);
}

real fifth_power(real x) {
  real x2 = x * x;
  return x2 * x2 * x;
}

// Returns 1 - (1 - c)^5 without the subtraction, so that small c lose no digits.
real one_minus_fifth_power(real c) { return c * (5 + c * (-10 + c * (10 + c * (-5 + c)))); }

// Returns the factor by which the lobe (n . h)^n reflects 1 at normal incidence, and less elsewhere.
real half_power_scale(real n) {
  return (n + 2) * (n + 4) / (8 * PI * (exp(real(-0.34657359027997265) * n) + n));
}
