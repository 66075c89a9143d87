#include "renderer/reflectance/measurements/utia.h"

#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace reflectance {
namespace {

constexpr std::size_t ThetaCount = 6;
constexpr std::size_t PhiCount = 48;
constexpr std::size_t DirectionCount = ThetaCount * PhiCount;
constexpr std::size_t PlaneCount = DirectionCount * DirectionCount;

std::vector<double> multiples(double degrees, std::size_t count) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < count; ++i)
    angles.push_back(degrees * static_cast<double>(i) * std::numbers::pi / 180);
  return angles;
}

}  // namespace

bool sniff_utia(std::string_view bytes) { return bytes.size() == 3 * PlaneCount * sizeof(double); }

std::shared_ptr<const AngleGrid> parse_utia(std::string_view bytes, const std::string& path,
                                            grf::Diagnostics& diagnostics) {
  const auto fail = [&](const std::string& what) {
    diagnostics.error(grf::whole_file(path), "not a file of the UTIA data base: " + what);
    return nullptr;
  };
  if (!sniff_utia(bytes))
    return fail(fmt::format("it has {} bytes, expected {}", bytes.size(), 3 * PlaneCount * sizeof(double)));
  GridAxes axes;
  axes.incidence = axes.polar = multiples(15, ThetaCount);
  axes.rotation = axes.azimuth = multiples(7.5, PhiCount);
  axes.extrapolates = true;
  std::vector<Rgb> values(PlaneCount);
  for (std::size_t i = 0; i < 3 * PlaneCount; ++i) {
    double value = 0;
    std::memcpy(&value, bytes.data() + i * sizeof(value), sizeof(value));
    if (!(std::abs(value) < 1e30))
      return fail(fmt::format("the number at byte {} is {}", i * sizeof(value), value));
    // In the file, the angle from the normal precedes the azimuth for the view too.
    const std::size_t entry = i % PlaneCount;
    const std::size_t light = entry / DirectionCount;
    const std::size_t theta = entry / PhiCount % ThetaCount;
    const std::size_t phi = entry % PhiCount;
    values[(light * PhiCount + phi) * ThetaCount + theta][static_cast<int>(i / PlaneCount)] =
        static_cast<float>(value);
  }
  return std::make_shared<const AngleGrid>(std::move(axes), std::move(values));
}

}  // namespace reflectance
