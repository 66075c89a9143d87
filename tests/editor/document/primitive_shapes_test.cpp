#include "editor/document/primitive_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "grf/scene_path.h"
#include "grf/topology.h"
#include "grf/vertex_tree.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using Kind = PrimitiveShape::Kind;
using std::numbers::pi;

constexpr Kind AllKinds[] = {Kind::Plane, Kind::Box, Kind::Sphere, Kind::Cylinder, Kind::Disc, Kind::Torus};

PrimitiveShape fine_shape(Kind kind) {
  PrimitiveShape shape;
  shape.kind = kind;
  shape.width = 2;
  shape.height = 3;
  shape.depth = 5;
  shape.radius = 1.5;
  shape.tube_radius = 0.5;
  shape.segments = 512;
  return shape;
}

/// The volume within a closed mesh by the divergence theorem, over fans of its faces.
double volume_in(const grf::Geometry& geometry) {
  double volume = 0;
  for (std::size_t i = 0; i < geometry.face_count(); ++i) {
    const auto face = geometry.face(i);
    const auto at = [&](std::size_t corner) { return grf::Vec3d(geometry.positions[face[corner]]); };
    for (std::size_t k = 2; k < face.size(); ++k) volume += at(0).dot(at(k - 1).cross(at(k))) / 6;
  }
  return volume;
}

/// Vertices - edges + faces, where vertices at the same position are one.
int euler_characteristic(const grf::Geometry& geometry) {
  const auto places = grf::first_at_position(geometry);
  std::set<std::uint32_t> vertices;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < geometry.face_count(); ++i) {
    const auto face = geometry.face(i);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t a = places[face[k]];
      const std::uint32_t b = places[face[(k + 1) % face.size()]];
      vertices.insert(a);
      edges.insert(std::minmax(a, b));
    }
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(geometry.face_count());
}

void expect_measures(Kind kind, double area, double volume) {
  const grf::Mesh mesh = mesh_of(fine_shape(kind));
  // With n segments, the relative error of an inscribed polygon is below (2 pi / n)^2, here for n = 256.
  const double error = std::pow(2 * pi / 256, 2);
  EXPECT_NEAR(mesh.geometry.area(), area, error * area) << name_of(kind);
  EXPECT_NEAR(volume_in(*mesh.geometry), volume, error * volume + 1e-6) << name_of(kind);
}

TEST(PrimitiveShapes, HaveTheAreasAndVolumesOfClosedForms) {
  expect_measures(Kind::Plane, 2 * 5, 0);
  expect_measures(Kind::Box, 2 * (2 * 3 + 3 * 5 + 2 * 5), 2 * 3 * 5);
  expect_measures(Kind::Sphere, 4 * pi * 1.5 * 1.5, 4.0 / 3 * pi * 1.5 * 1.5 * 1.5);
  expect_measures(Kind::Cylinder, 2 * pi * 1.5 * (1.5 + 3), pi * 1.5 * 1.5 * 3);
  expect_measures(Kind::Disc, pi * 1.5 * 1.5, 0);
  expect_measures(Kind::Torus, 4 * pi * pi * 1.5 * 0.5, 2 * pi * pi * 1.5 * 0.5 * 0.5);
}

TEST(PrimitiveShapes, AreManifoldsOfTheirGenus) {
  for (const int segments : {3, 4, 7, 32}) {
    for (const Kind kind : AllKinds) {
      PrimitiveShape shape = fine_shape(kind);
      shape.segments = segments;
      const grf::Mesh mesh = mesh_of(shape);
      const grf::Topology& topology = mesh.geometry.topology();
      const bool is_open = kind == Kind::Plane || kind == Kind::Disc;
      EXPECT_EQ(euler_characteristic(*mesh.geometry), is_open               ? 1
                                                      : kind == Kind::Torus ? 0
                                                                            : 2)
          << name_of(kind) << ' ' << segments;
      EXPECT_EQ(topology.boundary_loops, is_open ? 1U : 0U) << name_of(kind) << ' ' << segments;
      EXPECT_EQ(topology.nonmanifold_edges, 0U) << name_of(kind);
      EXPECT_EQ(topology.nonmanifold_vertices, 0U) << name_of(kind);
    }
  }
}

/// A vector outward at a point of the shape that its closed form has there.
grf::Vec3d outward_at(const PrimitiveShape& shape, const grf::Vec3d& point) {
  if (shape.kind == Kind::Plane || shape.kind == Kind::Disc) return {0, 1, 0};
  if (shape.kind == Kind::Sphere) return point - grf::Vec3d(0, shape.radius, 0);
  if (shape.kind != Kind::Torus) return point - grf::Vec3d(0, shape.height / 2, 0);  // it is convex
  const grf::Vec3d ring = grf::Vec3d(point.x, 0, point.z).normalized() * shape.radius;
  return point - ring - grf::Vec3d(0, shape.tube_radius, 0);
}

TEST(PrimitiveShapes, HaveOutwardFrontsWithUnitNormals) {
  for (const Kind kind : AllKinds) {
    PrimitiveShape shape = fine_shape(kind);
    shape.segments = 24;
    const grf::Mesh mesh = mesh_of(shape);
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      const auto face = mesh.face(i);
      const grf::Vec3d front = grf::doubled_area_vector(*mesh.geometry, i, {}).normalized();
      grf::Vec3d middle(0);
      for (const auto corner : face) {
        middle += grf::Vec3d(mesh.geometry->positions[corner]) / static_cast<double>(face.size());
      }
      EXPECT_GT(front.dot(outward_at(shape, middle)), 0) << name_of(kind) << ' ' << i;
      for (const auto corner : face) {
        ASSERT_TRUE(mesh.geometry->normals.has(corner));
        const grf::Vec3d normal(mesh.geometry->normals[corner]);
        EXPECT_NEAR(normal.length(), 1, 1e-6) << name_of(kind);
        EXPECT_GT(normal.dot(front), 0.9) << name_of(kind) << ' ' << i;
      }
    }
  }
}

TEST(PrimitiveShapes, HaveSmoothNormalsWhereTheyAreRound) {
  for (const Kind kind : {Kind::Sphere, Kind::Torus}) {
    const PrimitiveShape shape = fine_shape(kind);
    const grf::Mesh mesh = mesh_of(shape);
    for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
      const grf::Vec3d expected = outward_at(shape, grf::Vec3d(mesh.geometry->positions[i])).normalized();
      EXPECT_LT((grf::Vec3d(mesh.geometry->normals[i]) - expected).length(), 1e-5) << name_of(kind);
    }
  }
  // The sides of a cylinder are smooth, its caps flat.
  const grf::Mesh cylinder = mesh_of(fine_shape(Kind::Cylinder));
  for (std::size_t i = 0; i < cylinder.face_count(); ++i) {
    for (const auto corner : cylinder.face(i)) {
      const grf::Vec3d position(cylinder.geometry->positions[corner]);
      const grf::Vec3d expected = cylinder.face(i).size() == 4 ? grf::Vec3d(position.x, 0, position.z) / 1.5
                                                               : grf::Vec3d(0, position.y > 1 ? 1 : -1, 0);
      EXPECT_LT((grf::Vec3d(cylinder.geometry->normals[corner]) - expected).length(), 1e-5);
    }
  }
}

/// Texture coordinates turn as the face does: an image on the front is not mirrored.
TEST(PrimitiveShapes, HaveTextureCoordinatesThatAreNotMirrored) {
  for (const Kind kind : AllKinds) {
    PrimitiveShape shape = fine_shape(kind);
    shape.segments = 16;
    const grf::Mesh mesh = mesh_of(shape);
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      const auto face = mesh.face(i);
      double doubled_area = 0;
      for (std::size_t k = 0; k < face.size(); ++k) {
        ASSERT_TRUE(mesh.geometry->uvs.has(face[k]));
        const grf::Vec2f a = mesh.geometry->uvs[face[k]];
        const grf::Vec2f b = mesh.geometry->uvs[face[(k + 1) % face.size()]];
        EXPECT_TRUE(a.x >= 0 && a.x <= 1 && a.y >= 0 && a.y <= 1)
            << name_of(kind) << ' ' << a.x << ' ' << a.y;
        doubled_area += static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
      }
      EXPECT_GT(doubled_area, 0) << name_of(kind) << ' ' << i;
    }
  }
}

TEST(PrimitiveShapes, StandOnTheFloorWithTheLongestSideAsked) {
  for (const Kind kind : AllKinds) {
    const grf::Box3d bounds = mesh_of(shape_of_size(kind, 20)).geometry.vertices().bounds();
    const grf::Vec3d size = bounds.size();
    EXPECT_NEAR(std::max({size.x, size.y, size.z}), 20, 1e-4) << name_of(kind);
    EXPECT_NEAR(bounds.min.y, 0, 1e-5) << name_of(kind);
    EXPECT_NEAR(bounds.center().x, 0, 1e-5) << name_of(kind);
    EXPECT_NEAR(bounds.center().z, 0, 1e-5) << name_of(kind);
  }
}

TEST(PrimitiveShapes, HaveAQuarterOfTheScenesSizeRounded) {
  const auto size_in = [](double side) {
    return proportionate_size({grf::Vec3d(-1), grf::Vec3d(-0.9, side - 1, -0.95)});
  };
  EXPECT_NEAR(size_in(4), 1, 1e-12);
  EXPECT_NEAR(size_in(5.2), 1, 1e-12);
  EXPECT_NEAR(size_in(6), 2, 1e-12);
  EXPECT_NEAR(size_in(0.9), 0.2, 1e-12);
  EXPECT_NEAR(size_in(2000), 500, 1e-9);
  EXPECT_NEAR(size_in(3900), 1000, 1e-9);
  EXPECT_EQ(proportionate_size({}), 1);
  EXPECT_EQ(proportionate_size({grf::Vec3d(3), grf::Vec3d(3)}), 1);
}

TEST(PrimitiveShapes, AreAddedWithNamesAndPathsThatLeadToThem) {
  for (const std::string text :
       {"", "light begin (0, 9, 0) (1, 0, 0) (0, 0, 1) end\n",
        "def grey = rgb (0.5, 0.5, 0.5)\nbegin\nlight begin (0, 9, 0) (1, 0, 0) (0, 0, 1) end\nend\n"}) {
    grf::Scene scene = text.empty() ? grf::Scene() : scene_of(text);
    for (const auto& [name, position] :
         {std::pair("box", grf::Vec3d(0)), std::pair("box_2", grf::Vec3d(1, 0, -2))}) {
      const TransformedObjects added =
          add_mesh(scene, objects_of(scene, {}), mesh_of(shape_of_size(Kind::Box, 2)), position);
      scene = added.scene;
      ASSERT_EQ(added.paths.size(), 1U);
      const grf::Shared<grf::Mesh>* mesh = grf::find_mesh(scene, added.paths.front());
      ASSERT_NE(mesh, nullptr) << text;
      EXPECT_EQ((*mesh)->name, name);
      const grf::Box3d bounds = object_bounds(objects_of(scene, {}), added.paths.front());
      EXPECT_EQ(bounds.center(), position + grf::Vec3d(0, 1, 0));
    }
  }
}

}  // namespace
}  // namespace editor
