#pragma once

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "converters/gltf/gltf_document.h"
#include "converters/gltf/gltf_images.h"
#include "converters/material_rule.h"
#include "grf/diagnostics.h"
#include "grf/visit.h"

namespace convert {

/// Factors are near values, and have few digits.
inline double rounded_factor(double x) { return std::round(x * 1e6) / 1e6; }

/// Writes surfaces as the materials that come nearest to them, each once, and the images that they name.
class GltfMaterialWriter {
 public:
  /// Images are put into the document (a GLB file), or named from it. `path` is the file that is written.
  GltfMaterialWriter(GltfDocument& document, const std::string& path, bool embeds_images,
                     grf::Diagnostics& diagnostics)
      : document_(document), path_(path), embeds_images_(embeds_images), diagnostics_(diagnostics) {}

  /// The place of the surface's material. Faces of a mesh light reflect nothing, and their colour is what
  /// they emit.
  int material(const grf::Surface& surface, const grf::Scope& scope);
  int light_material(const grf::Surface& surface, const grf::Scope& scope);
  int light_material(const grf::Colour& radiance);

  /// The names of the images inside the document by those that the scene has for them.
  const std::map<std::string, std::string>& embedded() const { return embedded_; }

  /// Warns of images that cannot be read or that are of another kind than glTF knows.
  void report() const;

 private:
  int add(nlohmann::json material);
  int texture(const std::string& file);
  nlohmann::json image(const std::string& file);

  GltfDocument& document_;
  const std::string& path_;
  bool embeds_images_;
  grf::Diagnostics& diagnostics_;
  std::map<std::string, int> materials_;  ///< by their JSON
  std::map<std::string, int> textures_;   ///< by the name of their file; -1: there is none
  ImageNames names_;
  std::map<std::string, std::string> embedded_;
  std::vector<std::string> unreadable_;
  std::vector<std::string> unknown_;
};

/// What becomes of surfaces that are written.
std::span<const MaterialRule> gltf_material_writer_rules();

}  // namespace convert
