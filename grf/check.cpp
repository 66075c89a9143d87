#include "grf/check.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <unordered_map>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "grf/check_geometry.h"
#include "grf/keywords.h"
#include "grf/text_file.h"
#include "grf/visit.h"
#include "grf/write.h"

namespace grf {
namespace {

/// The models of one kind, and the name of the kind for messages.
template <class ModelOfKind>
struct Kind {
  const std::vector<ModelInfo>& models;
  std::string_view name;
};

std::string path_of(const SourceLocation& location, const std::string& file) {
  return location.file ? path_beside(location.file->path, file) : file;
}

/// Returns whether a name ends in `.grf`; a scene embedded in another format has no file name of its own.
bool is_plain_grf_name(const std::string& path) {
  return same_keyword(std::filesystem::path(path).extension().string(), ".grf");
}

bool is_combine(const BrdfModel& brdf) { return same_keyword(brdf.keyword, "combine"); }

class Check {
 public:
  Check(const Catalogue& catalogue, Diagnostics& diagnostics, const std::set<std::string>& images_to_come)
      : brdfs_{catalogue.brdfs, "BRDF"},
        pdfs_{catalogue.pdfs, "PDF"},
        diagnostics_(diagnostics),
        known_images_(images_to_come) {}

  void run(const Scene& scene) {
    SceneVisitor visitor;
    visitor.mesh = [this](const Mesh& mesh, const Placement& placement, const Block& block) {
      if (placement.instance_of == nullptr) check_mesh(mesh, placement.scope, block.location);
      lights_.add(mesh, placement);
    };
    visitor.mesh_light = [this](const MeshLight& light, const Placement& placement, const Block& block) {
      check_mesh_light(*light.mesh, placement.scope, block.location);
      lights_.add_light(light, placement, block);
    };
    visitor.light = [this](const AreaLight& light, const Placement& placement, const Block& block) {
      if (light.radiance) check_not_negative(*light.radiance, block.location, "radiance");
      lights_.add_light(light, placement, block);
    };
    visitor.definition = [this](const Definition& definition, const Placement& placement) {
      if (visited_.insert(&definition).second) definitions_.push_back(&definition);
      check_definition(definition, placement.scope);
    };
    visitor.use = [this](const Use& use, const Placement& placement, const Block&) {
      check_reference<Shared<Mesh>>(use.mesh, "mesh", placement.scope);
    };
    visitor.params = [this](const Params& params, const Placement&, const Block&) {
      has_observer_ = has_observer_ || !params.views.empty();
    };
    const std::size_t errors_before = diagnostics_.error_count();
    visit(scene, visitor);
    faces_.report(diagnostics_);
    warn_of_irradiance();
    // After an error these warnings could be consequences of it.
    if (diagnostics_.error_count() > errors_before) return;
    lights_.report(diagnostics_);
    warn_of_unused();
  }

 private:
  void check_mesh(const Mesh& mesh, const Scope& scope, const SourceLocation& location) {
    std::vector<bool> reads_images;
    for (const Surface& surface : mesh.surfaces) {
      const SourceLocation& place = surface.location.file ? surface.location : location;
      if (surface.brdf) check_model_attribute(*surface.brdf, brdfs_, scope);
      if (surface.pdf) check_model_attribute(*surface.pdf, pdfs_, scope);
      check_colour_attribute(surface.colour, place, scope);
      check_texture(surface.texture, place, scope);
      if (surface.emission) check_not_negative(*surface.emission, place, "radiance");
      if (surface.opacity) check_opacity(surface, place);
      const ResolvedSurface resolved = resolve(surface, scope);
      reads_images.push_back(surface.texture.has_value() ||
                             (resolved.brdf != nullptr && has_maps(*resolved.brdf)));
    }
    check_vertices(mesh, location);
    warn_of_default(mesh, location);
    faces_.add(mesh, reads_images, location, diagnostics_);
  }

  void check_mesh_light(const Mesh& mesh, const Scope& scope, const SourceLocation& location) {
    for (const Surface& surface : mesh.surfaces) {
      if (!surface.colour) continue;
      if (const auto* reference = std::get_if<Reference>(&*surface.colour)) {
        check_reference<Colour>(*reference, "colour", scope);
      } else {
        const SourceLocation& place = surface.location.file ? surface.location : location;
        check_not_negative(std::get<Colour>(*surface.colour), place, "radiance");
      }
    }
    check_vertices(mesh, location);
    faces_.add(mesh, std::vector<bool>(mesh.surfaces.size()), location, diagnostics_);
  }

  void check_vertices(const Mesh& mesh, const SourceLocation& location) {
    const auto& colours = mesh.geometry->colours;
    for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
      if (colours.has(i)) check_colour(colours[i], location, "vertex colour");
      if (mesh.irradiance->has(i)) check_irradiance((*mesh.irradiance)[i], location);
    }
  }

  void check_irradiance(const Irradiance& irradiance, const SourceLocation& location) {
    if (!irradiance_at_) irradiance_at_ = location;
    if (location.file && is_plain_grf_name(location.file->path) &&
        files_to_rename_.insert(location.file->path).second) {
      diagnostics_.warning(location, "irradiance makes this an IGRF file: its name should end in '.igrf'");
    }
    if (const auto* value = std::get_if<Colour>(&irradiance)) {
      return check_not_negative(*value, location, "irradiance");
    }
    for (const DirectionalIrradiance& arrival : std::get<1>(irradiance)) {
      check_not_negative(arrival.irradiance, location, "irradiance");
    }
  }

  // A missing BRDF falls back to an implicit default, so a file that relies on it gets one warning.
  void warn_of_default(const Mesh& mesh, const SourceLocation& location) {
    const std::string file = location.file ? location.file->path : std::string();
    if (files_with_default_.contains(file)) return;
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      if (mesh.surface(i).brdf || mesh.surface(i).emission) continue;
      files_with_default_.insert(file);
      diagnostics_.warning(location, "faces without a BRDF: they are diffuse with kd=0.5");
      return;
    }
  }

  template <class ModelOfKind>
  void check_model_attribute(const std::variant<ModelOfKind, Reference>& attribute,
                             const Kind<ModelOfKind>& kind, const Scope& scope) {
    if (const auto* reference = std::get_if<Reference>(&attribute)) {
      check_reference<ModelOfKind>(*reference, kind.name, scope);
    } else {
      check_model(std::get<ModelOfKind>(attribute), kind, scope);
    }
  }

  void check_model(const BrdfModel& brdf, const Kind<BrdfModel>& kind, const Scope& scope) {
    if (is_combine(brdf)) return check_combine(brdf, scope);
    const std::size_t errors_before = diagnostics_.error_count();
    if (!layer_names(brdf.keyword).empty() && !has_layers(brdf, scope)) return;
    check_known_model(brdf, kind, scope);
    if (const ModelInfo* info = find_model(kind.models, brdf.keyword)) check_data_file(brdf, *info);
    for (const Argument& argument : brdf.arguments) {
      if (argument.map && !argument.map->file.empty()) check_image(map_path(argument), argument.location);
    }
    if (diagnostics_.error_count() == errors_before) warn_of_gain(brdf);
  }
  // Some published models gain energy, and lobes may sum to more than 1: a warning, since it may be intended.
  // A face colour below 1 may compensate for it.
  void warn_of_gain(const BrdfModel& brdf) {
    constexpr float ClearlyOver = 1.02F;
    const ModelInfo* info = find_model(brdfs_.models, brdf.keyword);
    if (info == nullptr || info->largest_albedo == nullptr) return;
    const auto [known, is_new] = largest_albedos_.try_emplace(to_text(brdf));
    if (is_new) known->second = info->largest_albedo(brdf);
    const auto [albedo, degrees] = known->second;
    if (albedo < ClearlyOver) return;
    diagnostics_.warning(brdf.location,
                         fmt::format("'{}' reflects up to {:.3g} times the light it receives (at {} degrees)",
                                     info->keyword, albedo, degrees));
  }

  void check_model(const PdfModel& pdf, const Kind<PdfModel>& kind, const Scope& scope) {
    check_known_model(pdf, kind, scope);
  }

  void check_data_file(const BrdfModel& brdf, const ModelInfo& info) {
    const bool takes_file = info.argument_kind == ModelInfo::ArgumentKind::DataFile;
    std::string wrong;
    if (takes_file && brdf.data_file.empty()) {
      wrong = fmt::format("'{}' needs the name of a data file", info.keyword);
    } else if (!takes_file && !brdf.data_file.empty()) {
      wrong = fmt::format("'{}' takes no data file", info.keyword);
    } else if (takes_file) {
      const std::string path = path_of(brdf.location, brdf.data_file);
      std::error_code error;
      if (!std::filesystem::is_regular_file(path, error)) wrong = fmt::format("there is no file '{}'", path);
    }
    if (!wrong.empty()) diagnostics_.error(brdf.location, wrong);
  }

  void check_combine(const BrdfModel& brdf, const Scope& scope) {
    if (brdf.terms.empty())
      diagnostics_.error(brdf.location, "'combine' without terms, expected weights and names");
    for (const CombineTerm& term : brdf.terms) {
      check_term(brdf, term, scope);
      if (term.weight < 0) {
        diagnostics_.error(term.brdf.location,
                           fmt::format("the weight {} of a BRDF, expected 0 or more", term.weight));
      }
    }
    ModelInfo info;
    info.keyword = "combine";
    for (const Argument& argument : brdf.arguments) report_unknown_parameter(argument, info, diagnostics_);
  }

  /// Checks a BRDF that a sum or a layered model names. Layers are tabulated once, and not for each point.
  void check_term(const BrdfModel& whole, const CombineTerm& term, const Scope& scope) {
    check_reference<BrdfModel>(term.brdf, "BRDF", scope);
    const auto* brdf = scope.find<BrdfModel>(term.brdf.name);
    if (brdf == nullptr || !has_maps(*brdf)) return;
    diagnostics_.error(term.brdf.location,
                       fmt::format("images vary parameters of '{}', which '{}' cannot have as a part",
                                   term.brdf.name, whole.keyword));
  }

  /// Checks the layers of a layered model; returns false if their names are not all given. Each layer
  /// multiplies the cost of those below it, and its table is computed from them, so their number is limited.
  bool has_layers(const BrdfModel& brdf, const Scope& scope) {
    const auto names = layer_names(brdf.keyword);
    if (brdf.terms.size() != names.size()) {
      diagnostics_.error(brdf.location, fmt::format("'{}' needs the names of defined BRDFs: {}=NAME",
                                                    brdf.keyword, fmt::join(names, "=NAME ")));
      return false;
    }
    for (const CombineTerm& term : brdf.terms) check_term(brdf, term, scope);
    if (1 + deepest_layers(brdf, scope) > MostLayers) {
      diagnostics_.error(brdf.location,
                         fmt::format("'{}': over {} layers above each other", brdf.keyword, MostLayers));
    }
    return true;
  }

  /// The number of layers above each other in the BRDFs that another one names.
  std::size_t deepest_layers(const BrdfModel& brdf, const Scope& scope) const {
    std::size_t deepest = 0;
    for (const CombineTerm& term : brdf.terms) {
      const auto known = layers_.find(scope.find<BrdfModel>(term.brdf.name));
      if (known != layers_.end()) deepest = std::max(deepest, known->second);
    }
    return deepest;
  }

  // Names of definitions are suggested too: an unknown keyword may be a misspelled definition.
  template <class ModelOfKind>
  void check_known_model(const ModelOfKind& model, const Kind<ModelOfKind>& kind, const Scope& scope) {
    if (find_model(kind.models, model.keyword) != nullptr) {
      check(model, kind.models, kind.name, diagnostics_);
    } else if (scope.find<ModelOfKind>(model.keyword) != nullptr) {
      // A bare name on faces would be a reference, so this one is in a definition or has parameters.
      diagnostics_.error(model.location,
                         fmt::format("'{}' is the name of a {}, expected a model", model.keyword, kind.name));
    } else {
      report_unknown(model, kind.models, kind.name, names_to_suggest<ModelOfKind>(scope), diagnostics_);
    }
  }

  void check_colour_attribute(const std::optional<ColourAttribute>& attribute, const SourceLocation& location,
                              const Scope& scope) {
    if (!attribute) return;
    const auto* reference = std::get_if<Reference>(&*attribute);
    if (reference == nullptr) return check_colour(std::get<Colour>(*attribute), location, "colour");
    check_reference<Colour>(*reference, "colour", scope);
    // A mesh is not checked where it is defined: it can be meant for a light.
    const auto* colour = scope.find<Colour>(reference->name);
    if (colour != nullptr) check_colour(*colour, scope.find(reference->name)->location, "colour");
  }

  void check_texture(const std::optional<TextureAttribute>& attribute, const SourceLocation& place,
                     const Scope& scope) {
    if (!attribute) return;
    if (const auto* reference = std::get_if<Reference>(&*attribute)) {
      check_reference<Texture>(*reference, "texture", scope);
    } else {
      const auto& texture = std::get<Texture>(*attribute);
      check_image(texture, texture.location.file ? texture.location : place);
    }
  }

  void check_image(const Texture& texture, const SourceLocation& place) {
    check_image(path_of(place, texture.file), place);
  }

  // A missing image is a warning, since the scene still renders without it. Each is reported once.
  void check_image(const std::string& path, const SourceLocation& place) {
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error) || !known_images_.insert(path).second) return;
    diagnostics_.warning(place, fmt::format("there is no image '{}'", path));
  }

  void check_opacity(const Surface& surface, const SourceLocation& place) {
    const Opacity& opacity = *surface.opacity;
    if (!(opacity.value >= 0 && opacity.value <= 1)) {
      diagnostics_.error(place, fmt::format("'{}', expected a number from 0 to 1", to_text(opacity)));
    } else if (opacity.reads_alpha() && !surface.texture) {
      diagnostics_.warning(
          place, fmt::format("'{}' without a texture, whose alpha it uses: alpha is 1", to_text(opacity)));
    }
  }

  template <class Body>
  void check_reference(const Reference& reference, std::string_view kind, const Scope& scope) {
    if (scope.find<Body>(reference.name) != nullptr) {
      used_.insert(scope.find(reference.name));
      return;
    }
    const std::string suggestion = did_you_mean(reference.name, names_to_suggest<Body>(scope));
    diagnostics_.error(reference.location,
                       fmt::format("no {} called '{}' is defined here{}{}", kind, reference.name,
                                   suggestion.empty() ? "" : ": ", suggestion));
  }

  // Errors beyond the limit are discarded, so they need no suggestion: collecting names for each would be
  // quadratic.
  template <class Body>
  std::vector<std::string> names_to_suggest(const Scope& scope) const {
    return diagnostics_.is_full() ? std::vector<std::string>() : scope.names_of<Body>();
  }

  void check_definition(const Definition& definition, const Scope& scope) {
    if (const auto* brdf = std::get_if<BrdfModel>(&definition.body)) {
      check_model(*brdf, brdfs_, scope);
      // A file that is included twice enters its definitions twice: the latest are those that names find.
      layers_[brdf] = deepest_layers(*brdf, scope) + (is_layered(*brdf) ? 1 : 0);
    } else if (const auto* pdf = std::get_if<PdfModel>(&definition.body)) {
      check_model(*pdf, pdfs_, scope);
    } else if (const auto* colour = std::get_if<Colour>(&definition.body)) {
      check_not_negative(*colour, definition.location, "colour");
    } else if (const auto* texture = std::get_if<Texture>(&definition.body)) {
      check_image(*texture, texture->location);
    } else if (const auto* mesh = std::get_if<Shared<Mesh>>(&definition.body)) {
      check_mesh(**mesh, scope, definition.location);
    }
  }

  void check_not_negative(const Colour& colour, const SourceLocation& location, std::string_view what) {
    if (colour.x >= 0 && colour.y >= 0 && colour.z >= 0) return;
    diagnostics_.error(location,
                       fmt::format("{} {} of ({}, {}, {}), expected components of 0 or more",
                                   what == "irradiance" ? "an" : "a", what, colour.x, colour.y, colour.z));
  }

  void check_colour(const Colour& colour, const SourceLocation& location, std::string_view what) {
    check_not_negative(colour, location, what);
    if (std::max({colour.x, colour.y, colour.z}) > 1) {
      diagnostics_.warning(location,
                           "a colour over 1: such a surface can reflect more light than it receives");
    }
  }

  void warn_of_unused() {
    for (const Definition* definition : definitions_) {
      if (used_.contains(definition)) continue;
      diagnostics_.warning(definition->location, fmt::format("the {} '{}' is defined and never used",
                                                             kind_of(definition->body), definition->name));
    }
  }

  void warn_of_irradiance() {
    if (!irradiance_at_) return;
    if (!has_observer_) {
      diagnostics_.warning(
          *irradiance_at_,
          "irradiance without 'params begin dependent view (..) end', the observer that it is for");
    }
  }

  const Kind<BrdfModel> brdfs_;
  const Kind<PdfModel> pdfs_;
  Diagnostics& diagnostics_;
  FaceCheck faces_;
  LightCheck lights_;
  std::map<std::string, LargestAlbedo> largest_albedos_;      ///< by the text of the BRDF
  std::unordered_map<const BrdfModel*, std::size_t> layers_;  ///< above each other, of definitions in scope
  std::set<std::string> files_with_default_;
  std::set<std::string> known_images_;  ///< not reported as missing (again): reported before, or to come
  std::vector<const Definition*> definitions_;
  std::set<const Definition*> visited_;
  std::set<const Definition*> used_;
  std::set<std::string> files_to_rename_;
  std::optional<SourceLocation> irradiance_at_;
  bool has_observer_ = false;
};

}  // namespace

bool check(const Scene& scene, const Catalogue& catalogue, Diagnostics& diagnostics,
           const std::set<std::string>& images_to_come) {
  const std::size_t errors_before = diagnostics.error_count();
  Check(catalogue, diagnostics, images_to_come).run(scene);
  return diagnostics.error_count() == errors_before;
}

}  // namespace grf
