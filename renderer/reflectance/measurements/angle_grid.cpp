#include "renderer/reflectance/measurements/angle_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "renderer/reflectance/measurements/measurement.h"

namespace reflectance {
namespace {

using Imath::V3d;

constexpr double FullTurn = 2 * std::numbers::pi;

double angle_from_normal(const V3d& d) { return std::atan2(std::hypot(d.x, d.y), d.z); }

/// The axes around the mirror direction of a light.
struct MirrorFrame {
  explicit MirrorFrame(const V3d& light)
      : pole(-light.x, -light.y, light.z),
        to_normal(direction_at(angle_from_normal(pole) - std::numbers::pi / 2, std::atan2(pole.y, pole.x))),
        side(pole.cross(to_normal)) {}

  V3d pole, to_normal, side;
};

}  // namespace

AngleGrid::AngleGrid(GridAxes axes, std::vector<Rgb> values)
    : axes_(std::move(axes)), values_(std::move(values)) {
  assert(values_.size() ==
         axes_.incidence.size() * axes_.rotation.size() * axes_.azimuth.size() * axes_.polar.size());
}

AngleGrid::Place AngleGrid::place_between(const std::vector<double>& nodes, double angle, bool extrapolates) {
  if (nodes.size() == 1) return {};
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, angle);
  const auto upper = static_cast<std::size_t>(above - nodes.begin());
  const double fraction = (angle - nodes[upper - 1]) / (nodes[upper] - nodes[upper - 1]);
  return {upper - 1, upper, extrapolates ? fraction : std::clamp(fraction, 0.0, 1.0)};
}

// Between the last and the first angle the values go on around the turn.
AngleGrid::Place AngleGrid::place_around(const std::vector<double>& nodes, double angle) {
  if (nodes.size() == 1) return {};
  const double turns = (angle - nodes.front()) / FullTurn;
  const double wrapped = nodes.front() + FullTurn * (turns - std::floor(turns));
  if (wrapped <= nodes.back()) return place_between(nodes, wrapped, false);
  const double gap = nodes.front() + FullTurn - nodes.back();
  return {nodes.size() - 1, 0, std::min(1.0, (wrapped - nodes.back()) / gap)};
}

AngleGrid::Places AngleGrid::places_of(const V3d& u, const V3d& v) const {
  const double light_azimuth = std::atan2(v.y, v.x);
  double polar = angle_from_normal(u);
  double azimuth = std::atan2(u.y, u.x) - (is_anisotropic() ? 0 : light_azimuth);
  if (axes_.pole == GridAxes::Pole::Mirror) {
    const MirrorFrame frame(v);
    polar = std::atan2(frame.pole.cross(u).length(), frame.pole.dot(u));
    azimuth = std::atan2(frame.side.dot(u), frame.to_normal.dot(u));
  }
  if (axes_.is_mirrored) azimuth = std::abs(std::remainder(azimuth, FullTurn));
  return {
      place_between(axes_.incidence, angle_from_normal(v), axes_.extrapolates),
      place_around(axes_.rotation, light_azimuth),
      axes_.is_mirrored ? place_between(axes_.azimuth, azimuth, false) : place_around(axes_.azimuth, azimuth),
      place_between(axes_.polar, polar, axes_.extrapolates)};
}

Rgb AngleGrid::linear(const V3d& u, const V3d& v) const {
  const Places places = places_of(u, v);
  V3d sum(0);
  for (unsigned corner = 0; corner < 16; ++corner) {
    double weight = 1;
    const auto take = [&](const Place& place, unsigned bit) {
      const bool is_upper = (corner >> bit & 1U) != 0;
      weight *= is_upper ? place.fraction : 1 - place.fraction;
      return is_upper ? place.upper : place.lower;
    };
    const std::size_t incidence = take(places.incidence, 3);
    const std::size_t rotation = take(places.rotation, 2);
    const std::size_t azimuth = take(places.azimuth, 1);
    const std::size_t polar = take(places.polar, 0);
    if (weight != 0) sum += weight * V3d(value(incidence, rotation, azimuth, polar));
  }
  return Rgb(sum);
}

Rgb AngleGrid::nearest(const V3d& u, const V3d& v) const {
  const Places places = places_of(u, v);
  return value(places.incidence.nearest(), places.rotation.nearest(), places.azimuth.nearest(),
               places.polar.nearest());
}

}  // namespace reflectance
