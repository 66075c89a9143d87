// Adds the picture's colours to a sum of several.
layout(location = 0) out vec4 colour;

void main() { colour = texelFetch(colours, ivec2(gl_FragCoord.xy), 0); }
