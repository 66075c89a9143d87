#include "renderer/fit/observations.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <variant>

#include <boost/random/sobol.hpp>
#include <fmt/format.h>

#include "grf/text_file.h"
#include "renderer/reflectance/measurements/csv.h"

namespace fit {
namespace {

using reflectance::HalfAngles;
using reflectance::MerlTable;

constexpr double Degree = std::numbers::pi / 180;
constexpr double LargestMeasuredAngle = 80;
constexpr double LargestAngle = 88;

bool is_within(const Vec3d& direction, double degrees) { return direction.z >= std::cos(degrees * Degree); }

Vec3d turned(const Vec3d& direction, double phi) {
  const double cosine = std::cos(phi);
  const double sine = std::sin(phi);
  return {cosine * direction.x - sine * direction.y, sine * direction.x + cosine * direction.y, direction.z};
}

/// Returns whether all directions `u` are the same, or the same but for the azimuth.
bool has_one_view(const std::vector<Observation>& list) {
  return std::all_of(list.begin(), list.end(),
                     [&](const Observation& one) { return std::abs(one.u.z - list[0].u.z) < 1e-5; });
}

bool is_grey(const Observation& one) {
  const double most = std::max({one.value.x, one.value.y, one.value.z});
  return most - std::min({one.value.x, one.value.y, one.value.z}) <= 1e-6 * most;
}

}  // namespace

double mean_of(const std::vector<Observation>& list) {
  double sum = 0;
  for (const Observation& one : list) sum += (one.value.x + one.value.y + one.value.z) / 3 * one.v.z;
  return sum / static_cast<double>(std::max<std::size_t>(1, list.size()));
}

std::optional<Observations> usable(Observations observations, const std::string& path,
                                   grf::Diagnostics& diagnostics) {
  reflectance::remove_faulty(observations.list, path, diagnostics);
  const std::vector<Observation>& list = observations.list;
  const auto fail = [&](const char* why) {
    diagnostics.error(reflectance::line_of(path, 0), why);
    return std::nullopt;
  };
  if (list.empty()) return fail("no value can be used: there is nothing to fit");
  if (std::all_of(list.begin(), list.end(),
                  [](const Observation& one) { return one.value == Vec3d(0) || !(one.weight > 0); })) {
    return fail("all values are 0: there is nothing to fit");
  }
  if (has_one_view(list)) {
    diagnostics.warning(reflectance::line_of(path, 0),
                        "all values are of one view angle: how the BRDF changes with it is not determined");
  }
  observations.is_grey = std::all_of(list.begin(), list.end(), is_grey);
  return observations;
}

std::optional<Observations> read_csv(const std::string& path, grf::Diagnostics& diagnostics) {
  const auto bytes = grf::read_file(path, diagnostics);
  auto list = bytes ? reflectance::parse_csv(*bytes, path, diagnostics) : std::nullopt;
  if (!list) return std::nullopt;
  Observations observations;
  observations.description = fmt::format("{} lines of a CSV file", list->size());
  observations.list = *std::move(list);
  observations.is_isotropic = reflectance::are_isotropic(observations.list);
  return observations;
}

Observations cells_of(const MerlTable& table, std::size_t count) {
  const auto angles_of = [](std::uint32_t cell) {
    return MerlTable::angles_of(cell / (MerlTable::DifferenceCount * MerlTable::AzimuthCount),
                                cell / MerlTable::AzimuthCount % MerlTable::DifferenceCount,
                                cell % MerlTable::AzimuthCount);
  };
  std::vector<std::uint32_t> cells;
  for (std::uint32_t cell = 0; cell < MerlTable::CellCount; ++cell) {
    const HalfAngles angles = angles_of(cell);
    const reflectance::DirectionPair pair = directions_of(angles);
    if (!is_within(pair.u, LargestMeasuredAngle) || !is_within(pair.v, LargestMeasuredAngle)) continue;
    if (!reflectance::is_black(table.nearest(angles)))
      cells.push_back(cell);  // also of cells without a measurement
  }
  const std::size_t taken = std::min(count, cells.size());
  Observations observations;
  observations.description = fmt::format(
      "{} of {} cells of a MERL table, one at random from each run of cells; those over {} "
      "degrees, which were extrapolated, and those without a value are left out",
      taken, cells.size(), LargestMeasuredAngle);
  std::mt19937 random(1);
  for (std::size_t i = 0; i < taken; ++i) {
    const std::size_t begin = i * cells.size() / taken;
    const std::size_t end = (i + 1) * cells.size() / taken;
    const HalfAngles angles = angles_of(cells[begin + random() % (end - begin)]);
    const reflectance::DirectionPair pair = directions_of(angles);
    observations.list.push_back({pair.u.normalized(), pair.v.normalized(), Vec3d(table.nearest(angles))});
  }
  return observations;
}

Observations sampled(const reflectance::Brdf& brdf, std::size_t count, grf::Diagnostics& diagnostics) {
  const auto* measured = std::get_if<reflectance::Measured>(&brdf);
  if (measured != nullptr && measured->data && measured->data->merl() != nullptr)
    return cells_of(*measured->data->merl(), count);
  if (reflectance::has_specular_part(brdf))
    diagnostics.warning({}, "the specular (delta) part of the data is left out: no value shows it");
  const bool is_measured = measured != nullptr || std::holds_alternative<reflectance::Rgl>(brdf);
  const double largest = is_measured ? LargestMeasuredAngle : LargestAngle;
  Observations observations;
  observations.is_isotropic = !reflectance::is_anisotropic(brdf);
  boost::random::sobol sequence(4);
  const auto next = [&] { return static_cast<double>(sequence()) / 0x1p64; };
  while (observations.list.size() < count) {
    const double half = next();
    HalfAngles angles = {half * half * 90 * Degree, 0, 0};
    angles.theta_difference = next() * 90 * Degree;
    angles.phi_difference = next() * std::numbers::pi;
    const double phi = observations.is_isotropic ? 0 * next() : 2 * std::numbers::pi * next();
    const reflectance::DirectionPair pair = directions_of(angles);
    if (!is_within(pair.u, largest) || !is_within(pair.v, largest)) continue;
    observations.list.push_back({turned(pair.u.normalized(), phi), turned(pair.v.normalized(), phi), {}});
  }
  std::vector<Vec3d> values;
  evaluate(brdf, observations.list, values);
  for (std::size_t i = 0; i < count; ++i) observations.list[i].value = values[i];
  observations.description =
      fmt::format("{} pairs of directions up to {} degrees from the normal, with the density of MERL's cells",
                  count, largest);
  return observations;
}

}  // namespace fit
