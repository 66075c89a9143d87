// Furnace tests: under uniform illumination of radiance 1 a surface sends its albedo to the eye, however
// directions are sampled: every BRDF that a scene can use, and every sampling scheme.
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/schemes/own_scheme.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/support/thoroughness.h"
#include "tests/transport/scene_helpers.h"

namespace {

using test::RenderSetup;
using transport::CompiledScene;
using transport::Vec3f;

const std::vector<std::string> Schemes = {"auto", "own", "diffuse", "hemisphere", "sphere", "anisotropic",
                                          // Its own trees take a minute to build for narrow lobes.
                                          test::tries_all() ? "reject" : "reject nQT=20 res=100",
                                          "adaptive nQT=12", "adaptive mode=reject nQT=6 nAnisoQT=6 res=200",
                                          "factored", "cascadeCDF"};

/// The cases that a single instance in a scene can represent.
std::vector<std::string> scene_cases() {
  std::vector<std::string> cases;
  for (const auto* list : {&test::plain_cases(), &test::stepped_cases()}) {
    for (const std::string& text : *list) {
      const bool is_data = text.starts_with("table") || text.starts_with("rgl") || text.starts_with("utia") ||
                           text.starts_with("measured");
      const bool is_layered = text.find(" over ") != std::string::npos;  // needs definitions
      if (text.find('+') == std::string::npos && !is_data && !is_layered) cases.push_back(text);
    }
  }
  return cases;
}

/// A BRDF, by its index, and a scheme besides `auto` that samples it. Building tables takes seconds: only a
/// long run tests all of them, any other one scheme for each third BRDF.
struct SchemeCase {
  std::size_t brdf = 0;
  std::string scheme;
};

std::vector<SchemeCase> scheme_cases() {
  std::vector<SchemeCase> cases;
  for (std::size_t brdf = 0; brdf < scene_cases().size(); ++brdf) {
    if (test::tries_all()) {
      for (std::size_t i = 1; i < Schemes.size(); ++i) cases.push_back({brdf, Schemes[i]});
    } else if (brdf % 3 == 0) {
      cases.push_back({brdf, Schemes[1 + brdf / 3 % (Schemes.size() - 1)]});
    }
  }
  return cases;
}

/// Far from a sphere about the origin, so that neither hides the sky from the other.
const Vec3f FloorCentre(4096, 0, 0);

std::string floor_of(const std::string& attributes) {
  return test::quad(attributes, "(4087,-9,0) (4105,-9,0) (4105,9,0) (4087,9,0)");
}

/// The floor seen through a pinhole from one direction: its front is up z, and x is x.
RenderSetup look_from(const Vec3f& u) {
  RenderSetup setup;
  setup.eye = FloorCentre + 4.0F * u;
  setup.target = FloorCentre;
  setup.width = setup.height = 4;
  setup.samples = 512;
  setup.depth = 1;
  setup.background = 1;
  setup.field_of_view = 0.001F;
  return setup;
}

/// The mean albedo over a sphere's disc as seen from far away: the radius is the sine of the angle.
double albedo_over_disc(const reflectance::Reflector& reflector) {
  constexpr int Rings = 32;
  double sum = 0;
  for (int i = 0; i < Rings; ++i) {
    const float sine = std::sqrt((static_cast<float>(i) + 0.5F) / Rings);
    const Vec3f u(sine, 0, std::sqrt(1 - sine * sine));
    sum += reflectance::mean(reflectance::albedo(reflector, u, 512)) / Rings;
  }
  return sum;
}

/// A BRDF with its known albedo.
class KnownBrdf {
 public:
  explicit KnownBrdf(std::size_t index) : brdf_(scene_cases()[index]) {}

  const std::string& text() const { return brdf_; }

  void compare_floor(const CompiledScene& scene, const std::string& scheme) const {
    for (const float theta : {0.3F, 1.1F}) {
      const Vec3f u = reflectance::from_angles(std::cos(theta), std::sin(theta), 0.7F);
      const double expected = reflectance::mean(reflectance::albedo(known_, u));
      const test::Estimate shown = test::mean_radiance(test::render(scene, look_from(u)));
      // Over a hundred comparisons, in which each channel's noise is estimated from two halves of few pixels.
      EXPECT_NEAR(shown.mean, expected, 6 * shown.deviation + 3e-3 * expected) << brdf_ << " by " << scheme;
      EXPECT_LT(shown.deviation, 0.05 * expected + 2e-4) << brdf_ << " by " << scheme;
      if (test::info_of(known_.brdf()).not_conserving.empty()) {
        EXPECT_LT(shown.mean, 1 + 6 * shown.deviation + 2e-3) << brdf_ << " by " << scheme;
      }
    }
  }

  void compare_sphere(const CompiledScene& scene) const {
    if (reflectance::is_anisotropic(known_.brdf()))
      return;  // the image depends on the orientation of the frame
    RenderSetup setup;
    setup.eye = Vec3f(0, 0, 1000);
    setup.field_of_view = static_cast<float>(2 * std::atan(1.0 / 1000) * 180 / M_PI);
    setup.width = setup.height = 32;
    setup.samples = 36;
    setup.depth = 1;
    setup.background = 1;
    const test::Estimate shown = test::mean_radiance(test::render(scene, setup));
    const double disc = M_PI / 4;  // of the image
    const double expected = disc * albedo_over_disc(known_) + 1 - disc;
    // Even 120 rows of facets hide what interpolated normals reflect below them.
    EXPECT_NEAR(shown.mean, expected, 5 * shown.deviation + 0.01 * disc) << brdf_;
  }

 private:
  std::string brdf_;
  /// Uses the BRDF's own sampler, whatever scheme a scene has.
  reflectance::Reflector known_{test::brdf_of(brdf_), reflectance::OwnScheme()};
};

class Albedo : public testing::TestWithParam<std::size_t> {};

TEST_P(Albedo, IsWhatAFloorAndASphereShowUnderAWhiteSky) {
  const KnownBrdf brdf(GetParam());
  const std::string automatic = "brdf " + brdf.text() + " pdf auto";
  const CompiledScene scene = test::scene_of(floor_of(automatic) + test::sphere(automatic, 120, true));
  brdf.compare_floor(scene, "auto");
  brdf.compare_sphere(scene);
}

class AlbedoByScheme : public testing::TestWithParam<SchemeCase> {};

TEST_P(AlbedoByScheme, IsWhatAFloorShows) {
  const KnownBrdf brdf(GetParam().brdf);
  const std::string& scheme = GetParam().scheme;
  brdf.compare_floor(test::scene_of(floor_of("brdf " + brdf.text() + " pdf " + scheme)), scheme);
}

INSTANTIATE_TEST_SUITE_P(Brdfs, Albedo, testing::Range(std::size_t(0), scene_cases().size()));
INSTANTIATE_TEST_SUITE_P(Brdfs, AlbedoByScheme, testing::ValuesIn(scheme_cases()), [](const auto& instance) {
  const SchemeCase& one = instance.param;
  return one.scheme.substr(0, one.scheme.find(' ')) + "_" + std::to_string(instance.index);
});

}  // namespace
