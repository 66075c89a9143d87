// Returns the area inside the unit disc of the ellipse with semi-axes r and ry. Where it crosses the circle,
// both inverse sines of the textbook form are angles of points without differences.
real neumann_area(real r, real ry) {
  real a = max(r, ry);
  real b = min(r, ry);
  if (a <= 1) return PI * a * b;
  if (b >= 1) return PI;
  real outside = sqrt((a - 1) * (a + 1));
  real inside = sqrt((1 - b) * (1 + b));
  return 2 * a * b * atan2(inside, outside) +
         2 * atan2(b * outside, a * inside);
}

// Returns true if v, projected to the disc, is in the ellipse about u's mirror direction or, for retro, about
// u. The edge is a step, placed slightly outside, so that r = 2 covers the whole disc also after rounding.
bool neumann_is_inside(vec3 u, vec3 v, real r, real ry, bool retro) {
  real x = (retro ? v.x - u.x : v.x + u.x) / r;
  real y = (retro ? v.y - u.y : v.y + u.y) / ry;
  return x * x + y * y <= 1 + real(1e-6f);
}

// The print has pi/r inside a circle; 1 over the area conserves energy, and r = 2 is Lambert.
vec3 neumann(vec3 u, vec3 v, real r, real ry, bool retro, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  real lobe = neumann_is_inside(u, v, r, ry, retro) ? 1 / neumann_area(r, ry) : real(0);
  return bounded(kd / PI + ks * lobe);
}
