// Reads the parameters of a model's call, and what layers above the BRDF transmit.
uniform samplerBuffer terms;
int first_parameter;
int first_transmission;  // the table's first row; 0: there are no layers
vec3 parameter(int k) { return texelFetch(terms, first_parameter + k).xyz; }
vec3 transmitted(float c) {
  int row = transmission_row(c);
  vec3 below = texelFetch(terms, first_transmission + row).xyz;
  return mix(below, texelFetch(terms, first_transmission + row + 1).xyz, transmission_fraction(c, row));
}
vec3 through_layers(vec3 u, vec3 v) {
  return first_transmission == 0 ? vec3(1) : transmitted(u.z) * transmitted(v.z);
}
