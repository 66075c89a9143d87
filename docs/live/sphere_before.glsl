// What lit_surface.glsl needs besides the BRDF: one light, and the studio around it.
const int light_count = 1;
uniform vec3 light;  // unit, towards the light
vec3 light_direction(int i) { return light; }
vec3 light_irradiance(int i) { return vec3(3.0); }
vec3 tangent, bitangent, normal;
float shift_a = 0.5;
float shift_b = 0.5;
vec3 environment_radiance(vec3 d) { return studio_radiance(d); }
bool environment_is_drawn() { return false; }
float environment_pdf(vec3 d) { return 0.0; }
vec3 environment_direction(int i) { return vec3(0.0, 0.0, 1.0); }
