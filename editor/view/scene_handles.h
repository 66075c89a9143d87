// What stands in a scene besides faces, and can be taken and moved: lights, observers and the render's
// camera.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/document/scene_objects.h"
#include "editor/view/view_camera.h"

namespace editor {

enum class HandleKind { Light, Observer, CameraViewer, CameraTarget };

/// Which thing it is.
struct HandleId {
  HandleKind kind = HandleKind::Light;
  grf::ScenePath path;     ///< of the light or of the `params`; empty for the camera
  std::size_t number = 0;  ///< of the observer among those of its `params`

  bool operator==(const HandleId&) const = default;
};

struct SceneHandle {
  using Line = std::pair<grf::Vec3d, grf::Vec3d>;

  HandleId id;
  std::string name;  ///< in words
  /// In the world: a light's corner, where an observer or the camera is, what the camera looks at. What moves
  /// a thing moves this by as much.
  grf::Vec3d position;
  grf::Vec3d grip;          ///< where it is taken
  std::vector<Line> lines;  ///< in the world
};

/// Of a scene, and of a camera with the image that it makes if there is one; `size` is that of small symbols.
std::vector<SceneHandle> handles_of(const SceneObjects& objects, const std::optional<transport::View>& camera,
                                    double aspect, double size);

/// The handles that stand in a view, of which one may be under the pointer and be dragged. Pixels are those
/// of a window of that size, from the upper left.
class HandleGesture {
 public:
  const std::vector<SceneHandle>& handles() const { return handles_; }
  void set_handles(std::vector<SceneHandle> handles) { handles_ = std::move(handles); }
  /// As it is drawn.
  SceneHandle shown(std::size_t number) const;
  bool is_lit(std::size_t number) const { return taken_ == number || hovered_ == handles_[number].id; }

  /// The handle at a pixel: the nearest whose grip or lines are within some pixels; null: there is none.
  const SceneHandle* at(const grf::Vec2d& pixel, const ViewCamera& camera, const grf::Vec2d& size) const;
  /// The handle under the pointer, or null. Returns whether it is another one than before.
  bool hover(const SceneHandle* handle);

  void begin(const SceneHandle& handle, const grf::Vec2d& pixel);
  /// Moves it as far as the pointer: in the plane of the view, or only along the world's axis that is nearest
  /// to the pointer's way.
  void drag(const grf::Vec2d& pixel, const ViewCamera& camera, const grf::Vec2d& size, bool along_axis);
  /// Leaves it there, until other handles are set; or where it was. Returns the handle that was dragged.
  SceneHandle end(bool stays);

 private:
  std::vector<SceneHandle> handles_;
  std::optional<HandleId> hovered_;
  std::optional<std::size_t> taken_;
  grf::Vec2d taken_at_ = grf::Vec2d(0);
  grf::Vec3d offset_ = grf::Vec3d(0);
};

}  // namespace editor
