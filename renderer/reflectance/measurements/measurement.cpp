#include "renderer/reflectance/measurements/measurement.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace reflectance {
namespace {

constexpr double NearNormal = 1e-3;

/// Values beyond are no reflectances, and their squares overflow a float.
constexpr double Largest = 1e15;

bool is_finite(const Imath::V3d& vector) {
  return std::abs(vector.x) < Largest && std::abs(vector.y) < Largest && std::abs(vector.z) < Largest;
}

/// Returns why a measurement cannot be used, or null.
const char* fault_of(const Measurement& one) {
  if (!is_finite(one.value) || !is_finite(one.u) || !is_finite(one.v) || !std::isfinite(one.weight) ||
      !std::isfinite(one.deviation)) {
    return "not finite";
  }
  if (one.value.x < 0 || one.value.y < 0 || one.value.z < 0) return "negative";
  if (!(one.u.z > 1e-6 && one.v.z > 1e-6)) return "of directions at or below the horizon";
  return nullptr;
}

bool have_one_azimuth(const std::vector<Measurement>& list, Imath::V3d Measurement::*direction) {
  std::optional<double> first;
  return std::all_of(list.begin(), list.end(), [&](const Measurement& one) {
    const Imath::V3d& d = one.*direction;
    if (!(std::hypot(d.x, d.y) >= NearNormal)) return true;
    const double azimuth = std::atan2(d.y, d.x);
    if (!first) first = azimuth;
    return std::abs(std::sin(azimuth - *first)) <= NearNormal;
  });
}

}  // namespace

Imath::V3d direction_at(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

bool are_isotropic(const std::vector<Measurement>& list) {
  return have_one_azimuth(list, &Measurement::u) || have_one_azimuth(list, &Measurement::v);
}

grf::SourceLocation line_of(const std::string& path, std::uint32_t line) {
  if (path.empty()) return {};
  grf::SourceLocation location = grf::whole_file(path);
  location.line = line;
  location.column = line > 0 ? 1 : 0;
  return location;
}

void remove_faulty(std::vector<Measurement>& list, const std::string& path, grf::Diagnostics& diagnostics) {
  for (const char* fault : {"not finite", "negative", "of directions at or below the horizon"}) {
    const auto has_fault = [fault](const Measurement& one) { return fault_of(one) == fault; };
    const auto first = std::find_if(list.begin(), list.end(), has_fault);
    if (first == list.end()) continue;
    const std::uint32_t line = first->line;
    const std::size_t before = list.size();
    std::erase_if(list, has_fault);
    diagnostics.warning(line_of(path, line), fmt::format("{} of {} values are {}: they are left out",
                                                         before - list.size(), before, fault));
  }
}

}  // namespace reflectance
