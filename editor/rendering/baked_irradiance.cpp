#include "editor/rendering/baked_irradiance.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>

#include "editor/document/scene_places.h"
#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/visit.h"
#include "renderer/bake/baked_scene.h"

namespace editor {
namespace {

/// An unused name for the IGRF file that replaces an included file.
std::string igrf_name(const std::string& file, const std::string& naming_file) {
  const std::filesystem::path old = file;
  std::filesystem::path name = old;
  name.replace_extension(".igrf");
  for (int i = 2; std::filesystem::exists(grf::path_beside(naming_file, name.string())); ++i) {
    name = old.parent_path() / (old.stem().string() + "_" + std::to_string(i) + ".igrf");
  }
  return name.string();
}

/// Renames included files that hold irradiance to IGRF, so that they can be written.
class IncludeKeeper {
 public:
  explicit IncludeKeeper(const grf::Scene& scene) : counts_(included_files(scene)) {}

  /// `naming_file` is the file to which the names of includes are relative.
  void keep(grf::BlockList& list, const std::string& naming_file) {
    std::vector<grf::Block> blocks;
    blocks.reserve(list.blocks.size());
    for (grf::Block& block : list.blocks) {
      if (auto* transform = std::get_if<grf::Transform>(&block.content)) keep(transform->body, naming_file);
      if (auto* scope = std::get_if<grf::DefinitionScope>(&block.content)) keep(scope->body, naming_file);
      auto* include = std::get_if<grf::Include>(&block.content);
      if (include == nullptr || !keep(*include, naming_file)) {
        blocks.push_back(std::move(block));
        continue;
      }
      ++expanded_;
      grf::Scene part;
      part.contents.blocks.push_back(std::move(block));
      part = grf::flatten(part, naming_file);
      std::move(part.contents.blocks.begin(), part.contents.blocks.end(), std::back_inserter(blocks));
    }
    list.blocks = std::move(blocks);
  }
  std::size_t expanded_includes() const { return expanded_; }

 private:
  /// Whether the include has to be replaced by its blocks.
  bool keep(grf::Include& include, const std::string& naming_file) {
    grf::BlockList inside = *include.contents;
    keep(inside, grf::path_beside(naming_file, include.file));
    if (!(inside == *include.contents)) include.contents = std::move(inside);
    if (!grf::has_irradiance(*include.contents)) return false;
    const auto count = counts_.find(include.origin.path);
    if (count != counts_.end() && count->second > 1) return true;
    if (!grf::is_igrf_name(include.file)) include.file = igrf_name(include.file, naming_file);
    return false;
  }

  const std::map<std::string, std::size_t> counts_;
  std::size_t expanded_ = 0;
};

}  // namespace

BakedIrradiance::BakedIrradiance(const grf::Scene& snapshot, const grf::Scene& baked)
    : observers_(grf::observers_of(baked)) {
  std::vector<grf::Shared<grf::VertexIrradiance>> irradiances;
  grf::SceneVisitor collect;
  collect.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) {
    irradiances.push_back(mesh.irradiance);
  };
  grf::visit(baked, collect);
  std::size_t next = 0;
  grf::SceneVisitor match;
  match.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    if (next < irradiances.size()) {
      places_.emplace(key_of(mesh, placement.to_world), BakedMesh{mesh.geometry, irradiances[next]});
    }
    ++next;
  };
  grf::visit(snapshot, match);
  if (next != irradiances.size()) places_.clear();
}

BakedIrradiance::Key BakedIrradiance::key_of(const grf::Mesh& mesh, const grf::Matrix44d& to_world) {
  Key key = {&*mesh.geometry, {}};
  std::copy_n(to_world.getValue(), key.second.size(), key.second.begin());
  return key;
}

IrradiatedScene BakedIrradiance::applied_to(grf::Scene scene, const std::string& path) const {
  IrradiatedScene result;
  const auto arriving = [&](const grf::Mesh& mesh,
                            const grf::Matrix44d& to_world) -> std::optional<grf::VertexIrradiance> {
    const auto place = places_.find(key_of(mesh, to_world));
    ++(place == places_.end() ? result.skipped : result.meshes);
    if (place == places_.end()) return std::nullopt;
    return *place->second.irradiance;
  };
  IncludeKeeper includes(scene);
  result.scene = bake::with_irradiance(std::move(scene), arriving).scene;
  includes.keep(result.scene.contents, path);
  result.expanded_includes = includes.expanded_includes();
  if (result.meshes > 0 && !observers_.empty() && grf::observers_of(result.scene).empty()) {
    outermost_blocks(result.scene).blocks.emplace_back().content = grf::Params{observers_};
  }
  return result;
}

}  // namespace editor
