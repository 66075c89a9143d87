#include "renderer/reflectance/measured.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "grf/text_file.h"

namespace reflectance {
namespace {

constexpr double RightAngle = Pi / 2;
/// Rings beyond this angle of h occur only at grazing angles, where measurements are worst.
constexpr std::size_t DiffuseRings = 73;  // 60 degrees

double edge(std::size_t ring) {
  const double fraction = static_cast<double>(ring) / MerlTable::HalfCount;
  return RightAngle * fraction * fraction;
}

/// Returns directions turned about the normal.
Imath::V3d turned(const Imath::V3d& d, double phi) {
  return {std::cos(phi) * d.x - std::sin(phi) * d.y, std::sin(phi) * d.x + std::cos(phi) * d.y, d.z};
}

bool is_above(const DirectionPair& pair) { return pair.u.z > 1e-6 && pair.v.z > 1e-6; }

}  // namespace

// The mean over directions not too far from h, and over all azimuths of h if they differ.
float MeasuredData::mean_of_ring(std::size_t ring) const {
  constexpr std::size_t Farthest = 45;  // degrees
  constexpr int Azimuths = 8;
  const int turns = is_anisotropic() ? Azimuths : 1;
  float sum = 0;
  int count = 0;
  for (std::size_t difference = 0; difference < Farthest; difference += 3) {
    for (std::size_t azimuth = 0; azimuth < MerlTable::AzimuthCount; azimuth += 20) {
      const HalfAngles angles = MerlTable::angles_of(ring, difference, azimuth);
      const DirectionPair pair = directions_of(angles);
      if (merl_ == nullptr && !is_above(pair)) continue;
      for (int turn = 0; turn < turns; ++turn) {
        const double phi = 2 * double(Pi) * turn / turns;
        sum += mean(merl_ != nullptr ? merl_->linear(angles)
                                     : value(turned(pair.u, phi), turned(pair.v, phi), true));
        ++count;
      }
    }
  }
  return count > 0 ? sum / static_cast<float>(count) : 0;
}

MeasuredData::MeasuredData(MeasuredTable table) : table_(std::move(table)) {
  const auto* merl = std::get_if<std::shared_ptr<const MerlTable>>(&table_);
  if (merl != nullptr) merl_ = merl->get();
  std::array<float, MerlTable::HalfCount> values = {};
  for (std::size_t ring = 0; ring < values.size(); ++ring) values[ring] = mean_of_ring(ring);
  const float diffuse = *std::min_element(values.begin(), values.begin() + DiffuseRings);
  diffuse_albedo_ = std::min(1.0F, diffuse * Pi);
  double sum = 0;
  double albedo = 0;
  for (std::size_t ring = 0; ring < values.size(); ++ring) {
    const double inner = std::sin(edge(ring));
    const double outer = std::sin(edge(ring + 1));
    // The integral of (value - matte) cos(theta_h) over the ring; seen from the normal, the light's angle is
    // twice that of h.
    const double fraction = std::max(0.0F, values[ring] - diffuse) * Pi * (outer * outer - inner * inner);
    sum += fraction;
    albedo += 4 * fraction * std::max(0.05, 1 - 2 * outer * outer);
    versines_[ring + 1] = static_cast<float>(2 * std::pow(std::sin(edge(ring + 1) / 2), 2));
    cumulative_[ring + 1] = static_cast<float>(sum);
  }
  lobe_albedo_ = static_cast<float>(std::min(1.0, albedo));
  if (sum > 0) {
    for (float& fraction : cumulative_) fraction /= static_cast<float>(sum);
  }
  cumulative_.back() = 1;
}

Vec3f MeasuredData::lobe_direction(const Vec3f& u, const Vec2f& xi) const {
  const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, xi.x);
  const auto ring = static_cast<std::size_t>(above - cumulative_.begin()) - 1;
  const float fraction = (xi.x - cumulative_[ring]) / (cumulative_[ring + 1] - cumulative_[ring]);
  const float versine = versines_[ring] + fraction * (versines_[ring + 1] - versines_[ring]);
  return reflected(u, from_angles(1 - versine, std::sqrt(versine * (2 - versine)), 2 * Pi * xi.y));
}

float MeasuredData::lobe_pdf(const Vec3f& u, const Vec3f& v) const {
  const Vec3f h = u + v;
  const float length = h.length();
  const float versine = (h.x * h.x + h.y * h.y) / (length * (length + h.z));
  const auto above = std::upper_bound(versines_.begin() + 1, versines_.end() - 1, versine);
  const auto ring = static_cast<std::size_t>(above - versines_.begin()) - 1;
  const float solid_angle = 2 * Pi * (versines_[ring + 1] - versines_[ring]);
  return (cumulative_[ring + 1] - cumulative_[ring]) / (solid_angle * 4 * cosine_of_half(u, v));
}

Rgb MeasuredData::value(const Imath::V3d& u, const Imath::V3d& v, bool interpolates) const {
  const Rgb found = std::visit(
      [&]<class Table>(const std::shared_ptr<const Table>& table) {
        if constexpr (std::is_same_v<Table, MerlTable>) {
          const HalfAngles angles = half_angles(u, v);
          return interpolates ? table->linear(angles) : table->nearest(angles);
        } else {
          return interpolates ? table->linear(u, v) : table->nearest(u, v);
        }
      },
      table_);
  return {std::max(found.x, 0.0F), std::max(found.y, 0.0F), std::max(found.z, 0.0F)};
}

DataState MeasuredData::state(const Imath::V3d& u, const Imath::V3d& v) const {
  return std::visit(
      [&]<class Table>(const std::shared_ptr<const Table>& table) {
        if constexpr (std::is_same_v<Table, AngleGrid>) {
          const Rgb value = table->linear(u, v);
          return std::min({value.x, value.y, value.z}) < 0 ? DataState::Negative : DataState::Sound;
        } else if constexpr (std::is_same_v<Table, MerlTable>) {
          return table->is_missing(half_angles(u, v)) ? DataState::Missing : DataState::Sound;
        } else {
          return table->is_missing(u, v) ? DataState::Missing : DataState::Sound;
        }
      },
      table_);
}

bool MeasuredData::is_anisotropic() const {
  const auto* grid = std::get_if<std::shared_ptr<const AngleGrid>>(&table_);
  const auto* scattered = std::get_if<std::shared_ptr<const ScatteredTable>>(&table_);
  return (grid != nullptr && (*grid)->is_anisotropic()) ||
         (scattered != nullptr && (*scattered)->is_anisotropic());
}

namespace {

/// Reports that no format of measured data has a file's content.
void report_unknown_format(const std::string& path, std::string_view bytes, grf::Diagnostics& diagnostics,
                           const grf::SourceLocation& asked_for_at) {
  std::string names;
  for (const MeasuredFormat& format : measured_formats())
    names += fmt::format("{}{}", names.empty() ? "" : ", ", format.name);
  diagnostics.error(
      asked_for_at.file ? asked_for_at : grf::whole_file(path),
      sniff_rgl(bytes)
          ? fmt::format("'{}' is a file of the RGL data base, which the BRDF 'rgl' reads", path)
          : fmt::format("'{}' is no file of measured data; the formats that are read are {}", path, names));
}

}  // namespace

std::shared_ptr<const MeasuredData> Measured::load(const std::string& path, grf::Diagnostics& diagnostics,
                                                   const grf::SourceLocation& asked_for_at) {
  const auto bytes = grf::read_file(path, diagnostics, asked_for_at);
  if (!bytes) return nullptr;
  const MeasuredFormat* format = find_measured_format(*bytes);
  if (format == nullptr && path.ends_with(".binary")) {
    MerlTable::parse(*bytes, path, diagnostics, asked_for_at);
    return nullptr;
  }
  if (format == nullptr) report_unknown_format(path, *bytes, diagnostics, asked_for_at);
  auto table = format != nullptr ? format->read(*bytes, path, asked_for_at, diagnostics) : std::nullopt;
  return table ? std::make_shared<const MeasuredData>(*std::move(table)) : nullptr;
}

// The probability has a minimum, so that light outside the lobe's rings never has large weights.
float Measured::cosine_probability() const {
  const float total = data->diffuse_albedo() + data->lobe_albedo();
  return total > 0 ? std::max(0.1F, data->diffuse_albedo() / total) : 1;
}

float Measured::pdf(const Vec3f& u, const Vec3f& v) const {
  if (!data || u.z <= 0 || v.z <= 0) return 0;
  const float cosine_part = cosine_probability();
  const float lobe = cosine_part < 1 ? data->lobe_pdf(u, v) : 0;
  return cosine_part * cosine_pdf(v) + (1 - cosine_part) * lobe;
}

std::optional<DirectionSample> Measured::sample(const Vec3f& u, const Uniforms& xi) const {
  if (!data || u.z <= 0) return std::nullopt;
  const Vec3f v = xi.choice < cosine_probability() ? cosine_direction(xi.direction)
                                                   : data->lobe_direction(u, xi.direction);
  if (!(v.z > 0)) return std::nullopt;
  const float p = pdf(u, v);
  if (!(p > 0) || !std::isfinite(p)) return std::nullopt;
  return DirectionSample{v, evaluate(u, v) * (v.z / p), p};
}

}  // namespace reflectance
