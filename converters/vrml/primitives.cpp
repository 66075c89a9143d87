#include "converters/vrml/primitives.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace convert::vrml {
namespace {

constexpr unsigned SphereRows = SidesOfRound / 2;

/// Returns the direction at a fraction of a whole turn: from the back (-z) counter-clockwise, seen from
/// above, in which textures wrap.
grf::Vec3d direction(double turn) {
  const double angle = 2 * std::numbers::pi * turn;
  return {-std::sin(angle), 0, -std::cos(angle)};
}
double turn_of(unsigned side) { return static_cast<double>(side) / SidesOfRound; }

/// A builder of polygons, corner by corner.
class Solid {
 public:
  std::uint32_t add_position(const grf::Vec3d& position) {
    polygons_.positions.emplace_back(position);
    return static_cast<std::uint32_t>(polygons_.positions.size() - 1);
  }
  void add_corner(std::uint32_t position, const grf::Vec3d& normal, const grf::Vec2d& uv) {
    polygons_.corners.push_back(position);
    polygons_.normals.emplace_back(normal);
    polygons_.uvs.emplace_back(uv);
  }
  void end_face(std::uint32_t part) {
    polygons_.face_ends.push_back(polygons_.corners.size());
    polygons_.face_materials.push_back(part);
  }

  /// Adds a ring of positions, and returns the first index.
  std::uint32_t add_ring(double radius, double y) {
    const auto first = static_cast<std::uint32_t>(polygons_.positions.size());
    for (unsigned i = 0; i < SidesOfRound; ++i) {
      add_position(direction(turn_of(i)) * radius + grf::Vec3d(0, y, 0));
    }
    return first;
  }

  /// Adds the cap inside a ring, which faces up or down. Its texture is a disc of the image.
  void add_disc(std::uint32_t ring, bool looks_up, std::uint32_t part) {
    for (unsigned i = 0; i < SidesOfRound; ++i) {
      const unsigned side = looks_up ? i : SidesOfRound - 1 - i;
      const grf::Vec3d place = direction(turn_of(side));
      const double v = looks_up ? -place.z : place.z;
      add_corner(ring + side, grf::Vec3d(0), {(place.x + 1) / 2, (v + 1) / 2});
    }
    end_face(part);
  }

  Polygons take() { return std::move(polygons_); }

 private:
  Polygons polygons_ = {};
};

}  // namespace

Polygons make_box(const grf::Vec3d& size) {
  // Corners are 0 to 7: bit 0 is x, bit 1 is y, bit 2 is z. Each face starts at its lower left, seen from
  // outside.
  constexpr std::array<std::array<std::uint32_t, 4>, 6> Faces = {
      {{4, 5, 7, 6}, {1, 0, 2, 3}, {0, 4, 6, 2}, {5, 1, 3, 7}, {6, 7, 3, 2}, {0, 1, 5, 4}}};
  const std::array<grf::Vec2d, 4> uvs = {grf::Vec2d(0, 0), {1, 0}, {1, 1}, {0, 1}};
  Solid box;
  for (unsigned i = 0; i < 8; ++i) {
    const auto side = [i](unsigned bit) { return (i & bit) != 0 ? 0.5 : -0.5; };
    box.add_position(size * grf::Vec3d(side(1), side(2), side(4)));
  }
  for (std::uint32_t part = 0; part < Faces.size(); ++part) {
    for (std::size_t k = 0; k < 4; ++k) box.add_corner(Faces[part][k], grf::Vec3d(0), uvs[k]);
    box.end_face(part);
  }
  return box.take();
}

Polygons make_sphere(double radius) {
  struct Row {
    double y, radius;
    std::uint32_t first;
  };
  Solid sphere;
  std::array<Row, SphereRows + 1> rows = {};
  for (unsigned j = 0; j <= SphereRows; ++j) {
    const bool is_pole = j == 0 || j == SphereRows;
    const double angle = std::numbers::pi * j / SphereRows;
    Row& row = rows[j];
    row = {-std::cos(angle), is_pole ? 0 : std::sin(angle), 0};
    row.first = is_pole ? sphere.add_position({0, row.y * radius, 0})
                        : sphere.add_ring(row.radius * radius, row.y * radius);
  }
  // At a pole, where u is undefined, that of the middle of the triangle is used.
  const auto add_corner = [&](unsigned j, unsigned side, double turn) {
    const Row& row = rows[j];
    side %= SidesOfRound;
    const std::uint32_t position = row.radius == 0 ? row.first : row.first + side;
    sphere.add_corner(position, direction(turn_of(side)) * row.radius + grf::Vec3d(0, row.y, 0),
                      {turn, static_cast<double>(j) / SphereRows});
  };
  for (unsigned j = 0; j < SphereRows; ++j) {
    for (unsigned i = 0; i < SidesOfRound; ++i) {
      const double middle = (turn_of(i) + turn_of(i + 1)) / 2;
      add_corner(j, i, j == 0 ? middle : turn_of(i));
      if (j > 0) add_corner(j, i + 1, turn_of(i + 1));
      add_corner(j + 1, i + 1, j + 1 == SphereRows ? middle : turn_of(i + 1));
      if (j + 1 < SphereRows) add_corner(j + 1, i, turn_of(i));
      sphere.end_face(0);
    }
  }
  return sphere.take();
}

Polygons make_cone(double bottom_radius, double height, const Ends& ends) {
  Solid cone;
  const std::uint32_t ring = cone.add_ring(bottom_radius, -height / 2);
  const std::uint32_t apex = cone.add_position({0, height / 2, 0});
  const auto normal = [&](double turn) {
    return (direction(turn) * height + grf::Vec3d(0, bottom_radius, 0)).normalized();
  };
  for (unsigned i = 0; ends.side && i < SidesOfRound; ++i) {
    const double middle = (turn_of(i) + turn_of(i + 1)) / 2;
    cone.add_corner(ring + i, normal(turn_of(i)), {turn_of(i), 0});
    cone.add_corner(ring + (i + 1) % SidesOfRound, normal(turn_of((i + 1) % SidesOfRound)),
                    {turn_of(i + 1), 0});
    cone.add_corner(apex, normal(middle), {middle, 1});
    cone.end_face(0);
  }
  if (ends.bottom) cone.add_disc(ring, false, 1);
  return cone.take();
}

Polygons make_cylinder(double radius, double height, const Ends& ends) {
  Solid cylinder;
  const std::uint32_t bottom = cylinder.add_ring(radius, -height / 2);
  const std::uint32_t top = cylinder.add_ring(radius, height / 2);
  for (unsigned i = 0; ends.side && i < SidesOfRound; ++i) {
    const unsigned next = (i + 1) % SidesOfRound;
    const grf::Vec3d normal = direction(turn_of(i));
    const grf::Vec3d next_normal = direction(turn_of(next));
    cylinder.add_corner(bottom + i, normal, {turn_of(i), 0});
    cylinder.add_corner(bottom + next, next_normal, {turn_of(i + 1), 0});
    cylinder.add_corner(top + next, next_normal, {turn_of(i + 1), 1});
    cylinder.add_corner(top + i, normal, {turn_of(i), 1});
    cylinder.end_face(0);
  }
  if (ends.top) cylinder.add_disc(top, true, 1);
  if (ends.bottom) cylinder.add_disc(bottom, false, 2);
  return cylinder.take();
}

}  // namespace convert::vrml
