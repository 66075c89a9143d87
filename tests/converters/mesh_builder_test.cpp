#include "converters/mesh_builder.h"

#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace convert {
namespace {

using testing::ElementsAre;

Corner at(float x) { return {grf::Vec3f(x, 0, 0), std::nullopt, std::nullopt, std::nullopt}; }

TEST(MeshBuilder, SharesCornersThatAreAlike) {
  MeshBuilder builder("name");
  const std::uint32_t surface = builder.surface({});
  builder.add_face(std::vector{at(1), at(2), at(3)}, surface);
  builder.add_face(std::vector{at(3), at(2), at(4)}, surface);
  const grf::Mesh mesh = builder.take();
  EXPECT_EQ(mesh.name, "name");
  EXPECT_THAT(mesh.geometry->corners, ElementsAre(0, 1, 2, 2, 1, 3));
  EXPECT_EQ(mesh.geometry->positions.size(), 4U);
}

TEST(MeshBuilder, SharesNoCornersThatDifferInTheLastBit) {
  MeshBuilder builder("");
  builder.add_face(std::vector{at(1), at(std::nextafter(1.0F, 2.0F)), at(3)}, builder.surface({}));
  EXPECT_EQ(builder.take().geometry->positions.size(), 3U);
}

TEST(MeshBuilder, TellsAnAbsentValueFromZero) {
  Corner with_normal = at(1);
  with_normal.normal = grf::Vec3f(0);
  Corner with_colour = at(1);
  with_colour.colour = grf::Colour(0);
  MeshBuilder builder("");
  builder.add_face(std::vector{at(1), with_normal, with_colour}, builder.surface({}));
  const grf::Mesh mesh = builder.take();
  ASSERT_EQ(mesh.geometry->positions.size(), 3U);
  EXPECT_FALSE(mesh.geometry->normals.has(0));
  EXPECT_TRUE(mesh.geometry->normals.has(1));
  EXPECT_FALSE(mesh.geometry->normals.has(2));
  EXPECT_TRUE(mesh.geometry->colours.has(2));
}

TEST(MeshBuilder, TheFirstSurfaceIsTheMeshsOwn) {
  grf::Surface red;
  red.colour = grf::Colour(1, 0, 0);
  MeshBuilder builder("");
  const std::uint32_t first = builder.surface(red);
  const std::uint32_t second = builder.surface({});
  EXPECT_EQ(first, 0U);
  EXPECT_NE(second, first);
  EXPECT_EQ(builder.surface(red), first);
  EXPECT_EQ(builder.take().surfaces, (std::vector{red, grf::Surface()}));
}

RC_GTEST_PROP(MeshBuilder, HasEachDifferentCornerOnce, (const std::vector<std::vector<float>>& faces)) {
  MeshBuilder builder("");
  const std::uint32_t surface = builder.surface({});
  std::set<std::uint32_t> different;
  std::vector<std::uint32_t> bits;
  for (const std::vector<float>& face : faces) {
    std::vector<Corner> corners;
    for (const float x : face) {
      corners.push_back(at(x));
      const float unsigned_zero = x + 0.0F;  // the sign of a zero does not count
      std::memcpy(&bits.emplace_back(), &unsigned_zero, sizeof x);
      different.insert(bits.back());
    }
    builder.add_face(corners, surface);
  }
  const grf::Mesh mesh = builder.take();
  RC_ASSERT(mesh.geometry->positions.size() == different.size());
  for (std::size_t i = 0; i < bits.size(); ++i) {
    std::uint32_t kept = 0;
    const float x = mesh.geometry->positions[mesh.geometry->corners[i]].x + 0.0F;
    std::memcpy(&kept, &x, sizeof kept);
    RC_ASSERT(kept == bits[i]);
  }
}

}  // namespace
}  // namespace convert
