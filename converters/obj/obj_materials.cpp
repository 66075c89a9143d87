#include "converters/obj/obj_materials.h"

#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "converters/obj/mtl.h"
#include "converters/wording.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace convert {
namespace {

bool exists(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

}  // namespace

void ObjMaterials::read(const LibraryName& library) {
  names_library_ = true;
  if (exists(grf::path_beside(obj_path_, library.name))) return read_file(library.name, library.location);
  std::istringstream words(library.name);
  for (std::string word; words >> word;) read_file(word, library.location);
}

void ObjMaterials::read_file(const std::string& name, const grf::SourceLocation& location) {
  std::string path = grf::path_beside(obj_path_, name);
  const std::string usual_path = std::filesystem::path(obj_path_).replace_extension(".mtl").string();
  if (!exists(path) && exists(usual_path)) {
    // Models are renamed more often than the names inside them.
    diagnostics_.warning(location,
                         fmt::format("there is no '{}': '{}' is read in its place", path, usual_path));
    path = usual_path;
  }
  if (!paths_.insert(grf::canonical_path(path)).second) return;
  for (const PhongMaterial& material : read_mtl(path, location, diagnostics_)) add(material);
}

// The first definition of a name holds.
void ObjMaterials::add(const PhongMaterial& material) {
  if (!by_name_.emplace(material.name, entries_.size()).second) {
    defined_again_.push_back(material.name);
    return;
  }
  entries_.push_back({map_material(material)});
  if (entries_.back().material.clamped) clamped_.push_back(material.name);
}

grf::Surface ObjMaterials::surface(const std::string& name, std::size_t faces, Losses& losses) {
  const auto [known, is_new] = by_name_.emplace(name, entries_.size());
  if (is_new) {
    entries_.push_back({unknown_material(name, brdf_), false});
    unknown_.push_back(name);
  }
  const auto& [material, in_library] = entries_[known->second];
  if (!in_library) faces_of_unknown_ += faces;
  for (const Loss loss : material.losses) losses.add(loss, faces);
  grf::Surface surface;
  surface.brdf = grf::Reference{material.definition.name, {}};
  surface.emission = material.emission;
  if (material.texture) surface.texture = *material.texture;
  return surface;
}

void ObjMaterials::report(const grf::SourceLocation& location) const {
  if (!unknown_.empty()) {
    const std::string message = fmt::format("{} of materials that no library defines ({}): BRDF {}",
                                            counted(faces_of_unknown_, "face is", "faces are"),
                                            listed(unknown_), grf::to_text(brdf_));
    // Where the file names no library, nothing is missing: its materials are names alone.
    if (names_library_) {
      diagnostics_.warning(location, message);
    } else {
      diagnostics_.note(location, message);
    }
  }
  if (!defined_again_.empty()) {
    diagnostics_.warning(location, fmt::format("materials are defined again ({}): the first definition holds",
                                               listed(defined_again_)));
  }
  if (!clamped_.empty()) {
    diagnostics_.warning(location, fmt::format("values of materials are out of range, and were clamped ({})",
                                               listed(clamped_)));
  }
}

std::vector<grf::Definition> ObjMaterials::definitions() const {
  std::vector<grf::Definition> definitions;
  for (const Entry& entry : entries_) definitions.push_back(entry.material.definition);
  return definitions;
}

}  // namespace convert
