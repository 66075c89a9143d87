// Scenes in environments, with known images.
#include <gtest/gtest.h>

#include "renderer/reflectance/albedo.h"
#include "tests/transport/error_scenes.h"
#include "tests/transport/scene_helpers.h"

namespace {

using image::Image;
using reflectance::Resampling;
using test::RenderSetup;
using transport::CompiledScene;
using transport::EnvironmentMap;
using transport::Film;
using transport::RenderSettings;
using transport::Rgb;
using transport::Vec3f;

std::shared_ptr<const EnvironmentMap> constant_map() {
  return std::make_shared<EnvironmentMap>(Image{4, 2, std::vector<Rgb>(8, Rgb(1))});
}

/// A dim sky, and a sun some degrees wide, up on the right.
std::shared_ptr<const EnvironmentMap> sun_map(float sun) {
  Image image{64, 32, std::vector<Rgb>(64 * 32, Rgb(0.3F, 0.4F, 0.5F))};
  image.pixels[8 * 64 + 42] = Rgb(sun, sun, sun / 2);
  return test::environment_of(std::move(image));
}

Film render(const CompiledScene& scene, const RenderSettings& settings) {
  transport::Render render(scene, settings);
  render.run();
  EXPECT_EQ(render.rejected_samples(), 0U);
  return render.film();
}

Film render_in(const CompiledScene& scene, const RenderSetup& setup,
               std::shared_ptr<const EnvironmentMap> map, const std::optional<Resampling>& resampling = {}) {
  RenderSettings settings = test::settings_of(setup);
  settings.integrator.environment = std::move(map);
  settings.integrator.resampling = resampling;
  return render(scene, settings);
}

const std::vector<std::optional<Resampling>> Ways = {{}, Resampling{1, 1}, Resampling{16, 2}};

TEST(EnvironmentFurnace, WhiteSphereVanishes) {
  const CompiledScene scene = test::scene_of(test::sphere("brdf diffuse kd=1 pdf diffuse", 40, false));
  RenderSetup setup;
  setup.samples = 1024;
  setup.width = setup.height = 16;
  for (const auto& way : Ways) {
    const Film film = render_in(scene, setup, constant_map(), way);
    const Image mean = film.mean();
    const Image variance = film.variance();
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
      ASSERT_NEAR(mean.pixels[i].x, 1, 0.03) << i;
    }
    const test::Estimate estimate = test::mean_radiance(film);
    EXPECT_NEAR(estimate.mean, 1, 5 * estimate.deviation + 1e-5);
  }
}

// Under uniform illumination of radiance 1, a small part of a sphere sends its albedo to the eye (furnace
// test).
TEST(EnvironmentFurnace, SphereShowsItsAlbedo) {
  for (const char* brdf : {"diffuse kd=0.7", "ward sx=0.2 sy=0.2 ks=0.5 kd=0.3", "phong n=100 ks=0.4 kd=0.6",
                           "coupled Rm=1 Ro=0.05"}) {
    const CompiledScene scene = test::scene_of(test::sphere(fmt::format("brdf {}", brdf), 60, true));
    RenderSetup setup;
    setup.width = setup.height = 4;
    setup.samples = 4096;
    setup.depth = 1;
    setup.field_of_view = 0.001F;
    const float sine = 0.6F;
    setup.eye = Vec3f(0, sine, 4);
    setup.target = Vec3f(0, sine, 0);
    const auto point = scene.intersect({setup.eye, Vec3f(0, 0, -1)});
    ASSERT_TRUE(point);
    const float cosine = point->shading_normal.z;
    const Vec3f u(std::sqrt(1 - cosine * cosine), 0, cosine);
    const double expected = reflectance::mean(reflectance::albedo(*scene.reflector(*point->surface), u));
    for (const auto& way : Ways) {
      const test::Estimate estimate = test::mean_radiance(render_in(scene, setup, constant_map(), way));
      EXPECT_NEAR(estimate.mean, expected, 5 * estimate.deviation + 2e-3 * expected) << brdf;
      EXPECT_LT(estimate.deviation, 0.01 * expected) << brdf;
    }
  }
}

// With one candidate there is no light sampling at all.
TEST(EnvironmentLight, IsTheSameHoweverItIsSampled) {
  const std::string light = "light begin rgb (6,4,2) (-2,2,-1) (1,0,0) (0,0,1) end\n";
  const std::string floor =
      test::quad("brdf phong n=30 ks=0.3 kd=0.5", "(-3,-1,3) (3,-1,3) (3,-1,-3) (-3,-1,-3)");
  const std::string ball = test::sphere("brdf ward sx=0.3 sy=0.3 ks=0.4 kd=0.4", 20, true);
  for (const bool has_light : {false, true}) {
    const CompiledScene scene = test::scene_of((has_light ? light : "") + floor + ball);
    RenderSetup setup;
    setup.eye = Vec3f(0, 1, 5);
    setup.samples = 576;
    setup.depth = 3;
    setup.width = setup.height = 24;
    std::vector<test::Estimate> estimates;
    for (const auto& way : Ways) {
      estimates.push_back(test::mean_radiance(render_in(scene, setup, sun_map(100), way)));
      EXPECT_LT(estimates.back().deviation, 0.02 * estimates[0].mean);
      EXPECT_NEAR(estimates.back().mean, estimates[0].mean,
                  4.5 * std::hypot(estimates.back().deviation, estimates[0].deviation))
          << has_light;
    }
    EXPECT_LT(estimates[0].deviation, estimates[1].deviation / 3);
    EXPECT_LT(estimates[2].deviation, estimates[1].deviation);
  }
}

TEST(EnvironmentLight, IsSeenDirectlyAndInMirrors) {
  const CompiledScene scene =
      test::scene_of(test::quad("brdf specular ks=0.5", "(-9,0,9) (9,0,9) (9,0,-9) (-9,0,-9)"));
  RenderSetup setup;
  setup.eye = Vec3f(0, 1, 0);
  setup.field_of_view = 10;
  setup.samples = 4;
  const auto map = std::make_shared<EnvironmentMap>(
      Image{1, 4, {Rgb(8), Rgb(6), Rgb(4), Rgb(2)}});  // straight up 8, straight down 2
  for (const auto& way : Ways) {
    setup.target = Vec3f(0, 2, 0);
    for (const Rgb& pixel : render_in(scene, setup, map, way).mean().pixels) ASSERT_EQ(pixel, Rgb(8));
    setup.target = Vec3f(0, 0, 0);
    for (const Rgb& pixel : render_in(scene, setup, map, way).mean().pixels) ASSERT_EQ(pixel, Rgb(4));
  }
}

// The same image by both weights; under a sun and a dim sky, compensation has less error.
TEST(EnvironmentLight, HasLessErrorWithCompensation) {
  test::SampleScene scene = test::sun_scene();
  const Image image = scene.settings.integrator.environment->image();
  scene.settings.samples = 256;
  const auto rendered = [&](EnvironmentMap::Weights weights) {
    scene.settings.integrator.environment = std::make_shared<const EnvironmentMap>(image, 0, weights);
    transport::Render render(scene.scene, scene.settings);
    render.run();
    return std::pair(test::mean_radiance(render.film()), render.error_estimate()->error);
  };
  const auto [plain, error] = rendered(EnvironmentMap::Weights::Luminance);
  const auto [compensated, less] = rendered(EnvironmentMap::Weights::Compensated);
  EXPECT_NEAR(compensated.mean, plain.mean, 4 * std::hypot(compensated.deviation, plain.deviation));
  EXPECT_LT(less, 0.9 * error);
}

TEST(EnvironmentLight, MayBeBlack) {
  const CompiledScene scene = test::scene_of(test::sphere("brdf diffuse kd=1", 20, false));
  const auto black = std::make_shared<EnvironmentMap>(Image{2, 1, {Rgb(0), Rgb(0)}});
  for (const auto& way : Ways) {
    for (const Rgb& pixel : render_in(scene, RenderSetup(), black, way).mean().pixels)
      ASSERT_EQ(pixel, Rgb(0));
  }
}

TEST(EnvironmentLight, DoesNotDependOnTheNumberOfThreads) {
  const CompiledScene scene = test::scene_of(test::sphere("brdf ward sx=0.3 ks=0.4 kd=0.4", 20, true));
  for (const auto& way : Ways) {
    RenderSetup setup;
    setup.threads = 1;
    const Image one = render_in(scene, setup, sun_map(100), way).mean();
    setup.threads = 5;
    EXPECT_EQ(render_in(scene, setup, sun_map(100), way).mean().pixels, one.pixels);
  }
}

TEST(Backplate, IsSeenAndLightsNothing) {
  const CompiledScene scene = test::scene_of(test::sphere("brdf diffuse kd=1", 20, false));
  RenderSetup setup;
  setup.width = 20;
  setup.height = 10;
  setup.field_of_view = 90;
  RenderSettings settings = test::settings_of(setup);
  settings.backplate =
      std::make_shared<Image>(Image{2, 2, {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1), Rgb(1, 1, 1)}});
  const Image image = render(scene, settings).mean();
  EXPECT_EQ(image.at(0, 0), Rgb(1, 0, 0));
  EXPECT_EQ(image.at(19, 0), Rgb(0, 1, 0));
  EXPECT_EQ(image.at(0, 9), Rgb(0, 0, 1));
  EXPECT_EQ(image.at(19, 9), Rgb(1, 1, 1));
  EXPECT_EQ(image.at(10, 5), Rgb(0));
}

TEST(Render, MeasuresTheTimeSpentInSampling) {
  const CompiledScene scene = test::scene_of(test::sphere("brdf ward sx=0.3 ks=0.4 kd=0.4", 20, true));
  RenderSetup setup;
  setup.threads = 1;
  setup.samples = 256;
  RenderSettings settings = test::settings_of(setup);
  transport::Render plain(scene, settings);
  plain.run();
  EXPECT_EQ(plain.sampling_seconds(), 0);
  settings.integrator.measures_sampling = true;
  transport::Render measured(scene, settings);
  measured.run();
  EXPECT_GT(measured.sampling_seconds(), 0);
  EXPECT_LT(measured.sampling_seconds(), 0.9 * measured.seconds());
  EXPECT_EQ(measured.film().mean().pixels, plain.film().mean().pixels);
}

}  // namespace
