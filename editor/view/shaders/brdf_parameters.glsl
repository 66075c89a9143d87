// What a model's call reads its parameters with.
uniform samplerBuffer terms;
int first_parameter;
vec3 parameter(int k) { return texelFetch(terms, first_parameter + k).xyz; }
