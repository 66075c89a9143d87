#include "renderer/reflectance/rgl_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <ImathMatrix.h>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/bilinear_warp.h"
#include "renderer/reflectance/observer.h"
#include "renderer/reflectance/spectrum.h"
#include "renderer/reflectance/tensor_file.h"

namespace reflectance {
namespace {

using Imath::V2d;
using Imath::V3d;

constexpr double Turn = 2 * std::numbers::pi;
constexpr double LargestAngle = 88 * std::numbers::pi / 180;
/// The fraction of the wide microfacets, so that no half vector is out of reach.
constexpr double WidePart = 0.1;
constexpr double WideRoughness = 0.7;

V3d direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// A half vector at a point of the unit square, as in `RglTables`.
struct HalfVector {
  double theta = 0;
  V3d direction;
};
HalfVector half_vector(const V2d& point) {
  const double theta = point.x * point.x * std::numbers::pi / 2;
  return {theta, reflectance::direction(theta, (2 * point.y - 1) * std::numbers::pi)};
}

/// The ellipsoids of Trowbridge and Reitz 1975.
double wide_facets(double cosine) {
  constexpr double Square = WideRoughness * WideRoughness;
  const double below = cosine * cosine * (Square - 1) + 1;
  return Square / (std::numbers::pi * below * below);
}

V2d node_of(const NodeGrid& grid, std::size_t index) {
  const auto place = [](std::size_t i, std::size_t count) {
    return static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, count - 1));
  };
  return {place(index % grid.width, grid.width), place(index / grid.width, grid.height)};
}

std::vector<float> tabulated(const NodeGrid& grid, const std::function<double(const V2d&)>& function) {
  std::vector<float> values(grid.node_count());
  parallel::for_each_index(
      values.size(), [&](std::size_t i) { values[i] = static_cast<float>(function(node_of(grid, i))); });
  return values;
}

/// The distribution of microfacets and their projected areas, interpolated as readers do.
class Facets {
 public:
  Facets(const Brdf& brdf, std::size_t nodes)
      : grid_{nodes, is_anisotropic(brdf) ? nodes + 1 : 2},
        ndf_values_(distribution(brdf)),
        ndf_(grid_, 1, ndf_values_) {
    sigma_values_ =
        tabulated(grid_, [&](const V2d& point) { return projected_area(half_vector(point).direction); });
    sigma_ = BilinearTable(grid_, 1, sigma_values_);
  }

  const NodeGrid& grid() const { return grid_; }
  const std::vector<float>& ndf_values() const { return ndf_values_; }
  const std::vector<float>& sigma_values() const { return sigma_values_; }
  double ndf(const V2d& point) const { return ndf_.evaluate(point, {}); }
  double sigma(const V2d& point) const { return sigma_.evaluate(point, {}); }

 private:
  /// The squares of a fine grid, with the solid angles of their half vectors.
  template <class Add>
  static void for_each_half_vector(const Add& add) {
    constexpr int Across = 96;
    constexpr int Around = 96;
    for (int i = 0; i < Across; ++i) {
      for (int k = 0; k < Around; ++k) {
        const V2d point((i + 0.5) / Across, (k + 0.5) / Around);
        const HalfVector m = half_vector(point);
        const double solid_angle = std::numbers::pi * point.x * std::sin(m.theta) * Turn / (Across * Around);
        add(point, m.direction, solid_angle);
      }
    }
  }

  /// Facets that are seen along their normal reflect D/(4 cos^2), but for their shadows.
  std::vector<float> distribution(const Brdf& brdf) const {
    std::vector<float> seen = tabulated(grid_, [&](const V2d& point) {
      const V3d m = half_vector(point).direction;
      if (m.z < 0.02) return 0.0;
      const Vec3f u(m);
      return 4 * std::min(1e9, double(mean(evaluate(brdf, u, u)))) * m.z * m.z;
    });
    const BilinearTable table(grid_, 1, seen);
    double area = 0;
    for_each_half_vector([&](const V2d& point, const V3d& m, double solid_angle) {
      area += table.evaluate(point, {}) * m.z * solid_angle;
    });
    const double scale = area > 1e-12 ? (1 - WidePart) / area : 0;
    const double wide = area > 1e-12 ? WidePart : 1;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double cosine = half_vector(node_of(grid_, i)).direction.z;
      seen[i] = static_cast<float>(scale * double(seen[i]) + wide * wide_facets(cosine));
    }
    return seen;
  }

  double projected_area(const V3d& w) const {
    double area = 0;
    for_each_half_vector([&](const V2d& point, const V3d& m, double solid_angle) {
      area += ndf(point) * std::max(0.0, w.dot(m)) * solid_angle;
    });
    return area;
  }

  NodeGrid grid_;
  std::vector<float> ndf_values_;
  BilinearTable ndf_;
  std::vector<float> sigma_values_;
  BilinearTable sigma_;
};

/// Evaluates the channels of a file: RGB, or the values at wavelengths.
class Channels {
 public:
  Channels(const Brdf& brdf, RglColours colours, const Rgb& colour) : brdf_(brdf), colour_(colour) {
    if (colours == RglColours::LinearSrgb) return;
    const std::vector<float> own = wavelengths_of(brdf);
    has_spectrum_ = !own.empty();
    if (std::holds_alternative<Rgl>(brdf) && has_spectrum_) {
      wavelengths_ = own;
    } else if (has_spectrum_) {
      for (int nanometres = 380; nanometres <= 780; nanometres += 20) {
        wavelengths_.push_back(static_cast<float>(nanometres));
      }
    } else {
      wavelengths_ = {380, 470, 530, 560, 620, 780};  // where the slopes of the curves change
    }
    find_curves();
  }

  std::size_t count() const { return wavelengths_.empty() ? 3 : wavelengths_.size(); }
  const std::vector<float>& wavelengths() const { return wavelengths_; }

  /// Evaluates f(u, v) per channel. Below the horizon it is that of the mirrored direction.
  std::vector<double> evaluate(const V3d& u, const V3d& v) const {
    const V3d above(v.x, v.y, std::max(1e-4, std::abs(v.z)));
    if (has_spectrum_) {
      std::vector<double> values = spectrum_of(brdf_, u, above.normalized(), wavelengths_);
      for (std::size_t i = 0; i < values.size(); ++i) values[i] *= colour_spectrum_[i];
      return values;
    }
    const Rgb rgb = colour_ * reflectance::evaluate(brdf_, Vec3f(u), Vec3f(above.normalized()));
    if (wavelengths_.empty()) return {double(rgb.x), double(rgb.y), double(rgb.z)};
    return spectrum_with(rgb);
  }

 private:
  /// Returns the sum of the curves that has an RGB, of which negative values are 0.
  std::vector<double> spectrum_with(const Rgb& rgb) const {
    const V3d amounts = V3d(rgb) * of_rgb_;
    std::vector<double> values;
    for (const V3d& curve : curves_) values.push_back(std::max(0.0, curve.dot(amounts)));
    return values;
  }

  /// Makes three curves that sum to 1 everywhere, and the matrix whose amounts of them have a given RGB.
  void find_curves() {
    const auto ramp = [](double wavelength, double from, double to) {
      return std::clamp((wavelength - from) / (to - from), 0.0, 1.0);
    };
    for (const float nanometres : wavelengths_) {
      const double blue = 1 - ramp(double(nanometres), 470, 530);
      const double red = ramp(double(nanometres), 560, 620);
      curves_.emplace_back(red, 1 - red - blue, blue);
    }
    const auto weights = rgb_weights(wavelengths_);
    Imath::M33d to_rgb;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        to_rgb[row][column] = 0;
        for (std::size_t i = 0; i < curves_.size(); ++i) {
          to_rgb[row][column] += curves_[i][row] * weights[static_cast<std::size_t>(column)][i];
        }
      }
    }
    of_rgb_ = to_rgb.inverse();
    colour_spectrum_ = spectrum_with(colour_);
  }

  const Brdf& brdf_;
  Rgb colour_;
  std::vector<double> colour_spectrum_;  ///< of the colour; empty for RGB
  std::vector<float> wavelengths_;       ///< empty: RGB
  bool has_spectrum_ = false;
  std::vector<V3d> curves_;  ///< by wavelength
  Imath::M33d of_rgb_;       ///< row vectors of RGB to amounts of the curves
};

/// The tables of one view direction.
struct ViewTables {
  std::vector<float> visible;
  std::vector<float> luminance;
  std::vector<float> colours;  ///< by channel
};

ViewTables tables_of(const V3d& u, const V2d& view_point, const Facets& facets, const Channels& channels,
                     const NodeGrid& colour_grid) {
  const NodeGrid& grid =
      facets.grid().height > 2 ? facets.grid() : NodeGrid{facets.grid().width, facets.grid().width};
  ViewTables tables;
  tables.visible.resize(grid.node_count());
  for (std::size_t i = 0; i < tables.visible.size(); ++i) {
    const V2d point = node_of(grid, i);
    const HalfVector m = half_vector(point);
    const double density =
        std::max(0.0, u.dot(m.direction)) * facets.ndf(point) * point.x * std::sin(m.theta);
    tables.visible[i] = static_cast<float>(density);
  }
  const BilinearWarp warp(grid, tables.visible);
  const std::size_t nodes = colour_grid.node_count();
  tables.colours.resize(channels.count() * nodes);
  tables.luminance.resize(nodes);
  const double sigma = facets.sigma(view_point);
  for (std::size_t i = 0; i < nodes; ++i) {
    const V2d point = warp.sample(node_of(colour_grid, i), {}).point;
    const V3d m = half_vector(point).direction;
    const V3d v = 2 * u.dot(m) * m - u;
    const double factor = facets.ndf(point) > 0 ? v.z * 4 * sigma / facets.ndf(point) : 0;
    const std::vector<double> values = channels.evaluate(u, v);
    double sum = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      tables.colours[k * nodes + i] = static_cast<float>(values[k] * factor);
      sum += values[k] * factor;
    }
    tables.luminance[i] = static_cast<float>(std::max(0.0, sum));
  }
  return tables;
}

/// The view directions of a file; the azimuths of an anisotropic BRDF cover the full turn, both ends
/// included.
struct Views {
  std::vector<float> azimuths;
  std::vector<float> angles;

  Views(const RglResolution& resolution, bool is_isotropic) {
    const std::size_t around = is_isotropic ? 0 : std::max<std::size_t>(4, resolution.azimuths);
    for (std::size_t i = 0; i <= around; ++i) {
      const double place = around == 0 ? 0.5 : static_cast<double>(i) / static_cast<double>(around);
      azimuths.push_back(static_cast<float>((2 * place - 1) * std::numbers::pi));
    }
    const std::size_t count = std::max<std::size_t>(2, resolution.angles);
    for (std::size_t i = 0; i < count; ++i) {
      angles.push_back(
          static_cast<float>(LargestAngle * static_cast<double>(i) / static_cast<double>(count - 1)));
    }
  }
};

/// Appends the tables of all views in their order.
std::vector<float> joined(const std::vector<ViewTables>& views, std::vector<float> ViewTables::*table) {
  std::vector<float> all;
  for (const ViewTables& view : views) all.insert(all.end(), (view.*table).begin(), (view.*table).end());
  return all;
}

}  // namespace

RglResolution RglResolution::times(double factor) const {
  const auto scaled = [factor](std::size_t count) {
    return static_cast<std::size_t>(std::lround(factor * static_cast<double>(count)));
  };
  return {scaled(angles), scaled(azimuths), scaled(half_vectors), scaled(colours)};
}

std::string rgl_file_of(const Brdf& brdf, const RglResolution& resolution, RglColours colours,
                        const std::string& description, const Rgb& colour) {
  const Facets facets(brdf, resolution.half_vectors);
  const Channels channels(brdf, colours, colour);
  const Views views(resolution, !is_anisotropic(brdf));
  const NodeGrid colour_grid{resolution.colours, resolution.colours};
  std::vector<ViewTables> tables(views.azimuths.size() * views.angles.size());
  parallel::for_each_index(tables.size(), [&](std::size_t i) {
    const double theta = double(views.angles[i % views.angles.size()]);
    const double phi = double(views.azimuths[i / views.angles.size()]);
    const V2d place(std::sqrt(theta * 2 / std::numbers::pi), (phi + std::numbers::pi) / Turn);
    tables[i] = tables_of(direction(theta, phi), place, facets, channels, colour_grid);
  });
  const std::vector<std::size_t> leading = {views.azimuths.size(), views.angles.size()};
  const auto shape = [&](std::vector<std::size_t> more) {
    more.insert(more.begin(), leading.begin(), leading.end());
    return more;
  };
  const std::size_t half_rows = tables.front().visible.size() / facets.grid().width;
  TensorFileMaker file;
  file.add("description", description);
  file.add("phi_i", {views.azimuths.size()}, views.azimuths);
  file.add("theta_i", {views.angles.size()}, views.angles);
  file.add("ndf", {facets.grid().height, facets.grid().width}, facets.ndf_values());
  file.add("sigma", {facets.grid().height, facets.grid().width}, facets.sigma_values());
  file.add("vndf", shape({half_rows, facets.grid().width}), joined(tables, &ViewTables::visible));
  file.add("luminance", shape({colour_grid.height, colour_grid.width}),
           joined(tables, &ViewTables::luminance));
  const bool is_spectral = !channels.wavelengths().empty();
  if (is_spectral) file.add("wavelengths", {channels.count()}, channels.wavelengths());
  file.add(is_spectral ? "spectra" : "rgb", shape({channels.count(), colour_grid.height, colour_grid.width}),
           joined(tables, &ViewTables::colours));
  file.add("jacobian", std::string(1, '\1'));
  return file.bytes();
}

}  // namespace reflectance
