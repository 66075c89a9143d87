#pragma once

#include <QPainterPath>
#include <QPolygonF>
#include <QSize>
#include <functional>

#include "editor/document/face_selection.h"
#include "editor/view/geometry_store.h"
#include "editor/view/view_drawing.h"

namespace editor {

/// A scene with the camera and the size of its image.
struct ProjectedScene {
  const SceneObjects& objects;
  const std::vector<MeshShape>& shapes;
  const ViewCamera& camera;
  QSize size;
};

/// The nearest face on a ray in world space that is not hidden, and the intersection.
struct SceneHit {
  FaceId face;
  std::uint32_t instance = 0;
  double distance = 0;
  std::uint32_t triangle = 0;  ///< of the mesh's geometry
};
std::optional<SceneHit> intersect(const SceneObjects& objects, const std::vector<MeshShape>& shapes,
                                  const FaceSelection& hidden, const ViewRay& ray);
/// The unit normal at an intersection in world space, toward the origin of the ray: interpolated if all
/// corners of the triangle have one, else that of the triangle.
grf::Vec3d normal_at(const SceneObjects& objects, const std::vector<MeshShape>& shapes, const ViewRay& ray,
                     const SceneHit& hit);

/// The region inside a closed polygon, by the even-odd rule.
QPainterPath path_of(const QPolygonF& polygon);

/// The visible faces of a region of the image, which is in pixels from the upper left: those that
/// cover a pixel of it, and those smaller than a pixel whose centre is in the region and not occluded.
/// `faces_in` returns the pixels of a rectangle, from the lower left.
FaceSelection visible_in_region(const ProjectedScene& scene, const QPainterPath& region,
                                const std::function<std::vector<FacePixel>(const QRect&)>& faces_in);

/// All faces whose centre is in the region, occluded or not.
FaceSelection all_in_region(const ProjectedScene& scene, const QPainterPath& region);

}  // namespace editor
