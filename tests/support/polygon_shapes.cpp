#include "tests/support/polygon_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace shapes {
namespace {

void add(Polygon& polygon, double x, double y) {
  polygon.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0F);
}

/// Rotates a shape by a right angle.
Shape turned(Shape shape) {
  shape.name += ", turned";
  for (grf::Vec3f& corner : shape.polygon) corner = {-corner.y, corner.x, 0};
  return shape;
}

/// Makes a star about the origin with alternating radii 1 and 2: n triangles with two known sides and angle.
Shape star(std::uint32_t n) {
  Shape shape{"star", {}, n * 0.5 * 1 * 2 * std::sin(2 * M_PI / n)};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    const double radius = i % 2 == 0 ? 1 : 2;
    add(shape.polygon, radius * std::cos(angle), radius * std::sin(angle));
  }
  return shape;
}

/// Makes a comb: teeth are triangles of height 99 on a bar of height 1.
Shape comb(std::uint32_t n) {
  const std::uint32_t teeth = n / 2 - 1;
  Shape shape{"comb", {}, 2.0 * teeth + 99.0 * teeth};
  add(shape.polygon, 0, 0);
  add(shape.polygon, 2.0 * teeth, 0);
  add(shape.polygon, 2.0 * teeth, 1);
  for (std::uint32_t i = teeth; i > 0; --i) {
    add(shape.polygon, 2.0 * i - 1, 100);
    add(shape.polygon, 2.0 * i - 2, 1);
  }
  return shape;
}

/// Makes a zigzag band of height 1/2.
Shape zigzag(std::uint32_t n) {
  const std::uint32_t half = n / 2;
  Shape shape{"zigzag", {}, 0.5 * (half - 1)};
  for (std::uint32_t i = 0; i < half; ++i) add(shape.polygon, i, i % 2 * 100.0);
  for (std::uint32_t i = half; i-- > 0;) add(shape.polygon, i, i % 2 * 100.0 + 0.5);
  return shape;
}

/// Makes a rectangular spiral about the origin, a band of width 1/4, each side longer by 1 than the one
/// before the last. It ends in diagonals of the band, so each of its segments is a trapezoid.
Shape spiral(std::uint32_t n) {
  const std::uint32_t half = n / 2;
  constexpr double Width = 0.25;
  Shape shape{"spiral", {}, 0};
  const auto corner = [](std::uint32_t i, double inset) {
    const double reach = i / 4 + i % 4 / 4.0 + 1 - inset;
    const std::uint32_t quarter = i % 4;
    return grf::Vec2d(quarter == 0 || quarter == 3 ? reach : -reach, quarter < 2 ? reach : -reach);
  };
  for (std::uint32_t i = 0; i < half; ++i) add(shape.polygon, corner(i, 0).x, corner(i, 0).y);
  for (std::uint32_t i = half; i-- > 0;) add(shape.polygon, corner(i, Width).x, corner(i, Width).y);
  for (std::uint32_t i = 0; i + 1 < half; ++i) {
    const grf::Vec2d a = corner(i, 0), b = corner(i + 1, 0), c = corner(i + 1, Width), d = corner(i, Width);
    shape.area += 0.5 * ((b - a).cross(c - a) + (c - a).cross(d - a));
  }
  return shape;
}

/// Makes needles, triangles of width 2^-10 and height 1,000 on a degenerate base: one edge along all of them
/// touches their corners.
Shape needles(std::uint32_t n) {
  const std::uint32_t count = n / 3;
  constexpr double Width = 1.0 / 1024;
  Shape shape{"needles", {}, count * Width * 1000 / 2};
  for (std::uint32_t i = count; i-- > 0;) {
    add(shape.polygon, (2 * i + 1) * Width, 0);
    add(shape.polygon, (2 * i + 0.5) * Width, 1000);
    add(shape.polygon, 2 * i * Width, 0);
  }
  return shape;
}

/// Makes a plate with rows of diamond holes of area 1/2; bridges connect the holes and the left side, so they
/// occur as edges twice.
Shape plate_with_holes(std::uint32_t n) {
  const auto side = std::max(1U, static_cast<std::uint32_t>(std::sqrt(n / 6.0)));
  const double size = 2.0 * side + 1;
  Shape shape{"plate with holes", {}, size * size - 0.5 * side * side};
  Polygon& polygon = shape.polygon;
  add(polygon, -1, -1);
  add(polygon, size - 1, -1);
  add(polygon, size - 1, size - 1);
  add(polygon, -1, size - 1);
  for (std::uint32_t row = side; row-- > 0;) {
    const double y = 2.0 * row;
    add(polygon, -1, y);
    for (std::uint32_t i = 0; i < side; ++i) {
      add(polygon, 2.0 * i, y);
      add(polygon, 2.0 * i + 0.5, y + 0.5);
      add(polygon, 2.0 * i + 1, y);
    }
    for (std::uint32_t i = side; i-- > 0;) {
      add(polygon, 2.0 * i + 1, y);
      add(polygon, 2.0 * i + 0.5, y - 0.5);
      add(polygon, 2.0 * i, y);
    }
    add(polygon, -1, y);
  }
  return shape;
}

/// Makes a plate with triangular holes of area 1/2, with all bridges to one corner of the plate.
Shape bridges_from_one_corner(std::uint32_t n) {
  const std::uint32_t holes = n / 5;
  const double size = 3.0 * holes;
  Shape shape{"bridges from one corner", {}, (size + 1) * (size + 1) - 0.5 * holes};
  Polygon& polygon = shape.polygon;
  add(polygon, -1, -1);
  add(polygon, size, -1);
  add(polygon, size, size);
  add(polygon, -1, size);
  for (std::uint32_t i = holes; i-- > 0;) {
    add(polygon, 3.0 * i, 1);
    add(polygon, 3.0 * i + 1, 0);
    add(polygon, 3.0 * i, 0);
    add(polygon, 3.0 * i, 1);
    add(polygon, -1, size);
  }
  return shape;
}

/// Makes a square of side 16 with a slit from the middle of one side to its centre, in many steps each way.
Shape slit(std::uint32_t n) {
  Shape shape{"slit", {}, 256};
  Polygon& polygon = shape.polygon;
  add(polygon, 0, 0);
  add(polygon, 16, 0);
  add(polygon, 16, 16);
  add(polygon, 0, 16);
  const std::uint32_t steps = n / 2;
  for (std::uint32_t i = 0; i < steps; ++i) add(polygon, 8.0 * i / steps, 8);
  for (std::uint32_t i = steps + 1; i-- > 0;) add(polygon, 8.0 * i / steps, 8);
  return shape;
}

/// Makes a square of side 4 without the quarter between two corners and the centre, with collinear vertices
/// along its sides, each repeated `repeats` times.
Shape straight_sides(std::uint32_t n, int repeats) {
  Shape shape{repeats > 1 ? "repeated corners" : "straight sides", {}, 12};
  const std::uint32_t steps = std::max(1U, n / 3 / static_cast<std::uint32_t>(repeats));
  const std::array<grf::Vec2d, 5> corners = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}}};
  const auto add_side = [&](const grf::Vec2d& from, const grf::Vec2d& to, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const grf::Vec2d place = from + (to - from) * (i / double(count));
      for (int k = 0; k < repeats; ++k) add(shape.polygon, place.x, place.y);
    }
  };
  for (std::size_t i = 0; i < 3; ++i) add_side(corners[i], corners[i + 1], steps);
  add_side(corners[3], corners[4], 1);
  add_side(corners[4], corners[0], 1);
  return shape;
}

using Random = std::mt19937;

struct Square {
  int x = 0;
  int y = 0;
  std::array<int, 4> joined = {-1, -1, -1, -1};  ///< below, right, above, left
};

std::vector<Square> grown_tree(std::uint32_t count, Random& random) {
  constexpr std::array<int, 4> Right = {0, 1, 0, -1};
  constexpr std::array<int, 4> Up = {-1, 0, 1, 0};
  const bool is_bushy = random() % 2 == 0;
  std::vector<Square> squares(1);
  std::map<std::pair<int, int>, bool> is_taken = {{{0, 0}, true}};
  while (squares.size() < count) {
    const std::size_t last_ones =
        is_bushy || random() % 8 == 0 ? squares.size() : std::min<std::size_t>(squares.size(), 5);
    const std::size_t from = squares.size() - 1 - random() % last_ones;
    const std::size_t side = random() % 4;
    const std::pair place{squares[from].x + Right[side], squares[from].y + Up[side]};
    if (!is_taken.try_emplace(place, true).second) continue;
    squares[from].joined[side] = static_cast<int>(squares.size());
    squares.push_back({place.first, place.second});
    squares.back().joined[(side + 2) % 4] = static_cast<int>(from);
  }
  return squares;
}

/// Traces the outline of all squares, from the last one, which is a leaf of the tree.
Polygon outline_of(const std::vector<Square>& squares) {
  std::size_t square = squares.size() - 1;
  std::size_t side = 0;
  while (squares[square].joined[side] >= 0) ++side;
  const std::size_t first_side = side;
  Polygon polygon;
  do {
    const bool is_right = side == 1 || side == 2;
    const bool is_above = side >= 2;
    add(polygon, squares[square].x + int(is_right), squares[square].y + int(is_above));
    side = (side + 1) % 4;
    while (squares[square].joined[side] >= 0) {
      square = static_cast<std::size_t>(squares[square].joined[side]);
      side = (side + 3) % 4;
    }
  } while (square != squares.size() - 1 || side != first_side);
  return polygon;
}

Polygon without_some_straight_corners(const Polygon& polygon, Random& random) {
  Polygon left;
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    const bool is_straight = polygon[i] - polygon[(i + n - 1) % n] == polygon[(i + 1) % n] - polygon[i];
    if (!is_straight || random() % 2 == 0) left.push_back(polygon[i]);
  }
  return left;
}

}  // namespace

std::vector<Shape> hard_shapes(std::uint32_t corners) {
  std::vector<Shape> shapes = {star(corners),
                               comb(corners),
                               zigzag(corners),
                               spiral(corners),
                               needles(corners),
                               plate_with_holes(corners),
                               bridges_from_one_corner(corners),
                               slit(corners),
                               straight_sides(corners, 1),
                               straight_sides(corners, 4)};
  const std::size_t upright = shapes.size();
  for (std::size_t i = 0; i < upright; ++i) shapes.push_back(turned(shapes[i]));
  return shapes;
}

Shape tree_of_squares(std::uint32_t squares, std::uint32_t seed) {
  Random random(seed);
  Shape shape{"tree of squares " + std::to_string(seed), outline_of(grown_tree(squares, random)),
              double(squares)};
  if (random() % 2 == 0) shape.polygon = without_some_straight_corners(shape.polygon, random);
  const auto shear_x = static_cast<float>(int(random() % 7) - 3);
  const auto shear_y = static_cast<float>(int(random() % 7) - 3);
  for (grf::Vec3f& corner : shape.polygon) {
    corner.x += shear_x * corner.y;
    corner.y += shear_y * corner.x;
  }
  const auto first = static_cast<std::ptrdiff_t>(random() % shape.polygon.size());
  std::rotate(shape.polygon.begin(), shape.polygon.begin() + first, shape.polygon.end());
  return shape;
}

}  // namespace shapes
