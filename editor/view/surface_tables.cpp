#include "editor/view/surface_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <variant>

#include "grf/keywords.h"
#include "renderer/reflectance/brdf_maker.h"
#include "renderer/reflectance/shader.h"

namespace editor {
namespace {

using reflectance::Rgb;

constexpr std::size_t FormulaCount = std::variant_size_v<reflectance::FormulaBrdf>;

Imath::V4f row(const Rgb& rgb, float w) { return {rgb.x, rgb.y, rgb.z, w}; }

using reflectance::CombinedBrdf;
using reflectance::CombinedBrdfs;

class Builder {
 public:
  /// `made` has the layered BRDFs of the tables before.
  explicit Builder(LayeredBrdfs made) : made_(std::move(made)) {}

  LayeredBrdfs layered_brdfs() && { return std::move(layered_brdfs_); }

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
    const std::vector<CombinedBrdf> brdfs = is_black ? std::vector<CombinedBrdf>() : brdfs_of(flat_surface);
    const std::size_t first = tables_.terms.size();
    for (const CombinedBrdf& term : brdfs) add_term(term);
    tables_.surfaces.emplace_back(static_cast<float>(first), static_cast<float>(brdfs.size()),
                                  add_mirror(brdfs), lobe_exponent(brdfs));
    add_opacity(is_light ? grf::Opacity() : shown_opacity(flat_surface), flat_surface.texture);
  }

  /// Light passes glass straight on here, and solids are not bent: an outline of what is behind.
  static grf::Opacity shown_opacity(const FlatSurface& flat_surface) {
    constexpr float OfGlass = 0.3F;
    grf::Opacity opacity = flat_surface.opacity;
    const bool is_glass = flat_surface.brdf && flat_surface.brdf->terms.empty() &&
                          grf::same_keyword(flat_surface.brdf->keyword, "glass");
    if (is_glass && opacity.kind != grf::Opacity::Kind::Mask) opacity.value *= OfGlass;
    return opacity;
  }

  void add_opacity(const grf::Opacity& opacity, const std::string& texture) {
    const float alpha = opacity.reads_alpha() ? texture_number(texture) : -1;
    tables_.surfaces.emplace_back(opacity.kind == grf::Opacity::Kind::Mask ? 1.0F : 0.0F, opacity.value,
                                  alpha, 0.0F);
    tables_.has_cutouts |= opacity != grf::Opacity();
    if (alpha >= 0) tables_.alphas.insert(static_cast<std::size_t>(alpha));
  }

  float texture_number(const std::string& path) {
    if (path.empty()) return -1;
    const auto [entry, is_new] = texture_numbers_.try_emplace(path, tables_.textures.size());
    if (is_new) tables_.textures.push_back(path);
    return static_cast<float>(entry->second);
  }

  std::vector<CombinedBrdf> brdfs_of(const FlatSurface& flat_surface) {
    if (!flat_surface.brdf) return {{1, reflectance::default_brdf()}};
    if (flat_surface.brdf->terms.empty()) return {{1, brdf_of(*flat_surface.brdf)}};
    std::vector<CombinedBrdf> brdfs;
    for (const FlatTerm& term : flat_surface.terms) {
      if (grf::is_layered(term.brdf)) {
        add_layers(term, brdfs);
      } else {
        brdfs.push_back({term.weight, brdf_of(term.brdf)});
      }
    }
    return brdfs;
  }

  reflectance::Brdf brdf_of(const grf::BrdfModel& model) {
    const auto brdf = reflectance::make_brdf(model);
    if (brdf && brdf->index() < FormulaCount) return *brdf;
    tables_.not_shown.insert(model.keyword);
    return reflectance::default_brdf();
  }

  void add_layers(const FlatTerm& term, std::vector<CombinedBrdf>& brdfs) {
    const CombinedBrdfs& parts = parts_of(term);
    if (parts.empty()) {
      tables_.not_shown.insert(term.brdf.keyword);
      brdfs.push_back({term.weight, reflectance::default_brdf()});
    }
    for (CombinedBrdf part : parts) {
      part.weight *= term.weight;
      brdfs.push_back(std::move(part));
    }
  }

  /// Makes the parts of a layered BRDF, unless they are known: its quadrature takes milliseconds. Data files
  /// are not read here, so that a BRDF with one of them is shown as diffuse.
  const CombinedBrdfs& parts_of(const FlatTerm& term) {
    grf::ScopeStack stack;
    for (const grf::Definition& definition : term.definitions) stack.enter(definition);
    grf::Diagnostics ignored_diagnostics;
    reflectance::BrdfMaker maker(ignored_diagnostics);
    const std::string identity = maker.identity(term.brdf, stack.scope());
    const auto [entry, is_new] = layered_brdfs_.try_emplace(identity);
    if (!is_new) return entry->second;
    if (const auto before = made_.find(identity); before != made_.end()) {
      return entry->second = std::move(before->second);
    }
    const bool reads_data = !maker.data_files_of(term.brdf, stack.scope()).empty();
    const auto brdf = reads_data ? std::nullopt : maker.make(term.brdf, stack.scope());
    const auto* sum = brdf ? std::get_if<reflectance::Combine>(&*brdf) : nullptr;
    if (sum != nullptr && sum->parts) entry->second = *sum->parts;
    return entry->second;
  }

  void add_term(const CombinedBrdf& term) {
    tables_.models.insert(term.brdf.index());
    const std::vector<Rgb> values = reflectance::shader_values(term.brdf);
    tables_.terms.emplace_back(term.weight, static_cast<float>(term.brdf.index()),
                               static_cast<float>(values.size()),
                               term.transmission ? static_cast<float>(reflectance::Transmission::Rows) : 0);
    for (const Rgb& value : values) tables_.terms.push_back(row(value, 0));
    if (!term.transmission) return;
    for (const Rgb& value : term.transmission->table()) tables_.terms.push_back(row(value, 0));
  }

  /// Returns the row of the first value, or -1.
  float add_mirror(const std::vector<CombinedBrdf>& brdfs) {
    const bool has_one = std::ranges::any_of(
        brdfs, [](const CombinedBrdf& term) { return reflectance::has_specular_part(term.brdf); });
    if (!has_one) return -1;
    const std::size_t first = tables_.terms.size();
    for (int i = 0; i < SurfaceTables::SpecularValues; ++i) {
      const float cosine = std::max(1e-3F, static_cast<float>(i) / (SurfaceTables::SpecularValues - 1));
      const grf::Vec3f u(std::sqrt(1 - cosine * cosine), 0, cosine);
      Rgb sum(0);
      for (const CombinedBrdf& term : brdfs) sum += term.specular_weight(u);
      tables_.terms.push_back(row(sum, 0));
    }
    return static_cast<float>(first);
  }

  /// The exponent of the widest lobe; 1 if there is none.
  static float lobe_exponent(const std::vector<CombinedBrdf>& brdfs) {
    std::optional<float> widest;
    for (const CombinedBrdf& term : brdfs) {
      const auto exponents = reflectance::lobe_exponents(term.brdf);
      if (!exponents) continue;
      const float exponent = std::min(exponents->x, exponents->y);
      widest = widest ? std::min(*widest, exponent) : exponent;
    }
    return std::clamp(widest.value_or(1), 1.0F, 1e6F);
  }

  SurfaceTables tables_;
  std::map<std::string, std::size_t> texture_numbers_;
  LayeredBrdfs made_;
  LayeredBrdfs layered_brdfs_;
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

SurfaceTables surface_tables_of(const SceneObjects& objects, LayeredBrdfs& layered_brdfs) {
  Builder builder(std::move(layered_brdfs));
  SurfaceTables tables = builder.build(objects);
  layered_brdfs = std::move(builder).layered_brdfs();
  return tables;
}

bool have_same_faces(const SceneObjects& a, const SceneObjects& b) {
  return std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(),
                    [](const MeshObject& mesh, const MeshObject& other) {
                      return mesh.mesh->surface_of_face.shares(other.mesh->surface_of_face) &&
                             mesh.mesh->irradiance.shares(other.mesh->irradiance) &&
                             mesh.flat_surfaces.size() == other.flat_surfaces.size();
                    });
}

}  // namespace editor
