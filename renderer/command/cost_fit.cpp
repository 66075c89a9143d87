#include "renderer/command/cost_fit.h"

#include <cmath>
#include <cstddef>

namespace command {

double PowerLaw::at(double x) const { return factor * std::pow(x, -exponent); }

std::optional<double> PowerLaw::inverse(double y) const {
  if (!(exponent > 0)) return std::nullopt;
  return std::pow(factor / y, 1 / exponent);
}

std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y) {
  const auto count = static_cast<double>(x.size());
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / count;
    mean_y += std::log(y[i]) / count;
  }
  double square = 0;
  double product = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double distance = std::log(x[i]) - mean_x;
    square += distance * distance;
    product += distance * (std::log(y[i]) - mean_y);
  }
  if (!(square > 1e-12)) return std::nullopt;
  const double exponent = -product / square;
  return PowerLaw{std::exp(mean_y + exponent * mean_x), exponent};
}

CostFit fit_cost(std::span<const CostPoint> points, double reference_relmse) {
  CostFit fit;
  std::vector<double> samples;
  std::vector<double> seconds;
  std::vector<double> errors;
  for (const CostPoint& point : points) {
    if (!(point.relmse > 0 && point.relmse >= WellAboveReference * reference_relmse)) continue;
    fit.used.push_back(point);
    samples.push_back(point.samples);
    seconds.push_back(point.seconds);
    errors.push_back(std::sqrt(point.relmse - reference_relmse));
  }
  fit.over_seconds = fit_power_law(seconds, errors);
  fit.over_samples = fit_power_law(samples, errors);
  return fit;
}

}  // namespace command
