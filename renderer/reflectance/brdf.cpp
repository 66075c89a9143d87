#include "renderer/reflectance/brdf.h"

#include "renderer/reflectance/each_type.h"

namespace reflectance {
std::optional<Brdf> make_brdf(const grf::Model& data) { return make_any<Brdf>(data); }

Brdf default_brdf() { return Diffuse(); }

bool has_mirror(const Brdf& brdf) {
  return std::visit(
      [](const auto& model) {
        return requires { model.mirror(Vec3f()); };
      },
      brdf);
}

bool has_density(const Brdf& brdf) { return !std::holds_alternative<Specular>(brdf); }

bool has_diffuse_part(const Brdf& brdf) {
  return std::visit(
      [](const auto& model) {
        if constexpr (requires { model.has_diffuse_part(); }) {
          return model.has_diffuse_part();
        } else if constexpr (requires { model.kd; }) {
          return !is_black(model.kd);
        }
        return false;
      },
      brdf);
}

bool has_glossy_part(const Brdf& brdf) {
  return std::visit(
      [](const auto& model) {
        if constexpr (requires { model.has_glossy_part(); }) {
          return model.has_glossy_part();
        } else if constexpr (requires { model.lobe_albedo(Vec3f()); }) {
          return !is_black(model.ks);
        }
        return false;
      },
      brdf);
}

bool is_anisotropic(const Brdf& brdf) {
  return std::visit(
      [](const auto& model) {
        if constexpr (requires { model.is_anisotropic(); }) return model.is_anisotropic();
        return false;
      },
      brdf);
}

std::vector<grf::ModelInfo> brdf_infos() { return infos_of<Brdf>(); }

}  // namespace reflectance
