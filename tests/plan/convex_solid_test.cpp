// Triangles that enclose a convex solid, and near misses.
#include "renderer/plan/convex_solid.h"

#include <array>
#include <deque>
#include <vector>

#include <gtest/gtest.h>

namespace plan {
namespace {

using grf::Vec3d;

/// Triangles with their planes, from corners that are counter-clockwise seen from the front.
class Triangles {
 public:
  void add(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    corners_.push_back({a, b, c});
    const Vec3d normal = (b - a).cross(c - a).normalized();
    all_.push_back({corners_.back(), normal, normal.dot(a)});
  }
  void add(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    add(a, b, c);
    add(a, c, d);
  }
  void remove_last() { all_.pop_back(); }
  bool are_convex_solid() const { return enclose_convex_solid(all_, 1e-9); }

 private:
  std::deque<std::array<Vec3d, 3>> corners_;
  std::vector<PlaneTriangle> all_;
};

/// The sides of a box from `low` to `high`, the top last.
Triangles box(const Vec3d& low = Vec3d(0), const Vec3d& high = Vec3d(1)) {
  const auto at = [&](int x, int y, int z) {
    return Vec3d(x == 0 ? low.x : high.x, y == 0 ? low.y : high.y, z == 0 ? low.z : high.z);
  };
  Triangles sides;
  sides.add(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0));
  sides.add(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
  sides.add(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
  sides.add(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
  sides.add(at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0));
  sides.add(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
  return sides;
}

TEST(ConvexSolid, IsABox) { EXPECT_TRUE(box().are_convex_solid()); }

TEST(ConvexSolid, IsATetrahedron) {
  Triangles sides;
  sides.add(Vec3d(0), Vec3d(0, 1, 0), Vec3d(1, 0, 0));
  sides.add(Vec3d(0), Vec3d(0, 0, 1), Vec3d(0, 1, 0));
  sides.add(Vec3d(0), Vec3d(1, 0, 0), Vec3d(0, 0, 1));
  EXPECT_FALSE(sides.are_convex_solid()) << "its last side is missing";
  sides.add(Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1));
  EXPECT_TRUE(sides.are_convex_solid());
}

// Light gets in, and from inside to inside.
TEST(ConvexSolid, IsNoBoxWithoutLid) {
  Triangles open = box();
  open.remove_last();
  EXPECT_FALSE(open.are_convex_solid());
  open.remove_last();
  EXPECT_FALSE(open.are_convex_solid());
}

TEST(ConvexSolid, IsNoSheetOfTwoSides) {
  Triangles sheet;
  sheet.add(Vec3d(0), Vec3d(1, 0, 0), Vec3d(0, 1, 0));
  EXPECT_FALSE(sheet.are_convex_solid());
  sheet.add(Vec3d(0), Vec3d(0, 1, 0), Vec3d(1, 0, 0));
  EXPECT_FALSE(sheet.are_convex_solid());
}

TEST(ConvexSolid, HasItsFrontsOutwards) {
  EXPECT_FALSE(box(Vec3d(1), Vec3d(0)).are_convex_solid()) << "turned inside out";
}

TEST(ConvexSolid, IsNoSolidWithADent) {
  Triangles dented = box();
  dented.remove_last();
  dented.remove_last();
  const Vec3d dent(0.5, 0.5, 0.9);
  const std::array<Vec3d, 4> rim = {Vec3d(0, 0, 1), Vec3d(1, 0, 1), Vec3d(1, 1, 1), Vec3d(0, 1, 1)};
  for (std::size_t i = 0; i < 4; ++i) dented.add(rim[i], rim[(i + 1) % 4], dent);
  EXPECT_FALSE(dented.are_convex_solid());
}

}  // namespace
}  // namespace plan
