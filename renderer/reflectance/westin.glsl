// Evaluates `he` without its effective roughness.
vec3 westin(vec3 u, vec3 v, real sigma, real tau, vec3 lambda, real nreal, real nimag, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  return kirchhoff(u, v, sigma, sigma, tau, lambda, nreal, nimag, ks, kd);
}

vec3 westin_specular(vec3 u, real sigma, real tau, vec3 lambda, real nreal, real nimag, vec3 ks) {
  return kirchhoff_specular(u, sigma, sigma, tau, lambda, nreal, nimag, ks);
}
