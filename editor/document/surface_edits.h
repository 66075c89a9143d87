// What selected faces have, and giving them something else.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "editor/document/face_selection.h"
#include "editor/document/scene_objects.h"
#include "editor/document/scene_patch.h"
#include "grf/scene_path.h"
#include "grf/surface.h"

namespace editor {

/// An attribute that stays as it is, is taken away so that its default holds, or gets a value.
template <class Value>
class AttributeEdit {
 public:
  AttributeEdit() = default;
  static AttributeEdit set(Value value) { return AttributeEdit(std::move(value)); }
  static AttributeEdit remove() { return AttributeEdit(std::optional<Value>()); }

  bool is_any() const { return is_any_; }
  const std::optional<Value>& value() const { return value_; }
  void apply(std::optional<Value>& attribute) const {
    if (is_any_) attribute = value_;
  }

 private:
  explicit AttributeEdit(std::optional<Value> value) : is_any_(true), value_(std::move(value)) {}

  bool is_any_ = false;
  std::optional<Value> value_;
};

/// What to give faces.
struct SurfaceEdit {
  AttributeEdit<grf::ColourAttribute> colour;
  AttributeEdit<grf::BrdfAttribute> brdf;
  AttributeEdit<grf::PdfAttribute> pdf;
  AttributeEdit<grf::TextureAttribute> texture;
  AttributeEdit<grf::Colour> emission;

  void apply(grf::Surface& surface) const;
  /// Faces of any surface get the same.
  const SurfaceEdit& operator()(const grf::Surface&) const { return *this; }
};

/// What to give the faces that have a surface; a SurfaceEdit is one, too.
using SurfaceEdits = std::function<SurfaceEdit(const grf::Surface&)>;

/// All that a surface has: for copies from face to face.
SurfaceEdit edit_to(const grf::Surface& surface);

/// What the faces of a selection have in an attribute.
template <class Value>
struct CommonValue {
  bool is_mixed = false;
  std::optional<Value> value;  ///< absent: no face has one; meaningless if it is mixed

  /// Takes up what one more face has.
  void meet(const std::optional<Value>& other, bool is_first) {
    if (is_first) {
      value = other;
    } else if (value != other) {
      is_mixed = true;
    }
  }
};

struct CommonSurface {
  CommonValue<grf::ColourAttribute> colour;
  CommonValue<grf::BrdfAttribute> brdf;
  CommonValue<grf::PdfAttribute> pdf;
  CommonValue<grf::TextureAttribute> texture;
  CommonValue<grf::Colour> emission;  ///< of mesh lights, what they have instead of all
};

/// Of a selection without faces nothing is common, and nothing mixed.
CommonSurface common_surface(const SceneObjects& objects, const FaceSelection& selection);

/// The BRDFs that selected faces have, each once a mesh; those of mesh lights, which reflect nothing, left
/// out.
struct MeshBrdf {
  std::uint32_t mesh = 0;
  std::optional<grf::BrdfAttribute> brdf;  ///< absent: the default

  bool operator==(const MeshBrdf&) const = default;
};
std::vector<MeshBrdf> selected_brdfs(const SceneObjects& objects, const FaceSelection& selection);

/// The area of the selected faces in the world, all instances counted.
double selected_area(const SceneObjects& objects, const FaceSelection& selection);

/// Takes away surfaces that no face has, but for the first, which is the mesh's own: where all faces have
/// another one, that becomes it.
void remove_unused_surfaces(std::vector<grf::Surface>& surfaces, std::vector<std::uint32_t>& surface_of_face);

/// The meshes with selected faces after edits. Mesh lights get their emission, and no more.
std::vector<PlacedMesh> edited(const SceneObjects& objects, const FaceSelection& selection,
                               const SurfaceEdits& edits);

}  // namespace editor
