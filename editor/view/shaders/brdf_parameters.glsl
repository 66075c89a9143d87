// Reads the parameters of a model's call.
uniform samplerBuffer terms;
int first_parameter;
vec3 parameter(int k) { return texelFetch(terms, first_parameter + k).xyz; }
