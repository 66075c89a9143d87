// Scenes with known images.
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/transport/scene_helpers.h"

namespace {

using image::Image;
using test::render;
using test::RenderSetup;
using transport::CompiledScene;
using transport::Film;
using transport::Rgb;
using transport::Vec3f;

void expect_everywhere(const Film& film, double expected, double tolerance) {
  const Image image = film.mean();
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(image.at(x, y)[k], expected, tolerance) << x << ", " << y;
    }
  }
}

TEST(Furnace, WhiteSphereVanishesInWhiteSurroundings) {
  RenderSetup setup;
  setup.background = 1;
  setup.width = setup.height = 64;
  expect_everywhere(render(test::scene_of(test::sphere("brdf diffuse kd=1", 40, false)), setup), 1, 1e-3);
}

TEST(Furnace, OpenWhiteFloorVanishesUnderAWhiteSky) {
  RenderSetup setup;
  setup.eye = Vec3f(0, 3, 6);
  setup.background = 1;
  const std::string floor = test::quad("brdf diffuse kd=1", "(-5,0,5) (5,0,5) (5,0,-5) (-5,0,-5)");
  expect_everywhere(render(test::scene_of(floor), setup), 1, 1e-3);
}

TEST(Furnace, PerfectMirrorVanishesToo) {
  RenderSetup setup;
  setup.background = 1;
  expect_everywhere(render(test::scene_of(test::sphere("brdf specular ks=1", 40, false)), setup), 1, 1e-3);
}

// A closed white box that emits 1/2 everywhere, with an albedo of 1/2: each bounce adds half of the previous
// contribution.
TEST(Furnace, ClosedBoxFollowsTheGeometricSeries) {
  const std::string walls = "brdf diffuse kd=0.5 light rgb (0.5,0.5,0.5)";
  std::string box =
      "begin mesh " + walls +
      " begin vertexs (-1,-1,-1) (1,-1,-1) (1,1,-1) (-1,1,-1) (-1,-1,1) (1,-1,1) (1,1,1) (-1,1,1) "
      "end vertexs begin faces (0,1,2,3) (4,7,6,5) (0,4,5,1) (2,6,7,3) (0,3,7,4) (1,5,6,2) "
      "end faces end mesh";
  const CompiledScene scene = test::scene_of(box);
  for (const int depth : {0, 1, 2, 20}) {
    RenderSetup setup;
    setup.eye = Vec3f(0.1F, 0.2F, 0.3F);
    setup.target = Vec3f(1, 0.3F, -0.2F);
    setup.depth = depth;
    setup.samples = 256;
    setup.width = setup.height = 16;
    const test::Estimate estimate = test::mean_radiance(render(scene, setup));
    const double expected = 1 - std::pow(0.5, depth + 1);
    EXPECT_NEAR(estimate.mean, expected, 5 * estimate.deviation + 1e-5) << depth;
    EXPECT_LT(estimate.deviation, 0.01);
  }
}

/// The irradiance of a polygon of radiance 1 at a point with a normal, by Lambert's formula.
double lambert_irradiance(const std::vector<Imath::V3d>& corners, const Imath::V3d& point,
                          const Imath::V3d& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Imath::V3d a = (corners[i] - point).normalized();
    const Imath::V3d b = (corners[(i + 1) % corners.size()] - point).normalized();
    sum += std::acos(a.dot(b)) * a.cross(b).normalized().dot(normal);
  }
  return std::abs(sum) / 2;
}

TEST(DirectLight, OfAParallelogramIsLambertsFormula) {
  const std::string light = "light begin rgb (3,3,3) (-1,2,-1) (2,0,0) (0.5,0,2) end\n";
  const std::string floor = test::quad("brdf diffuse kd=0.7", "(-9,0,9) (9,0,9) (9,0,-9) (-9,0,-9)");
  const CompiledScene scene = test::scene_of(light + floor);
  const std::vector<Imath::V3d> corners = {{-1, 2, -1}, {1, 2, -1}, {1.5, 2, 1}, {-0.5, 2, 1}};
  for (const Vec3f& target : {Vec3f(0, 0, 0), Vec3f(2, 0, 1), Vec3f(-4, 0, 3), Vec3f(6, 0, -6)}) {
    RenderSetup setup;
    setup.eye = target + Vec3f(0, 1, 0.3F);
    setup.target = target;
    setup.field_of_view = 0.01F;
    setup.width = setup.height = 8;
    setup.samples = 1024;
    setup.depth = 1;
    const test::Estimate estimate = test::mean_radiance(render(scene, setup));
    const double expected = 3 * 0.7 / M_PI * lambert_irradiance(corners, Imath::V3d(target), {0, 1, 0});
    EXPECT_NEAR(estimate.mean, expected, 5 * estimate.deviation + 1e-4 * expected) << target;
    EXPECT_LT(estimate.deviation, 0.01 * expected);
  }
}

TEST(DirectLight, ReachesNothingBehindTheLight) {
  const std::string light = "light begin rgb (3,3,3) (-1,2,-1) (0,0,2) (2,0,0) end\n";  // shines upwards
  const std::string floor = test::quad("brdf diffuse kd=0.7", "(-9,0,9) (9,0,9) (9,0,-9) (-9,0,-9)");
  RenderSetup setup;
  setup.eye = Vec3f(0, 1, 0.3F);
  expect_everywhere(render(test::scene_of(light + floor), setup), 0, 0);
}

// The sampling scheme affects only the noise, not the image.
TEST(SamplingSchemes, GiveTheSameImage) {
  const std::string light = "light begin rgb (9,9,9) (-1,3,-1) (2,0,0) (0,0,2) end\n";
  for (const char* brdf : {"ward sx=0.3 ks=0.6 kd=0.2", "phong n=20 ks=0.5 kd=0.3",
                           "blinn n=20 ks=0.4 kd=0.3", "lewis n=20 ks=0.6 kd=0.3"}) {
    std::vector<test::Estimate> estimates;
    for (const char* pdf : {"pdf auto", "pdf diffuse"}) {
      const std::string floor =
          test::quad(fmt::format("brdf {} {}", brdf, pdf), "(-3,0,3) (3,0,3) (3,0,-3) (-3,0,-3)");
      RenderSetup setup;
      setup.eye = Vec3f(0, 2, 5);
      setup.background = 0.3F;
      setup.samples = 400;
      estimates.push_back(test::mean_radiance(render(test::scene_of(light + floor), setup)));
    }
    const double deviation = std::hypot(estimates[0].deviation, estimates[1].deviation);
    EXPECT_NEAR(estimates[0].mean, estimates[1].mean, 5 * deviation) << brdf;
    EXPECT_LT(deviation, 0.01 * estimates[0].mean);
  }
}

TEST(Mirror, ShowsTheLight) {
  const std::string light = "light begin rgb (2,3,4) (-50,5,-50) (100,0,0) (0,0,100) end\n";
  const std::string floor = test::quad("brdf specular ks=0.5", "(-3,0,3) (3,0,3) (3,0,-3) (-3,0,-3)");
  RenderSetup setup;
  setup.eye = Vec3f(0, 2, 0.1F);
  setup.field_of_view = 20;
  const Image image = render(test::scene_of(light + floor), setup).mean();
  for (const Rgb& pixel : image.pixels) ASSERT_EQ(pixel, Rgb(1, 1.5F, 2));
}

std::string cornell_box() { return std::string(GRANADA_SOURCE_DIR) + "/samples/cornell_box/cornell_box.grf"; }

CompiledScene cornell_scene() {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(cornell_box(), diagnostics);
  return *transport::compile(scene.value(), diagnostics);
}

RenderSetup cornell_look() {
  RenderSetup setup;
  setup.eye = Vec3f(278, 273, -800);
  setup.target = Vec3f(278, 273, 0);
  setup.field_of_view = 39.3076F;
  setup.depth = 8;
  setup.width = setup.height = 48;
  return setup;
}

TEST(CornellBox, DoesNotDependOnTheNumberOfThreads) {
  const CompiledScene scene = cornell_scene();
  RenderSetup setup = cornell_look();
  setup.threads = 1;
  const Image one = render(scene, setup).mean();
  for (const int threads : {2, 7}) {
    setup.threads = threads;
    EXPECT_EQ(render(scene, setup).mean().pixels, one.pixels) << threads;
  }
}

TEST(CornellBox, HasTheSameMeanForAllSeeds) {
  const CompiledScene scene = cornell_scene();
  RenderSetup setup = cornell_look();
  setup.samples = 64;
  const test::Estimate first = test::mean_radiance(render(scene, setup));
  Image first_image = render(scene, setup).mean();
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    setup.seed = seed;
    const Film film = render(scene, setup);
    const test::Estimate estimate = test::mean_radiance(film);
    EXPECT_NEAR(estimate.mean, first.mean, 4.5 * std::hypot(estimate.deviation, first.deviation));
    EXPECT_NE(film.mean().pixels, first_image.pixels);
  }
  EXPECT_LT(first.deviation, 0.005 * first.mean);
}

// A pixel shows the backplate at the positions of its samples: of 16 cells with powers of two, those at the
// centres of two columns and two rows, or the one at the centre.
TEST(Render, PlacesSamplesInAPixel) {
  const CompiledScene scene = test::scene_of("light begin (0,0,100) (0,1,0) (1,0,0) end");
  image::Image plate{4, 4, {}};
  for (int i = 0; i < 16; ++i) plate.pixels.emplace_back(static_cast<float>(1 << i));
  RenderSetup setup;
  setup.width = setup.height = 1;
  setup.samples = 4;
  transport::RenderSettings settings = test::settings_of(setup);
  settings.backplate = std::make_shared<const image::Image>(plate);
  const auto shown = [&] {
    transport::Render render(scene, settings);
    render.run();
    return render.film().mean().at(0, 0).x;
  };
  settings.pixel_sampling = transport::PixelSampling::Regular;
  settings.grid_columns = 2;
  EXPECT_EQ(shown(), ((1 << 5) + (1 << 7) + (1 << 13) + (1 << 15)) / 4.0F);
  settings.samples = 6;  // three rows, at whose centres are rows 0, 2 and 3
  EXPECT_FLOAT_EQ(shown(), ((1 << 1) + (1 << 3) + (1 << 9) + (1 << 11) + (1 << 13) + (1 << 15)) / 6.0F);
  settings.pixel_sampling = transport::PixelSampling::Centre;
  EXPECT_EQ(shown(), 1 << 10);
}

/// The pixels of a crop window are those of the whole image, and only they are sampled.
TEST(Render, TracesOnlyThePixelsOfItsCropWindow) {
  const CompiledScene scene = cornell_scene();
  RenderSetup setup = cornell_look();
  setup.samples = 4;
  transport::RenderSettings settings = test::settings_of(setup);
  settings.backplate = std::make_shared<const Image>(Image{2, 2, {Rgb(1), Rgb(2), Rgb(3), Rgb(4)}});
  transport::Render whole(scene, settings);
  whole.run();
  settings.crop = transport::CropWindow{5, 20, 37, 11};
  transport::Render cropped(scene, settings);
  cropped.run();
  EXPECT_EQ(cropped.path_count(), 37U * 11 * 4);
  EXPECT_EQ(cropped.samples_per_pixel(), 4);
  EXPECT_EQ(cropped.progress().done, 1);
  const Image expected = whole.film().mean();
  const Image image = cropped.film().mean();
  ASSERT_EQ(image.width, 37);
  ASSERT_EQ(image.height, 11);
  EXPECT_EQ(cropped.snapshot().mean.pixels, image.pixels);
  for (int y = 0; y < 11; ++y) {
    for (int x = 0; x < 37; ++x) ASSERT_EQ(image.at(x, y), expected.at(x + 5, y + 20)) << x << ", " << y;
  }
}

TEST(Render, StopsEarlyWithTheImageSoFar) {
  const CompiledScene scene = cornell_scene();
  RenderSetup setup = cornell_look();
  setup.samples = 1'000'000;
  transport::Render render(scene, test::settings_of(setup));
  std::thread stopper([&] {
    while (render.progress().done <= 0) std::this_thread::yield();
    render.stop();
  });
  render.run();
  stopper.join();
  EXPECT_TRUE(render.is_stopped());
  EXPECT_LT(render.progress().done, 1);
  EXPECT_GT(test::mean_radiance(render.film()).mean, 0);
}

}  // namespace
