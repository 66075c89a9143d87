uniform vec4 line_colour;  // premultiplied
layout(location = 0) out vec4 colour;

void main() { colour = line_colour; }
