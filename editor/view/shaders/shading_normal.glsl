// The normal of a fragment of geometry.vert in camera space, towards the eye.
in vec3 camera_place;
in vec4 camera_normal;

// The geometric normal, towards the eye.
vec3 flat_normal(vec3 eye) {
  vec3 n = cross(dFdx(camera_place), dFdy(camera_place));
  float size = length(n);
  if (!(size > 0)) return eye;
  return dot(n, eye) < 0 ? -n / size : n / size;
}

vec3 shading_normal(vec3 eye) {
  vec3 n = flat_normal(eye);
  // A face with a corner that has no normal is flat.
  if (!(camera_normal.w > 0.999 && dot(camera_normal.xyz, camera_normal.xyz) > 0)) return n;
  vec3 smooth_normal = normalize(camera_normal.xyz);
  return dot(smooth_normal, n) < 0 ? -smooth_normal : smooth_normal;
}
