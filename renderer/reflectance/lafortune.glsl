// Returns (c - b) / c for b = Cx ux vx + Cy uy vy + Cz uz vz and c the largest magnitude of the C's. With the
// sign s and w = 1 - |C|/c of each axis it is the sum of (u - s v)^2/2 + w s u v, whose terms are all >= 0:
// the cosine itself has lost the digits that a large n needs. (-1, -1, 1) gives half the squared distance
// from the mirror direction, as in mirror_power.
real lafortune_shortfall(real u, real v, real factor, real largest) {
  real s = factor < 0 ? real(-1) : real(1);
  real difference = u - s * v;
  return difference * difference / 2 + (1 - abs(factor) / largest) * (s * (u * v));
}

real lafortune_largest(real cx, real cy, real cz) { return max(abs(cx), max(abs(cy), abs(cz))); }

// Returns log(b / c), or -1e30 if b <= 0. Far from the lobe's axis b itself is more accurate.
real lafortune_log_cosine(vec3 u, vec3 v, real cx, real cy, real cz) {
  real largest = lafortune_largest(cx, cy, cz);
  if (!(largest > 0)) return real(-1e30f);
  real shortfall = lafortune_shortfall(u.x, v.x, cx, largest) + lafortune_shortfall(u.y, v.y, cy, largest) +
                   lafortune_shortfall(u.z, v.z, cz, largest);
  if (shortfall < real(0.5)) return log1p(-shortfall);
  real cosine = (cx * (u.x * v.x) + cy * (u.y * v.y) + cz * (u.z * v.z)) / largest;
  return cosine > 0 ? log(cosine) : real(-1e30f);
}

// Returns b^n, and 0 if b <= 0, also for n = 0.
real lafortune_lobe(vec3 u, vec3 v, real n, real cx, real cy, real cz) {
  real log_cosine = lafortune_log_cosine(u, v, cx, cy, cz);
  return log_cosine > real(-1e29f) ? exp(n * (log_cosine + log(lafortune_largest(cx, cy, cz)))) : real(0);
}

vec3 lafortune(vec3 u, vec3 v, real n, vec3 kp, real cx, real cy, real cz) {
  if (below_horizon(u, v)) return vec3(0);
  return bounded(kp / PI + vec3(lafortune_lobe(u, v, n, cx, cy, cz)));
}
