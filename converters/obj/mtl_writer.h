#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "converters/brdf_parts.h"
#include "converters/material_mapping.h"
#include "converters/material_rule.h"
#include "converters/world_meshes.h"
#include "grf/scene.h"
#include "grf/unique_names.h"

namespace convert {

/// The materials of an OBJ file that is written: one for each BRDF of a scene, by the name of its definition
/// or by what it says, and more where faces with it differ in colour, image or emission. Each has the exact
/// BRDF in a comment, which `read_mtl` takes back.
class MtlWriter {
 public:
  /// The scene is flat, so that each definition stands at one place. Pointers into the scene and the meshes
  /// are kept: both outlive this.
  MtlWriter(const grf::Scene& scene, const WorldMeshes& meshes);

  bool empty() const { return materials_.empty(); }

  /// The name of the material that faces with a surface have; null where they have none.
  const std::string* name_of(const WorldSurface& surface, bool is_light) const;
  /// The name that stands for none behind faces that have a material.
  const std::string* name_of_none() const;

  /// The library.
  std::string text() const;

  /// How many faces have a BRDF that the values of MTL only come near.
  std::size_t approximated_faces() const { return approximated_faces_; }

 private:
  /// What makes a material another one. Pointers are into the scene.
  struct Key {
    const grf::BrdfModel* brdf = nullptr;
    std::vector<const grf::BrdfModel*> terms;  ///< of a `combine`: what it names
    bool is_black = false;                     ///< where there is no BRDF: a light's
    std::optional<std::string> image;
    std::vector<float> colour;    ///< empty if there is none
    std::vector<float> emission;  ///< the same

    /// True of faces that need no material.
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
  BrdfParts parts_of(const grf::BrdfModel& brdf, const std::vector<const grf::BrdfModel*>& terms) const;
  PhongMaterial phong_of(const Key& key) const;
  std::string text_of(const Material& material) const;

  std::vector<NamedBrdf> definitions_;
  std::map<const grf::BrdfModel*, BrdfParts> parts_of_definitions_;
  std::map<const grf::BrdfModel*, std::size_t> first_of_brdf_;
  std::vector<Material> materials_;
  std::map<Key, std::size_t> by_key_;
  grf::UniqueNames names_;
  std::size_t approximated_faces_ = 0;
};

/// What becomes of surfaces that are written.
std::span<const MaterialRule> mtl_writer_rules();

}  // namespace convert
