// An ideal mirror reflects only by its delta part.
vec3 specular(vec3 u, vec3 v, vec3 ks) { return vec3(0); }
