#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/plot/fit_file.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/studies/angles.h"
#include "renderer/studies/brdf_instance.h"
#include "renderer/studies/drawn_samples.h"
#include "renderer/studies/environment_sampling.h"
#include "renderer/studies/environment_view.h"
#include "renderer/transport/image/image_encoders.h"
#include "tests/studies/study_of_text.h"
#include "tests/support/temporary_folder.h"

namespace {

using reflectance::mean;
using reflectance::Rgb;
using reflectance::Vec3f;
using studies::Degree;
using studies::FilteredMap;
using studies::LitSurface;
using studies::SphereGrid;
using studies::SurfaceQuadrature;
using testing::HasSubstr;
using transport::Image;

constexpr double Pi = std::numbers::pi;

Image filled(int width, int height, const Rgb& radiance) {
  return {width, height, std::vector<Rgb>(static_cast<std::size_t>(width * height), radiance)};
}

/// A surface whose normal is y.
LitSurface surface_under(const Image& image, const std::string& brdf, const std::string& pdf,
                         double theta = 30, double phi = 0) {
  grf::Diagnostics diagnostics;
  auto instance = studies::read_sampled_instance(brdf, pdf, diagnostics);
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
    EXPECT_NEAR(values.product, std::cos(theta * Degree) / Pi, 1e-4) << theta;
    EXPECT_NEAR(values.brdf, std::cos(theta * Degree) / Pi, 1e-4) << theta;
    EXPECT_NEAR(values.scheme, std::cos(theta * Degree) / Pi, 1e-5) << theta;
    EXPECT_NEAR(values.map, 1 / (4 * Pi), 1e-5);
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

class EnvironmentViewer : public testing::Test {
 protected:
  test::StudyOutcome outcome(const std::string& settings = {}, const std::string& rest = {}) const {
    return test::outcome_of("tool emviewer " + settings + "\n" +
                                (rest.find("brdf") == std::string::npos ? "brdf diffuse\n" : "") +
                                (rest.find("pdf ") == std::string::npos ? "pdf auto\n" : "") + rest,
                            folder_.path("a.study"));
  }
  studies::Study study(const std::string& settings = {}, const std::string& rest = {}) const {
    test::StudyOutcome made = outcome(settings, rest);
    if (!made.study) throw std::runtime_error(made.messages);
    return std::move(*made.study);
  }
  std::string message(const std::string& settings, const std::string& rest) const {
    const test::StudyOutcome made = outcome(settings, rest);
    EXPECT_FALSE(made.study) << settings << rest;
    return made.messages;
  }
  /// Adds a map, and returns the line of a state that opens it.
  std::string map_line(const std::string& name, const Image& image) const {
    folder_.add(name, transport::encode_pfm({image}));
    return "file " + name + "\n";
  }

  test::TemporaryFolder folder_;
};

/// The positions of the dots of a colour that are on the unrolled map, at (415, 106), 520 by 260.
std::vector<plot::Point> dots_on_map(const studies::Study& study, const std::string& colour) {
  std::vector<plot::Point> dots;
  for (const auto& path : test::elements(test::svg_of(study.figure.str()), "path")) {
    if (!path.get_optional<std::string>("<xmlattr>.stroke-linecap")) continue;
    if (path.get<std::string>("<xmlattr>.stroke") != colour) continue;
    std::string text = path.get<std::string>("<xmlattr>.d");
    for (char& letter : text) letter = letter == 'M' || letter == 'h' ? ' ' : letter;
    std::istringstream stream(text);
    double zero = 0;
    for (plot::Point at; stream >> at.x >> at.y >> zero;) {
      if (at.x >= 415 && at.x <= 935 && at.y >= 106 && at.y <= 366) dots.push_back(at);
    }
  }
  return dots;
}

TEST_F(EnvironmentViewer, ShowsSamplesInTheOnlyBrightTexel) {
  Image image = filled(8, 4, Rgb(0));
  image.pixels[8 + 5] = Rgb(10);  // the second row and the sixth column: 65 wide and high
  const studies::Study made = study("N=500 M=20", map_line("a.pfm", image));
  const auto samples = dots_on_map(made, "#d6006e");
  ASSERT_GT(samples.size(), 5U);
  for (const plot::Point& at : samples) {
    EXPECT_GE(at.x, 415 + 5 * 65 - 0.1);
    EXPECT_LE(at.x, 415 + 6 * 65 + 0.1);
    EXPECT_GE(at.y, 106 + 65 - 0.1);
    EXPECT_LE(at.y, 106 + 2 * 65 + 0.1);
  }
  EXPECT_EQ(dots_on_map(made, "#e69f00").size(), 500U);
  const studies::Study without = study("dots=samples", map_line("a.pfm", image));
  EXPECT_TRUE(dots_on_map(without, "#e69f00").empty());
  EXPECT_FALSE(dots_on_map(without, "#d6006e").empty());
}

TEST_F(EnvironmentViewer, SaysWhatItFound) {
  const studies::Study made = study("N=100 M=10", map_line("a.pfm", filled(16, 8, Rgb(4))));
  EXPECT_THAT(made.summary, HasSubstr("100 of 100 candidates are effective"));
  EXPECT_THAT(made.summary, HasSubstr("is 2 by resampling and 2 by quadrature"));
  const auto words = test::words_of(made);
  EXPECT_THAT(words, testing::IsSupersetOf({"100 of 100, 100 %", "N = 100 candidates",
                                            "M = 10 samples, larger if chosen again"}));
  EXPECT_THAT(words, testing::Contains(HasSubstr("under a.pfm, 16 \u00D7 8 texels")));
  EXPECT_THAT(test::words_of(study()), testing::Contains(HasSubstr("under the built-in sky")));
}

TEST_F(EnvironmentViewer, DescribesADirectionOfTheMap) {
  const studies::Study made = study("", map_line("a.pfm", filled(16, 8, Rgb(4, 2, 1))));
  // A quarter from above and in the middle: 45 degrees high, towards -z. cos 45 / pi is 0.2251.
  const std::string words = made.describe({415 + 260, 106 + 65});
  EXPECT_THAT(words, HasSubstr("elevation 45\u00B0, azimuth 90\u00B0: radiance (4, 2, 1)"));
  EXPECT_THAT(words, HasSubstr("f cos 0.1125"));
  EXPECT_THAT(words, HasSubstr("BRDF 0.2251, map 0.07958"));
  EXPECT_THAT(words, HasSubstr("product 0.2251, scheme 0.2251; product over scheme 1"));
  EXPECT_THAT(made.describe({415 + 390, 106 + 195}), HasSubstr("azimuth 0\u00B0"));
  EXPECT_THAT(made.describe({415 + 390, 106 + 195}), HasSubstr("below the surface"));
  EXPECT_NE(made.describe({186, 276}), "") << "the sphere";
  EXPECT_EQ(made.describe({400, 600}), "");
}

// Under constant light L, each candidate of a diffuse surface weighs kd L, and has the density cos / pi.
TEST_F(EnvironmentViewer, HasTheCandidatesAsText) {
  const studies::Study made = study("N=40 M=5", map_line("a.pfm", filled(16, 8, Rgb(8, 4, 0))));
  std::istringstream lines(made.csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "candidate,x,y,z,map_x,map_y,map_z,red,green,blue,weight,pdf,specular,chosen");
  double count = 0;
  double chosen = 0;
  std::size_t different = 0;
  for (; std::getline(lines, line); ++count) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    const std::vector<double> cells{std::istream_iterator<double>(numbers), {}};
    ASSERT_EQ(cells.size(), 14U);
    EXPECT_EQ(cells[0], count);
    EXPECT_NEAR(cells[1], cells[4], 1e-6) << "x is x for a surface that faces y";
    EXPECT_NEAR(cells[2], -cells[6], 1e-6);
    EXPECT_NEAR(cells[3], cells[5], 1e-6);
    EXPECT_NEAR(cells[7], 4, 1e-5);
    EXPECT_NEAR(cells[8], 2, 1e-5);
    EXPECT_EQ(cells[9], 0);
    EXPECT_NEAR(cells[10], 2, 1e-5);
    EXPECT_NEAR(cells[11], cells[3] / Pi, 1e-5);
    EXPECT_EQ(cells[12], 0);
    chosen += cells[13];
    different += cells[13] > 0 ? 1 : 0;
  }
  EXPECT_EQ(count, 40);
  EXPECT_EQ(chosen, 5);
  grf::Diagnostics diagnostics;
  const auto fit = plot::read_fit(made.fit, "a.fit", diagnostics);
  ASSERT_TRUE(fit) << diagnostics.to_text();
  EXPECT_EQ(fit->points.size(), different);
  EXPECT_NEAR(fit->points.front().value, 0.5 / Pi, 1e-5);
}

TEST_F(EnvironmentViewer, FollowsEachSetting) {
  const std::string plain = study().figure.str();
  for (const std::string setting : {"theta=20",
                                    "phi=10",
                                    "tilt=30",
                                    "N=99",
                                    "M=9",
                                    "seed=2",
                                    "show=fcos",
                                    "show=light",
                                    "show=warps",
                                    "show=product",
                                    "show=scheme",
                                    "show=lost",
                                    "channel=luminance",
                                    "exposure=1",
                                    "azimuth=70",
                                    "elevation=10",
                                    "visibility=open",
                                    "visibility=half",
                                    "deviations=false",
                                    "dots=hidden",
                                    "dots=candidates",
                                    "dots=samples"}) {
    EXPECT_NE(study(setting).figure.str(), plain) << setting;
  }
  EXPECT_NE(study("tilt=30 heading=20").figure.str(), study("tilt=30").figure.str());
  EXPECT_NE(study("", "brdf ward\n").figure.str(), study().figure.str());
  EXPECT_NE(study("", "pdf hemisphere exp=0\n").figure.str(), study().figure.str());
  EXPECT_EQ(study("theta=50 N=256").figure.str(), study().figure.str()) << "the defaults";
}

TEST_F(EnvironmentViewer, IsTheSameFromTheTextOfItsState) {
  folder_.add("a.pfm", transport::encode_pfm({filled(8, 4, Rgb(1))}));
  const std::string text = "tool emviewer theta=40 M=8 show=lost\nbrdf ward sx=0.1\npdf auto\nfile a.pfm\n";
  grf::Diagnostics diagnostics;
  const auto state = studies::read_state(text, folder_.path("a.study"), diagnostics);
  ASSERT_TRUE(state);
  const std::string again = studies::to_text(*state, folder_.path("b.study"));
  EXPECT_EQ(test::study_of_text(again, folder_.path("b.study")).figure.str(),
            test::study_of_text(text, folder_.path("a.study")).figure.str());
}

TEST_F(EnvironmentViewer, SaysWhatIsWrong) {
  EXPECT_THAT(message("N=10 M=11", ""), HasSubstr("M = 11 samples cannot be chosen from N = 10 candidates"));
  EXPECT_THAT(message("", "file gone.hdr\n"), HasSubstr("gone.hdr"));
  EXPECT_THAT(message("", map_line("black.pfm", filled(256, 128, Rgb(0)))),
              HasSubstr("black.pfm' is black: there is nothing to sample"));
  folder_.add("zeros.hdr", std::string(512 * 1024, '\0'));
  EXPECT_THAT(message("", "file zeros.hdr\n"), HasSubstr("zeros.hdr"));
  folder_.add("words.txt", "no picture");
  EXPECT_THAT(message("", "file words.txt\n"), HasSubstr("words.txt"));
  EXPECT_THAT(message("", "file a.pfm\nfile b.pfm\n"), HasSubstr("the state has 2 files"));
  EXPECT_THAT(message("", "brdf specular\n"), HasSubstr("reflects into the mirror direction only"));
  EXPECT_THAT(message("show=maps", ""), HasSubstr("show"));
  EXPECT_THAT(message("N=0", ""), HasSubstr("out of range"));
}

TEST_F(EnvironmentViewer, WarnsOfInvalidTexels) {
  Image image = filled(16, 8, Rgb(1));
  image.pixels[3] = Rgb(std::numeric_limits<float>::infinity());
  image.pixels[20].y = std::numeric_limits<float>::quiet_NaN();
  const std::string line = map_line("a.pfm", image);
  for (int repeated = 0; repeated < 2; ++repeated) {
    const auto made = outcome("", line);
    ASSERT_TRUE(made.study) << made.messages;
    EXPECT_THAT(made.messages,
                HasSubstr("warning: 2 of 128 texels of the environment map are negative or not"));
    EXPECT_THAT(test::words_of(*made.study), testing::Not(testing::Contains(HasSubstr("nan"))));
  }
}

// Light from below only, and a figure without numbers that are none.
TEST_F(EnvironmentViewer, ShowsASurfaceThatNoLightReaches) {
  Image image = filled(8, 4, Rgb(0));
  image.pixels[8 * 3] = Rgb(5);
  const std::string line = map_line("a.pfm", image);
  for (const std::string show : {"map", "product", "lost", "scheme"}) {
    const studies::Study made = study("show=" + show, line);
    EXPECT_THAT(made.summary, HasSubstr("0 of 256 candidates are effective"));
    for (const std::string& words : test::words_of(made)) {
      EXPECT_EQ(words.find("nan"), std::string::npos) << words;
      EXPECT_EQ(words.find("inf"), std::string::npos) << words;
    }
  }
}

// A changed file is read again.
TEST_F(EnvironmentViewer, SeesAFileChange) {
  const studies::Study first = study("", map_line("a.pfm", filled(16, 8, Rgb(4))));
  const studies::Study second = study("", map_line("a.pfm", filled(32, 16, Rgb(6))));
  EXPECT_THAT(first.summary, HasSubstr("is 2 by resampling"));
  EXPECT_THAT(second.summary, HasSubstr("is 3 by resampling"));
}

// The tables of a scheme are kept while a study uses them, and only for the same models.
TEST_F(EnvironmentViewer, SeesAChangeOfModels) {
  const studies::Study first = study("", "brdf diffuse kd=0.2\npdf adaptive\n");
  const studies::Study again = study("", "brdf diffuse kd=0.2\npdf adaptive\n");
  const studies::Study other = study("", "brdf diffuse kd=0.4\npdf adaptive\n");
  const studies::Study sampled = study("", "brdf diffuse kd=0.4\npdf auto\n");
  EXPECT_EQ(again.csv, first.csv);
  EXPECT_NE(other.csv, first.csv);
  EXPECT_NE(sampled.csv, other.csv);
}

TEST_F(EnvironmentViewer, StopsEarly) {
  grf::Diagnostics diagnostics;
  const auto state = studies::initial_state("emviewer");
  ASSERT_TRUE(state);
  std::atomic<int> polls = 0;
  studies::study_of(*state, {plot::Paper::White, [&] { return ++polls > 0; }}, diagnostics);
  EXPECT_GT(polls, 0);
  EXPECT_LT(polls, 1000);
}

}  // namespace
