// Panes and solids of glass, by closed forms and quadrature.
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/transport/scene_helpers.h"

namespace {

using std::numbers::pi;
using test::RenderSetup;
using transport::CompiledScene;
using transport::Integrator;
using transport::Rgb;
using transport::Vec3f;

/// Fresnel's reflectance at a cosine of incidence and a ratio of the indices behind and before the surface.
double fresnel(double c, double n) {
  const double sine = std::sqrt(1 - c * c) / n;
  if (sine >= 1) return 1;
  const double ct = std::sqrt(1 - sine * sine);
  const double s = (c - n * ct) / (c + n * ct);
  const double p = (n * c - ct) / (n * c + ct);
  return (s * s + p * p) / 2;
}

/// What a pane of index 1.5 transmits and reflects, as sums over the reflections between its sides.
struct Pane {
  double transmitted = 0;
  double reflected = 0;
};
Pane pane(double c, double colour) {
  const double f = fresnel(c, 1.5);
  const double a = std::pow(colour, 1 / std::sqrt(1 - (1 - c * c) / 2.25));
  Pane sum = {0, f};
  double inside = (1 - f) * a;
  for (int i = 0; i < 200; ++i) {
    (i % 2 == 0 ? sum.transmitted : sum.reflected) += inside * (1 - f);
    inside *= f * a;
  }
  return sum;
}

/// A square of side 2 `half`, upright at z, facing +z.
std::string upright(const std::string& attributes, double z, double half = 9) {
  return test::quad(attributes,
                    fmt::format("(-{0},-{0},{1}) ({0},-{0},{1}) ({0},{0},{1}) (-{0},{0},{1})", half, z));
}
/// The same, facing -z.
std::string averted(const std::string& attributes, double z, double half = 9) {
  return test::quad(attributes,
                    fmt::format("(-{0},{0},{1}) ({0},{0},{1}) ({0},-{0},{1}) (-{0},-{0},{1})", half, z));
}
/// A slab of the solid from z = -0.5 to 0.5.
std::string slab(const std::string& attributes) {
  return upright(attributes, 0.5) + averted(attributes, -0.5);
}

const std::string BlackWall = upright("rgb (0,0,0) brdf diffuse", -2, 99);
const std::string Floor = upright("brdf diffuse kd=0.5", 0, 1);
/// A white lamp at z = 1 that shines down on the origin.
const std::string Lamp = "light begin (-1,-1,1) (0,2,0) (2,0,0) end\n";

/// Looks at the origin from a direction at this angle from z.
RenderSetup at_angle(double degrees, int samples = 64) {
  const double theta = degrees * pi / 180;
  RenderSetup setup;
  setup.eye = Vec3f(static_cast<float>(4 * std::sin(theta)), 0, static_cast<float>(4 * std::cos(theta)));
  setup.width = setup.height = 2;
  setup.field_of_view = 0.01F;
  setup.samples = samples;
  return setup;
}
RenderSetup with_sky(RenderSetup setup, int depth = 5) {
  setup.background = 1;
  setup.depth = depth;
  return setup;
}
/// The origin from close above, below the panes over it.
RenderSetup look_at_origin(int samples) {
  RenderSetup setup = at_angle(0, samples);
  setup.eye = Vec3f(0, 0, 0.1F);
  setup.depth = 1;
  return setup;
}

test::Estimate seen(const std::string& text, const RenderSetup& setup, Integrator integrator) {
  const CompiledScene scene = test::scene_of(text);
  transport::RenderSettings settings = test::settings_of(setup);
  settings.integrator.integrator = integrator;
  settings.integrator.secondary_rays = 16;
  transport::Render render(scene, settings);
  render.run();
  EXPECT_EQ(render.rejected_samples(), 0U);
  return test::mean_radiance(render.film());
}

/// Both integrators must show this.
void expect_seen(const std::string& text, const RenderSetup& setup, double expected) {
  for (const Integrator integrator : {Integrator::Path, Integrator::Naive}) {
    const test::Estimate estimate = seen(text, setup, integrator);
    EXPECT_NEAR(estimate.mean, expected, 5 * estimate.deviation + 2e-5) << text;
    EXPECT_LT(estimate.deviation, 0.03) << text;
  }
}

/// The integral over the lamp of the light that arrives at the origin, kd/pi of which is reflected, by the
/// midpoint rule; a function of the cosine there tells what passes.
double lit_by_lamp(const std::function<double(double)>& passing) {
  constexpr int Count = 200;
  double sum = 0;
  for (int i = 0; i < Count; ++i) {
    for (int k = 0; k < Count; ++k) {
      const double x = -1 + (i + 0.5) * 2 / Count;
      const double y = -1 + (k + 0.5) * 2 / Count;
      const double squared = x * x + y * y + 1;
      const double cosine = 1 / std::sqrt(squared);
      sum += cosine * cosine / squared * passing(cosine) * 4 / Count / Count;
    }
  }
  return 0.5 / pi * sum;
}

TEST(Glass, PaneReflectsAndTransmits) {
  const std::string clear = upright("brdf glass thin=true", 0);
  const std::string tinted = upright("brdf glass thin=true colour=0.6", 0);
  for (const double degrees : {0.0, 60.0, 85.0}) {
    const double cosine = std::cos(degrees * pi / 180);
    const Pane of_tinted = pane(cosine, 0.6);
    expect_seen(clear, with_sky(at_angle(degrees)), 1);
    expect_seen(tinted, with_sky(at_angle(degrees, 1024)), of_tinted.reflected + of_tinted.transmitted);
    expect_seen(clear + BlackWall, with_sky(at_angle(degrees, 4096)), pane(cosine, 1).reflected);
    expect_seen(tinted + BlackWall, with_sky(at_angle(degrees, 4096)), of_tinted.reflected);
  }
}

TEST(Glass, PaneLetsLampsShineThrough) {
  const auto with_pane = [](const std::string& attributes) {
    return Floor + upright("brdf glass thin=true " + attributes, 0.5) + Lamp;
  };
  const RenderSetup setup = look_at_origin(1024);
  expect_seen(with_pane(""), setup, lit_by_lamp([](double c) { return pane(c, 1).transmitted; }));
  expect_seen(with_pane("colour=0.3"), setup, lit_by_lamp([](double c) { return pane(c, 0.3).transmitted; }));
  expect_seen(with_pane("rgb (0.5,0.5,0.5)"), setup,
              lit_by_lamp([](double c) { return 0.5 * pane(c, 1).transmitted; }));
  expect_seen(with_pane("opacity 0.5"), setup,
              lit_by_lamp([](double c) { return 0.5 + 0.5 * pane(c, 1).transmitted; }));
  expect_seen(with_pane("") + upright("brdf glass thin=true", 0.75), setup,
              lit_by_lamp([](double c) { return std::pow(pane(c, 1).transmitted, 2); }));
}

// The sky over a floor, through a pane so large that it covers all of it, also with depth for no other
// bounce.
TEST(Glass, PaneLetsTheSkyShineThrough) {
  const CompiledScene scene = test::scene_of(Floor + upright("brdf glass thin=true colour=0.5", 0.5, 1e4));
  double expected = 0;
  constexpr int Count = 1000;
  for (int i = 0; i < Count; ++i) {
    const double c = (i + 0.5) / Count;
    expected += 2 * c * pane(c, 0.5).transmitted / Count;
  }
  transport::RenderSettings settings = test::settings_of(look_at_origin(1024));
  settings.integrator.environment = test::environment_of(image::Image{4, 2, std::vector<Rgb>(8, Rgb(1))});
  for (const bool resamples : {false, true}) {
    if (resamples) settings.integrator.resampling.emplace();
    transport::Render render(scene, settings);
    render.run();
    const test::Estimate estimate = test::mean_radiance(render.film());
    EXPECT_NEAR(estimate.mean, 0.5 * expected, 5 * estimate.deviation + 1e-3) << resamples;
    EXPECT_LT(estimate.deviation, 0.01);
  }
}

// At normal incidence, a slab of thickness 1 is a pane that absorbs by its distance.
TEST(Glass, SolidAbsorbsByTheWayInIt) {
  const std::string solid = slab("brdf glass colour=0.49 distance=2");
  const Pane expected = pane(1, 0.7);
  expect_seen(solid, with_sky(at_angle(0, 1024), 30), expected.reflected + expected.transmitted);
  expect_seen(solid + BlackWall, with_sky(at_angle(0, 4096), 30), expected.reflected);
  expect_seen(slab("brdf glass colour=0 distance=2"), with_sky(at_angle(0, 1024), 30), fresnel(1, 1.5));
}

// A sphere in a sky that is the same everywhere cannot be seen. Between its flat faces light stays for long;
// interpolated normals turn some against the surface near the outline.
TEST(Glass, SolidConservesEnergy) {
  for (const bool has_normals : {false, true}) {
    RenderSetup setup = with_sky(RenderSetup(), 1000);
    setup.samples = 8;
    for (const Integrator integrator : {Integrator::Path, Integrator::Naive}) {
      const test::Estimate estimate = seen(test::sphere("brdf glass", 24, has_normals), setup, integrator);
      EXPECT_NEAR(estimate.mean, 1, has_normals ? 0.01 : 1e-5);
    }
  }
}

// Radiance grows with the squared index where light enters.
TEST(Glass, LampInASolidIsDimmerByTheSquaredIndex) {
  const std::string lamp = upright("light rgb (1,1,1)", -1, 1);
  for (const double degrees : {0.0, 50.0}) {
    const double c = std::cos(degrees * pi / 180);
    const double inside = std::sqrt(1 - (1 - c * c) / 2.25);
    RenderSetup setup = at_angle(degrees, 1024);
    expect_seen(upright("brdf glass colour=0.5 distance=3", 0) + lamp, setup,
                (1 - fresnel(c, 1.5)) / 2.25 * std::pow(0.5, 1 / inside / 3));
  }
}

// Light that arrives at 45 degrees goes on at 28.1, and meets the plane below at the tangent of that.
TEST(Glass, BendsLightBySnellsLaw) {
  const double tangent = std::tan(std::asin(std::sqrt(0.5) / 1.5));
  const auto strip = [](double from, double to) {
    return test::quad("light rgb (1,1,1)",
                      fmt::format("({0},-1,-1) ({1},-1,-1) ({1},1,-1) ({0},1,-1)", from, to));
  };
  const auto is_seen = [&](double at) {
    const std::string text = upright("brdf glass", 0) + strip(at - 0.02, at + 0.02);
    return seen(text, at_angle(45), Integrator::Path).mean > 0.1;
  };
  EXPECT_TRUE(is_seen(-tangent));
  EXPECT_FALSE(is_seen(-1));
  EXPECT_FALSE(is_seen(-tangent + 0.05));
  EXPECT_FALSE(is_seen(-tangent - 0.05));
}

TEST(Glass, ReflectsAllFromInsideBeyondTheCriticalAngle) {
  const std::string text = upright("brdf glass", 0.5) + upright("light rgb (1,1,1)", -1);
  for (const double degrees : {20.0, 40.0, 43.0, 60.0}) {
    const double theta = degrees * pi / 180;
    RenderSetup setup = at_angle(0, 4096);
    setup.eye = Vec3f(0);
    setup.target = Vec3f(static_cast<float>(std::sin(theta)), 0, static_cast<float>(std::cos(theta)));
    expect_seen(text, setup, fresnel(std::cos(theta), 1 / 1.5));
  }
}

// A ball over a floor: its shadow has a caustic, which both integrators find by chance alone.
TEST(Glass, CausticsAreThoseOfTheNaiveEstimator) {
  const std::string ball = test::placed(test::sphere("brdf glass colour=(0.9,0.7,0.4)", 12, true),
                                        Vec3f(0.5F), Vec3f(0), Vec3f(0, 0, 0.75F));
  const std::string text =
      upright("brdf diffuse kd=0.5", 0, 2) + ball + "light begin rgb (2,2,2) (-2,-2,3) (0,4,0) (4,0,0) end\n";
  RenderSetup setup;
  setup.eye = Vec3f(3, 0, 3);
  setup.target = Vec3f(0, 0, 0.3F);
  setup.width = setup.height = 12;
  setup.depth = 8;
  setup.samples = 1024;
  const test::Estimate path = seen(text, setup, Integrator::Path);
  setup.samples = 64;
  const test::Estimate naive = seen(text, setup, Integrator::Naive);
  EXPECT_NEAR(path.mean, naive.mean, 5 * std::hypot(path.deviation, naive.deviation));
  EXPECT_LT(naive.deviation, 0.02 * naive.mean);
  setup.depth = 1;
  EXPECT_GT(path.mean, 1.1 * seen(text, setup, Integrator::Path).mean) << "the ball is not only a shadow";
}

// All kernels that support a scene give the same image: glass costs nothing where there is none.
TEST(Glass, IsLeftOutWhereThereIsNone) {
  EXPECT_FALSE(test::scene_of(Floor + Lamp).has_glass());
  EXPECT_TRUE(test::scene_of(Floor + slab("brdf glass")).has_glass());
  EXPECT_FALSE(test::scene_of(Floor + slab("brdf glass")).has_cutouts()) << "shadow rays do not ask for more";
  EXPECT_TRUE(test::scene_of(Floor + upright("brdf glass thin=true", 1)).has_cutouts());
}

}  // namespace
