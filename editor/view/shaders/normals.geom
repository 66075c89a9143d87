// Draws a line along each normal, of constant length in world space.
layout(points) in;
layout(line_strip, max_vertices = 2) out;
uniform mat4 camera_to_clip;
uniform mat4 to_camera;
uniform mat3 normal_to_camera;
uniform float size;
uniform float nearer;
in vec4 direction[];

void put(vec3 place) {
  gl_Position = camera_to_clip * vec4(place, 1);
  gl_Position.z -= nearer;
  EmitVertex();
}

void main() {
  vec3 along = normal_to_camera * direction[0].xyz;
  float along_size = length(along);
  if (direction[0].w < 0.5 || !(along_size > 0)) return;
  vec3 from = (to_camera * gl_in[0].gl_Position).xyz;
  put(from);
  put(from + along * (size / along_size));
  EndPrimitive();
}
