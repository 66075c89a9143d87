// Reads and edits the surfaces of selected faces.
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

/// An edit of an attribute: keep it, remove it so that its default applies, or set it.
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

/// The edits of a surface's attributes.
struct SurfaceEdit {
  AttributeEdit<grf::ColourAttribute> colour;
  AttributeEdit<grf::BrdfAttribute> brdf;
  AttributeEdit<grf::PdfAttribute> pdf;
  AttributeEdit<grf::TextureAttribute> texture;
  AttributeEdit<grf::Colour> emission;
  AttributeEdit<grf::Opacity> opacity;

  void apply(grf::Surface& surface) const;
  /// Faces of any surface get the same.
  const SurfaceEdit& operator()(const grf::Surface&) const { return *this; }
};

/// A function from the present surface to its edit. A SurfaceEdit is one, too.
using SurfaceEdits = std::function<SurfaceEdit(const grf::Surface&)>;

/// The edit that copies a whole surface from face to face.
SurfaceEdit edit_to(const grf::Surface& surface);

/// The value of an attribute that the selected faces share.
template <class Value>
struct CommonValue {
  bool is_mixed = false;
  std::optional<Value> value;  ///< absent if no face has one; undefined if mixed

  /// Accumulates the value of another face.
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
  CommonValue<grf::Colour> emission;  ///< for mesh lights, whose only attribute it is
  CommonValue<grf::Opacity> opacity;
};

/// Computes the common attributes; for an empty selection nothing is common, and nothing mixed.
CommonSurface common_surface(const SceneObjects& objects, const FaceSelection& selection);

/// A BRDF of selected faces, once per mesh; mesh lights, which do not reflect, are left out.
struct MeshBrdf {
  std::uint32_t mesh = 0;
  std::optional<grf::BrdfAttribute> brdf;  ///< absent for the default

  bool operator==(const MeshBrdf&) const = default;
};
std::vector<MeshBrdf> selected_brdfs(const SceneObjects& objects, const FaceSelection& selection);

/// World-space area of the selected faces, summed over all instances.
double selected_area(const SceneObjects& objects, const FaceSelection& selection);

/// Removes unused surfaces, except for the first, which is the mesh's own: if no face has it, another one
/// takes its place.
void remove_unused_surfaces(std::vector<grf::Surface>& surfaces, std::vector<std::uint32_t>& surface_of_face);

/// Returns the meshes with selected faces after the edits. Mesh lights get only their emission.
std::vector<PlacedMesh> edited(const SceneObjects& objects, const FaceSelection& selection,
                               const SurfaceEdits& edits);

}  // namespace editor
