#pragma once

#include "grf/math.h"
#include "renderer/transport/scene/ray_caster.h"

namespace transport {

/// The position and direction of a camera in world space; double, so that it works far from the world's
/// origin.
struct View {
  grf::Vec3d eye = grf::Vec3d(0);
  grf::Vec3d target = grf::Vec3d(0);
  Vec3f up = Vec3f(
      0, 1, 0);  ///< the z axis (or, if need be, x) replaces it where it is parallel to the view direction
  float field_of_view = 45;  ///< vertical, degrees, between 0 and 180
};

/// Returns a view that frames the whole box, from the front (looking along -z) and slightly above.
View view_of(const grf::Box3d& bounds, float field_of_view, float aspect);

/// Returns the same view in coordinates with their origin at this point.
View relative_to(const grf::Vec3d& origin, const View& view);

/// A pinhole camera.
class Camera {
 public:
  Camera(const View& view, int width, int height);

  /// The ray through an image point, in pixels from the upper left corner. Its cone is one pixel wide.
  Ray ray(float x, float y) const;

  /// The matrix from world space to camera space, for row vectors: x right, y up, looking along -z.
  Imath::M44f world_to_camera() const;
  /// The projective matrix from world space to the image, for row vectors: after the division, x and y go
  /// from 0 at the upper left corner to 1 at the lower right one.
  Imath::M44f world_to_image() const;
  /// The width of the image plane at distance 1.
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
