#include <cmath>

#include <gtest/gtest.h>

#include "renderer/transport/integrators/path.h"
#include "tests/transport/scene_helpers.h"

namespace {

using test::RenderSetup;
using transport::CompiledScene;
using transport::Integrator;
using transport::IntegratorSettings;
using transport::Kernel;
using transport::PathEffects;
using transport::PathSampler;
using transport::Rgb;

/// A room open to the viewer, with an emitting ceiling that rays often hit.
std::string room(const std::string& brdf) {
  return test::quad("brdf " + brdf, "(-1,-1,1)(1,-1,1)(1,-1,-1)(-1,-1,-1)") +
         test::quad("brdf diffuse kd=(0.7,0.3,0.2)", "(-1,-1,1)(-1,-1,-1)(-1,1,-1)(-1,1,1)") +
         test::quad("brdf " + brdf, "(-1,-1,-1)(1,-1,-1)(1,1,-1)(-1,1,-1)") +
         "light begin rgb (2,3,4) (-1,1,-1) (2,0,0) (0,0,2) end\n";
}

test::Estimate mean_of(const CompiledScene& scene, const RenderSetup& setup, IntegratorSettings integrator) {
  transport::RenderSettings settings = test::settings_of(setup);
  integrator.depth = setup.depth;
  integrator.background = Rgb(setup.background);
  settings.integrator = integrator;
  transport::Render render(scene, settings);
  render.run();
  EXPECT_EQ(render.rejected_samples(), 0U);
  return test::mean_radiance(render.film());
}

class Integrators : public testing::TestWithParam<const char*> {};

TEST_P(Integrators, NaiveAndPathAgree) {
  transport::CompileSettings compile_settings;
  compile_settings.missed_part = reflectance::MissedPart::Missing;
  const CompiledScene scene = test::scene_of(room(GetParam()), compile_settings);
  for (const int depth : {0, 1, 2, 4}) {
    RenderSetup setup;
    setup.depth = depth;
    setup.background = 0.3F;
    setup.samples = 256;
    const test::Estimate path = mean_of(scene, setup, {});
    setup.samples = 16;
    setup.seed = 1;
    IntegratorSettings naive;
    naive.integrator = Integrator::Naive;
    naive.secondary_rays = 64;
    const test::Estimate other = mean_of(scene, setup, naive);
    // Four standard deviations, and the uncertainty of the deviations themselves.
    const double deviation = std::hypot(path.deviation, other.deviation);
    EXPECT_NEAR(path.mean, other.mean, 5 * deviation) << "depth " << depth;
    EXPECT_LT(deviation, 0.01 * path.mean);
  }
}

INSTANTIATE_TEST_SUITE_P(Brdfs, Integrators,
                         testing::Values("diffuse kd=0.8", "phong kd=0.3 ks=0.6 n=40",
                                         "torrance rough=0.3 kd=0.2", "coupled", "specular ks=0.9",
                                         "lewis n=20 kd=0.4 ks=0.5"));

// What a sampling scheme misses is missing in the image: Lambertian light beside a narrow lobe.
TEST(Naive, ShowsWhatAWrongSchemeMisses) {
  const std::string text = room("diffuse kd=0.8");
  transport::CompileSettings wrong;
  grf::Diagnostics diagnostics;
  const auto scheme = grf::read_pdf("hemisphere exp=100000", "test", diagnostics);
  ASSERT_TRUE(scheme) << diagnostics.to_text();
  wrong.scheme = {*scheme, {}};
  wrong.missed_part = reflectance::MissedPart::Missing;
  RenderSetup setup;
  setup.depth = 1;
  IntegratorSettings naive;
  naive.integrator = Integrator::Naive;
  const double right = mean_of(test::scene_of(text), setup, naive).mean;
  const double missing = mean_of(test::scene_of(text, wrong), setup, naive).mean;
  EXPECT_LT(missing, 0.8 * right);
}

TEST(Normals, AreTheComponentsOnTheViewersSide) {
  const CompiledScene scene = test::scene_of(test::quad("", "(-9,-9,0)(9,-9,0)(9,9,0)(-9,9,0)"));
  IntegratorSettings normals;
  normals.integrator = Integrator::Normals;
  for (const float side : {1.0F, -1.0F}) {
    transport::RayCounter counter;
    PathSampler sampler(0, 0);
    const transport::Ray ray = {{0, 0, 3 * side}, {0.1F, 0.2F, -side}};
    EXPECT_EQ(kernel_of(scene, normals)(scene, normals, ray, {}, sampler, counter), Rgb(0, 0, side));
  }
}

// Where rounding puts a point on its back in front of its front.
TEST(Path, LightsNoFaceByItself) {
  const CompiledScene scene =
      test::scene_of(test::quad("brdf diffuse kd=0.5 light rgb (1,2,1)",
                                "(-0.36749107,0.9572506,1.5854685)"
                                "(0.22587675,0.43399888,-0.12987137)(0.57726663,-1.4840348,-0.4794128)"
                                "(-0.016101182,-0.9607831,1.2359271)"));
  const image::Image image = test::render(scene, RenderSetup()).mean();
  // The other triangle of the quad may be visible edge-on, as rounding bends the two.
  for (const Rgb& pixel : image.pixels) EXPECT_LT(pixel.length(), 1e-9F);
}

struct KernelCase {
  const char* name;
  std::string text;
  PathEffects effects;
};

// A kernel leaves out only what does nothing: its image is that of the full kernel, bit for bit.
TEST(Kernels, GiveTheFullKernelsImage) {
  const std::vector<KernelCase> cases = {
      {"matte", room("diffuse kd=0.8"), {true, false, false, false, false, false}},
      {"glossy", room("ward"), {true, false, false, true, false, false}},
      {"all but glass and images", room("ward"), {true, true, true, true, false, false}},
      {"no lights", test::sphere("brdf blinn", 12, true), {false, true, false, true, false, false}}};
  for (const KernelCase& one : cases) {
    const CompiledScene scene = test::scene_of(one.text);
    IntegratorSettings settings;
    settings.background = Rgb(0.5F);
    const Kernel kernel = transport::path_kernel(one.effects);
    const Kernel full = transport::path_kernel({});
    EXPECT_NE(kernel, full) << one.name;
    for (std::uint32_t i = 0; i < 20000; ++i) {
      PathSampler a(7, i);
      PathSampler b(7, i);
      const auto place = a.next();
      b.next();
      const transport::Ray ray = {{0, 0, 4}, {place.x - 0.5F, place.y - 0.5F, -1.5F}};
      transport::RayCounter counter;
      const Rgb expected = full(scene, settings, ray, {}, b, counter);
      ASSERT_EQ(kernel(scene, settings, ray, {}, a, counter), expected) << one.name << " " << i;
    }
  }
}

}  // namespace
