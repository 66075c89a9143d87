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

/// The surface of faces with a material.
struct ObjSurface {
  grf::Surface surface;
  UvTransform uv;  ///< transform of their texture coordinates
};

/// The materials of an OBJ file: those of its libraries, and undefined ones that only its faces name.
class ObjMaterials {
 public:
  /// `brdf` is for undefined materials.
  ObjMaterials(std::string obj_path, grf::BrdfModel brdf, grf::Diagnostics& diagnostics)
      : obj_path_(std::move(obj_path)), brdf_(std::move(brdf)), diagnostics_(diagnostics) {}

  /// Reads the libraries of a `mtllib` statement: one file, or several separated by spaces.
  void read(const LibraryName& library);

  /// Returns whether a library defines the name.
  bool has(std::string_view name) const { return by_name_.contains(name); }

  /// Returns the surface of a material for a number of faces, and counts their losses.
  ObjSurface surface(const std::string& name, std::size_t faces, Losses& losses);

  /// Reports problems of the materials, one line per kind. Must be called after all faces.
  void report(const grf::SourceLocation& location) const;

  /// Returns a definition per material, used or not.
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
  std::set<std::string> paths_;  // libraries read so far: exporters repeat the name for each object
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t, std::less<>> by_name_;
  std::vector<std::string> clamped_;
  std::vector<std::string> defined_again_;
  std::vector<std::string> unknown_;
  std::size_t faces_of_unknown_ = 0;
  bool names_library_ = false;
};

}  // namespace convert
