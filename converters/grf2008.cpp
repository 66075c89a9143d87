#include "converters/grf2008.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "grf/relocate.h"
#include "grf/unique_names.h"
#include "grf/visit.h"
#include "grf/write.h"

namespace convert {
namespace {

template <class Attribute>
bool is_reset(const std::optional<Attribute>& before, const std::optional<Attribute>& after) {
  return before && !after;
}

/// Returns whether a face after another one would need `none`.
bool needs_none(const grf::Surface& before, const grf::Surface& after) {
  return is_reset(before.colour, after.colour) || is_reset(before.brdf, after.brdf) ||
         is_reset(before.pdf, after.pdf) || is_reset(before.texture, after.texture);
}

grf::BrdfModel black() {
  grf::BrdfModel brdf;
  brdf.keyword = "diffuse";
  brdf.arguments.push_back({"kd", 0.0F, {}});
  return brdf;
}

/// The conversion of one mesh.
struct Parts {
  std::vector<grf::Mesh> meshes;  ///< empty if all faces emit
  std::optional<grf::MeshLight> light;
};

struct ChangedFile {
  std::string name;
  grf::SourceLocation named_at;
};

class Downgrade {
 public:
  explicit Downgrade(grf::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  grf::Scene run(const grf::Scene& scene) {
    grf::SceneVisitor names;
    names.definition = [this](const grf::Definition& definition, const grf::Placement&) {
      names_.add(definition.name);
    };
    grf::visit(scene, names);
    return {blocks(scene.contents)};
  }

  /// An included file that would have to change, with the location of its name.
  const std::optional<ChangedFile>& changed_file() const { return changed_file_; }

 private:
  grf::BlockList blocks(const grf::BlockList& list) {
    grf::BlockList result;
    for (const grf::Block& block : list.blocks) {
      std::visit([&](const auto& content) { add(content, block, result); }, block.content);
    }
    result.end_comments = list.end_comments;
    return result;
  }

  void add(const grf::Shared<grf::Mesh>& mesh, const grf::Block& block, grf::BlockList& result) {
    Parts parts = parts_of(*mesh, block.location);
    const std::size_t first = result.blocks.size();
    for (grf::Mesh& part : parts.meshes)
      result.blocks.push_back({grf::Shared<grf::Mesh>(std::move(part)), {}, block.location});
    if (parts.light) result.blocks.push_back({*parts.light, {}, block.location});
    result.blocks[first].comments = block.comments;
    name_in_comment(*mesh, result.blocks[first].comments);
  }

  void add(const grf::MeshLight& light, const grf::Block& block, grf::BlockList& result) {
    grf::Block& copy = result.blocks.emplace_back(block);
    std::get<grf::MeshLight>(copy.content) = plain_light(*light.mesh, block.location);
  }

  void add(const grf::AreaLight&, const grf::Block& block, grf::BlockList& result) {
    result.blocks.push_back(block);
  }
  void add(const grf::Params&, const grf::Block& block, grf::BlockList& result) {
    result.blocks.push_back(block);
  }

  void add(const grf::Include& include, const grf::Block& block, grf::BlockList& result) {
    const bool stays = blocks(*include.contents) == *include.contents;
    if (!stays) changed_file_ = {include.file, block.location};
    result.blocks.push_back(block);
  }

  void add(const grf::Transform& transform, const grf::Block& block, grf::BlockList& result) {
    grf::Block& copy = result.blocks.emplace_back(
        grf::Block{grf::Transform{transform.steps, {}}, block.comments, block.location});
    grf::BlockList body = blocks(transform.body);
    std::get<grf::Transform>(copy.content).body = std::move(body);
  }

  void add(const grf::DefinitionScope& scope, const grf::Block& block, grf::BlockList& result) {
    grf::DefinitionScope converted;
    for (const grf::Definition& definition : scope.definitions) {
      define(definition, converted.definitions);
      scope_.enter(definition);
    }
    converted.body = blocks(scope.body);
    scope_.leave(scope.definitions.size());
    result.blocks.push_back({std::move(converted), block.comments, block.location});
  }

  // A mesh that is split becomes several definitions, and its `use` is repeated for each.
  void define(const grf::Definition& definition, std::vector<grf::Definition>& result) {
    const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body);
    if (mesh == nullptr) {
      grf::Definition& copy = result.emplace_back(definition);
      if (auto* brdf = std::get_if<grf::BrdfModel>(&copy.body)) downgrade(*brdf);
      if (auto* pdf = std::get_if<grf::PdfModel>(&copy.body)) downgrade(*pdf);
      return;
    }
    Parts parts = parts_of(**mesh, definition.location);
    Placed& placed = placed_[&definition] = {{}, parts.light};
    if (parts.meshes.empty()) parts.meshes.emplace_back();  // a `def` needs a body
    for (grf::Mesh& part : parts.meshes) {
      grf::Definition& copy =
          result.emplace_back(grf::Definition{definition.name, {}, {}, definition.location});
      if (placed.names.empty()) {
        copy.comments = definition.comments;
        name_in_comment(**mesh, copy.comments);
      } else {
        copy.name = names_.take(definition.name);
      }
      placed.names.push_back(copy.name);
      copy.body = grf::Shared<grf::Mesh>(std::move(part));
    }
  }

  void add(const grf::Use& use, const grf::Block& block, grf::BlockList& result) {
    const auto placed = placed_.find(scope_.scope().find(use.mesh.name));
    if (placed == placed_.end()) return result.blocks.push_back(block);
    for (const std::string& name : placed->second.names) {
      grf::Block& copy = result.blocks.emplace_back(block);
      copy.content = grf::Use{{name, use.mesh.location}};
      if (name != use.mesh.name) copy.comments = {};
    }
    if (placed->second.light) result.blocks.push_back({*placed->second.light, {}, block.location});
  }

  static void name_in_comment(const grf::Mesh& mesh, grf::Comments& comments) {
    std::string name = mesh.name;
    while (name.ends_with('\r')) name.pop_back();  // it would become part of the line end
    if (!name.empty()) comments.before.push_back(" " + name);
  }

  Parts parts_of(const grf::Mesh& original, const grf::SourceLocation& location) {
    grf::Mesh mesh = original;
    mesh.name.clear();
    std::vector<std::uint32_t> reflecting;
    std::vector<std::uint32_t> emitting;
    for (std::uint32_t i = 0; i < mesh.face_count(); ++i) {
      (emits(mesh.surface(i)) ? emitting : reflecting).push_back(i);
    }
    report_opacity(mesh, location);
    Parts parts;
    if (!emitting.empty()) parts.light = light_of(mesh, emitting, location);
    if (parts.light && reflecting.empty()) {
      grf::Mesh& light = parts.light->mesh.edit();
      light.comments = mesh.comments;
      keep_comments(light);
      return parts;
    }
    for (grf::Surface& surface : mesh.surfaces) downgrade(surface);
    const std::vector<std::vector<std::uint32_t>> runs = runs_without_none(mesh, reflecting);
    if (runs.size() > 1) {
      diagnostics_.warning(
          location,
          fmt::format("the grammar of 2008 has no 'none' in faces: the mesh becomes {}", runs.size()));
    }
    if (runs.size() == 1 && emitting.empty()) {
      own_of_first_face(mesh);
      keep_comments(mesh);
      parts.meshes.push_back(std::move(mesh));
      return parts;
    }
    for (const auto& run : runs) parts.meshes.push_back(grf::submesh(mesh, run));
    parts.meshes.front().comments = mesh.comments;
    keep_comments(parts.meshes.front());
    return parts;
  }

  // Comments of a removed attribute are kept before the vertices.
  static void keep_comments(grf::Mesh& mesh) {
    const grf::Surface& own = mesh.surfaces.front();
    std::vector<std::string>& kept = mesh.comments.vertices.before;
    const auto keep = [&kept](bool has_attribute, grf::Comments& comments) {
      if (has_attribute) return;
      if (!comments.behind.empty()) comments.before.push_back(comments.behind);
      kept.insert(kept.begin(), comments.before.begin(), comments.before.end());
      comments = {};
    };
    keep(own.opacity.has_value(), mesh.comments.opacity);
    keep(own.emission.has_value(), mesh.comments.emission);
    keep(own.texture.has_value(), mesh.comments.texture);
    keep(own.pdf.has_value(), mesh.comments.pdf);
    keep(own.brdf.has_value(), mesh.comments.brdf);
    keep(own.colour.has_value(), mesh.comments.colour);
  }

  // An opacity of 1 is the default.
  void report_opacity(const grf::Mesh& mesh, const grf::SourceLocation& location) {
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      const grf::Surface& surface = mesh.surface(i);
      if (!surface.opacity || *surface.opacity == grf::Opacity()) continue;
      diagnostics_.error(surface.location.file ? surface.location : location,
                         fmt::format("face {} has '{}', which the grammar of 2008 lacks", i,
                                     grf::to_text(*surface.opacity)));
      return;
    }
  }

  static bool emits(const grf::Surface& surface) {
    return surface.emission && *surface.emission != grf::Colour(0);
  }

  // The mesh's own surface becomes that of its first face if that lacks an attribute.
  static void own_of_first_face(grf::Mesh& mesh) {
    if (mesh.face_count() == 0 || !needs_none(mesh.surfaces.front(), mesh.surface(0))) return;
    const std::uint32_t first = mesh.surface_of_face->front();
    std::swap(mesh.surfaces.front(), mesh.surfaces[first]);
    for (std::uint32_t& surface : mesh.surface_of_face.edit()) {
      if (surface == 0 || surface == first) surface = first - surface;
    }
  }

  static std::vector<std::vector<std::uint32_t>> runs_without_none(const grf::Mesh& mesh,
                                                                   const std::vector<std::uint32_t>& faces) {
    std::vector<std::vector<std::uint32_t>> runs(1);
    const grf::Surface* before = nullptr;
    for (const std::uint32_t face : faces) {
      const grf::Surface& surface = mesh.surface(face);
      if (before != nullptr && needs_none(*before, surface)) runs.emplace_back();
      runs.back().push_back(face);
      before = &surface;
    }
    return runs;
  }

  grf::MeshLight light_of(const grf::Mesh& mesh, const std::vector<std::uint32_t>& faces,
                          const grf::SourceLocation& location) {
    grf::Mesh light = grf::submesh(mesh, faces);
    bool had_brdf = false;
    bool had_radiance = false;
    for (const std::uint32_t face : faces) {
      const grf::Surface& surface = mesh.surface(face);
      had_brdf = had_brdf || surface.brdf;
      had_radiance = had_radiance || *surface.emission != grf::Colour(1);
    }
    make_plain(light);
    if (had_radiance) warn_of_radiance(location);
    if (had_brdf) diagnostics_.warning(location, "faces that emit lose their BRDF: they become a mesh light");
    return {std::move(light)};
  }

  grf::MeshLight plain_light(grf::Mesh mesh, const grf::SourceLocation& location) {
    bool had_radiance = false;
    for (const std::uint32_t surface : *mesh.surface_of_face) {
      const grf::ResolvedSurface resolved = grf::resolve(mesh.surfaces[surface], scope_.scope());
      had_radiance = had_radiance || resolved.colour != grf::Colour(1);
    }
    if (had_radiance) warn_of_radiance(location);
    make_plain(mesh);
    keep_comments(mesh);
    return {std::move(mesh)};
  }

  static void make_plain(grf::Mesh& light) {
    light.surfaces = {grf::Surface()};
    light.surface_of_face = std::vector<std::uint32_t>(light.face_count(), 0);
  }

  void warn_of_radiance(const grf::SourceLocation& location) {
    diagnostics_.warning(location,
                         "mesh lights have the radiance 1 in the grammar of 2008: another one is lost");
  }

  // Only reflecting faces are kept. A face with an emission of 0 is as black as one that emits.
  void downgrade(grf::Surface& surface) {
    if (surface.emission && !surface.brdf) surface.brdf = black();
    surface.emission.reset();
    surface.opacity.reset();
    if (surface.brdf) downgrade_model<grf::BrdfModel>(*surface.brdf);
    if (surface.pdf) downgrade_model<grf::PdfModel>(*surface.pdf);
  }

  template <class ModelOfKind>
  void downgrade_model(std::variant<ModelOfKind, grf::Reference>& attribute) {
    if (auto* model = std::get_if<ModelOfKind>(&attribute)) downgrade(*model);
  }

  void downgrade(grf::BrdfModel& brdf) {
    if (!brdf.data_file.empty() && !brdf.arguments.empty()) {
      diagnostics_.warning(
          brdf.arguments.front().location,
          fmt::format("'{}' has no parameters in the grammar of 2008: they are lost", brdf.keyword));
      brdf.arguments.clear();
      if (!brdf.instance_file.empty()) changed_file_ = {brdf.instance_file, brdf.location};
    }
    if (is_layered(brdf)) {
      diagnostics_.error(
          brdf.location,
          fmt::format("'{}' names a BRDF as a value, which the grammar of 2008 lacks", brdf.keyword));
    }
    downgrade(static_cast<grf::Model&>(brdf));
  }

  // Parameters of a sampling scheme do not change the image; those of a BRDF do.
  void downgrade(grf::PdfModel& pdf) {
    std::erase_if(pdf.arguments, [this](const grf::Argument& argument) {
      const bool is_word = std::holds_alternative<grf::Word>(argument.value);
      if (is_word) {
        diagnostics_.warning(
            argument.location,
            fmt::format("'{}' has a word as value, which the grammar of 2008 lacks: it is lost",
                        argument.name));
      }
      return is_word;
    });
    downgrade(static_cast<grf::Model&>(pdf));
  }

  void downgrade(grf::Model& model) {
    for (const grf::Argument& argument : model.arguments) {
      if (argument.map) {
        diagnostics_.error(
            argument.location,
            fmt::format("an image varies '{}', which the grammar of 2008 lacks", argument.name));
      }
      if (std::holds_alternative<grf::Word>(argument.value)) {
        diagnostics_.error(
            argument.location,
            fmt::format("'{}' has a word as value, which the grammar of 2008 lacks", argument.name));
      }
      if (!std::holds_alternative<grf::Colour>(argument.value)) continue;
      diagnostics_.error(argument.location,
                         fmt::format("'{}' has three numbers, and parameters have one in the grammar of 2008",
                                     argument.name));
    }
  }

  /// The conversion of a defined mesh.
  struct Placed {
    std::vector<std::string> names;
    std::optional<grf::MeshLight> light;
  };

  grf::Diagnostics& diagnostics_;
  std::optional<ChangedFile> changed_file_;
  grf::ScopeStack scope_;
  grf::UniqueNames names_;  ///< names of all definitions
  std::map<const grf::Definition*, Placed> placed_;
};

}  // namespace

std::optional<grf::Scene> to_grf2008(const grf::Scene& scene, const std::string& path,
                                     grf::Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  grf::Diagnostics ignored_diagnostics;
  Downgrade trial(ignored_diagnostics);
  trial.run(scene);
  const std::optional<ChangedFile>& changed = trial.changed_file();
  if (changed) {
    diagnostics.warning(changed->named_at,
                        fmt::format("'{}' needs what the grammar of 2008 lacks: all files are written as one",
                                    changed->name));
  }
  grf::Scene result = Downgrade(diagnostics).run(changed ? grf::flatten(scene, path) : scene);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return result;
}

}  // namespace convert
