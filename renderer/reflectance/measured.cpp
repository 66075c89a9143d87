#include "renderer/reflectance/measured.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reflectance {
namespace {

constexpr double RightAngle = Pi / 2;
/// Rings beyond this angle of h occur only at grazing angles, where measurements are worst.
constexpr std::size_t DiffuseRings = 73;  // 60 degrees

double edge(std::size_t ring) {
  const double fraction = static_cast<double>(ring) / MerlTable::HalfCount;
  return RightAngle * fraction * fraction;
}

/// Returns the mean of the table at an angle of h, over directions not too far from it.
float mean_of_ring(const MerlTable& table, std::size_t ring) {
  constexpr std::size_t Farthest = 45;  // degrees
  float sum = 0;
  int count = 0;
  for (std::size_t difference = 0; difference < Farthest; difference += 3) {
    for (std::size_t azimuth = 0; azimuth < MerlTable::AzimuthCount; azimuth += 20) {
      sum += mean(table.linear(MerlTable::angles_of(ring, difference, azimuth)));
      ++count;
    }
  }
  return sum / static_cast<float>(count);
}

}  // namespace

MeasuredData::MeasuredData(std::shared_ptr<const MerlTable> table) : table_(std::move(table)) {
  std::array<float, MerlTable::HalfCount> values = {};
  for (std::size_t ring = 0; ring < values.size(); ++ring) values[ring] = mean_of_ring(*table_, ring);
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

std::shared_ptr<const MeasuredData> Measured::load(const std::string& path, grf::Diagnostics& diagnostics,
                                                   const grf::SourceLocation& asked_for_at) {
  auto table = MerlTable::load(path, diagnostics, asked_for_at);
  return table ? std::make_shared<const MeasuredData>(std::move(table)) : nullptr;
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
