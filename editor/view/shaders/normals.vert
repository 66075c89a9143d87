layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
out vec4 direction;

void main() {
  gl_Position = vec4(position, 1);
  direction = normal;
}
