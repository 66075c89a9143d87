#pragma once

#include <QPolygonF>
#include <QSize>
#include <functional>

#include "editor/document/face_selection.h"
#include "editor/view/geometry_store.h"
#include "editor/view/view_drawing.h"

namespace editor {

/// A scene as it is seen in an image of so many pixels.
struct SeenScene {
  const SceneObjects& objects;
  const std::vector<MeshShape>& shapes;
  const ViewCamera& camera;
  QSize size;
};

/// The nearest face on a ray in the world, and where the ray meets it.
struct SceneHit {
  FaceId face;
  std::uint32_t instance = 0;
  double distance = 0;
};
std::optional<SceneHit> intersect(const SceneObjects& objects, const std::vector<MeshShape>& shapes,
                                  const ViewRay& ray);

/// The faces of a region of the image, whose corners are in pixels from the upper left. Those that are seen
/// in a pixel of it are; and of those too small for a pixel, those whose centre is in the region and lies on
/// what is seen there. `faces_in` gives the pixels of a rectangle, from the lower left.
FaceSelection seen_in_region(const SeenScene& scene, const QPolygonF& region,
                             const std::function<std::vector<FacePixel>(const QRect&)>& faces_in);

/// All faces whose centre is in the region, hidden or not.
FaceSelection all_in_region(const SeenScene& scene, const QPolygonF& region);

}  // namespace editor
