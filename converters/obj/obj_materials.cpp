#include "converters/obj/obj_materials.h"

#include <filesystem>
#include <sstream>
#include <utility>

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

/// Converts a file name relative to another file to one relative to the OBJ file.
std::string named_from(const std::string& obj_path, const std::string& naming_file, const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path named(name);
  if (named.is_absolute()) return name;
  const fs::path from = fs::path(grf::canonical_path(obj_path)).parent_path();
  const fs::path to = fs::path(grf::canonical_path(naming_file)).parent_path();
  if (from == to) return named.lexically_normal().string();
  const fs::path relative = (to / named).lexically_normal().lexically_relative(from);
  return relative.empty() ? (to / named).string() : relative.string();
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
    // Files are often renamed without the references to them.
    diagnostics_.warning(location,
                         fmt::format("there is no '{}': '{}' is read in its place", path, usual_path));
    path = usual_path;
  }
  if (!paths_.insert(grf::canonical_path(path)).second) return;
  for (MtlMaterial& material : read_mtl(path, location, diagnostics_)) add(std::move(material), path);
}

// The first definition of a name is used.
void ObjMaterials::add(MtlMaterial material, const std::string& library_path) {
  const std::string name = material.phong.name;
  if (!by_name_.emplace(name, entries_.size()).second) {
    defined_again_.push_back(name);
    return;
  }
  if (material.phong.diffuse_map) {
    std::string& image = material.phong.diffuse_map->file;
    image = image_named_from_obj(image, library_path);
  }
  Entry entry;
  entry.material = map_material(material.phong);
  entry.uv = material.uv;
  if (material.exact) {
    entry.material.clamped = false;
    entry.colour = material.exact->colour;
    entry.has_brdf = material.exact->brdf.has_value();
    if (entry.has_brdf) {
      grf::BrdfModel& brdf = *material.exact->brdf;
      if (!brdf.data_file.empty()) brdf.data_file = named_from(obj_path_, library_path, brdf.data_file);
      entry.material.definition.body = brdf;
      entry.material.definition.comments = {};
    }
  }
  if (entry.material.clamped) clamped_.push_back(name);
  entries_.push_back(std::move(entry));
}

// Models are often moved together with their images, but without the folders that they name.
std::string ObjMaterials::image_named_from_obj(const std::string& name, const std::string& library_path) {
  const std::string beside = std::filesystem::path(name).filename().string();
  for (const std::string& candidate : {name, beside}) {
    std::error_code error;
    const bool is_there = std::filesystem::is_regular_file(grf::path_beside(library_path, candidate), error);
    if (is_there) return named_from(obj_path_, library_path, candidate);
  }
  return named_from(obj_path_, library_path, name);
}

ObjSurface ObjMaterials::surface(const std::string& name, std::size_t faces, Losses& losses) {
  const auto [known, is_new] = by_name_.emplace(name, entries_.size());
  if (is_new) {
    Entry& entry = entries_.emplace_back();
    entry.material = unknown_material(name, brdf_);
    entry.in_library = false;
    unknown_.push_back(name);
  }
  const Entry& entry = entries_[known->second];
  if (!entry.in_library) faces_of_unknown_ += faces;
  for (const Loss loss : entry.material.losses) losses.add(loss, faces);
  ObjSurface result;
  result.uv = entry.uv;
  grf::Surface& surface = result.surface;
  if (entry.has_brdf) surface.brdf = grf::Reference{entry.material.definition.name, {}};
  if (entry.colour) surface.colour = *entry.colour;
  surface.emission = entry.material.emission;
  surface.opacity = entry.material.opacity;
  if (entry.material.texture) surface.texture = *entry.material.texture;
  return result;
}

void ObjMaterials::report(const grf::SourceLocation& location) const {
  if (!unknown_.empty()) {
    const std::string message = fmt::format("{} of materials that no library defines ({}): BRDF {}",
                                            counted(faces_of_unknown_, "face is", "faces are"),
                                            listed(unknown_), grf::to_text(brdf_));
    // If the file names no library, nothing is missing: its materials are only names.
    if (names_library_) {
      diagnostics_.warning(location, message);
    } else {
      diagnostics_.note(location, message);
    }
  }
  if (!defined_again_.empty()) {
    diagnostics_.warning(location,
                         fmt::format("materials are defined again ({}): the first definition is used",
                                     listed(defined_again_)));
  }
  if (!clamped_.empty()) {
    diagnostics_.warning(location, fmt::format("values of materials are out of range, and were clamped ({})",
                                               listed(clamped_)));
  }
}

std::vector<grf::Definition> ObjMaterials::definitions() const {
  std::vector<grf::Definition> definitions;
  for (const Entry& entry : entries_) {
    if (entry.has_brdf) definitions.push_back(entry.material.definition);
  }
  return definitions;
}

}  // namespace convert
