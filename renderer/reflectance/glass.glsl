// Computes what a solid's surface reflects, as a fraction: Fresnel's reflectance. c is the cosine of incidence,
// from outside or, with the inverse index, from inside.
real glass_surface(real c, real index) { return fresnel(c, index, real(0)); }

// Computes the cosine of the refracted direction to the normal, by Snell's law; c as above, and index over 1.
real glass_refracted_cosine(real c, real index) {
  return sqrt((index - 1) * (index + 1) + c * c) / index;
}

// Computes x^power for x from 0 to 1 and a power that is not negative.
real glass_power(real x, real power) {
  if (x > 0) return exp(power * log(x));
  return power > 0 ? real(0) : real(1);
}

// Computes what is left of light after a way through the glass: `left` is what is left of it after `reach`.
vec3 glass_absorbed(vec3 left, real way, real reach) {
  real power = way / reach;
  return vec3(glass_power(left.x, power), glass_power(left.y, power), glass_power(left.z, power));
}

// Computes what a pane transmits with all reflections between its sides, of the reflectance r of a side and
// what one crossing leaves of light: (1 - r)^2 a + (1 - r)^2 r^2 a^3 + ...
real glass_through(real r, real a) { return r < 1 ? (1 - r) * (1 - r) * a / (1 - r * r * a * a) : real(0); }

vec3 glass_pane_transmitted(real c, real index, vec3 left) {
  real r = glass_surface(c, index);
  vec3 a = glass_absorbed(left, real(1), glass_refracted_cosine(c, index));
  return vec3(glass_through(r, a.x), glass_through(r, a.y), glass_through(r, a.z));
}

// Computes what a pane reflects, likewise: r + (1 - r)^2 r a^2 + ...
vec3 glass_pane_reflected(real c, real index, vec3 left) {
  real r = glass_surface(c, index);
  vec3 a = glass_absorbed(left, real(1), glass_refracted_cosine(c, index));
  return vec3(r) + r * a * vec3(glass_through(r, a.x), glass_through(r, a.y), glass_through(r, a.z));
}

// Glass reflects only by its delta part.
vec3 glass(vec3 u, vec3 v, real index, vec3 left, real reach, bool thin) { return vec3(0); }

// Returns the weight of the delta part.
vec3 glass_specular(vec3 u, real index, vec3 left, bool thin) {
  return thin ? glass_pane_reflected(u.z, index, left) : vec3(glass_surface(u.z, index));
}
