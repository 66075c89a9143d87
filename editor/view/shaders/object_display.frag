// Exposes the BRDF viewer's image for the screen, over the environment or a plain background, after g_buffer.glsl
// and object_environment.glsl.
uniform sampler2D radiance;  // sums
uniform float passes;
uniform vec2 screen;
uniform float gain;
uniform bool has_backdrop;
uniform vec3 view_forward, view_right, view_up;
uniform vec3 background_top, background_bottom;
layout(location = 0) out vec4 colour;

void main() {
  vec2 at = gl_FragCoord.xy / screen;
  vec4 shown = texture(radiance, at) / passes;
  float free = 1 - min(shown.a, 1.0);
  vec3 direction = normalize(view_forward + view_right * (at.x * 2 - 1) + view_up * (at.y * 2 - 1));
  if (has_backdrop) shown.rgb += free * environment_radiance(direction);
  vec3 lit = encoded(shown.rgb * gain);
  if (!has_backdrop) lit = free >= 1 ? vec3(0) : encoded(shown.rgb * gain / (1 - free)) * (1 - free);
  colour = vec4(has_backdrop ? lit : lit + mix(background_bottom, background_top, at.y) * free, 1);
}
