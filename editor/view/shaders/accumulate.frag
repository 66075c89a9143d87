// Adds an image to the sum of several passes.
layout(location = 0) out vec4 colour;

void main() { colour = texelFetch(colours, ivec2(gl_FragCoord.xy), 0); }
