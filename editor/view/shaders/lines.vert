// Transforms edges and points of a mesh, slightly toward the eye so that faces do not hide them.
layout(location = 0) in vec3 position;
uniform mat4 to_clip;
uniform float nearer;
uniform float point_size;

void main() {
  gl_Position = to_clip * vec4(position, 1);
  gl_Position.z -= nearer;
  gl_PointSize = point_size;
}
