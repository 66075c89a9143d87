// Evaluates the energy-preserving Oren-Nayar model (Portsmouth, Kutz and Hill 2025): Fujii's single scattering
// with the published albedo, and a lobe with what that lacks. Differences that vanish at grazing are
// rearranged, so that no digits are lost.

// Returns by how much white facets of roughness 1 reflect less than 1 in single scattering, as a part of what
// they reflect at normal incidence (equation 14 of the paper, taken from 1): 0 at grazing.
real eon_missing(vec3 u) {
  real sine = sqrt(u.x * u.x + u.y * u.y);
  real elevation = atan2(u.z, sine);
  real level = (PI / 2 - real(2) / 3) * u.z * u.z / (1 + sine);
  real slope = sine * u.z * (1 + sine + sine * sine) / (1 + sine);
  return max(real(0), (level + sine * elevation + sine * sine * u.z - slope * 2 / 3) / PI);
}

// Returns single scattering relative to that of a smooth surface, before it is scaled (Fujii's improved form).
real eon_single(vec3 u, vec3 v, real rough) {
  real along = u.x * v.x + u.y * v.y;
  if (along >= 0) return 1 + rough * along / max(u.z, v.z);
  // 1 + along, without the subtraction.
  real sines = sqrt((u.x * u.x + u.y * u.y) * (v.x * v.x + v.y * v.y));
  real across = u.x * v.y - u.y * v.x;
  real u2 = u.z * u.z;
  real v2 = v.z * v.z;
  real opposite = (u2 + v2 - u2 * v2) / (1 + sines) + across * across / (sines - along);
  return 1 - rough + rough * opposite;
}

// Evaluates the model above the horizon.
vec3 eon_value(vec3 u, vec3 v, real rough, vec3 kd) {
  real at_normal = real(1) / 2 - 2 / (3 * PI);  // what is missing at normal incidence
  real mean_missing = real(6) / 5 / PI - real(1) / 6;
  real scale = 1 / (1 + at_normal * rough);
  real unscattered = scale * rough * mean_missing;
  vec3 further = kd * kd * ((1 - unscattered) / PI) / (vec3(1) - kd * unscattered);
  real lobe = scale * rough * eon_missing(u) * eon_missing(v) / mean_missing;
  return kd * (scale * eon_single(u, v, rough) / PI) + further * lobe;
}
