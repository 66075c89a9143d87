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

/// A handle that is moved by so much.
SceneHandle moved(const SceneHandle& handle, const grf::Vec3d& offset);

/// Which handle is at a place of the image: the nearest whose grip or lines are within so many pixels.
std::optional<std::size_t> handle_at(const std::vector<SceneHandle>& handles, const ViewCamera& camera,
                                     const grf::Vec2d& pixel, const grf::Vec2d& size);

/// Where a handle's grip goes when the pointer goes from one pixel to another: in the plane of the view, or
/// only along the world's axis that is nearest to the pointer's way.
grf::Vec3d dragged(const grf::Vec3d& grip, const ViewCamera& camera, const grf::Vec2d& from,
                   const grf::Vec2d& to, const grf::Vec2d& size, bool along_axis);

}  // namespace editor
