#include "editor/document/studio.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "editor/document/primitive_shapes.h"

namespace editor {
namespace {

/// A scene with a sphere of that radius on y = `low`.
grf::Scene sphere_scene(double radius, double low) {
  const PrimitiveShape shape = shape_of_size(PrimitiveShape::Kind::Sphere, 2 * radius);
  return add_mesh({}, {}, mesh_of(shape), {3 * radius, low, radius}).scene;
}

SceneObjects studio_objects(double radius, double low) {
  const grf::Scene scene = sphere_scene(radius, low);
  return objects_of(add_studio(scene, objects_of(scene, {})), {});
}

/// Irradiance at a point from one light by the midpoint rule over its area.
double irradiance_of(const grf::AreaLight& light, const grf::Vec3d& point, const grf::Vec3d& normal) {
  constexpr int Steps = 24;
  const grf::Vec3d edge1(light.edge1);
  const grf::Vec3d edge2(light.edge2);
  const grf::Vec3d area = edge1.cross(edge2) / (Steps * Steps);
  double sum = 0;
  for (int i = 0; i < Steps; ++i) {
    for (int j = 0; j < Steps; ++j) {
      const grf::Vec3d way =
          grf::Vec3d(light.corner) + edge1 * ((i + 0.5) / Steps) + edge2 * ((j + 0.5) / Steps) - point;
      const double emitted = -way.dot(area);
      const double received = way.dot(normal);
      if (emitted > 0 && received > 0) sum += emitted * received / std::pow(way.length2(), 2);
    }
  }
  return sum * light.radiance->x;
}

TEST(Studio, PutsAFloorUnderTheScene) {
  for (const double radius : {0.001, 1.0, 500.0}) {
    const SceneObjects objects = studio_objects(radius, -2 * radius);
    ASSERT_EQ(objects.meshes.size(), 2U);
    EXPECT_EQ(objects.meshes[1].mesh->name, "floor");
    EXPECT_TRUE(objects.meshes[1].mesh->surface(0).brdf) << "a face without a BRDF is a warning";
    const grf::Box3d floor = object_bounds(objects, objects.meshes[1].path);
    EXPECT_NEAR(floor.min.y, -2 * radius, 0.001 * radius);
    EXPECT_LT(floor.min.y, -2 * radius) << "not in the plane of the undersides";
    EXPECT_GT(floor.size().x, 20 * radius);
    EXPECT_EQ(floor.size().y, 0);
    EXPECT_GT(grf::doubled_area_vector(*objects.meshes[1].mesh->geometry, 0, {}).y, 0) << "its front is up";
  }
}

TEST(Studio, LightsAnObjectOfAnySizeAlike) {
  for (const double radius : {0.001, 1.0, 500.0}) {
    const SceneObjects objects = studio_objects(radius, 0);
    ASSERT_EQ(objects.lights.size(), 2U);
    const grf::Vec3d centre(3 * radius, radius, radius);
    // The radiance of white paper, albedo 0.8, that faces each light.
    for (const LightObject& light : objects.lights) {
      const grf::Vec3d middle =
          grf::Vec3d(light.light.corner) + grf::Vec3d(light.light.edge1 + light.light.edge2) / 2;
      const grf::Vec3d direction = (middle - centre).normalized();
      EXPECT_GT(middle.y, 2 * radius) << "it is above";
      const double radiance =
          0.8 / std::numbers::pi * irradiance_of(light.light, centre + direction * radius, direction);
      const bool is_rim = middle.z < centre.z;
      EXPECT_GT(radiance, is_rim ? 0.05 : 0.5) << radius;
      EXPECT_LT(radiance, 1) << radius << ": burnt white";
    }
  }
}

TEST(Studio, StandsInAnEmptySceneToo) {
  const SceneObjects objects = objects_of(add_studio({}, {}), {});
  EXPECT_EQ(objects.meshes.size(), 1U);
  EXPECT_EQ(objects.lights.size(), 2U);
}

}  // namespace
}  // namespace editor
