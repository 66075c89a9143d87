// Transforms the triangles of a mesh instance.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 value;
layout(location = 3) in vec2 uv;
uniform mat4 to_camera;
uniform mat4 to_clip;
uniform mat3 normal_to_camera;
out vec3 camera_place;
out vec4 camera_normal;
out vec4 vertex_value;
out vec2 vertex_uv;

void main() {
  camera_place = (to_camera * vec4(position, 1)).xyz;
  camera_normal = vec4(normal_to_camera * normal.xyz, normal.w);
  vertex_value = value;
  vertex_uv = uv;
  gl_Position = to_clip * vec4(position, 1);
}
