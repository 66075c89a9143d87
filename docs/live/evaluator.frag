// Evaluates a BRDF for pairs of directions, one per pixel. The bits of the values are written, so that a target of
// integers, which every WebGL 2 has, keeps all of their digits.
uniform sampler2D views;
uniform sampler2D lights;
out uvec4 result;
void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  vec3 value = brdf_value(texelFetch(views, place, 0).xyz, texelFetch(lights, place, 0).xyz);
  result = uvec4(floatBitsToUint(value), 1u);
}
