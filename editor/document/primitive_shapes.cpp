#include "editor/document/primitive_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "editor/document/scene_places.h"
#include "grf/unique_names.h"

namespace editor {
namespace {

using ShapeKind = PrimitiveShape::Kind;

/// The direction of a fraction of a full turn. The first and the last one are exactly equal, so that seams
/// are closed.
grf::Vec2d direction_at(int index, int count) {
  const double angle = 2 * std::numbers::pi * (index % count) / count;
  return {std::cos(angle), std::sin(angle)};
}

std::uint32_t add_vertex(grf::MeshDraft& mesh, const grf::Vec3d& position, const grf::Vec3d& normal,
                         const grf::Vec2d& uv) {
  const std::size_t index = mesh.positions.size();
  mesh.positions.emplace_back(position);
  mesh.normals.set(index, grf::Vec3f(normal));
  mesh.uvs.set(index, grf::Vec2f(uv));
  return static_cast<std::uint32_t>(index);
}

/// Adds a flat parallelogram whose front is the side to which edge1 x edge2 points.
void add_parallelogram(grf::MeshDraft& mesh, const grf::Vec3d& corner, const grf::Vec3d& edge1,
                       const grf::Vec3d& edge2) {
  const grf::Vec3d normal = edge1.cross(edge2).normalized();
  const std::array face = {add_vertex(mesh, corner, normal, {0, 0}),
                           add_vertex(mesh, corner + edge1, normal, {1, 0}),
                           add_vertex(mesh, corner + edge1 + edge2, normal, {1, 1}),
                           add_vertex(mesh, corner + edge2, normal, {0, 1})};
  mesh.add_face(face, 0);
}

void add_box(grf::MeshDraft& mesh, const grf::Vec3d& size) {
  const grf::Vec3d low(-size.x / 2, 0, -size.z / 2);
  const grf::Vec3d high(size.x / 2, size.y, size.z / 2);
  const grf::Vec3d x(size.x, 0, 0);
  const grf::Vec3d y(0, size.y, 0);
  const grf::Vec3d z(0, 0, size.z);
  add_parallelogram(mesh, {low.x, low.y, high.z}, x, y);
  add_parallelogram(mesh, high - y, -z, y);
  add_parallelogram(mesh, {high.x, low.y, low.z}, -x, y);
  add_parallelogram(mesh, low, z, y);
  add_parallelogram(mesh, {low.x, high.y, high.z}, x, -z);
  add_parallelogram(mesh, low, x, z);
}

/// Adds a regular polygon about the y axis, whose front is up or down.
void add_disc(grf::MeshDraft& mesh, double radius, double y, int segments, bool is_up) {
  std::vector<std::uint32_t> face;
  for (int i = 0; i < segments; ++i) {
    const grf::Vec2d direction = direction_at(i, segments);
    const grf::Vec2d uv(direction.y, is_up ? -direction.x : direction.x);
    face.push_back(add_vertex(mesh, {radius * direction.y, y, radius * direction.x},
                              {0, is_up ? 1.0 : -1.0, 0}, (uv + grf::Vec2d(1)) / 2));
  }
  if (!is_up) std::reverse(face.begin(), face.end());
  mesh.add_face(face, 0);
}

/// A point of a profile that turns about the y axis; x is the distance from the axis.
struct ProfilePoint {
  grf::Vec2d position;
  grf::Vec2d normal;
};

/// Adds the first vertex of a ring for each of its columns, and one more that closes the seam. At a pole,
/// each column has a vertex in its middle, where the texture coordinate of a triangle's tip is.
std::vector<std::uint32_t> add_ring(grf::MeshDraft& mesh, const ProfilePoint& point, double v, int segments) {
  std::vector<std::uint32_t> ring;
  const bool is_pole = point.position.x == 0;
  for (int i = 0; i < segments + (is_pole ? 0 : 1); ++i) {
    const grf::Vec2d direction = direction_at(i, segments);
    const auto turned = [&direction](const grf::Vec2d& at) {
      return grf::Vec3d(at.x * direction.y, at.y, at.x * direction.x);
    };
    ring.push_back(add_vertex(mesh, turned(point.position), turned(point.normal),
                              {(i + (is_pole ? 0.5 : 0)) / segments, v}));
  }
  return ring;
}

/// Adds a surface of revolution about the y axis. Its outside is to the right along the profile.
void add_revolution(grf::MeshDraft& mesh, const std::vector<ProfilePoint>& profile, int segments) {
  const double last = static_cast<double>(profile.size() - 1);
  std::vector<std::uint32_t> below = add_ring(mesh, profile.front(), 0, segments);
  for (std::size_t row = 1; row < profile.size(); ++row) {
    std::vector<std::uint32_t> above =
        add_ring(mesh, profile[row], static_cast<double>(row) / last, segments);
    const bool is_first = profile[row - 1].position.x == 0;
    const bool is_last = profile[row].position.x == 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(segments); ++i) {
      if (is_first) {
        mesh.add_face(std::array{below[i], above[i + 1], above[i]}, 0);
      } else if (is_last) {
        mesh.add_face(std::array{below[i], below[i + 1], above[i]}, 0);
      } else {
        mesh.add_face(std::array{below[i], below[i + 1], above[i + 1], above[i]}, 0);
      }
    }
    below = std::move(above);
  }
}

std::vector<ProfilePoint> sphere_profile(double radius, int rows) {
  std::vector<ProfilePoint> profile;
  for (int row = 0; row <= rows; ++row) {
    const double angle = std::numbers::pi * (static_cast<double>(row) / rows - 0.5);
    const bool is_pole = row == 0 || row == rows;
    const grf::Vec2d normal(is_pole ? 0 : std::cos(angle), std::sin(angle));
    profile.push_back({normal * radius + grf::Vec2d(0, radius), normal});
  }
  return profile;
}

std::vector<ProfilePoint> torus_profile(double radius, double tube_radius, int rows) {
  std::vector<ProfilePoint> profile;
  for (int row = 0; row <= rows; ++row) {
    const grf::Vec2d normal = direction_at(row, rows);
    profile.push_back({normal * tube_radius + grf::Vec2d(radius, tube_radius), normal});
  }
  return profile;
}

}  // namespace

std::string_view name_of(ShapeKind kind) {
  constexpr std::array<std::string_view, 6> Names = {"plane", "box", "sphere", "cylinder", "disc", "torus"};
  return Names[static_cast<std::size_t>(kind)];
}

PrimitiveShape shape_of_size(ShapeKind kind, double size) {
  PrimitiveShape shape;
  shape.kind = kind;
  shape.width = shape.height = shape.depth = size;
  shape.tube_radius = size / 8;
  shape.radius = kind == ShapeKind::Torus      ? size / 2 - shape.tube_radius
                 : kind == ShapeKind::Cylinder ? size / 4
                                               : size / 2;
  return shape;
}

grf::Mesh mesh_of(const PrimitiveShape& shape) {
  const int segments = std::max(shape.segments, 3);
  const int rows = std::max(segments / 2, 3);
  grf::MeshDraft mesh;
  mesh.name = name_of(shape.kind);
  switch (shape.kind) {
    case ShapeKind::Plane:
      add_parallelogram(mesh, {-shape.width / 2, 0, shape.depth / 2}, {shape.width, 0, 0},
                        {0, 0, -shape.depth});
      break;
    case ShapeKind::Box:
      add_box(mesh, {shape.width, shape.height, shape.depth});
      break;
    case ShapeKind::Sphere:
      add_revolution(mesh, sphere_profile(shape.radius, rows), segments);
      break;
    case ShapeKind::Cylinder:
      add_revolution(mesh, {{{shape.radius, 0}, {1, 0}}, {{shape.radius, shape.height}, {1, 0}}}, segments);
      add_disc(mesh, shape.radius, shape.height, segments, true);
      add_disc(mesh, shape.radius, 0, segments, false);
      break;
    case ShapeKind::Disc:
      add_disc(mesh, shape.radius, 0, segments, true);
      break;
    case ShapeKind::Torus:
      add_revolution(mesh, torus_profile(shape.radius, shape.tube_radius, rows), segments);
      break;
  }
  return mesh;
}

double proportionate_size(const grf::Box3d& bounds) {
  const grf::Vec3d sides = bounds.isEmpty() ? grf::Vec3d(0) : bounds.size();
  const double wanted = std::max({sides.x, sides.y, sides.z}) / 4;
  if (!(wanted > 0) || !std::isfinite(wanted)) return 1;
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  // The nearest one by ratio: the limits are geometric means of neighbours.
  const double digit = wanted / power;
  return power * (digit < std::sqrt(2) ? 1 : digit < std::sqrt(10) ? 2 : digit < std::sqrt(50) ? 5 : 10);
}

TransformedObjects add_mesh(const grf::Scene& scene, const SceneObjects& objects, grf::Mesh mesh,
                            const grf::Vec3d& position) {
  grf::UniqueNames names;
  for (const MeshObject& object : objects.meshes) names.add(object.mesh->name);
  mesh.name = names.take(mesh.name);
  grf::Scene added = scene;
  std::vector<grf::Block>& blocks = outermost_blocks(added).blocks;
  grf::ScenePath path = {static_cast<std::uint32_t>(blocks.size())};
  if (&blocks != &added.contents.blocks) {
    const auto& scope = std::get<grf::DefinitionScope>(added.contents.blocks.front().content);
    path = {0, static_cast<std::uint32_t>(scope.definitions.size() + blocks.size())};
  }
  grf::Block block;
  block.content = grf::Shared<grf::Mesh>(std::move(mesh));
  blocks.push_back(std::move(block));
  TransformAction move;
  move.value = position;
  grf::Diagnostics none;
  return *transform_objects(added, {std::move(path)}, move, none);
}

}  // namespace editor
