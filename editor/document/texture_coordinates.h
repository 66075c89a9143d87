// Texture coordinates (UVs) of selected faces are projected and transformed. Vertices are split where
// coordinates of a face come to differ from its neighbour's; faces that are not selected keep theirs.
#pragma once

#include "editor/document/geometry_edits.h"
#include "grf/math.h"

namespace editor {

/// How texture coordinates are projected onto faces, about the bounds of the selected faces in world space,
/// so that an object's transform does not stretch the image. A mesh with several instances is projected
/// where its first one is.
enum class UvProjection {
  AlongX,       ///< on a plane, as seen from +x; the longer side of the bounds fills 0 to 1
  AlongY,       ///< as seen from above, with -z upwards
  AlongZ,       ///< as seen from +z
  AlongNormal,  ///< as seen along the mean normal of the faces; from +z if their normals cancel out
  Box,          ///< each face along the axis that is nearest to its normal; the longest side fills 0 to 1
  Cylinder,     ///< about a vertical axis: u is the longitude, 0.5 toward +z; v is the height; faces whose
                ///< normal is nearer to the axis than to the horizon (caps) are projected along it
  Sphere,       ///< u is the longitude about a vertical axis, 0.5 toward +z; v is the latitude, 0.5 at the
                ///< equator
};

/// Projects texture coordinates onto the faces. At the seam of a cylinder or sphere, at -z, coordinates
/// continue beyond 0 or 1, so that no face has the whole image; the corner of a face at a pole has the mean
/// longitude of the others.
grf::Scene with_projected_uvs(const SelectedFaces& faces, UvProjection projection);

/// Returns a projection that suits the faces: along their mean normal if they are nearly flat, from a box
/// otherwise.
UvProjection suitable_projection(const SelectedFaces& faces);

/// A transform of texture coordinates: scale and then rotation about the pivot, then translation.
struct UvTransform {
  grf::Vec2d pivot = grf::Vec2d(0);
  grf::Vec2d scale = grf::Vec2d(1);  ///< negative to flip
  double rotation = 0;               ///< degrees, counter-clockwise
  grf::Vec2d offset = grf::Vec2d(0);

  grf::Vec2d operator()(const grf::Vec2d& uv) const;
};

/// Transforms the texture coordinates that the faces have.
grf::Scene with_transformed_uvs(const SelectedFaces& faces, const UvTransform& transform);

/// A rectangle of texture coordinates.
using UvBounds = Imath::Box2d;

/// The bounds of the texture coordinates of the faces; empty if they have none.
UvBounds uv_bounds(const SceneObjects& objects, const FaceSelection& selection);

/// The transform from bounds that are not empty to other ones, each axis by itself. An axis along which the
/// bounds have no extent is only moved.
UvTransform fitted(const UvBounds& bounds, const UvBounds& target);

}  // namespace editor
