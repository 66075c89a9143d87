// Transforms lines over the scene from camera space.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;
uniform mat4 to_clip;
out vec4 line_colour;

void main() {
  gl_Position = to_clip * vec4(position, 1);
  line_colour = colour;
}
