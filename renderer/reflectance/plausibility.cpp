#include "renderer/reflectance/plausibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "renderer/reflectance/albedo.h"

namespace reflectance {
namespace {

constexpr int AzimuthCount = 32;  ///< between both directions
constexpr int TurnCount = 8;      ///< of the view

Vec3f direction_of(std::size_t index, double azimuth) {
  const double theta = AngleMap::degrees(index) * std::numbers::pi / 180;
  return from_angles(static_cast<float>(std::cos(theta)), static_cast<float>(std::sin(theta)),
                     static_cast<float>(azimuth));
}

/// Returns the azimuth of a direction: not a round part of the circle, where tables have the edges of their
/// cells.
double azimuth_of(int index, int count) { return 2 * std::numbers::pi * (index + 0.37) / count; }

double mean_difference(const Rgb& a, const Rgb& b) {
  return (std::abs(double(a.x) - double(b.x)) + std::abs(double(a.y) - double(b.y)) +
          std::abs(double(a.z) - double(b.z))) /
         3;
}

/// Returns the cosine of a row's or column's angle times the solid angle of its cell, but for a factor.
double cosine_and_area(std::size_t index) {
  return std::sin(2 * AngleMap::degrees(index) * std::numbers::pi / 180);
}

/// Sums over the azimuths of a cell.
struct CellSums {
  double difference = 0;
  double value = 0;
  int missing = 0;
  int negative = 0;
  int count = 0;

  void add(const CheckedValue& one, const CheckedValue& other) {
    ++count;
    missing += one.state == DataState::Missing ? 1 : 0;
    negative += one.state == DataState::Negative ? 1 : 0;
    if (one.state == DataState::Missing || other.state == DataState::Missing) return;
    difference += mean_difference(one.value, other.value);
    value += (double(mean(one.value)) + double(mean(other.value))) / 2;
  }
  double part_of(int some) const { return static_cast<double>(some) / count; }
};

/// Sums over all cells.
class Totals {
 public:
  void add(const CellSums& sums, double weight) {
    weight_ += weight;
    difference_ += weight * sums.difference / sums.count;
    value_ += weight * sums.value / sums.count;
    missing_ += weight * sums.part_of(sums.missing);
    negative_ += weight * sums.part_of(sums.negative);
  }

  void compare(const SwappedPair& pair, DataState state, DataState swapped) {
    if (state == DataState::Missing || swapped == DataState::Missing) return;
    const double seen = mean_difference(pair.value, pair.swapped) * double(pair.u.z) * double(pair.v.z);
    if (!(seen > largest_)) return;
    largest_ = seen;
    worst_ = pair;
  }

  void put_into(Plausibility& result) const {
    result.mean_asymmetry = value_ > 0 ? difference_ / value_ : 0;
    result.missing_fraction = missing_ / weight_;
    result.negative_fraction = negative_ / weight_;
    result.worst_pair = worst_;
  }

 private:
  double weight_ = 0;
  double difference_ = 0;
  double value_ = 0;
  double missing_ = 0;
  double negative_ = 0;
  double largest_ = -1;
  SwappedPair worst_;
};

template <class Model>
DataState state_of(const Model& model, const Vec3f& u, const Vec3f& v) {
  if constexpr (requires { model.data_state(u, v); }) {
    return model.data_state(u, v);
  } else {
    return DataState::Sound;
  }
}

}  // namespace

DataState data_state(const Brdf& brdf, const Vec3f& u, const Vec3f& v) {
  if (const auto* sum = std::get_if<Combine>(&brdf); sum != nullptr && sum->parts) {
    DataState worst = DataState::Sound;
    for (const CombinedBrdf& part : *sum->parts) {
      const DataState state = std::visit([&](const auto& model) { return state_of(model, u, v); }, part.brdf);
      if (worst == DataState::Sound) worst = state;
    }
    return worst;
  }
  return std::visit([&](const auto& model) { return state_of(model, u, v); },
                    static_cast<const AnyBrdf&>(brdf));
}

Plausibility check_values(const std::function<CheckedValue(const Vec3f& u, const Vec3f& v)>& brdf,
                          bool is_anisotropic) {
  Plausibility result;
  Totals totals;
  for (std::size_t view = 0; view < AngleMap::Side; ++view) {
    for (std::size_t light = 0; light < AngleMap::Side; ++light) {
      CellSums sums;
      for (int turn = 0; turn < (is_anisotropic ? TurnCount : 1); ++turn) {
        const double first = is_anisotropic ? azimuth_of(turn, TurnCount) : 0;
        const Vec3f u = direction_of(view, first);
        for (int i = 0; i < AzimuthCount; ++i) {
          const Vec3f v = direction_of(light, first + azimuth_of(i, AzimuthCount));
          const CheckedValue value = brdf(u, v);
          const CheckedValue swapped = brdf(v, u);
          sums.add(value, swapped);
          totals.compare({u, v, value.value, swapped.value}, value.state, swapped.state);
        }
      }
      result.asymmetry.at(view, light) = sums.value > 0 ? sums.difference / sums.value : 0;
      result.missing.at(view, light) = sums.part_of(sums.missing);
      result.negative.at(view, light) = sums.part_of(sums.negative);
      totals.add(sums, cosine_and_area(view) * cosine_and_area(light));
    }
  }
  totals.put_into(result);
  return result;
}

Plausibility check_plausibility(const Brdf& brdf) {
  Plausibility result = check_values(
      [&](const Vec3f& u, const Vec3f& v) {
        return CheckedValue{evaluate(brdf, u, v), data_state(brdf, u, v)};
      },
      is_anisotropic(brdf));
  result.largest_albedo = largest_albedo(brdf);
  return result;
}

}  // namespace reflectance
