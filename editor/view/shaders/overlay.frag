uniform float width;
uniform float opacity;
in vec4 strip_colour;
noperspective in float across;
layout(location = 0) out vec4 colour;

void main() {
  float cover = clamp(width / 2 + 0.5 - abs(across), 0, 1) * opacity;
  colour = vec4(strip_colour.rgb, strip_colour.a * cover);
}
