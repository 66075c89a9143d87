// Computes the diffuse part: what the coat transmits from v and to u. The paper's two factors 1 - R are (1 -
// R0) times the brackets, and its constant has (1 - R0) once in the denominator; the print lost one.
vec3 coupled(vec3 u, vec3 v, vec3 rm, vec3 r0) {
  if (below_horizon(u, v)) return vec3(0);
  real brackets = one_minus_fifth_power(u.z) * one_minus_fifth_power(v.z);
  return bounded(rm * (vec3(1) - r0) * (21 * brackets / (20 * PI)));
}

// Returns the weight of the delta part.
vec3 coupled_specular(vec3 u, vec3 r0) { return schlick_fresnel(r0, 1 - u.z); }
