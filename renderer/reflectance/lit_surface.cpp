#include "renderer/reflectance/lit_surface.h"

#include "renderer/reflectance/shader.h"

namespace reflectance {
namespace {

constexpr std::string_view PrologueText = R"(
uniform vec3 specular_weights[64];
vec3 brdf_specular(vec3 u) {
  float place = acos(clamp(u.z, 0.0, 1.0)) / (PI / 2) * 63;
  int below = min(int(place), 62);
  return mix(specular_weights[below], specular_weights[below + 1], place - below);
}
uniform int light_count;  // up to 3
uniform vec3 light_directions[3];
uniform vec3 light_irradiances[3];
vec3 light_direction(int i) { return light_directions[min(i, 2)]; }
vec3 light_irradiance(int i) { return light_irradiances[min(i, 2)]; }
vec3 tangent, bitangent, normal;
float shift_a = 0.5;
float shift_b = 0.5;
)";

struct StudioFormula {
  using real = float;
  using vec3 = Vec3f;
  static real exp(real x) { return std::exp(x); }
#include "renderer/reflectance/studio.glsl"
};

}  // namespace

SpecularTable specular_table(const Brdf& brdf) {
  SpecularTable table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double degrees =
        std::min(89.9999, 90.0 * static_cast<double>(i) / static_cast<double>(table.size() - 1));
    const double theta = degrees * static_cast<double>(Pi) / 180;
    table[i] =
        specular_weight(brdf, {static_cast<float>(std::sin(theta)), 0, static_cast<float>(std::cos(theta))});
  }
  return table;
}

Rgb studio_radiance(const Vec3f& direction) { return StudioFormula().studio_radiance(direction); }

std::string lit_surface_shader(const std::string& brdf, const std::string& environment) {
  std::string text = brdf;
  text += PrologueText;
  text += shader_file("studio");
  text += environment;
  text += shader_file("lit_surface");
  return text;
}

}  // namespace reflectance
