// Returns tan(theta) erfc(tau / (2 sigma) cot(theta)).
real hidden_slope(vec3 w, real sigma, real tau) {
  real sine = sqrt(w.x * w.x + w.y * w.y);
  return sine / w.z * erfc(min(tau * w.z / max(2 * sigma * sine, real(1e-30)), real(30)));
}

// Returns the effective roughness of what both directions see. The paper's root z of sqrt(pi/2) z = (sigma/4)
// K' exp(-z^2/(2 sigma^2)) is Lambert's function: (z/sigma)^2 = W(K^2), and the roughness sigma/sqrt(1 + W).
real effective_roughness(vec3 u, vec3 v, real sigma, real tau) {
  real k = (hidden_slope(u, sigma, tau) + hidden_slope(v, sigma, tau)) / (2 * sqrt(2 * PI));
  return k > real(1e-15) ? sigma / sqrt(1 + lambert_w(2 * log(k))) : sigma;
}

vec3 he(vec3 u, vec3 v, real sigma, real tau, vec3 lambda, real nreal, real nimag, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  return kirchhoff(u, v, sigma, effective_roughness(u, v, sigma, tau), tau, lambda, nreal, nimag, ks, kd);
}

vec3 he_specular(vec3 u, real sigma, real tau, vec3 lambda, real nreal, real nimag, vec3 ks) {
  if (below_horizon(u, u)) return vec3(0);
  return kirchhoff_specular(u, sigma, effective_roughness(u, u, sigma, tau), tau, lambda, nreal, nimag, ks);
}
