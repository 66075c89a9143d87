// Returns the half vector of both directions inside the film. Tangential components are summed outside, where
// they are not rounded between.
vec3 half_inside(vec3 u, vec3 v, real nreal) {
  vec3 h = u + v;
  real m = (nreal - 1) * (nreal + 1);
  return vec3(h.x, h.y, sqrt(m + u.z * u.z) + sqrt(m + v.z * v.z));
}

// Returns (normal . h)^n for the normal (normal.x, 0, normal.y) and h of any length, by the tangent.
real tilted_power(vec3 h, real n, vec2 normal) {
  real x = h.x * normal.y - h.z * normal.x;
  real z = h.x * normal.x + h.z * normal.y;
  return z > 0 ? exp(-n / 2 * log1p((x * x + h.y * h.y) / (z * z))) : real(0);
}

// Returns |sqrt(r) + exp(i 2 pi order) sqrt(t)|^2, as a sum without cancellation. Fringes above order 20
// fade, and are averaged from 100 on: three wavelengths cannot resolve them, and the phase exceeds float
// precision.
real two_beams(real r, real t, real order) {
  real a = sqrt(r);
  real b = sqrt(t);
  real place = order - floor(order) - real(0.5);
  real s = sin(PI * place);
  real fringes = (a - b) * (a - b) + 4 * a * b * s * s;
  real resolved = min(real(1), max(real(0), (100 - order) / 80));
  return resolved * fringes + (1 - resolved) * (r + t);
}

// Terms common to all channels: exponent and normal of the inner lobe, both lobes without factors that depend
// on the index of refraction, 1 - u.h, and the path length in the film over that index.
struct Film {
  real m;
  vec2 inner_normal;
  real outer;
  real inner;
  real one_minus_cos;
  real path;
};

real film_channel(Film film, vec3 u, vec3 v, real nreal, real lambda, real ks, real kt) {
  real next = nreal + 1;
  real f0 = (nreal - 1) * (nreal - 1) / (next * next);
  real entering = 4 / (next * next);  // (1 - f0) / nreal
  real inner = tilted_power(half_inside(u, v, nreal), film.m, film.inner_normal);
  real reflected = ks * schlick_fresnel(f0, film.one_minus_cos) * film.outer;
  return two_beams(reflected, kt * entering * entering * film.inner * inner, nreal / lambda * film.path);
}

vec3 granier(vec3 u, vec3 v, vec3 nreal, real d, real n, real m, real tilt, vec3 ks, vec3 kt, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  real c = cosine_at_half(u, v);
  vec3 e = u - v;
  Film film;
  film.m = m;
  film.inner_normal = vec2(sin(tilt), cos(tilt));
  film.outer = half_power_scale(n) * half_power(u, v, n);
  film.inner = half_power_scale(m) * one_minus_fifth_power(u.z) * one_minus_fifth_power(v.z);
  film.one_minus_cos = (e.x * e.x + e.y * e.y + e.z * e.z) / (4 * (1 + c));
  film.path = 2 * d * min(real(1), (u.z + v.z) / (2 * c));
  return bounded(kd / PI + vec3(film_channel(film, u, v, nreal.x, real(645), ks.x, kt.x),
                                film_channel(film, u, v, nreal.y, real(525), ks.y, kt.y),
                                film_channel(film, u, v, nreal.z, real(445), ks.z, kt.z)));
}
