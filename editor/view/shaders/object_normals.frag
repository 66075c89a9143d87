// The normals of the BRDF viewer's object in world space, towards the eye, after shading_normal.glsl.
uniform mat3 camera_to_world;
layout(location = 0) out vec4 normal_out;

void main() { normal_out = vec4(camera_to_world * shading_normal(normalize(-camera_place)), 1); }
