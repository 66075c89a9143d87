// Expands lines to strips of constant screen width, one pixel wider for antialiased edges.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
uniform vec2 screen;  // pixels
uniform float width;  // pixels
uniform float nearer;
in vec4 line_colour[];
out vec4 strip_colour;
noperspective out float across;

void put(vec4 clip, vec2 aside, float side, vec4 colour) {
  gl_Position = clip + vec4(aside * 2 / screen * clip.w * side, -nearer, 0);
  strip_colour = colour;
  across = side * (width / 2 + 1);
  EmitVertex();
}

void main() {
  vec4 a = gl_in[0].gl_Position;
  vec4 b = gl_in[1].gl_Position;
  // The part behind the eye cannot be projected.
  float least = 1e-5;
  if (a.w < least && b.w < least) return;
  if (a.w < least) a = mix(a, b, (least - a.w) / (b.w - a.w));
  if (b.w < least) b = mix(b, a, (least - b.w) / (a.w - b.w));
  vec2 along = (b.xy / b.w - a.xy / a.w) * screen;
  float size = length(along);
  vec2 aside = size > 0 ? vec2(-along.y, along.x) / size * (width / 2 + 1) : vec2(0);
  put(a, aside, -1, line_colour[0]);
  put(a, aside, 1, line_colour[0]);
  put(b, aside, -1, line_colour[1]);
  put(b, aside, 1, line_colour[1]);
  EndPrimitive();
}
