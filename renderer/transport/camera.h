#pragma once

#include "grf/math.h"
#include "renderer/transport/scene/ray_caster.h"

namespace transport {

/// Where the eye is and what it sees, in the world: in double, so that scenes far from its origin can be
/// seen.
struct View {
  grf::Vec3d eye = grf::Vec3d(0);
  grf::Vec3d target = grf::Vec3d(0);
  Vec3f up = Vec3f(0, 1, 0);  ///< where it is parallel to the view, the z axis (or, if need be, x) is taken
  float field_of_view = 45;   ///< vertical, degrees, between 0 and 180
};

/// A view of the whole box, from in front (looking along -z) and slightly above.
View view_of(const grf::Box3d& bounds, float field_of_view, float aspect);

/// The same view in coordinates that have this point as their origin.
View seen_from(const grf::Vec3d& origin, const View& view);

/// A pinhole camera.
class Camera {
 public:
  Camera(const View& view, int width, int height);

  /// The ray through a point of the image: pixels, from the upper left corner. Its cone is one pixel wide.
  Ray ray(float x, float y) const;

  /// From world space to the camera's, for row vectors: x to the right, y up, and the eye looks down -z.
  Imath::M44f world_to_camera() const;
  /// From world space to the image, homogeneous: after the division, x and y go from 0 at the upper left
  /// corner to 1 at the lower right one.
  Imath::M44f world_to_image() const;
  /// Of the image, on the plane at distance 1.
  float screen_width() const { return step_x_.length() * width_; }

 private:
  Vec3f eye_;
  Vec3f corner_;  ///< from the eye to the image's upper left corner, on the plane at distance 1
  Vec3f step_x_;
  Vec3f step_y_;
  float width_;
  float height_;
  float pixel_angle_ = 0;
};

}  // namespace transport
