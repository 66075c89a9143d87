// Evaluates the Henyey-Greenstein phase function for light along v scattered towards u, both pointing away.
// The denominator 1 + g^2 - 2 g cos is written as sums, for narrow lobes.
real henyey_greenstein(vec3 u, vec3 v, real g) {
  vec3 forward = u + v;
  vec3 backward = u - v;
  real f2 = forward.x * forward.x + forward.y * forward.y + forward.z * forward.z;
  real b2 = backward.x * backward.x + backward.y * backward.y + backward.z * backward.z;
  real q = g > 0 ? (1 - g) * (1 - g) + g * f2 : (1 + g) * (1 + g) - g * b2;
  return (1 - g) * (1 + g) / (4 * PI * q * sqrt(q));
}

// Computes single scattering in the layer: the Lommel-Seeliger law, refracted in and out.
real scattered_once(vec3 u, vec3 v, real nreal, real g, real depth) {
  vec3 a = refracted(u, nreal);
  vec3 b = refracted(v, nreal);
  real kept = -expm1(-depth * (1 / a.z + 1 / b.z));
  return henyey_greenstein(a, b, g) * kept / (nreal * nreal * (a.z + b.z));
}

vec3 hanrahan(vec3 u, vec3 v, real nreal, real g, vec3 albedo, real depth, real rough, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  real transmitted = transmittance(u.z, nreal) * transmittance(v.z, nreal);
  real surface = fresnel_at_half(u, v, nreal, real(0)) * beckmann(u, v, rough, rough);
  return bounded(ks * surface + (albedo * scattered_once(u, v, nreal, g, depth) + kd / PI) * transmitted);
}
