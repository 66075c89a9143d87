#pragma once

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "converters/gltf/gltf_brdf.h"
#include "converters/gltf/gltf_document.h"
#include "converters/gltf/gltf_images.h"
#include "converters/material_rule.h"
#include "grf/diagnostics.h"
#include "grf/visit.h"

namespace convert {

/// Rounds a material factor, since it is approximate anyway, to few digits.
inline double rounded_factor(double x) { return std::round(x * 1e6) / 1e6; }

/// Writes surfaces as the nearest glTF materials, without duplicates, and the images that they name.
class GltfMaterialWriter {
 public:
  /// Images are embedded in the document (a GLB file), or referenced. `path` is the written file.
  GltfMaterialWriter(GltfDocument& document, const std::string& path, bool embeds_images,
                     grf::Diagnostics& diagnostics)
      : document_(document), path_(path), embeds_images_(embeds_images), diagnostics_(diagnostics) {}

  /// Returns the index of the surface's material. Faces of a mesh light reflect nothing, and their colour is
  /// the emitted radiance.
  int material(const grf::Surface& surface, const grf::Scope& scope);
  int light_material(const grf::Surface& surface, const grf::Scope& scope);
  int light_material(const grf::Colour& radiance);

  /// Returns the names of embedded images, by their names in the scene.
  const std::map<std::string, std::string>& embedded() const { return embedded_; }

  /// Warns about images that cannot be read or are of a format that glTF does not support.
  void report() const;

 private:
  int add(nlohmann::json material);
  void add_maps(nlohmann::json& material, const GltfBrdf& values, bool has_texture);
  int texture(const std::string& file);
  nlohmann::json image(const std::string& file);

  GltfDocument& document_;
  const std::string& path_;
  bool embeds_images_;
  grf::Diagnostics& diagnostics_;
  std::map<std::string, int> materials_;  ///< by their JSON
  std::map<std::string, int> textures_;   ///< by file name; -1: not available
  ImageNames names_;
  std::map<std::string, std::string> embedded_;
  std::vector<std::string> unreadable_;
  std::vector<std::string> unknown_;
  std::vector<std::string> lost_maps_;  ///< parameters
};

/// Returns the table of conversions of surfaces that are written.
std::span<const MaterialRule> gltf_material_writer_rules();

}  // namespace convert
