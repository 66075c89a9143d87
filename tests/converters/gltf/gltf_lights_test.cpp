// Lights of KHR_lights_punctual as meshes that emit: their irradiance far away against the closed forms for
// lights without size.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/geometry.h"
#include "grf/write.h"
#include "tests/converters/gltf/gltf_maker.h"

namespace convert {
namespace {

using grf::Vec3d;
using nlohmann::json;
using testing::HasSubstr;

/// Reads a file of one triangle and a light at a node.
Reading read_light(const json& light, json node = json::object()) {
  GltfMaker maker = GltfMaker::triangle();
  node["extensions"] = {{"KHR_lights_punctual", {{"light", 0}}}};
  maker.add_root(std::move(node));
  maker.json["extensionsUsed"] = {"KHR_lights_punctual"};
  maker.json["extensions"] = {{"KHR_lights_punctual", {{"lights", json::array({light})}}}};
  return maker.read();
}

/// The mesh of the light, of which all faces emit.
grf::Mesh light_mesh(const Reading& reading) {
  EXPECT_TRUE(reading.scene) << reading.text();
  const auto meshes = meshes_of(*reading.scene);
  EXPECT_EQ(meshes.size(), 2U);
  return meshes.back();
}

/// The irradiance of a surface at a place that faces the mesh, if that is small and far away: the sum over
/// faces of L cos dA cos / r^2 (with the normal towards the mesh).
Vec3d irradiance_at(const grf::Mesh& mesh, const Vec3d& place, const Vec3d& normal) {
  Vec3d sum(0);
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    const auto corner = [&](std::size_t i) { return Vec3d(mesh.geometry->positions[corners[i]]); };
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Vec3d area = (corner(i - 1) - corner(0)).cross(corner(i) - corner(0)) / 2;
      const Vec3d towards = place - (corner(0) + corner(i - 1) + corner(i)) / 3;
      const double emitted = area.dot(towards.normalized());
      const double received = -normal.dot(towards.normalized());
      if (emitted <= 0 || received <= 0) continue;
      sum += Vec3d(*mesh.surface(face).emission) * (emitted * received / towards.dot(towards));
    }
  }
  return sum;
}

// An icosahedron's projected area differs from its mean by 5 % at most.
TEST(GltfLight, OfAPointHasItsIntensityInAllDirections) {
  const Reading reading =
      read_light({{"type", "point"}, {"intensity", 20}, {"color", {1, 0.5, 0.25}}, {"name", "bulb"}},
                 {{"translation", {1, 2, 3}}, {"scale", {7, 7, 7}}});
  EXPECT_THAT(reading.text(), HasSubstr("1 light became a small mesh that emits: GRF has only area lights"));
  const grf::Mesh mesh = light_mesh(reading);
  EXPECT_EQ(mesh.name, "bulb");
  EXPECT_EQ(mesh.face_count(), 20U);
  double mean = 0;
  for (int i = 0; i < 200; ++i) {
    // Points of a Fibonacci spiral on the sphere.
    const double z = 1 - (i + 0.5) / 100;
    const double angle = i * 2.399963229728653;
    const Vec3d towards(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
    const Vec3d irradiance = irradiance_at(mesh, Vec3d(1, 2, 3) + towards * 2, -towards);
    EXPECT_NEAR(irradiance.x, 20 / 4.0, 0.05 * 5) << i;
    EXPECT_NEAR(irradiance.y, 10 / 4.0, 0.05 * 2.5) << i;
    EXPECT_NEAR(irradiance.z, 5 / 4.0, 0.05 * 1.25) << i;
    mean += irradiance.x / 200;
  }
  EXPECT_NEAR(mean, 5, 0.005 * 5);
}

// The triangle's box has a diagonal of sqrt 2, and a 200th of that is the radius.
TEST(GltfLight, IsSmallerThanWhatItLights) {
  const grf::Mesh mesh = light_mesh(read_light({{"type", "point"}}));
  for (const grf::Vec3f& position : mesh.geometry->positions)
    EXPECT_NEAR(position.length(), std::numbers::sqrt2 / 200, 1e-6);
}

TEST(GltfLight, OfASpotShinesAlongItsNode) {
  // Turned by 90 degrees about y: -z becomes -x.
  const double half = std::numbers::sqrt2 / 2;
  const Reading reading =
      read_light({{"type", "spot"}, {"intensity", 3}, {"spot", {{"outerConeAngle", 0.4}}}},
                 {{"rotation", {0, half, 0, half}}, {"translation", {5, 0, 0}}});
  EXPECT_THAT(reading.text(), HasSubstr("1 spot light lost its cone"));
  const grf::Mesh mesh = light_mesh(reading);
  EXPECT_NEAR(irradiance_at(mesh, Vec3d(3, 0, 0), Vec3d(1, 0, 0)).x, 3.0 / 4, 1e-3);
  EXPECT_EQ(irradiance_at(mesh, Vec3d(7, 0, 0), Vec3d(-1, 0, 0)).x, 0);
}

TEST(GltfLight, FromADirectionHasItsIrradianceEverywhere) {
  // Turned by -90 degrees about x: -z becomes -y, so that it shines down.
  const double half = std::numbers::sqrt2 / 2;
  const Reading reading =
      read_light({{"type", "directional"}, {"intensity", 8}}, {{"rotation", {-half, 0, 0, half}}});
  const grf::Mesh mesh = light_mesh(reading);
  for (const Vec3d& place : {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)})
    EXPECT_NEAR(irradiance_at(mesh, place, Vec3d(0, 1, 0)).x, 8, 0.02 * 8) << place;
  EXPECT_NEAR(irradiance_at(mesh, Vec3d(0), Vec3d(half, half, 0)).x, 8 * half, 0.01 * 8);
}

TEST(GltfLight, ReflectsNothing) {
  const grf::Mesh mesh = light_mesh(read_light({{"type", "point"}}));
  EXPECT_EQ(grf::to_text(std::get<grf::BrdfModel>(*mesh.surface(0).brdf)), "diffuse kd=0");
}

TEST(GltfLight, ThatIsNotValidIsLeftOut) {
  for (const json& light : {json{{"type", "neon"}}, json{{"type", "point"}, {"intensity", -2}},
                            json{{"type", "point"}, {"intensity", 1e300}}}) {
    const Reading reading = read_light(light);
    EXPECT_EQ(only_mesh(reading).face_count(), 1U) << light;
    EXPECT_THAT(reading.text(), HasSubstr("1 light was left out"));
  }
}

}  // namespace
}  // namespace convert
