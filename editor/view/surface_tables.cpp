#include "editor/view/surface_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <variant>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/shader.h"

namespace editor {
namespace {

using reflectance::Rgb;

constexpr std::size_t FormulaCount = std::variant_size_v<reflectance::FormulaBrdf>;

Imath::V4f row(const Rgb& rgb, float w) { return {rgb.x, rgb.y, rgb.z, w}; }

struct WeightedBrdf {
  float weight = 1;
  reflectance::Brdf brdf;
};

class Builder {
 public:
  SurfaceTables build(const SceneObjects& objects) {
    for (const MeshObject& mesh : objects.meshes) {
      for (const FlatSurface& flat_surface : mesh.flat_surfaces) add_surface(flat_surface, mesh.is_light);
      tables_.ends.push_back(std::max(tables_.surfaces.size(), tables_.terms.size()));
    }
    return std::move(tables_);
  }

 private:
  void add_surface(const FlatSurface& flat_surface, bool is_light) {
    const std::optional<grf::Colour> emission = is_light ? flat_surface.colour : flat_surface.emission;
    const Rgb colour = is_light ? Rgb(1) : flat_surface.colour;
    tables_.surfaces.push_back(row(colour, texture_number(flat_surface.texture)));
    tables_.surfaces.push_back(row(emission.value_or(Rgb(0)), emission ? 1.0F : 0.0F));
    const bool is_black = emission && !flat_surface.brdf;
    const std::vector<WeightedBrdf> brdfs = is_black ? std::vector<WeightedBrdf>() : brdfs_of(flat_surface);
    const std::size_t first = tables_.terms.size();
    for (const WeightedBrdf& term : brdfs) add_term(term);
    tables_.surfaces.emplace_back(static_cast<float>(first), static_cast<float>(brdfs.size()),
                                  add_mirror(brdfs), lobe_exponent(brdfs));
  }

  float texture_number(const std::string& path) {
    if (path.empty()) return -1;
    const auto [entry, is_new] = texture_numbers_.try_emplace(path, tables_.textures.size());
    if (is_new) tables_.textures.push_back(path);
    return static_cast<float>(entry->second);
  }

  std::vector<WeightedBrdf> brdfs_of(const FlatSurface& flat_surface) {
    if (!flat_surface.brdf) return {{1, reflectance::default_brdf()}};
    if (flat_surface.brdf->terms.empty()) return {{1, brdf_of(*flat_surface.brdf)}};
    std::vector<WeightedBrdf> brdfs;
    for (const FlatTerm& term : flat_surface.terms) brdfs.push_back({term.weight, brdf_of(term.brdf)});
    return brdfs;
  }

  reflectance::Brdf brdf_of(const grf::BrdfModel& model) {
    const auto brdf = reflectance::make_brdf(model);
    if (brdf && brdf->index() < FormulaCount) return *brdf;
    tables_.not_shown.insert(model.keyword);
    return reflectance::default_brdf();
  }

  void add_term(const WeightedBrdf& term) {
    tables_.models.insert(term.brdf.index());
    const std::vector<Rgb> values = reflectance::shader_values(term.brdf);
    tables_.terms.emplace_back(term.weight, static_cast<float>(term.brdf.index()),
                               static_cast<float>(values.size()), 0);
    for (const Rgb& value : values) tables_.terms.push_back(row(value, 0));
  }

  /// Returns the row of the first value, or -1.
  float add_mirror(const std::vector<WeightedBrdf>& brdfs) {
    const bool has_one = std::ranges::any_of(
        brdfs, [](const WeightedBrdf& term) { return reflectance::has_specular_part(term.brdf); });
    if (!has_one) return -1;
    const std::size_t first = tables_.terms.size();
    for (int i = 0; i < SurfaceTables::SpecularValues; ++i) {
      const float cosine = std::max(1e-3F, static_cast<float>(i) / (SurfaceTables::SpecularValues - 1));
      const grf::Vec3f u(std::sqrt(1 - cosine * cosine), 0, cosine);
      Rgb sum(0);
      for (const WeightedBrdf& term : brdfs) sum += term.weight * reflectance::specular_weight(term.brdf, u);
      tables_.terms.push_back(row(sum, 0));
    }
    return static_cast<float>(first);
  }

  /// The exponent of the widest lobe; 1 if there is none.
  static float lobe_exponent(const std::vector<WeightedBrdf>& brdfs) {
    std::optional<float> widest;
    for (const WeightedBrdf& term : brdfs) {
      const auto exponents = reflectance::lobe_exponents(term.brdf);
      if (!exponents) continue;
      const float exponent = std::min(exponents->x, exponents->y);
      widest = widest ? std::min(*widest, exponent) : exponent;
    }
    return std::clamp(widest.value_or(1), 1.0F, 1e6F);
  }

  SurfaceTables tables_;
  std::map<std::string, std::size_t> texture_numbers_;
};

/// An exposure that maps a value which few vertices exceed to white.
float irradiance_scale(const SceneObjects& objects) {
  std::vector<float> values;
  for (const MeshObject& mesh : objects.meshes) {
    const auto& irradiance = mesh.mesh->irradiance;
    if (irradiance->empty()) continue;
    for (std::size_t i = 0; i < mesh.mesh->geometry->positions.size(); ++i) {
      if (!irradiance->has(i)) continue;
      float value = 0;
      if (const auto* colour = std::get_if<grf::Colour>(&(*irradiance)[i]))
        value = reflectance::largest(*colour);
      values.push_back(value);
    }
  }
  if (values.empty()) return 1;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 95 / 100);
  std::nth_element(values.begin(), place, values.end());
  return *place > 0 ? 1 / *place : 1;
}

}  // namespace

FaceTables face_tables_of(const SceneObjects& objects) {
  FaceTables tables;
  tables.surface_of_face.reserve(objects.faces);
  std::uint32_t surfaces = 0;
  for (const MeshObject& mesh : objects.meshes) {
    tables.first_face.push_back(static_cast<std::uint32_t>(tables.surface_of_face.size()));
    for (const std::uint32_t surface : *mesh.mesh->surface_of_face) {
      tables.surface_of_face.push_back(surfaces + surface);
    }
    surfaces += static_cast<std::uint32_t>(mesh.flat_surfaces.size());
  }
  tables.irradiance_scale = irradiance_scale(objects);
  return tables;
}

SurfaceTables surface_tables_of(const SceneObjects& objects) { return Builder().build(objects); }

bool have_same_faces(const SceneObjects& a, const SceneObjects& b) {
  return std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(),
                    [](const MeshObject& mesh, const MeshObject& other) {
                      return mesh.mesh->surface_of_face.shares(other.mesh->surface_of_face) &&
                             mesh.mesh->irradiance.shares(other.mesh->irradiance) &&
                             mesh.flat_surfaces.size() == other.flat_surfaces.size();
                    });
}

}  // namespace editor
