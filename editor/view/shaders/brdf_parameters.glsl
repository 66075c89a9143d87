// What a model's call reads its parameters with.
uniform samplerBuffer terms;
int first_parameter;
vec3 parameter(int k) { return texelFetch(terms, first_parameter + k).xyz; }

// The tangent, the other direction along the surface, and the normal, in the camera's coordinates.
mat3 frame_at(ivec2 place, vec3 n) {
  float side = n.z >= 0 ? 1 : -1;
  float a = -1 / (side + n.z);
  float b = n.x * n.y * a;
  vec3 x = vec3(1 + side * n.x * n.x * a, side * b, -side * n.x);
  vec3 y = vec3(b, side + n.y * n.y * a, -n.y);
  float angle = (texelFetch(normals, place, 0).z - 0.5) * 6.28318531;
  vec3 tangent = x * cos(angle) + y * sin(angle);
  return mat3(tangent, cross(n, tangent), n);
}
