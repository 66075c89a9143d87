// All that an ideal mirror reflects is in its Dirac part.
vec3 specular(vec3 u, vec3 v, vec3 ks) { return vec3(0); }
