#include "renderer/reflectance/rgl_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "renderer/reflectance/halton.h"

namespace reflectance {
namespace {

using Imath::V2d;
using Imath::V3d;

constexpr double DoublePi = std::numbers::pi;
constexpr double Horizon = 1e-12;
constexpr double LargestValue = 1e30;  // as of `bounded` in common.glsl

double bounded_value(double value) { return value > 0 ? std::min(value, LargestValue) : 0; }

bool are_above_horizon(const V3d& u, const V3d& v) { return u.z > Horizon && v.z > Horizon; }

double theta_of(const V3d& direction) {
  return std::atan2(std::hypot(direction.x, direction.y), direction.z);
}
double phi_of(const V3d& direction) { return std::atan2(direction.y, direction.x); }

/// Returns an angle's place between 0 and a full turn.
double wrapped(double angle) { return angle - 2 * DoublePi * std::floor(angle / (2 * DoublePi)); }

/// Returns the point of the unit square for a direction. Angles near the normal get more of it.
V2d square_point(double theta, double phi) {
  const double turns = (phi + DoublePi) / (2 * DoublePi);
  return {std::sqrt(theta * 2 / DoublePi), turns - std::floor(turns)};
}

/// Returns the signs of x and y that turn a direction with this azimuth into the range that the file covers.
V2d flip_into(AzimuthRange range, double first_azimuth, const V3d& u) {
  if (range == AzimuthRange::Half) {
    const double sign = wrapped(phi_of(u) - first_azimuth) > DoublePi ? -1 : 1;
    return {sign, sign};
  }
  if (range != AzimuthRange::Quarter) return {1, 1};
  const double middle = first_azimuth + DoublePi / 4;
  return {std::cos(middle) * u.x < 0 ? -1.0 : 1.0, std::sin(middle) * u.y < 0 ? -1.0 : 1.0};
}

/// Returns an azimuth of the range as a number from its start. Rounding may put one just outside, at either
/// end.
double azimuth_in(double first_azimuth, double phi) {
  const double offset = wrapped(phi - first_azimuth);
  constexpr double Rounding = 1e-6;
  return first_azimuth + (offset > 2 * DoublePi - Rounding ? 0 : offset);
}

V3d flipped(const V3d& direction, const V2d& flip) {
  return {direction.x * flip.x, direction.y * flip.y, direction.z};
}

}  // namespace

/// A view direction with what the tables have for it.
struct RglData::View {
  V2d flip;
  V3d u;
  double phi = 0;  ///< subtracted from the azimuth of h: 0 unless the file is isotropic
  SliceWeights slices;
  double sigma = 0;
};

/// A half vector in the tables.
struct RglData::Place {
  V2d half;             ///< in the unit square
  WarpedPoint uniform;  ///< the point that is warped to `half`, with the density there
  double factor = 0;    ///< of the tabulated colour, so that it becomes f
  double jacobian = 0;  ///< solid angle of v per area of the unit square
};

std::shared_ptr<const RglData> RglData::load(const std::string& path, grf::Diagnostics& diagnostics,
                                             const grf::SourceLocation& asked_for_at) {
  const auto file = TensorFile::load(path, diagnostics, asked_for_at);
  if (!file) return nullptr;
  std::string error;
  auto tables = read_rgl_tables(*file, error);
  if (!tables) {
    diagnostics.error(asked_for_at.file ? asked_for_at : grf::whole_file(path),
                      fmt::format("'{}' is not an RGL BRDF file: {}", path, error));
    return nullptr;
  }
  return std::make_shared<const RglData>(*std::move(tables));
}

RglData::RglData(RglTables tables) : tables_(std::move(tables)) {
  for (std::size_t i = 0; i < AlbedoCount; ++i) {
    albedos_[i] = estimated_albedo(std::max(0.02, static_cast<double>(i) / (AlbedoCount - 1)));
  }
}

RglData::View RglData::view_of(const V3d& u) const {
  View view;
  view.flip = flip_into(tables_.range, tables_.first_azimuth, u);
  view.u = flipped(u, view.flip);
  const double theta = theta_of(u);
  const double phi = phi_of(view.u);
  view.phi = is_isotropic() ? phi : 0;
  const double azimuth = is_isotropic() ? tables_.first_azimuth : azimuth_in(tables_.first_azimuth, phi);
  view.slices = tables_.views.around(azimuth, theta);
  view.sigma = tables_.sigma.evaluate(square_point(theta, phi - view.phi), {});
  return view;
}

RglData::Place RglData::place_of(const View& view, const V3d& v) const {
  const V3d sum = view.u + flipped(v, view.flip);
  const double length = sum.length();
  Place place;
  place.half = square_point(theta_of(sum), phi_of(sum) - view.phi);
  place.uniform = tables_.visible.invert(place.half, view.slices);
  const double ndf = tables_.is_divided_by_ndf ? tables_.ndf.evaluate(place.half, {}) : 4 * view.sigma;
  place.factor = view.sigma > 0 ? ndf / (4 * view.sigma * v.z) : 0;
  // d(theta, phi) per area, then sin(theta), then the solid angle of v per one of h.
  const double sine = std::hypot(sum.x, sum.y) / length;
  place.jacobian = 2 * DoublePi * DoublePi * place.half.x * sine * 2 * length;
  return place;
}

V3d RglData::rgb_at(const Place& place, const View& view) const {
  V3d value;
  for (unsigned int k = 0; k < 3; ++k) {
    value[static_cast<int>(k)] =
        bounded_value(tables_.rgb.evaluate(place.uniform.point, view.slices, k) * place.factor);
  }
  return value;
}

double RglData::sampled_pdf(const Place& place, const View& view) const {
  const double in_square = place.uniform.pdf * tables_.luminance.pdf(place.uniform.point, view.slices);
  // At h = n the jacobian is 0.
  return std::min(in_square / std::max(place.jacobian, 1e-30), LargestValue);
}

V3d RglData::evaluate(const V3d& u, const V3d& v) const {
  if (!are_above_horizon(u, v)) return V3d(0);
  const View view = view_of(u);
  return rgb_at(place_of(view, v), view);
}

bool RglData::is_negative(const V3d& u, const V3d& v) const {
  if (!are_above_horizon(u, v)) return false;
  const View view = view_of(u);
  const Place place = place_of(view, v);
  for (unsigned int k = 0; k < 3; ++k) {
    if (tables_.rgb.evaluate(place.uniform.point, view.slices, k) < 0) return true;
  }
  return false;
}

double RglData::pdf(const V3d& u, const V3d& v) const {
  if (!are_above_horizon(u, v)) return 0;
  const View view = view_of(u);
  return sampled_pdf(place_of(view, v), view);
}

Reflection RglData::reflect(const V3d& u, const V3d& v) const {
  if (!are_above_horizon(u, v)) return {};
  const View view = view_of(u);
  const Place place = place_of(view, v);
  return {Rgb(rgb_at(place, view)), static_cast<float>(sampled_pdf(place, view))};
}

std::vector<double> RglData::spectrum(const V3d& u, const V3d& v) const {
  std::vector<double> values(tables_.wavelengths.size());
  if (!are_above_horizon(u, v)) return values;
  const View view = view_of(u);
  const Place place = place_of(view, v);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = bounded_value(tables_.spectra.evaluate(place.uniform.point, view.slices, i) * place.factor);
  }
  return values;
}

V3d RglData::direction(const V3d& u, const V2d& xi) const {
  const View view = view_of(u);
  const V2d uniform = tables_.luminance.sample(xi, view.slices).point;
  const V2d half = tables_.visible.sample(uniform, view.slices).point;
  const double theta = half.x * half.x * DoublePi / 2;
  const double phi = (2 * half.y - 1) * DoublePi + view.phi;
  const double sine = std::sin(theta);
  const V3d h(sine * std::cos(phi), sine * std::sin(phi), std::cos(theta));
  return flipped(2 * view.u.dot(h) * h - view.u, view.flip);
}

float RglData::estimated_albedo(double cosine) const {
  constexpr std::uint32_t Count = 128;
  double sum = 0;
  for (std::uint32_t i = 0; i < Count; ++i) {
    const Uniforms xi = halton_point(i);
    const double phi = is_isotropic() ? 0 : 2 * DoublePi * double(xi.choice);
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const V3d u(sine * std::cos(phi), sine * std::sin(phi), cosine);
    // Both techniques of the mixture that Rgl samples, in equal parts: by the tables, and by the cosine.
    for (const V3d& v : {direction(u, V2d(xi.direction)), V3d(cosine_direction(xi.direction))}) {
      const Reflection reflection = reflect(u, v);
      const double mixed = double(reflection.pdf) + v.z / DoublePi;
      if (v.z > 0 && mixed > 0) sum += double(mean(reflection.value)) * v.z / mixed;
    }
  }
  return static_cast<float>(std::min(1.0, sum / Count));
}

float RglData::albedo(const Vec3f& u) const {
  const float place = std::clamp(u.z, 0.0F, 1.0F) * (AlbedoCount - 1);
  const auto lower = std::min(static_cast<std::size_t>(place), AlbedoCount - 2);
  const float fraction = place - static_cast<float>(lower);
  return (1 - fraction) * albedos_[lower] + fraction * albedos_[lower + 1];
}

}  // namespace reflectance
