// Lights, observers and the render camera have handles that are dragged.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/document/scene_objects.h"
#include "editor/view/view_camera.h"

namespace editor {

enum class HandleKind { Light, Observer, CameraEye, CameraTarget };

/// Identifies a handle.
struct HandleId {
  HandleKind kind = HandleKind::Light;
  grf::ScenePath path;     ///< of the light or of the `params`; empty for the camera
  std::size_t number = 0;  ///< of the observer in its `params`

  bool operator==(const HandleId&) const = default;
};

struct SceneHandle {
  using Line = std::pair<grf::Vec3d, grf::Vec3d>;

  HandleId id;
  std::string name;  ///< display name
  /// World-space position of a light's corner, of an observer, of the camera or of its target. Dragging
  /// translates it.
  grf::Vec3d position;
  grf::Vec3d grip;          ///< where it is grabbed
  std::vector<Line> lines;  ///< world space
};

/// Creates the handles of a scene, and of the render camera with its image if there is one; `size` is that of
/// small symbols.
std::vector<SceneHandle> handles_of(const SceneObjects& objects, const std::optional<transport::View>& camera,
                                    double aspect, double size);

/// The handles of a view: hover and drag. Pixels are relative to the upper left corner of a window of the
/// given size.
class HandleGesture {
 public:
  const std::vector<SceneHandle>& handles() const { return handles_; }
  void set_handles(std::vector<SceneHandle> handles) { handles_ = std::move(handles); }
  /// The handle as it is drawn, also during a drag.
  SceneHandle shown(std::size_t number) const;
  bool is_lit(std::size_t number) const { return taken_ == number || hovered_ == handles_[number].id; }

  /// The handle at a pixel: the nearest whose grip or lines are within some pixels; null if there is none.
  const SceneHandle* at(const grf::Vec2d& pixel, const ViewCamera& camera, const grf::Vec2d& size) const;
  /// Sets the handle under the pointer, or null. Returns whether it changed.
  bool hover(const SceneHandle* handle);

  void begin(const SceneHandle& handle, const grf::Vec2d& pixel);
  /// Drags the handle with the pointer: in the view plane, or only along the world axis nearest to the
  /// motion.
  void drag(const grf::Vec2d& pixel, const ViewCamera& camera, const grf::Vec2d& size, bool along_axis);
  /// Ends the drag; the handle stays until others are set, or returns. Returns the dragged handle.
  SceneHandle end(bool stays);

 private:
  std::vector<SceneHandle> handles_;
  std::optional<HandleId> hovered_;
  std::optional<std::size_t> taken_;
  grf::Vec2d taken_at_ = grf::Vec2d(0);
  grf::Vec3d offset_ = grf::Vec3d(0);
};

}  // namespace editor
