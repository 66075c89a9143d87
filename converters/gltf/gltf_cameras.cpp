#include "converters/gltf/gltf_cameras.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "converters/renderers/render_view.h"
#include "converters/text_encoding.h"
#include "grf/keywords.h"
#include "grf/unique_names.h"
#include "renderer/options/op_file.h"

namespace convert {
namespace {

using grf::Matrix44d;
using grf::Vec3d;

using options::NamedCamera;

constexpr double RadiansPerDegree = std::numbers::pi / 180;

Vec3d direction_of(const Matrix44d& to_scene, int axis) {
  return Vec3d(to_scene[axis][0], to_scene[axis][1], to_scene[axis][2]);
}

/// Returns the camera of a node with this transform, or nothing if GRF has no such camera.
std::optional<NamedCamera> camera_of(const tinygltf::Camera& source, const Matrix44d& to_scene,
                                     const grf::Box3d& bounds) {
  const double angle = source.perspective.yfov / RadiansPerDegree;
  Vec3d forward = -direction_of(to_scene, 2);
  Vec3d up = direction_of(to_scene, 1);
  if (source.type != "perspective" || !(angle > 0 && angle < 180)) return std::nullopt;
  if (!(forward.length() > 0) || !(up.length() > 0)) return std::nullopt;
  forward.normalize();
  up.normalize();
  const Vec3d eye = direction_of(to_scene, 3);
  const double reach = bounds.isEmpty() ? 0 : forward.dot(bounds.center() - eye);
  NamedCamera camera;
  camera.eye = grf::Vec3f(eye);
  camera.target = grf::Vec3f(eye + (reach > 0 ? reach : 1) * forward);
  camera.up = grf::Vec3f(up);
  camera.field_of_view = static_cast<float>(angle);
  const auto is_finite = [](const grf::Vec3f& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  const bool is_possible = is_finite(camera.eye) && is_finite(camera.target) && is_finite(camera.up) &&
                           camera.eye != camera.target && camera.field_of_view < 180;
  return is_possible ? std::optional(camera) : std::nullopt;
}

/// Returns a name that an OP file can have, from that of a node or a camera.
std::string op_name(const std::string& name) {
  std::string text = on_one_line(name);
  std::erase(text, '"');
  const bool is_usable = text.find_first_not_of(' ') != std::string::npos && !grf::same_keyword(text, "none");
  return is_usable ? text : "camera";
}

/// glTF's matrices are column-major for column vectors: the numbers are those of rows for row vectors.
nlohmann::json numbers_of(const Matrix44d& matrix) {
  nlohmann::json numbers = nlohmann::json::array();
  for (int i = 0; i < 16; ++i) numbers.push_back(matrix[i / 4][i % 4]);
  return numbers;
}

int add_camera(const std::string& name, const RenderView& view, const grf::Box3d& bounds,
               GltfDocument& document) {
  // Others clip what is nearer; bpt does not.
  const double reach = reach_from(view.eye, bounds);
  nlohmann::json perspective = {{"yfov", view.field_of_view * RadiansPerDegree},
                                {"znear", std::max(1e-5 * reach, 1e-30)}};
  if (view.width > 0 && view.height > 0) perspective["aspectRatio"] = double(view.width) / view.height;
  const int camera = document.append(
      "cameras", {{"name", name}, {"type", "perspective"}, {"perspective", std::move(perspective)}});
  return document.append("nodes",
                         {{"name", name}, {"camera", camera}, {"matrix", numbers_of(camera_to_world(view))}});
}

}  // namespace

std::vector<NamedCamera> read_cameras(const GltfFile& file, const GltfNodes& nodes, const grf::Box3d& bounds,
                                      Losses& losses) {
  std::vector<NamedCamera> cameras;
  grf::UniqueNames names;
  const auto& model = file.model;
  // Nodes are trees, and not deeper than GltfNodes::Deepest.
  const std::function<void(int)> read_from = [&](int index) {
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(index)];
    if (node.camera >= 0) {
      const auto number = static_cast<std::size_t>(node.camera);
      auto camera = number < model.cameras.size()
                        ? camera_of(model.cameras[number], nodes.to_scene(index), bounds)
                        : std::nullopt;
      if (camera) {
        camera->name = names.take(op_name(node.name.empty() ? model.cameras[number].name : node.name));
        cameras.push_back(*std::move(camera));
      } else {
        losses.add(Loss::Camera);
      }
    }
    for (const int child : node.children) read_from(child);
  };
  for (const int root : nodes.roots()) read_from(root);
  return cameras;
}

bool write_cameras(const std::string& op_file, const grf::Box3d& bounds, GltfDocument& document,
                   std::vector<int>& nodes, grf::Diagnostics& diagnostics) {
  auto render_options = options::read_op_file(op_file, diagnostics);
  if (!render_options) return false;
  if (bounds.isEmpty()) return true;
  if (!render_options->environment.empty()) {
    diagnostics.loss(grf::whole_file(op_file), "the image around the scene was left out: glTF has none");
    render_options->environment.clear();
  }
  const std::string rendering = render_options->camera;
  const auto write = [&](const std::string& name, const std::string& shown) {
    render_options->camera = name;
    const auto view = render_view(render_options, bounds, diagnostics);
    if (view) nodes.push_back(add_camera(to_utf8(shown), *view, bounds, document));
    return view.has_value();
  };
  // Where an OP file leaves the camera open, others place one as they like.
  const bool has_own = !rendering.empty() || render_options->eye.has_value();
  if (has_own && !write(rendering, rendering.empty() ? "Camera" : rendering)) return false;
  return std::ranges::all_of(render_options->cameras, [&](const NamedCamera& camera) {
    return camera.name == rendering || write(camera.name, camera.name);
  });
}

}  // namespace convert
