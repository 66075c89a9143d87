// The Kirchhoff geometry factor 4 (u.h / n.h)^2 with the geometric-optics limit of the wave-optics series is
// exactly the Beckmann lobe. A smooth surface is a lobe of width 1e-4.
vec3 kajiya(vec3 u, vec3 v, real sigma, real taux, real tauy, real nreal, real nimag, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  real ax = max(real(1e-4), 2 * sigma / taux);
  real ay = max(real(1e-4), 2 * sigma / tauy);
  return bounded(kd / PI + ks * (fresnel_at_half(u, v, nreal, nimag) * beckmann(u, v, ax, ay)));
}
