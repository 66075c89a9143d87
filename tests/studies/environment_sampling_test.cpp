#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/brdf_instance.h"
#include "renderer/studies/angles.h"
#include "renderer/studies/drawn_samples.h"
#include "renderer/studies/environment/sampling.h"
#include "renderer/studies/environment/view.h"
#include "tests/studies/filled_image.h"

namespace {

using image::Image;
using reflectance::mean;
using reflectance::Rgb;
using reflectance::Vec3f;
using studies::Degree;
using studies::FilteredMap;
using studies::LitSurface;
using studies::SphereGrid;
using studies::SurfaceQuadrature;
using test::filled;

/// A surface whose normal is y.
LitSurface surface_under(const Image& image, const std::string& brdf, const std::string& pdf,
                         double theta = 30, double phi = 0) {
  grf::Diagnostics diagnostics;
  auto instance = reflectance::read_sampled_instance(brdf, pdf, diagnostics);
  if (!instance) throw std::runtime_error(diagnostics.to_text());
  return {std::make_shared<FilteredMap>(transport::EnvironmentMap(image), "test"),
          std::make_shared<reflectance::Reflector>(instance->reflector), reflectance::Frame(Vec3f(0, 1, 0)),
          studies::direction_of({theta * Degree, phi * Degree})};
}

/// A diffuse surface whose candidates are uniform over the hemisphere: they are from a lobe of exponent 0
/// about the normal.
LitSurface uniformly_sampled(const Image& image) {
  LitSurface surface = surface_under(image, "diffuse kd=0.5", "hemisphere exp=0", 0);
  surface.reflector = std::make_shared<reflectance::Reflector>(
      surface.reflector->brdf(), surface.reflector->scheme(), reflectance::MissedPart::Missing);
  return surface;
}

/// Integrates the densities over the sphere, by a grid of other cells than those of the code.
studies::DirectionValues integrals_of(const SurfaceQuadrature& quadrature) {
  constexpr SphereGrid Cells = {1500, 900};
  studies::DirectionValues sums;
  for (int y = 0; y < Cells.height; ++y) {
    for (int x = 0; x < Cells.width; ++x) {
      const double solid_angle = Cells.solid_angle(y, y + 1, 1);
      const studies::DirectionValues values = quadrature.at(Cells.direction(x + 0.5, y + 0.5));
      sums.product += values.product * solid_angle;
      sums.map += values.map * solid_angle;
      sums.warps += values.warps * solid_angle;
      sums.brdf += values.brdf * solid_angle;
      sums.scheme += values.scheme * solid_angle;
    }
  }
  return sums;
}

// The documented orientation: y is up, the centre looks down -z, and +x is right of it.
TEST(EnvironmentViews, HaveTheOrientationOfEnvironmentMaps) {
  EXPECT_LT((studies::map_direction(0.5, 0.5) - Vec3f(0, 0, -1)).length(), 1e-6F);
  EXPECT_LT((studies::map_direction(0.75, 0.5) - Vec3f(1, 0, 0)).length(), 1e-6F);
  EXPECT_LT((studies::map_direction(0.3, 0) - Vec3f(0, 1, 0)).length(), 1e-6F);
  Image image = filled(8, 4, Rgb(0));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = Rgb(static_cast<float>(i + 1));
  const transport::EnvironmentMap map(image);
  const studies::UnrolledView view({{100, 50}, 80, 40});
  for (int i = 0; i < 32; ++i) {
    const plot::Point centre(100 + 10 * (i % 8) + 5, 50 + 10 * (i / 8) + 5);
    const auto direction = view.direction(centre);
    ASSERT_TRUE(direction);
    EXPECT_EQ(map.radiance(*direction).x, static_cast<float>(i + 1));
    EXPECT_LT((view.point(*direction) - centre).length(), 1e-4);
  }
  EXPECT_FALSE(view.direction({99, 60}));
  EXPECT_FALSE(view.direction({120, 91}));
}

// From the positive x axis, -z is at the right, since y is up.
TEST(EnvironmentViews, ShowTheSphereFromOutside) {
  const studies::SphereView view(0, 0, {200, 100}, 50);
  EXPECT_LT((view.point({1, 0, 0}) - plot::Point(200, 100)).length(), 1e-4);
  EXPECT_LT((view.point({0, 0, -1}) - plot::Point(250, 100)).length(), 1e-4);
  EXPECT_LT((view.point({0, 1, 0}) - plot::Point(200, 50)).length(), 1e-4);
  EXPECT_TRUE(view.is_in_front({1, 0, 0}));
  EXPECT_FALSE(view.is_in_front({-1, 0, 0}));
  EXPECT_FALSE(view.direction({251, 100}));
  const studies::SphereView other(130, 40, {200, 100}, 50);
  for (const plot::Point& at : {plot::Point(200, 100), plot::Point(220, 75), plot::Point(170, 120)}) {
    const auto direction = other.direction(at);
    ASSERT_TRUE(direction);
    EXPECT_TRUE(other.is_in_front(*direction));
    EXPECT_NEAR(direction->length(), 1, 1e-5);
    EXPECT_LT((other.point(*direction) - at).length(), 1e-4);
  }
}

TEST(EnvironmentViews, FilterMapsBySolidAngle) {
  // Four rows to two: the row at the pole has 1 - cos 45 degrees of the upper half's solid angle.
  Image image = filled(2, 4, Rgb(0));
  image.pixels[0] = image.pixels[1] = Rgb(1);
  const auto cells = studies::box_filtered(image, {1, 2});
  EXPECT_NEAR(cells[0].x, 1 - std::sqrt(0.5), 1e-6);
  EXPECT_EQ(cells[1].x, 0);
  // Three columns to two.
  const Image across = {3, 1, {Rgb(1), Rgb(4), Rgb(7)}};
  const auto halves = studies::box_filtered(across, {2, 1});
  EXPECT_NEAR(halves[0].x, (1 + 0.5 * 4) / 1.5, 1e-6);
  EXPECT_NEAR(halves[1].x, (0.5 * 4 + 7) / 1.5, 1e-6);
}

// Under constant light, the product is the BRDF times cosine: cos / pi for a diffuse one.
TEST(SurfaceQuadrature, HasTheProductUnderConstantLight) {
  const LitSurface surface = surface_under(filled(16, 8, Rgb(3)), "diffuse kd=0.5", "auto");
  const SurfaceQuadrature quadrature(surface);
  for (const double theta : {0.0, 20.0, 60.0, 85.0}) {
    const Vec3f v = studies::direction_of({theta * Degree, 40 * Degree});
    const auto values = quadrature.at(surface.frame.to_world(v));
    EXPECT_NEAR(values.product, std::cos(theta * Degree) / std::numbers::pi, 1e-4) << theta;
    EXPECT_NEAR(values.brdf, std::cos(theta * Degree) / std::numbers::pi, 1e-4) << theta;
    EXPECT_NEAR(values.scheme, std::cos(theta * Degree) / std::numbers::pi, 1e-5) << theta;
    EXPECT_NEAR(values.map, 1 / (4 * std::numbers::pi), 1e-5);
    EXPECT_EQ(values.radiance, Rgb(3));
  }
  EXPECT_EQ(quadrature.at({0, -1, 0}).product, 0);
  EXPECT_NEAR(quadrature.albedo().x, 0.5, 1e-4);
  EXPECT_NEAR(quadrature.reflected().x, 1.5, 3e-4);
  EXPECT_EQ(quadrature.missed_light(10), 0);
}

// A ring of light from 22.5 to 45 degrees reflects kd L (sin^2 45 - sin^2 22.5).
TEST(SurfaceQuadrature, HasTheLightOfARing) {
  Image image = filled(16, 8, Rgb(0));
  for (std::size_t x = 0; x < 16; ++x) image.pixels[16 + x] = Rgb(2, 4, 6);
  const LitSurface surface = surface_under(image, "diffuse kd=0.5", "auto");
  const SurfaceQuadrature quadrature(surface);
  const double factor = 0.5 * (0.5 - std::pow(std::sin(22.5 * Degree), 2));
  EXPECT_NEAR(quadrature.reflected().x, 2 * factor, 2e-4);
  EXPECT_NEAR(quadrature.reflected().y, 4 * factor, 4e-4);
  EXPECT_NEAR(quadrature.reflected().z, 6 * factor, 6e-4);
}

// The other way to an albedo is importance sampling. The lobes are from wide to far narrower than a cell.
TEST(SurfaceQuadrature, FindsNarrowLobes) {
  using Case = std::pair<std::string, double>;
  for (const auto& [brdf, tolerance] :
       {Case("ward sx=0.3", 0.001), Case("ward sx=0.05", 0.001), Case("ward sx=0.3 sy=0.02 kd=0", 0.001),
        Case("ward sx=0.002", 0.003), Case("ward sx=0.0003", 0.015)}) {
    for (const double theta : {0.0, 17.3, 40.0, 61.1}) {
      const LitSurface surface = surface_under(filled(16, 8, Rgb(1)), brdf, "auto", theta, 25);
      const double expected = reflectance::albedo(*surface.reflector, surface.u, 65536).x;
      const SurfaceQuadrature quadrature(surface);
      EXPECT_NEAR(quadrature.albedo().x, expected, tolerance) << brdf << " at " << theta;
      EXPECT_NEAR(quadrature.reflected().x, expected, tolerance) << brdf << " at " << theta;
    }
  }
}

// The density of a scheme lacks the samples that it loses, those below the surface.
TEST(SurfaceQuadrature, DensitiesIntegrateToOne) {
  for (const std::string brdf : {"ward sx=0.3", "diffuse"}) {
    const LitSurface surface = surface_under(studies::built_in_sky(), brdf, "auto", 50, -140);
    const studies::DirectionValues integrals = integrals_of(SurfaceQuadrature(surface));
    EXPECT_NEAR(integrals.product, 1, 0.01) << brdf;
    EXPECT_NEAR(integrals.map, 1, 0.01) << brdf;
    EXPECT_NEAR(integrals.warps, 1, 0.01) << brdf;
    EXPECT_NEAR(integrals.brdf, 1, 0.005) << brdf;
    const auto drawn = studies::draw_samples(*surface.reflector, surface.u, 1U << 14, 1);
    const double kept = static_cast<double>(drawn.samples.size()) / static_cast<double>(drawn.count());
    EXPECT_NEAR(integrals.scheme, kept, 0.003) << brdf;
  }
}

// All light comes from one texel of 8 x 4, which uniform sampling hits as rarely as its solid angle is small.
TEST(SurfaceQuadrature, SaysWhereLightIsMissed) {
  Image image = filled(64, 32, Rgb(0));
  image.pixels[8 * 64 + 20] = Rgb(1000);
  const LitSurface surface = uniformly_sampled(image);
  const SurfaceQuadrature quadrature(surface);
  EXPECT_NEAR(quadrature.missed_light(10), 1, 1e-6);
  EXPECT_EQ(quadrature.missed_light(1e6), 0);
}

// Uniform candidates of a diffuse surface have the weights 2 cos, with the mean square 4/3.
TEST(SurfaceQuadrature, ExpectsTheEfficiencyOfCandidates) {
  const LitSurface uniform = uniformly_sampled(filled(16, 8, Rgb(2)));
  EXPECT_NEAR(SurfaceQuadrature(uniform).expected_efficiency(), 0.75, 1e-3);
  const LitSurface best = surface_under(filled(16, 8, Rgb(2)), "diffuse", "auto");
  EXPECT_NEAR(SurfaceQuadrature(best).expected_efficiency(), 1, 1e-3);
}

// The mean over seeds is kd L, from candidates that are not in proportion to the product.
TEST(ResampledLight, HasNoBias) {
  const LitSurface surface = uniformly_sampled(filled(16, 8, Rgb(3, 2, 1)));
  constexpr int Seeds = 2000;
  double sum = 0;
  double squares = 0;
  for (std::uint32_t seed = 0; seed < Seeds; ++seed) {
    const double estimate = mean(studies::resample(surface, {8, 2}, seed).estimate);
    sum += estimate / Seeds;
    squares += estimate * estimate / Seeds;
  }
  const double sigma = std::sqrt((squares - sum * sum) / Seeds);
  EXPECT_GT(sigma, 1e-5) << "estimates vary";
  EXPECT_LT(sigma, 0.01);
  EXPECT_NEAR(sum, 0.5 * 2, 4 * sigma);
}

TEST(ResampledLight, CountsEffectiveCandidates) {
  const LitSurface equal = surface_under(filled(16, 8, Rgb(3)), "diffuse", "auto");
  EXPECT_NEAR(studies::resample(equal, {100, 10}, 1).effective_candidates(), 100, 1e-3);
  EXPECT_NEAR(studies::resample(equal, {100, 10}, 1).largest_weight(), 1, 1e-4);
  studies::ResampledLight light;
  for (const float weight : {1.0F, 2.0F, 3.0F, 0.0F}) light.candidates.push_back({{}, Rgb(weight)});
  EXPECT_NEAR(light.effective_candidates(), 36.0 / 14, 1e-6);
  EXPECT_NEAR(light.largest_weight(), 2, 1e-6);
  EXPECT_EQ(light.rejected(), 1U);
  EXPECT_EQ(studies::ResampledLight().effective_candidates(), 0);
}

// Systematic resampling chooses a candidate of probability s floor(M s) or ceil(M s) times.
TEST(ResampledLight, CountsTheCopiesOfEachCandidate) {
  const LitSurface surface = surface_under(studies::built_in_sky(), "ward sx=0.1", "auto", 50, -125);
  for (const int chosen : {1, 7, 64}) {
    const auto light = studies::resample(surface, {64, chosen}, 5);
    const double total = std::accumulate(
        light.candidates.begin(), light.candidates.end(), 0.0,
        [](double sum, const studies::Candidate& candidate) { return sum + candidate.weight(); });
    int copies = 0;
    for (const studies::Candidate& candidate : light.candidates) {
      copies += candidate.copies;
      EXPECT_LT(std::abs(candidate.copies - chosen * candidate.weight() / total), 1);
    }
    EXPECT_EQ(copies, chosen);
  }
}

// Uniform candidates of a diffuse surface have the weights 2 cos, whose relative variance is 1/3.
TEST(Deviations, FallWithCandidates) {
  const LitSurface surface = uniformly_sampled(filled(16, 8, Rgb(1)));
  const auto deviations = studies::measure_deviations(
      surface, [](const Vec3f&) { return true; }, {{1, 4, 64, 1024}, {1}, 256, 4096}, 3);
  ASSERT_EQ(deviations.size(), 4U);
  EXPECT_NEAR(deviations[0].relative, std::sqrt(1.0 / 3), 0.06) << "a single sample";
  EXPECT_LT(deviations[1].relative, std::sqrt(1.0 / 3) / 2 * 1.2);
  EXPECT_LT(deviations[2].relative, 0.5 * deviations[1].relative);
  EXPECT_LT(deviations[3].relative, 0.5 * deviations[2].relative);
}

// If half of the light is hidden, one sample of equal candidates is all or nothing: the deviation is the
// mean.
TEST(Deviations, FallWithSamples) {
  const LitSurface surface = surface_under(filled(16, 8, Rgb(1)), "diffuse", "auto");
  const auto deviations = studies::measure_deviations(
      surface, [](const Vec3f& v) { return v.x >= 0; }, {{64}, {1, 4, 16, 256}, 400, 0}, 3);
  ASSERT_EQ(deviations.size(), 3U) << "no more samples than candidates";
  EXPECT_NEAR(deviations[0].relative, 1, 0.1);
  EXPECT_EQ(deviations[2].counts.chosen, 16);
  EXPECT_LT(deviations[1].relative, 0.6);
  EXPECT_LT(deviations[2].relative, 0.3);
}

}  // namespace
