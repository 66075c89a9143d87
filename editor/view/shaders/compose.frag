// Composes an image for the screen: over the background, with the selection in the accent colour.
uniform sampler2D sum;
uniform float sum_weight;  // 0 shows the image's own colours
uniform vec2 to_picture;   // image pixels per screen pixel
uniform vec3 background_top;
uniform vec3 background_bottom;
uniform vec3 view_forward, view_right, view_up;  // the last two are half the image plane at distance 1
uniform sampler2D plate;                         // image behind the scene, its first row on top
uniform float plate_width;                       // fraction of the screen's; 0: none
uniform float plate_scale;
uniform sampler2D rendered;  // premultiplied, its first row on top
uniform bool has_rendered;
uniform vec2 size;  // of the screen, in pixels
uniform vec3 accent;
uniform float fill;  // opacity of the accent on selected faces
uniform bool has_selection;
uniform bool has_borders;
layout(location = 0) out vec4 colour;

bool is_selected(ivec2 place) {
  ivec2 size = textureSize(faces, 0);
  uvec2 face = face_at(clamp(place, ivec2(0), size - 1));
  return !is_nothing(face) && texelFetch(selected, int(face.y)).r != 0u;
}

vec3 background(vec2 at) {
#ifdef HAS_MAP
  return tone_mapped(visible_sky(normalize(view_forward + view_right * (at.x * 2 - 1) + view_up * (at.y * 2 - 1))));
#else
  float across = plate_width > 0 ? 0.5 + (at.x - 0.5) / plate_width : -1;
  if (across >= 0 && across <= 1) return tone_mapped(plate_scale * texture(plate, vec2(across, 1 - at.y)).rgb);
  return mix(background_bottom, background_top, at.y);
#endif
}

vec3 with_selection(vec3 shown, ivec2 place) {
  bool here = is_selected(place);
  if (here) shown = mix(shown, accent, fill);
  if (!has_borders) return shown;
  int others = 0;
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i < 2 ? 2 * i - 1 : 0, i < 2 ? 0 : 2 * i - 5);
    if (is_selected(place + step) != here) ++others;
  }
  return others > 0 ? mix(shown, accent, here ? 1.0 : 0.45) : shown;
}

void main() {
  vec2 at = gl_FragCoord.xy * to_picture;
  ivec2 place = ivec2(at);
  vec4 shown = sum_weight > 0 ? texelFetch(sum, place, 0) * sum_weight
                              : texture(colours, at / vec2(textureSize(colours, 0)));
  vec3 over = shown.rgb;
  if (shown.a < 1) over += background(gl_FragCoord.xy / size) * (1 - shown.a);
  if (has_rendered) {
    vec4 image = texture(rendered, vec2(gl_FragCoord.x / size.x, 1 - gl_FragCoord.y / size.y));
    over = image.rgb + over * (1 - image.a);
  }
  if (has_selection) over = with_selection(over, place);
  colour = vec4(over, 1);
  gl_FragDepth = texelFetch(depths, place, 0).r;
}
