// The surroundings in the display mode BRDF: with HAS_MAP an environment map, after object_environment.glsl, and else
// the studio sky. Programs with and without a map differ, since software rasterisers execute both sides of a branch.
// sky.glsl precedes this text; the C++ side is cpu_shading.cpp.
uniform float headlight;  // radiance of a white surface, relative to that of its BRDF for u = v
uniform int light_count;
uniform vec3 light_directions[16];
uniform vec3 light_irradiance[16];

#ifdef HAS_MAP
uniform float sky_limit;  // luminance up to which the map is sampled; its lights have the rest

vec3 sampled_sky(vec3 d) {
  vec3 radiance = environment_radiance(d);
  float luminance = dot(radiance, vec3(0.2126, 0.7152, 0.0722));
  return luminance > sky_limit ? radiance * (sky_limit / luminance) : radiance;
}

// All of it, interpolated between texels.
vec3 visible_sky(vec3 d) { return sky_scale * textureLod(sky_map, sky_place(d), 0).rgb; }
#else
vec3 sampled_sky(vec3 d) { return studio_sky(d); }
vec3 visible_sky(vec3 d) { return studio_sky(d); }
#endif

// A shoulder keeps bright colours distinct.
vec3 tone_mapped(vec3 radiance) { return encoded(vec3(1) - exp(-1.25 * radiance)); }
