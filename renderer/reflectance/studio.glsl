// A dim studio environment: brighter from above, with a soft window at the upper left, where the eye is on
// the z axis.
vec3 studio_radiance(vec3 d) {
  real up = real(0.5f) + real(0.5f) * d.y;
  real window = exp(real(30.0f) * ((-d.x * real(0.55f) + d.y * real(0.65f) + d.z * real(0.524f)) - real(1.0f)));
  vec3 ground = vec3(real(0.10f), real(0.10f), real(0.11f));
  vec3 above = vec3(real(0.42f), real(0.47f), real(0.55f));
  return ground * (1 - up) + above * up + vec3(real(2.5f)) * window;
}
