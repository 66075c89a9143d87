#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "converters/brdf_lobes.h"
#include "converters/material_mapping.h"
#include "converters/material_rule.h"
#include "converters/world_meshes.h"
#include "grf/scene.h"
#include "grf/unique_names.h"

namespace convert {

/// The materials of a written OBJ file: one per BRDF of a scene, named by its definition or its text, and
/// further ones if faces with it differ in colour, image, emission or opacity. Each has the exact BRDF in a
/// comment, which `read_mtl` restores.
class MtlWriter {
 public:
  /// Collects the materials of a flat scene, in which each definition occurs once. Pointers into the scene
  /// and the meshes are kept: both must outlive this.
  MtlWriter(const grf::Scene& scene, const WorldMeshes& meshes);

  bool empty() const { return materials_.empty(); }

  /// Returns the name of the material of faces with a surface; null if they have none.
  const std::string* name_of(const WorldSurface& surface, bool is_light) const;
  /// Returns the name of the default material, for faces without a material after faces with one.
  const std::string* name_of_none() const;

  /// Returns the text of the library.
  std::string text() const;

  /// Returns the number of faces with a BRDF that MTL's values only approximate.
  std::size_t approximated_faces() const { return approximated_faces_; }

 private:
  /// The key by which materials are distinct. Pointers are into the scene.
  struct Key {
    const grf::BrdfModel* brdf = nullptr;
    std::vector<const grf::BrdfModel*> terms;  ///< resolved terms of a `combine`
    bool is_black = false;                     ///< for lights, which have no BRDF
    std::optional<std::string> image;
    std::vector<float> colour;    ///< empty if there is none
    std::vector<float> emission;  ///< empty if there is none
    float opacity = 1;            ///< a factor if alpha is read
    bool reads_alpha = false;     ///< of the image

    /// Returns true for faces that need no material.
    bool is_plain() const { return *this == Key(); }
    bool operator==(const Key&) const = default;
    auto operator<=>(const Key&) const = default;
  };
  struct Material {
    Key key;
    std::string name;
  };
  struct NamedBrdf {
    const grf::Definition* definition = nullptr;
    std::vector<const grf::BrdfModel*> terms;
  };

  static bool returns_to_plain(const WorldMeshes& meshes);
  static Key key_of(const WorldSurface& surface, bool is_light);
  void find_definitions(const grf::Scene& scene);
  void add_materials(const std::vector<Key>& keys);
  void add(const Key& key, const std::string& name);
  std::optional<grf::BrdfModel> with_named_terms(const Key& key) const;
  BrdfLobes lobes_of(const grf::BrdfModel& brdf, const std::vector<const grf::BrdfModel*>& terms) const;
  PhongMaterial phong_of(const Key& key) const;
  std::string text_of(const Material& material) const;

  std::vector<NamedBrdf> definitions_;
  std::map<const grf::BrdfModel*, BrdfLobes> lobes_of_definitions_;
  std::map<const grf::BrdfModel*, std::size_t> first_of_brdf_;
  std::vector<Material> materials_;
  std::map<Key, std::size_t> by_key_;
  grf::UniqueNames names_;
  std::size_t approximated_faces_ = 0;
};

/// Returns the table of conversions of surfaces that are written.
std::span<const MaterialRule> mtl_writer_rules();

}  // namespace convert
