// The Utah teapot, cut from the Bezier patches that Martin Newell published in 1975 (with the bottom that
// Frank Crow added in 1987). The control points are those of a quarter of the body, rim, lid and bottom, and
// of one half of handle and spout; the rest follows by reflection.
#include "samples/shapes/teapot.h"

namespace shape {
namespace {

using grf::Vec3f;
using Points = std::array<Vec3f, 16>;

struct PatchIndices {
  bool in_all_quarters;  ///< reflected in x and y, or in y alone
  std::array<int, 16> points;
};

constexpr std::array<PatchIndices, 10> Patches = {{
    {true, {102, 103, 104, 105, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}},                // rim
    {true, {12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27}},              // body
    {true, {24, 25, 26, 27, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40}},              // body
    {true, {96, 96, 96, 96, 97, 98, 99, 100, 101, 101, 101, 101, 0, 1, 2, 3}},             // lid
    {true, {0, 1, 2, 3, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117}},      // lid
    {true, {118, 118, 118, 118, 124, 122, 119, 121, 123, 126, 125, 120, 40, 39, 38, 37}},  // bottom
    {false, {41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56}},             // handle
    {false, {53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 28, 65, 66, 67}},             // handle
    {false, {68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83}},             // spout
    {false, {80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95}},             // spout
}};

// z is up here.
constexpr float ControlPoints[127][3] = {
    {0.2F, 0, 2.7F},
    {0.2F, -0.112F, 2.7F},
    {0.112F, -0.2F, 2.7F},
    {0, -0.2F, 2.7F},
    {1.3375F, 0, 2.53125F},
    {1.3375F, -0.749F, 2.53125F},
    {0.749F, -1.3375F, 2.53125F},
    {0, -1.3375F, 2.53125F},
    {1.4375F, 0, 2.53125F},
    {1.4375F, -0.805F, 2.53125F},
    {0.805F, -1.4375F, 2.53125F},
    {0, -1.4375F, 2.53125F},
    {1.5F, 0, 2.4F},
    {1.5F, -0.84F, 2.4F},
    {0.84F, -1.5F, 2.4F},
    {0, -1.5F, 2.4F},
    {1.75F, 0, 1.875F},
    {1.75F, -0.98F, 1.875F},
    {0.98F, -1.75F, 1.875F},
    {0, -1.75F, 1.875F},
    {2, 0, 1.35F},
    {2, -1.12F, 1.35F},
    {1.12F, -2, 1.35F},
    {0, -2, 1.35F},
    {2, 0, 0.9F},
    {2, -1.12F, 0.9F},
    {1.12F, -2, 0.9F},
    {0, -2, 0.9F},
    {-2, 0, 0.9F},
    {2, 0, 0.45F},
    {2, -1.12F, 0.45F},
    {1.12F, -2, 0.45F},
    {0, -2, 0.45F},
    {1.5F, 0, 0.225F},
    {1.5F, -0.84F, 0.225F},
    {0.84F, -1.5F, 0.225F},
    {0, -1.5F, 0.225F},
    {1.5F, 0, 0.15F},
    {1.5F, -0.84F, 0.15F},
    {0.84F, -1.5F, 0.15F},
    {0, -1.5F, 0.15F},
    {-1.6F, 0, 2.025F},
    {-1.6F, -0.3F, 2.025F},
    {-1.5F, -0.3F, 2.25F},
    {-1.5F, 0, 2.25F},
    {-2.3F, 0, 2.025F},
    {-2.3F, -0.3F, 2.025F},
    {-2.5F, -0.3F, 2.25F},
    {-2.5F, 0, 2.25F},
    {-2.7F, 0, 2.025F},
    {-2.7F, -0.3F, 2.025F},
    {-3, -0.3F, 2.25F},
    {-3, 0, 2.25F},
    {-2.7F, 0, 1.8F},
    {-2.7F, -0.3F, 1.8F},
    {-3, -0.3F, 1.8F},
    {-3, 0, 1.8F},
    {-2.7F, 0, 1.575F},
    {-2.7F, -0.3F, 1.575F},
    {-3, -0.3F, 1.35F},
    {-3, 0, 1.35F},
    {-2.5F, 0, 1.125F},
    {-2.5F, -0.3F, 1.125F},
    {-2.65F, -0.3F, 0.9375F},
    {-2.65F, 0, 0.9375F},
    {-2, -0.3F, 0.9F},
    {-1.9F, -0.3F, 0.6F},
    {-1.9F, 0, 0.6F},
    {1.7F, 0, 1.425F},
    {1.7F, -0.66F, 1.425F},
    {1.7F, -0.66F, 0.6F},
    {1.7F, 0, 0.6F},
    {2.6F, 0, 1.425F},
    {2.6F, -0.66F, 1.425F},
    {3.1F, -0.66F, 0.825F},
    {3.1F, 0, 0.825F},
    {2.3F, 0, 2.1F},
    {2.3F, -0.25F, 2.1F},
    {2.4F, -0.25F, 2.025F},
    {2.4F, 0, 2.025F},
    {2.7F, 0, 2.4F},
    {2.7F, -0.25F, 2.4F},
    {3.3F, -0.25F, 2.4F},
    {3.3F, 0, 2.4F},
    {2.8F, 0, 2.475F},
    {2.8F, -0.25F, 2.475F},
    {3.525F, -0.25F, 2.49375F},
    {3.525F, 0, 2.49375F},
    {2.9F, 0, 2.475F},
    {2.9F, -0.15F, 2.475F},
    {3.45F, -0.15F, 2.5125F},
    {3.45F, 0, 2.5125F},
    {2.8F, 0, 2.4F},
    {2.8F, -0.15F, 2.4F},
    {3.2F, -0.15F, 2.4F},
    {3.2F, 0, 2.4F},
    {0, 0, 3.15F},
    {0.8F, 0, 3.15F},
    {0.8F, -0.45F, 3.15F},
    {0.45F, -0.8F, 3.15F},
    {0, -0.8F, 3.15F},
    {0, 0, 2.85F},
    {1.4F, 0, 2.4F},
    {1.4F, -0.784F, 2.4F},
    {0.784F, -1.4F, 2.4F},
    {0, -1.4F, 2.4F},
    {0.4F, 0, 2.55F},
    {0.4F, -0.224F, 2.55F},
    {0.224F, -0.4F, 2.55F},
    {0, -0.4F, 2.55F},
    {1.3F, 0, 2.55F},
    {1.3F, -0.728F, 2.55F},
    {0.728F, -1.3F, 2.55F},
    {0, -1.3F, 2.55F},
    {1.3F, 0, 2.4F},
    {1.3F, -0.728F, 2.4F},
    {0.728F, -1.3F, 2.4F},
    {0, -1.3F, 2.4F},
    {0, 0, 0},
    {1.425F, -0.798F, 0},
    {1.5F, 0, 0.075F},
    {1.425F, 0, 0},
    {0.798F, -1.425F, 0},
    {0, -1.5F, 0.075F},
    {0, -1.425F, 0},
    {1.5F, -0.84F, 0.075F},
    {0.84F, -1.5F, 0.075F},
};

/// The control points of a patch, reflected; a single reflection turns the patch, so its rows run backwards.
Points control_points(const PatchIndices& patch, bool reflect_x, bool reflect_y) {
  Points points;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const int source = reflect_x != reflect_y ? 3 - column : column;
      const float* p = ControlPoints[patch.points[4 * row + source]];
      points[4 * row + column] = {reflect_x ? -p[0] : p[0], reflect_y ? -p[1] : p[1], p[2]};
    }
  }
  return points;
}

struct Weights {
  std::array<float, 4> value;
  std::array<float, 4> derivative;
};

/// Cubic Bernstein polynomials.
Weights bernstein(float t) {
  const float s = 1 - t;
  return {{s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t},
          {-3 * s * s, 3 * s * s - 6 * t * s, 6 * t * s - 3 * t * t, 3 * t * t}};
}

Vec3f combine(const Points& points, const std::array<float, 4>& rows, const std::array<float, 4>& columns) {
  Vec3f sum(0);
  for (int i = 0; i < 16; ++i) sum += points[i] * rows[i / 4] * columns[i % 4];
  return sum;
}

Vec3f normal_at(const Points& points, float row, float column) {
  const Weights a = bernstein(row);
  const Weights b = bernstein(column);
  return combine(points, a.derivative, b.value).cross(combine(points, a.value, b.derivative));
}

/// Where a side of the patch is a point, a derivative is 0 there, and the normal is that of a place nearby.
Vec3f unit_normal_at(const Points& points, float row, float column) {
  const Vec3f normal = normal_at(points, row, column);
  if (normal.length() > 1e-4F) return normal.normalized();
  const auto inwards = [](float t) { return t + (0.5F - t) * 2e-2F; };
  return normal_at(points, inwards(row), inwards(column)).normalized();
}

Vec3f y_up(const Vec3f& v) { return {v.x, v.z, -v.y}; }

/// A quad, or a triangle where two corners are one point.
void add_face(const std::array<std::uint32_t, 4>& quad, Patch& patch) {
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3f to_last = patch.positions[quad[i]] - patch.positions[quad[(i + 3) % 4]];
    if (!(to_last.length() < 1e-6F)) corners.push_back(quad[i]);
  }
  if (corners.size() >= 3) patch.faces.push_back(std::move(corners));
}

Patch cut(const Points& points, int subdivisions) {
  Patch patch;
  const int side = subdivisions + 1;
  for (int i = 0; i < side * side; ++i) {
    const float row = static_cast<float>(i / side) / static_cast<float>(subdivisions);
    const float column = static_cast<float>(i % side) / static_cast<float>(subdivisions);
    patch.positions.push_back(y_up(combine(points, bernstein(row).value, bernstein(column).value)));
    patch.normals.push_back(y_up(unit_normal_at(points, row, column)));
  }
  const auto width = static_cast<std::uint32_t>(side);
  for (std::uint32_t row = 0; row + 1 < width; ++row) {
    for (std::uint32_t column = 0; column + 1 < width; ++column) {
      const std::uint32_t a = row * width + column;
      add_face({a, a + width, a + width + 1, a + 1}, patch);
    }
  }
  return patch;
}

}  // namespace

std::vector<Patch> teapot_patches(int subdivisions) {
  std::vector<Patch> patches;
  for (const PatchIndices& patch : Patches) {
    for (const bool reflect_x : {false, true}) {
      if (reflect_x && !patch.in_all_quarters) continue;
      for (const bool reflect_y : {false, true})
        patches.push_back(cut(control_points(patch, reflect_x, reflect_y), subdivisions));
    }
  }
  return patches;
}

grf::Mesh teapot(int subdivisions) {
  grf::MeshDraft mesh;
  for (const Patch& patch : teapot_patches(subdivisions)) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t i = 0; i < patch.positions.size(); ++i) {
      mesh.normals.set(mesh.positions.size(), patch.normals[i]);
      mesh.positions.push_back(patch.positions[i]);
    }
    for (std::vector<std::uint32_t> corners : patch.faces) {
      for (std::uint32_t& corner : corners) corner += first;
      mesh.add_face(corners, 0);
    }
  }
  return mesh;
}

}  // namespace shape
