// Radiance of a studio sky, brighter upwards, with a large soft lamp. In the common subset of GLSL and C++.
vec3 studio_sky(vec3 d) {
  real height = 0.5 + 0.5 * d.y;
  vec3 open = mix(vec3(0.15, 0.145, 0.14), vec3(0.42, 0.47, 0.55), smoothstep(0.3, 0.75, height));
  real lamp = max(dot(d, vec3(-0.424, 0.742, 0.519)), 0.0);
  real lamp2 = lamp * lamp;
  real lamp8 = lamp2 * lamp2 * lamp2 * lamp2;
  return open + vec3(3.4, 3.2, 3) * (lamp8 * lamp8 * lamp8);
}
