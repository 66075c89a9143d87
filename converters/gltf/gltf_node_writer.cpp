#include "converters/gltf/gltf_node_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "converters/text_encoding.h"
#include "grf/keywords.h"

namespace convert {
namespace {

using grf::Vec3d;
using nlohmann::json;
using Kind = grf::TransformStep::Kind;

json numbers(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// A rotation as a unit quaternion (x, y, z, w).
using Quaternion = std::array<double, 4>;

/// Composes rotations: a, then b.
Quaternion product(const Quaternion& b, const Quaternion& a) {
  return {b[3] * a[0] + b[0] * a[3] + b[1] * a[2] - b[2] * a[1],
          b[3] * a[1] - b[0] * a[2] + b[1] * a[3] + b[2] * a[0],
          b[3] * a[2] + b[0] * a[1] - b[1] * a[0] + b[2] * a[3],
          b[3] * a[3] - b[0] * a[0] - b[1] * a[1] - b[2] * a[2]};
}

/// Converts Euler angles about x, then y, then z.
Quaternion quaternion_of(const grf::Vec3f& angles) {
  Quaternion turn = {0, 0, 0, 1};
  for (int axis = 0; axis < 3; ++axis) {
    Quaternion about = {0, 0, 0, std::cos(0.5 * angles[axis])};
    about[static_cast<std::size_t>(axis)] = std::sin(0.5 * angles[axis]);
    turn = product(about, turn);
  }
  double squared = 0;
  for (const double x : turn) squared += x * x;
  for (double& x : turn) x /= std::sqrt(squared);
  return turn;
}

/// The steps that one node can represent: a scale, then a rotation, then a translation, each at most once. A
/// node has no shear, and so a list may need several nodes.
struct NodeTransform {
  std::array<const grf::TransformStep*, 3> steps = {};

  bool takes(const grf::TransformStep& step) const {
    const auto place = static_cast<std::size_t>(step.kind);
    return std::all_of(steps.begin() + static_cast<std::ptrdiff_t>(place), steps.end(),
                       [](const auto* later) { return later == nullptr; });
  }
  json node() const {
    json node = json::object();
    if (steps[0] != nullptr) node["scale"] = numbers(Vec3d(steps[0]->value));
    if (steps[1] != nullptr) node["rotation"] = quaternion_of(steps[1]->value);
    if (steps[2] != nullptr) node["translation"] = numbers(Vec3d(steps[2]->value));
    return node;
  }
};

static_assert(static_cast<int>(Kind::Scale) == 0 && static_cast<int>(Kind::Rotation) == 1 &&
              static_cast<int>(Kind::Translation) == 2);

/// Splits a list of steps into nodes, the innermost first.
std::vector<NodeTransform> node_transforms(const std::vector<grf::TransformStep>& steps) {
  std::vector<NodeTransform> nodes(1);
  for (const grf::TransformStep& step : steps) {
    if (!nodes.back().takes(step)) nodes.emplace_back();
    nodes.back().steps[static_cast<std::size_t>(step.kind)] = &step;
  }
  return nodes;
}

}  // namespace

std::vector<int> GltfNodeWriter::write(const grf::BlockList& list) {
  Nodes nodes;
  for (const grf::Block& block : list.blocks) {
    std::visit([&](const auto& content) { write(content, nodes); }, block.content);
  }
  return nodes;
}

void GltfNodeWriter::write(const grf::Shared<grf::Mesh>& mesh, Nodes& nodes) {
  add_node(add_mesh(*mesh, mesh->name), mesh->name, nodes);
}

void GltfNodeWriter::write(const grf::MeshLight& light, Nodes& nodes) {
  const grf::Scope scope = scope_.scope();
  WrittenMesh written = write_mesh(
      *light.mesh, "light",
      [&](const grf::Surface& surface) { return materials_.light_material(surface, scope); }, document_);
  lists_.push_back(std::move(written.lists));
  add_node(written.mesh, "light", nodes);
}

void GltfNodeWriter::write(const grf::AreaLight& light, Nodes& nodes) {
  grf::MeshDraft mesh;
  mesh.positions = {light.corner, light.corner + light.edge1, light.corner + light.edge1 + light.edge2,
                    light.corner + light.edge2};
  // glTF has no infinity: a corner out of the range of a float is clamped to the largest float.
  constexpr float Largest = std::numeric_limits<float>::max();
  for (grf::Vec3f& position : mesh.positions) {
    for (int k = 0; k < 3; ++k) position[k] = std::clamp(position[k], -Largest, Largest);
  }
  constexpr std::array<std::uint32_t, 4> Corners = {0, 1, 2, 3};
  mesh.add_face(Corners, 0);
  const grf::Colour radiance = light.radiance.value_or(grf::Colour(1));
  // Its lists are not needed: the light is in the scene's text.
  const WrittenMesh written = write_mesh(
      grf::Mesh(std::move(mesh)), "light",
      [&](const grf::Surface&) { return materials_.light_material(radiance); }, document_);
  add_node(written.mesh, "light", nodes);
}

void GltfNodeWriter::write(const grf::Transform& transform, Nodes& nodes) {
  Nodes inside = write(transform.body);
  if (inside.empty()) return;
  for (const NodeTransform& part : node_transforms(transform.steps)) {
    json node = part.node();
    node["children"] = inside;
    inside = {document_.append("nodes", std::move(node))};
  }
  nodes.insert(nodes.end(), inside.begin(), inside.end());
}

void GltfNodeWriter::write(const grf::DefinitionScope& scope, Nodes& nodes) {
  for (const grf::Definition& definition : scope.definitions) {
    if (const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body)) {
      const std::string& own = (*mesh)->name;
      meshes_[&definition] = add_mesh(**mesh, own.empty() ? grf::from_identifier(definition.name) : own);
    }
    scope_.enter(definition);
  }
  const Nodes inside = write(scope.body);
  scope_.leave(scope.definitions.size());
  nodes.insert(nodes.end(), inside.begin(), inside.end());
}

void GltfNodeWriter::write(const grf::Use& use, Nodes& nodes) {
  const auto mesh = meshes_.find(scope_.scope().find(use.mesh.name));
  if (mesh != meshes_.end()) add_node(mesh->second, grf::from_identifier(use.mesh.name), nodes);
}

int GltfNodeWriter::add_mesh(const grf::Mesh& mesh, const std::string& name) {
  const grf::Scope scope = scope_.scope();
  const auto material_of = [&](grf::Surface surface) {
    // glTF has no texture without texture coordinates; GRF uses a single texel.
    if (mesh.geometry->uvs.empty()) surface.texture.reset();
    return materials_.material(surface, scope);
  };
  WrittenMesh written = write_mesh(mesh, to_utf8(name), material_of, document_);
  lists_.push_back(std::move(written.lists));
  return written.mesh;
}

void GltfNodeWriter::add_node(int mesh, const std::string& name, Nodes& nodes) {
  if (mesh < 0) return;
  json node = {{"mesh", mesh}};
  if (!name.empty()) node["name"] = to_utf8(name);
  nodes.push_back(document_.append("nodes", std::move(node)));
}

}  // namespace convert
