#pragma once

#include "grf/math.h"
#include "renderer/transport/scene/ray_caster.h"

namespace transport {

class CompiledScene;

/// A rectangle of pixels of an image, from its upper left corner.
struct CropWindow {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool operator==(const CropWindow&) const = default;
};

/// The position, direction and lens of a camera in world space; double, so that it works far from the world's
/// origin.
struct View {
  grf::Vec3d eye = grf::Vec3d(0);
  grf::Vec3d target = grf::Vec3d(0);
  Vec3f up = Vec3f(
      0, 1, 0);  ///< the z axis (or, if need be, x) replaces it where it is parallel to the view direction
  float field_of_view = 45;  ///< vertical, degrees, between 0 and 180
  float lens_radius = 0;     ///< of a thin lens, in world units; 0: a pinhole, so that everything is sharp
  float focus_distance =
      0;  ///< from the eye to the plane of focus, along the view direction; 0: to the target

  bool operator==(const View&) const = default;
};

/// Returns a view that frames the whole box, from the front (looking along -z) and slightly above.
View view_of(const grf::Box3d& bounds, float field_of_view, float aspect);

/// Returns the distance from the eye to the plane of focus, along the view direction.
float focus_distance_of(const View& view);

/// Returns the same view in coordinates with their origin at this point.
View relative_to(const grf::Vec3d& origin, const View& view);

/// A camera with a thin lens, or a pinhole camera if the radius of the lens is 0.
class Camera {
 public:
  Camera(const View& view, int width, int height);

  /// The ray from the centre of the lens through an image point, in pixels from the upper left corner. Its
  /// cone is one pixel wide.
  Ray ray(float x, float y) const;
  /// The ray to the same point of the plane of focus from a point of the lens: depth of field (Cook, Porter
  /// and Carpenter 1984, "Distributed ray tracing"). `xi` in [0,1) is uniform over the lens.
  Ray ray(float x, float y, const grf::Vec2f& xi) const;
  bool has_lens() const { return lens_x_ != Vec3f(0); }

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
  Vec3f lens_x_;  ///< from the lens' centre to its rim
  Vec3f lens_y_;
  float focus_distance_;
};

/// Returns a camera for a view, in world space, of a scene: its rays are in the scene's coordinates. An eye
/// that lies in a face, within rounding, does not see the face.
Camera camera_of(const CompiledScene& scene, const View& view, int width, int height);

}  // namespace transport
