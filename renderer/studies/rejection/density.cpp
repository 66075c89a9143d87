#include "renderer/studies/rejection/density.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "renderer/reflectance/model.h"

namespace studies {
namespace {

namespace math = boost::math;
using grf::ParameterScale;
using reflectance::ModelTable;
using reflectance::number_parameter;

/// Overflow gives infinity instead of an exception: a tail's quantile may have no number.
using Policy = math::policies::policy<math::policies::promote_double<false>,
                                      math::policies::domain_error<math::policies::ignore_error>,
                                      math::policies::pole_error<math::policies::ignore_error>,
                                      math::policies::overflow_error<math::policies::ignore_error>,
                                      math::policies::evaluation_error<math::policies::ignore_error>>;

constexpr double Unbounded = 1e300;

/// Cuts the support and wraps the functions of a distribution.
template <class Distribution>
Density density_of(const Distribution& distribution, double tail) {
  const auto support = math::support(distribution);
  Density density;
  density.is_cut_low = support.first < -Unbounded;
  density.is_cut_high = support.second > Unbounded;
  // Boost gives the least positive number for 0.
  density.low = density.is_cut_low ? math::quantile(distribution, tail) : std::floor(support.first);
  density.high = density.is_cut_high ? math::quantile(math::complement(distribution, tail)) : support.second;
  // Boost takes 0 at 0 for the density of all gamma distributions, the exponential one included.
  constexpr double AlmostZero = 1e-100;
  const double least = density.low == 0 ? AlmostZero : density.low;
  density.pdf = [distribution, least](double x) { return math::pdf(distribution, std::max(x, least)); };
  density.cdf = [distribution](double x) { return math::cdf(distribution, x); };
  return density;
}

Density with_mode(Density density, double mode) {
  density.mode = std::clamp(mode, density.low, density.high);
  return density;
}

Density with_pole(Density density, std::string_view parameter, double pole) {
  density.pole_parameter = parameter;
  density.pole = density.mode = pole;
  return density;
}

struct Normal {
  float mean = 0;
  float deviation = 1;

  static ModelTable<Normal> table() {
    using Self = Normal;
    return {.keyword = "normal",
            .title = "Normal",
            .parameters = {number_parameter(&Self::mean, "mean", -100, 100, "mean"),
                           number_parameter(&Self::deviation, "deviation", 0.01F, 100, "standard deviation",
                                            ParameterScale::Logarithmic)},
            .description = "The normal (Gaussian) distribution."};
  }
  Density density(double tail) const {
    return with_mode(density_of(math::normal_distribution<double, Policy>(mean, deviation), tail), mean);
  }
};

struct Gamma {
  float shape = 2;
  float scale = 1;

  static ModelTable<Gamma> table() {
    using Self = Gamma;
    return {.keyword = "gamma",
            .title = "Gamma",
            .parameters = {number_parameter(&Self::shape, "shape", 0.05F, 100,
                                            "shape; below 1, the density is infinite at 0",
                                            ParameterScale::Logarithmic),
                           number_parameter(&Self::scale, "scale", 0.01F, 100, "scale: the mean over shape",
                                            ParameterScale::Logarithmic)},
            .description = "The gamma distribution; with shape=1 the exponential one."};
  }
  Density density(double tail) const {
    const auto cut = density_of(math::gamma_distribution<double, Policy>(shape, scale), tail);
    if (shape < 1) return with_pole(cut, "shape", 0);
    return with_mode(cut, (double(shape) - 1) * scale);
  }
};

struct ChiSquared {
  float freedom = 4;

  static ModelTable<ChiSquared> table() {
    return {.keyword = "chisquared",
            .title = "Chi-squared",
            .parameters = {number_parameter(&ChiSquared::freedom, "freedom", 0.1F, 200,
                                            "degrees of freedom; below 2, the density is infinite at 0",
                                            ParameterScale::Logarithmic)},
            .description = "The chi-squared distribution."};
  }
  Density density(double tail) const {
    const auto cut = density_of(math::chi_squared_distribution<double, Policy>(freedom), tail);
    if (freedom < 2) return with_pole(cut, "freedom", 0);
    return with_mode(cut, double(freedom) - 2);
  }
};

struct Student {
  float freedom = 4;

  static ModelTable<Student> table() {
    return {.keyword = "student",
            .title = "Student's t",
            .parameters = {number_parameter(&Student::freedom, "freedom", 0.5F, 200,
                                            "degrees of freedom; the fewer, the heavier the tails",
                                            ParameterScale::Logarithmic)},
            .description = "Student's t distribution."};
  }
  Density density(double tail) const {
    return with_mode(density_of(math::students_t_distribution<double, Policy>(freedom), tail), 0);
  }
};

struct Beta {
  float alpha = 2;
  float beta = 5;

  static ModelTable<Beta> table() {
    using Self = Beta;
    return {.keyword = "beta",
            .title = "Beta",
            .parameters = {number_parameter(&Self::alpha, "alpha", 0.05F, 100,
                                            "first shape; below 1, the density is infinite at 0",
                                            ParameterScale::Logarithmic),
                           number_parameter(&Self::beta, "beta", 0.05F, 100,
                                            "second shape; below 1, the density is infinite at 1",
                                            ParameterScale::Logarithmic)},
            .description = "The beta distribution on [0, 1]; uniform with alpha=1 beta=1."};
  }
  Density density(double tail) const {
    const auto whole = density_of(math::beta_distribution<double, Policy>(alpha, beta), tail);
    if (alpha < 1) return with_pole(whole, "alpha", 0);
    if (beta < 1) return with_pole(whole, "beta", 1);
    const double over = double(alpha) - 1;
    const double sum = over + double(beta) - 1;
    return with_mode(whole, sum > 0 ? over / sum : 0.5);
  }
};

struct LogNormal {
  float location = 0;
  float scale = 0.5F;

  static ModelTable<LogNormal> table() {
    using Self = LogNormal;
    return {
        .keyword = "lognormal",
        .title = "Log-normal",
        .parameters = {number_parameter(&Self::location, "location", -5, 5, "mean of the logarithm"),
                       number_parameter(&Self::scale, "scale", 0.02F, 3,
                                        "standard deviation of the logarithm", ParameterScale::Logarithmic)},
        .description = "The log-normal distribution: the logarithm is normally distributed."};
  }
  Density density(double tail) const {
    const double variance = double(scale) * scale;
    return with_mode(density_of(math::lognormal_distribution<double, Policy>(location, scale), tail),
                     std::exp(location - variance));
  }
};

template <class... Distributions>
struct Table {
  static std::vector<grf::ModelInfo> infos() { return {reflectance::info_of<Distributions>()...}; }

  static std::optional<Density> make(const grf::Model& model, double tail) {
    std::optional<Density> density;
    const auto try_one = [&]<class Distribution>(const Distribution*) {
      if (grf::same_keyword(Distribution::table().keyword, model.keyword))
        density = reflectance::make<Distribution>(model).density(tail);
    };
    (try_one(static_cast<const Distributions*>(nullptr)), ...);
    return density;
  }
};

using Distributions = Table<Normal, Gamma, ChiSquared, Student, Beta, LogNormal>;

}  // namespace

double Density::maximum(double from, double to) const {
  if (has_pole() && from <= pole && pole <= to) return std::numeric_limits<double>::infinity();
  return std::max({pdf(from), pdf(to), pdf(std::clamp(mode, from, to))});
}

std::vector<grf::ModelInfo> density_infos() { return Distributions::infos(); }

std::optional<Density> make_density(const grf::Model& model, double tail) {
  return Distributions::make(model, tail);
}

}  // namespace studies
