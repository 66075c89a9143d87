#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "converters/format.h"
#include "converters/losses.h"
#include "converters/material_mapping.h"
#include "converters/obj/mtl.h"
#include "converters/obj/obj_text.h"
#include "grf/diagnostics.h"

namespace convert {

/// What faces with a material have.
struct ObjSurface {
  grf::Surface surface;
  UvTransform uv;  ///< for their texture coordinates
};

/// The materials of an OBJ file: those of its libraries, and those that only its faces name.
class ObjMaterials {
 public:
  /// `brdf` is for materials of which nothing but the name is known.
  ObjMaterials(std::string obj_path, grf::BrdfModel brdf, grf::Diagnostics& diagnostics)
      : obj_path_(std::move(obj_path)), brdf_(std::move(brdf)), diagnostics_(diagnostics) {}

  /// Reads what a `mtllib` statement names: one file, or several with spaces between.
  void read(const LibraryName& library);

  /// True if a library defines the name.
  bool has(std::string_view name) const { return by_name_.contains(name); }

  /// The surface of so many faces with the material, whose losses are counted.
  ObjSurface surface(const std::string& name, std::size_t faces, Losses& losses);

  /// Warns of what is wrong with the materials, a line a kind. To be called when all faces are known.
  void report(const grf::SourceLocation& location) const;

  /// A definition for each material, whether or not a face has it.
  std::vector<grf::Definition> definitions() const;

 private:
  struct Entry {
    MappedMaterial material;
    UvTransform uv;
    std::optional<grf::Colour> colour;
    bool has_brdf = true;
    bool in_library = true;
  };

  void read_file(const std::string& name, const grf::SourceLocation& location);
  void add(MtlMaterial material, const std::string& library_path);
  std::string image_named_from_obj(const std::string& name, const std::string& library_path);

  std::string obj_path_;
  grf::BrdfModel brdf_;
  grf::Diagnostics& diagnostics_;
  std::set<std::string> paths_;  // of libraries that were read: exporters name one again for each object
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t, std::less<>> by_name_;
  std::vector<std::string> clamped_;
  std::vector<std::string> defined_again_;
  std::vector<std::string> unknown_;
  std::size_t faces_of_unknown_ = 0;
  bool names_library_ = false;
};

}  // namespace convert
