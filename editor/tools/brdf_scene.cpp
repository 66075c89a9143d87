#include "editor/tools/brdf_scene.h"

#include <algorithm>
#include <cmath>

#include "editor/view/view_camera.h"

namespace editor {

int BrdfScene::split_column(int width) const {
  return std::clamp(static_cast<int>(std::lround(split * width)), 0, width);
}

int BrdfScene::samples() const {
  return lighting.environment.kind == studies::Environment::Kind::None ? 0 : lighting.samples;
}

reflectance::Vec3f BrdfScene::to_eye(double x, double y) const {
  return -reflectance::Vec3f(ViewCamera(view).ray({x, y}, aspect()).direction.normalized());
}

std::shared_ptr<const ViewedObject> viewed_object(const SceneObjects& objects) {
  auto object = std::make_shared<ViewedObject>();
  object->bounds = objects.mesh_bounds;
  object->triangles = objects.triangles;
  object->parts.resize(objects.meshes.size());
  for (const MeshInstance& instance : *objects.instances) {
    ViewedObject::Part& part = object->parts[instance.mesh];
    if (!part.geometry)
      part.geometry = std::make_shared<const MeshGeometry>(*objects.meshes[instance.mesh].mesh);
    part.to_world.push_back(instance.to_world);
  }
  std::erase_if(object->parts, [](const ViewedObject::Part& part) { return !part.geometry; });
  return object;
}

}  // namespace editor
