#include "renderer/reflectance/merl_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "grf/wording.h"

namespace reflectance {
namespace {

static_assert(std::endian::native == std::endian::little, "MERL files are little-endian");

constexpr double HalfPi = std::numbers::pi / 2;
constexpr std::array<std::int32_t, 3> Dimensions = {90, 90, 180};
constexpr std::size_t HeaderSize = sizeof(Dimensions);
constexpr std::size_t FileSize = HeaderSize + 3 * sizeof(double) * MerlTable::CellCount;
/// Scale factors of the doubles of each channel.
constexpr std::array<double, 3> Scales = {1 / 1500.0, 1.15 / 1500, 1.66 / 1500};
constexpr float Invalid = -1;

/// An interpolation position: the lower cell's index and the fraction of the way to the next.
struct Position {
  std::ptrdiff_t lower = 0;
  float fraction = 0;
};
Position position_of(float coordinate) {
  const float lower = std::floor(coordinate - 0.5F);
  return {static_cast<std::ptrdiff_t>(lower), coordinate - 0.5F - lower};
}

float half_coordinate(double theta) {
  return 90 * std::sqrt(std::max(0.0F, static_cast<float>(theta / HalfPi)));
}
float difference_coordinate(double theta) { return static_cast<float>(90 * theta / HalfPi); }
float azimuth_coordinate(double phi) { return static_cast<float>(180 * phi / std::numbers::pi); }

std::size_t clamped(std::ptrdiff_t index, std::size_t count) {
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(count) - 1));
}

/// Accumulates a cell; invalid channels have weight 0.
void add(const Rgb& cell, float weight, Rgb& sum, Rgb& weights) {
  for (int channel = 0; channel < 3; ++channel) {
    const float valid = cell[channel] >= 0 ? weight : 0;
    sum[channel] += valid * cell[channel];
    weights[channel] += valid;
  }
}

}  // namespace

DirectionPair directions_of(const HalfAngles& angles) {
  const double sine = std::sin(angles.theta_difference);
  const Imath::V3d v(sine * std::cos(angles.phi_difference), sine * std::sin(angles.phi_difference),
                     std::cos(angles.theta_difference));
  const Imath::V3d u(-v.x, -v.y, v.z);
  const double c = std::cos(angles.theta_half);
  const double s = std::sin(angles.theta_half);
  const auto turned = [&](const Imath::V3d& d) {
    return Imath::V3d(c * d.x + s * d.z, d.y, c * d.z - s * d.x);
  };
  return {turned(u), turned(v)};
}

HalfAngles MerlTable::angles_of(std::size_t half, std::size_t difference, std::size_t azimuth) {
  const double fraction = (static_cast<double>(half) + 0.5) / 90;
  return {HalfPi * fraction * fraction, HalfPi * (static_cast<double>(difference) + 0.5) / 90,
          std::numbers::pi * (static_cast<double>(azimuth) + 0.5) / 180};
}

std::shared_ptr<const MerlTable> MerlTable::load(const std::string& path, grf::Diagnostics& diagnostics,
                                                 const grf::SourceLocation& asked_for_at) {
  const auto bytes = grf::read_file(path, diagnostics, asked_for_at);
  return bytes ? parse(*bytes, path, diagnostics, asked_for_at) : nullptr;
}

bool MerlTable::sniff(std::string_view bytes) {
  return bytes.size() >= HeaderSize && std::memcmp(bytes.data(), Dimensions.data(), HeaderSize) == 0;
}

std::shared_ptr<const MerlTable> MerlTable::parse(std::string_view bytes, const std::string& path,
                                                  grf::Diagnostics& diagnostics,
                                                  const grf::SourceLocation& asked_for_at) {
  const auto fail = [&](const std::string& what) {
    diagnostics.error(asked_for_at.file ? asked_for_at : grf::whole_file(path),
                      fmt::format("'{}' is not a MERL BRDF file: {}", path, what));
    return nullptr;
  };
  if (bytes.size() < HeaderSize)
    return fail(grf::counted(bytes.size(), "byte is", "bytes are") + " too few for its header");
  std::array<std::int32_t, 3> dimensions = {};
  std::memcpy(dimensions.data(), bytes.data(), HeaderSize);
  if (dimensions != Dimensions) {
    return fail(fmt::format("its dimensions are {} x {} x {}, expected 90 x 90 x 180", dimensions[0],
                            dimensions[1], dimensions[2]));
  }
  if (bytes.size() != FileSize)
    return fail(fmt::format("it has {} bytes, expected {}", bytes.size(), FileSize));
  std::shared_ptr<MerlTable> table(new MerlTable());
  table->cells_.resize(CellCount);
  const char* position = bytes.data() + HeaderSize;
  for (int channel = 0; channel < 3; ++channel) {
    const double scale = Scales[static_cast<std::size_t>(channel)];
    for (Rgb& cell : table->cells_) {
      double value = 0;
      std::memcpy(&value, position, sizeof(value));
      position += sizeof(value);
      value *= scale;
      cell[channel] = value >= 0 && value < 1e30 ? static_cast<float>(value) : Invalid;
    }
  }
  return table;
}

MerlTable::MerlTable(const std::function<Rgb(const Vec3f& u, const Vec3f& v)>& brdf) {
  cells_.reserve(CellCount);
  for (std::size_t half = 0; half < HalfCount; ++half) {
    for (std::size_t difference = 0; difference < DifferenceCount; ++difference) {
      for (std::size_t azimuth = 0; azimuth < AzimuthCount; ++azimuth) {
        const DirectionPair pair = directions_of(angles_of(half, difference, azimuth));
        const bool is_above = pair.u.z > 0 && pair.v.z > 0;
        cells_.push_back(is_above ? brdf(Vec3f(pair.u), Vec3f(pair.v)) : Rgb(Invalid));
      }
    }
  }
}

bool MerlTable::write(const std::string& path, grf::Diagnostics& diagnostics) const {
  std::string bytes(reinterpret_cast<const char*>(Dimensions.data()), HeaderSize);
  bytes.reserve(FileSize);
  for (int channel = 0; channel < 3; ++channel) {
    const double scale = Scales[static_cast<std::size_t>(channel)];
    for (const Rgb& cell : cells_) {
      const double value = cell[channel] < 0 ? Invalid : cell[channel] / scale;
      bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
  }
  return grf::replace_file(path, bytes, diagnostics);
}

const Rgb& MerlTable::nearest_cell(const HalfAngles& angles) const {
  const auto half = clamped(static_cast<std::ptrdiff_t>(half_coordinate(angles.theta_half)), HalfCount);
  const auto difference =
      clamped(static_cast<std::ptrdiff_t>(difference_coordinate(angles.theta_difference)), DifferenceCount);
  const auto azimuth = static_cast<std::size_t>(azimuth_coordinate(angles.phi_difference)) % AzimuthCount;
  return cell(half, difference, azimuth);
}

bool MerlTable::is_missing(const HalfAngles& angles) const {
  const Rgb& value = nearest_cell(angles);
  return std::min({value.x, value.y, value.z}) < 0;
}

Rgb MerlTable::nearest(const HalfAngles& angles) const {
  const Rgb& value = nearest_cell(angles);
  return {std::max(value.x, 0.0F), std::max(value.y, 0.0F), std::max(value.z, 0.0F)};
}

Rgb MerlTable::linear(const HalfAngles& angles) const {
  const Position half = position_of(half_coordinate(angles.theta_half));
  const Position difference = position_of(difference_coordinate(angles.theta_difference));
  const Position azimuth = position_of(azimuth_coordinate(angles.phi_difference));
  const std::size_t first = (azimuth.lower + AzimuthCount) % AzimuthCount;
  const std::array<std::size_t, 2> azimuths = {first, first + 1 == AzimuthCount ? 0 : first + 1};
  Rgb sum(0);
  Rgb weights(0);
  for (int corner = 0; corner < 4; ++corner) {
    const int h = corner & 1;
    const int d = corner >> 1;
    const float weight = (h == 1 ? half.fraction : 1 - half.fraction) *
                         (d == 1 ? difference.fraction : 1 - difference.fraction);
    const Rgb* row =
        &cell(clamped(half.lower + h, HalfCount), clamped(difference.lower + d, DifferenceCount), 0);
    add(row[azimuths[0]], weight * (1 - azimuth.fraction), sum, weights);
    add(row[azimuths[1]], weight * azimuth.fraction, sum, weights);
  }
  const auto mean = [](float total, float weight) { return weight > 0 ? total / weight : 0.0F; };
  return {mean(sum.x, weights.x), mean(sum.y, weights.y), mean(sum.z, weights.z)};
}

}  // namespace reflectance
