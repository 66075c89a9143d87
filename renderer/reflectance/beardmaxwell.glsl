// Returns B of the Cauchy microfacet distribution B hz / (sigma^2 hz^2 + hx^2 + hy^2), which normalises D
// cos(theta_h): a^2 / (2 pi (atanh(a)/a - 1)) with a^2 = 1 - sigma^2, as a series where that is 0/0.
real cauchy_scale(real sigma) {
  real a2 = (1 - sigma) * (1 + sigma);
  real a = sqrt(abs(a2));
  if (a2 > real(0.1)) return a2 / (2 * PI * (log((1 + a) / sigma) / a - 1));
  if (a2 < real(-0.1)) return -a2 / (2 * PI * (1 - atan2(a, real(1)) / a));
  real series = real(0);
  for (int j = 12; j >= 0; --j) series = series * a2 + 1 / real(2 * j + 3);
  return 1 / (2 * PI * series);
}

// Computes shadowing and obscuration: 1 in the mirror direction, h = n.
real shadowing(vec3 s, vec3 e, real omega, real tau) {
  real theta = atan2(sqrt(s.x * s.x + s.y * s.y), s.z) / omega;
  real beta = atan2(sqrt(e.x * e.x + e.y * e.y + e.z * e.z), sqrt(s.x * s.x + s.y * s.y + s.z * s.z));
  real kept = tau > 0 ? exp(-2 * beta / tau) : real(0);
  return (1 + theta * kept) / (1 + theta);
}

// Computes the first-surface term without its weight. s is 2 c h, as the distribution expects.
real first_surface(vec3 u, vec3 v, real omega, real tau, real nreal, real nimag, real sigma) {
  vec3 s = u + v;
  real c = cosine_at_half(u, v);
  real facets = cauchy_scale(sigma) * 2 * c * s.z / (sigma * sigma * s.z * s.z + s.x * s.x + s.y * s.y);
  return fresnel_at_half(u, v, nreal, nimag) * facets * shadowing(s, u - v, omega, tau) / (4 * u.z * v.z);
}

vec3 beardmaxwell(vec3 u, vec3 v, real omega, real tau, real nreal, real nimag, vec3 rs, vec3 rd, vec3 rv,
                  real sigma) {
  if (below_horizon(u, v)) return vec3(0);
  vec3 diffuse = (rd + rv * (2 / (u.z + v.z))) / PI;
  return bounded(rs * first_surface(u, v, omega, tau, nreal, nimag, sigma) + diffuse);
}
