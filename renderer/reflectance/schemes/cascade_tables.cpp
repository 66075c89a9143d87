#include "renderer/reflectance/schemes/cascade_tables.h"

#include <array>
#include <numeric>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/schemes/cumulative.h"

namespace reflectance {
namespace {

/// The fraction of samples that is uniform over all h: no cell is empty, so that light unknown to a table,
/// such as that of other views that use it, still has a pdf above 0.
constexpr double CascadeFloor = 0.01;

/// The corners of the range of views that a table serves, from which it is made.
using Corners = std::array<std::array<Vec3f, 2>, 2>;  // by theta_u and phi_u

Corners corners_of(std::size_t view, bool is_anisotropic) {
  constexpr std::array<float, 2> Places = {0.125F, 0.875F};
  Corners corners;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const float angle = static_cast<float>(view % CascadeTables::ViewAngles) + Places[i];
      const float azimuth = static_cast<float>(view / CascadeTables::ViewAngles) + Places[k];
      const float theta = Pi / 2 * angle / CascadeTables::ViewAngles;
      const float phi = is_anisotropic ? 2 * Pi * azimuth / CascadeTables::ViewAzimuths : 0;
      corners[i][k] = from_angles(std::cos(theta), std::sin(theta), phi);
    }
  }
  return corners;
}

/// Merges all rows between two edges into one.
std::vector<double> merged(std::span<const double> masses, std::size_t columns, std::size_t first,
                           std::size_t end) {
  std::vector<double> sums(columns, 0.0);
  for (std::size_t i = first * columns; i < end * columns; ++i) sums[i % columns] += masses[i];
  return sums;
}

std::vector<double> row_sums(std::span<const double> masses, std::size_t columns) {
  std::vector<double> sums;
  for (std::size_t i = 0; i < masses.size(); i += columns) {
    sums.push_back(std::accumulate(masses.begin() + i, masses.begin() + i + columns, 0.0));
  }
  return sums;
}

template <class Value>
void extend(std::vector<Value>& list, const std::vector<Value>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

CascadeTables::CascadeTables(const Brdf& brdf, const Size& size, bool compress)
    : grid_(size.rows, size.columns), is_anisotropic_(is_anisotropic(brdf)) {
  std::vector<Curves> views(ViewAngles * (is_anisotropic_ ? ViewAzimuths : 1));
  parallel::for_each_index(views.size(), [&](std::size_t i) { views[i] = make_view(brdf, i, compress); });
  for (Curves& view : views) {
    append(view);
    view = {};
  }
  curves_.begins.push_back(static_cast<std::uint32_t>(curves_.values.size()));
  curves_.values.shrink_to_fit();
  curves_.points.shrink_to_fit();
  curves_.begins.shrink_to_fit();
}

CascadeTables::Curves CascadeTables::make_view(const Brdf& brdf, std::size_t view, bool compress) const {
  Curves curves;
  const std::vector<double> cells = masses(brdf, view);
  if (compress) {
    append_compressed(curves, cells);
  } else {
    append_plain(curves, cells);
  }
  return curves;
}

std::vector<double> CascadeTables::masses(const Brdf& brdf, std::size_t view) const {
  const Corners corners = corners_of(view, is_anisotropic_);
  const CellPoints points(grid_, 256, 32);
  std::vector<double> masses;
  for (std::size_t row = 0; row < grid_.rows(); ++row) {
    for (std::size_t column = 0; column < grid_.columns(); ++column) {
      double sum = 0;
      for (std::size_t i = 0; i < points.down(); ++i) {
        for (std::size_t k = 0; k < points.across(); ++k) {  // all corners, on each side of the cell
          sum += scalar_of_half(brdf, corners[(i + k) % 2][k % 2], points.direction(row, column, i, k));
        }
      }
      masses.push_back(sum * grid_.solid_angle(row, row + 1, 1));
    }
  }
  const double sum = std::accumulate(masses.begin(), masses.end(), 0.0);
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const std::size_t row = i / grid_.columns();
    const double even = grid_.solid_angle(row, row + 1, 1) / (2 * Pi);
    masses[i] = sum > 0 ? masses[i] / sum * (1 - CascadeFloor) + CascadeFloor * even : even;
  }
  return masses;
}

void CascadeTables::append_plain(Curves& curves, std::span<const double> masses) const {
  const auto add = [&](std::span<const double> cells) {
    curves.begins.push_back(static_cast<std::uint32_t>(curves.values.size()));
    extend(curves.values, cumulative(cells));
  };
  add(row_sums(masses, grid_.columns()));
  for (std::size_t row = 0; row < grid_.rows(); ++row) {
    add(masses.subspan(row * grid_.columns(), grid_.columns()));
  }
}

void CascadeTables::append_compressed(Curves& curves, std::span<const double> masses) const {
  const auto add = [&](std::span<const double> cells, std::span<const float> edges, float tolerance) {
    const std::vector<float> curve = cumulative(cells);
    std::vector<std::uint16_t> kept = simplified(edges, curve, tolerance);
    curves.begins.push_back(static_cast<std::uint32_t>(curves.values.size()));
    for (const std::uint16_t i : kept) curves.values.push_back(curve[i]);
    extend(curves.points, kept);
    return kept;
  };
  const std::vector<std::uint16_t> rows =
      add(row_sums(masses, grid_.columns()), grid_.versines(), MarginalTolerance);
  std::vector<float> edges(grid_.columns() + 1);
  std::iota(edges.begin(), edges.end(), 0.0F);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    add(merged(masses, grid_.columns(), rows[i], rows[i + 1]), edges, ConditionalTolerance);
  }
}

void CascadeTables::append(const Curves& view) {
  marginals_.push_back(static_cast<std::uint32_t>(curves_.begins.size()));
  const auto offset = static_cast<std::uint32_t>(curves_.values.size());
  for (const std::uint32_t begin : view.begins) curves_.begins.push_back(begin + offset);
  extend(curves_.values, view.values);
  extend(curves_.points, view.points);
}

std::size_t CascadeTables::Curve::piece_with(std::size_t cell) const {
  if (points == nullptr) return cell;
  const auto* const above = std::upper_bound(points + 1, points + values.size() - 1, cell);
  return static_cast<std::size_t>(above - points) - 1;
}

CascadeTables::Curve CascadeTables::curve(std::size_t index) const {
  const std::size_t begin = curves_.begins[index];
  const std::size_t end = curves_.begins[index + 1];
  return {std::span(curves_.values).subspan(begin, end - begin),
          curves_.points.empty() ? nullptr : curves_.points.data() + begin};
}

std::size_t CascadeTables::view_of(const Vec3f& u) const {
  const auto nearest = [](float fraction, std::size_t count) {
    return std::min(static_cast<std::size_t>(fraction * static_cast<float>(count)), count - 1);
  };
  const std::size_t angle = nearest(right_angles_of(versine_of(u)), ViewAngles);
  return is_anisotropic_ ? angle + ViewAngles * nearest(turns_of(u), ViewAzimuths) : angle;
}

Vec3f CascadeTables::half_vector(const Vec3f& u, const Vec2f& xi) const {
  const std::size_t first = marginals_[view_of(u)];
  const Curve marginal = curve(first);
  const CdfPosition row = inverted(marginal.values, xi.x);
  const Curve conditional = curve(first + 1 + row.cell);
  const CdfPosition column = inverted(conditional.values, xi.y);
  const auto from = static_cast<float>(conditional.point(column.cell));
  const auto to = static_cast<float>(conditional.point(column.cell + 1));
  const Vec3f h = grid_.direction(marginal.point(row.cell), marginal.point(row.cell + 1), row.fraction,
                                  from + column.fraction * (to - from));
  return is_anisotropic_ ? h : AzimuthRotation(u).from_plane(h);
}

float CascadeTables::half_pdf(const Vec3f& u, const Vec3f& h) const {
  const Vec3f turned = is_anisotropic_ ? h : AzimuthRotation(u).to_plane(h);
  const std::size_t first = marginals_[view_of(u)];
  const Curve marginal = curve(first);
  const std::size_t row = marginal.piece_with(grid_.row_of(turned));
  const Curve conditional = curve(first + 1 + row);
  const std::size_t column = conditional.piece_with(grid_.column_of(turned));
  const float mass = (marginal.values[row + 1] - marginal.values[row]) *
                     (conditional.values[column + 1] - conditional.values[column]);
  return mass / grid_.solid_angle(marginal.point(row), marginal.point(row + 1),
                                  conditional.point(column + 1) - conditional.point(column));
}

std::size_t CascadeTables::bytes() const {
  return sizeof(*this) + grid_.bytes() + curves_.values.size() * sizeof(float) +
         curves_.points.size() * sizeof(std::uint16_t) +
         (curves_.begins.size() + marginals_.size()) * sizeof(std::uint32_t);
}

}  // namespace reflectance
