// Multiplies the colours of the faces that have this texture.
uniform sampler2D image;
uniform int number;
layout(location = 0) out vec4 factor;

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  uvec2 face = face_at(place);
  if (is_nothing(face) || int(surface_row(face, 0).a) != number) discard;
  vec2 size = vec2(textureSize(image, 0));
  float level = texelFetch(values, place, 0).a + log2(max(size.x, size.y));
  vec4 texel = textureLod(image, texelFetch(uvs, place, 0).xy, level);
  bool is_of_opaque_part = surface_row(face, 3).z >= 0;
  factor = vec4(is_of_opaque_part ? texel.rgb / max(texel.a, 1e-4) : texel.rgb, 1);
}
