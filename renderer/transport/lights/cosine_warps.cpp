#include "renderer/transport/lights/cosine_warps.h"

#include <algorithm>
#include <cmath>

namespace transport {
namespace {

using grf::Vec2f;
using grf::Vec3f;

constexpr float EvenShare = 0.05F;
/// Normals lie on a grid over the unfolded octahedron: odd, so that the axis-aligned ones, as of floors and
/// walls, are exact.
constexpr int NormalsAcross = 13;

float sign_of(float x) { return x < 0 ? -1.0F : 1.0F; }

/// Octahedral coordinates between -1 and 1 (Cigolle, Donow, Evangelakos, Mara, McGuire and Meyer 2014, "A
/// survey of efficient representations for independent unit vectors").
Vec2f to_octahedron(const Vec3f& v) {
  const float norm = std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
  const Vec2f p(v.x / norm, v.y / norm);
  if (v.z >= 0) return p;
  return {(1 - std::abs(p.y)) * sign_of(p.x), (1 - std::abs(p.x)) * sign_of(p.y)};
}
Vec3f from_octahedron(const Vec2f& p) {
  Vec3f v(p.x, p.y, 1 - std::abs(p.x) - std::abs(p.y));
  if (v.z < 0) {
    v.x = (1 - std::abs(p.y)) * sign_of(p.x);
    v.y = (1 - std::abs(p.x)) * sign_of(p.y);
  }
  return v.normalized();
}

template <class Shares>
struct Cell {
  std::size_t index;
  float start;
  float share;

  Cell(const Shares& shares, std::size_t at)
      : index(at), start(at == 0 ? 0 : shares[at - 1]), share(shares[at] - start) {}
  static Cell choose(const Shares& shares, float xi) {
    const auto above = std::upper_bound(shares.begin(), shares.end() - 1, xi);
    return Cell(shares, static_cast<std::size_t>(above - shares.begin()));
  }
  /// Inverts the CDF within the cell, which is uniform, for a number in [0,1).
  float place(float xi) const {
    const float inside =
        (static_cast<float>(index) + (xi - start) / share) / static_cast<float>(Shares().size());
    return std::min(inside, 0x1.fffffep-1F);
  }
};

/// Returns the index of the cell, of `count` equal ones in the unit interval, that contains xi.
std::size_t cell_at(float xi, std::size_t count) {
  return std::min(static_cast<std::size_t>(xi * static_cast<float>(count)), count - 1);
}

}  // namespace

CosineWarps::CosineWarps(const std::function<Vec3f(const Vec2f&)>& direction_of) {
  constexpr int Points = 4;  // across and down a cell
  std::vector<std::vector<Vec3f>> directions;
  for (int cell = 0; cell < Cells * Cells; ++cell) {
    auto& inside = directions.emplace_back();
    for (int i = 0; i < Points * Points; ++i) {
      const auto at = [](int index, int point) {
        return (static_cast<float>(index) + (static_cast<float>(point) + 0.5F) / Points) / Cells;
      };
      inside.push_back(direction_of({at(cell % Cells, i % Points), at(cell / Cells, i / Points)}));
    }
  }
  for (int i = 0; i < NormalsAcross * NormalsAcross; ++i) {
    const auto at = [](int k) { return static_cast<float>(2 * k) / (NormalsAcross - 1) - 1; };
    tables_.push_back(table_for(directions, from_octahedron({at(i % NormalsAcross), at(i / NormalsAcross)})));
  }
}

CosineWarps::Table CosineWarps::table_for(const std::vector<std::vector<Vec3f>>& directions,
                                          const Vec3f& normal) {
  std::array<double, Cells * Cells> weights;
  double total = 0;
  for (std::size_t cell = 0; cell < weights.size(); ++cell) {
    weights[cell] = 0;
    for (const Vec3f& direction : directions[cell]) weights[cell] += std::max(0.0F, direction.dot(normal));
    total += weights[cell];
  }
  constexpr double Even = 1.0 / (Cells * Cells);
  Table table;
  double sum = 0;
  for (std::size_t row = 0; row < Cells; ++row) {
    std::array<double, Cells> shares;
    double in_row = 0;
    for (std::size_t column = 0; column < Cells; ++column) {
      const double cosine_part = total > 0 ? weights[row * Cells + column] / total : Even;
      shares[column] = (1 - EvenShare) * cosine_part + EvenShare * Even;
      in_row += shares[column];
    }
    double before = 0;
    for (std::size_t column = 0; column < Cells; ++column) {
      before += shares[column];
      table.columns[row][column] = static_cast<float>(before / in_row);
    }
    table.columns[row].back() = 1;
    sum += in_row;
    table.rows[row] = static_cast<float>(sum);
  }
  table.rows.back() = 1;
  return table;
}

std::size_t CosineWarps::table_of(const Vec3f& normal) {
  const Vec2f p = to_octahedron(normal);
  const auto nearest = [](float x) {
    const int k = static_cast<int>(std::lround((x + 1) * (0.5F * (NormalsAcross - 1))));
    return static_cast<std::size_t>(std::clamp(k, 0, NormalsAcross - 1));
  };
  return nearest(p.y) * NormalsAcross + nearest(p.x);
}

CosineWarps::Warped CosineWarps::warp(const Vec3f& normal, const Vec2f& xi) const {
  const Table& table = tables_[table_of(normal)];
  const auto row = Cell<std::array<float, Cells>>::choose(table.rows, xi.y);
  const auto column = Cell<std::array<float, Cells>>::choose(table.columns[row.index], xi.x);
  return {{column.place(xi.x), row.place(xi.y)}, row.share * column.share * (Cells * Cells)};
}

float CosineWarps::pdf(const Vec3f& normal, const Vec2f& warped) const {
  const Table& table = tables_[table_of(normal)];
  const Cell row(table.rows, cell_at(warped.y, Cells));
  const Cell column(table.columns[row.index], cell_at(warped.x, Cells));
  return row.share * column.share * (Cells * Cells);
}

}  // namespace transport
