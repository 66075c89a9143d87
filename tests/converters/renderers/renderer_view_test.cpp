// The cameras and surroundings of exported scenes, by the conventions of the renderers, against our own.
#include <cmath>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/renderers/surroundings_image.h"
#include "renderer/image/image_file.h"
#include "renderer/transport/camera.h"
#include "renderer/transport/lights/environment_map.h"
#include "tests/converters/renderers/exported_scene.h"

namespace convert {
namespace {

using grf::Vec2d;
using grf::Vec3d;

struct CameraCase {
  grf::Vec3f eye;
  grf::Vec3f target;
  grf::Vec3f up = grf::Vec3f(0, 1, 0);
  float field_of_view = 45;
  int width = 300;
  int height = 200;
};

/// Where our own renderer sees a point, in pixels.
Vec2d own_pixel(const CameraCase& one, const Vec3d& point) {
  transport::View view;
  view.eye = Vec3d(one.eye);
  view.target = Vec3d(one.target);
  view.up = one.up;
  view.field_of_view = one.field_of_view;
  const transport::Camera camera(view, one.width, one.height);
  const grf::Vec3f place = grf::Vec3f(point) * camera.world_to_image();
  return {double(place.x) * one.width, double(place.y) * one.height};
}

TEST(RendererCameras, SeePointsWhereOurOwnDoes) {
  const std::vector<CameraCase> cases = {
      {{0, 0, 5}, {0, 0, 0}},
      {{3, 2, 4}, {0.5F, -0.25F, 1}, {0.25F, 1, 0.125F}, 35},
      {{3, 2, 4}, {0.5F, -0.25F, 1}, {0.25F, 1, 0.125F}, 35, 200, 300},
      {{-4, -1, 2}, {0, 0, 0}, {0, 0, 1}, 70, 256, 256},
      {{0, 6, 0}, {0, 0, 0}, {0, 1, 0}, 50, 400, 100},
      {{1000, 1002, 995}, {1000, 1000, 1000}, {1, 0, 0}, 20, 120, 500},
  };
  for (const CameraCase& one : cases) {
    const auto words = [](const grf::Vec3f& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
    const ExportedScene scene(
        cube(), fmt::format("BPT_Scene scene.grf\nBPT_Viewer {}\nBPT_VLook {}\nBPT_Up {}\n"
                            "BPT_FieldOfView {}\nBPT_Image_Resolution {} {}\n",
                            words(one.eye), words(one.target), words(one.up), one.field_of_view, one.width,
                            one.height));
    for (const Vec3d& offset : {Vec3d(0), Vec3d(0.5, 0, 0), Vec3d(0, 0.5, 0), Vec3d(0.25, -0.5, 0.75)}) {
      const Vec3d point = Vec3d(one.target) + offset;
      const Vec2d expected = own_pixel(one, point);
      EXPECT_LT((test::pbrt_pixel(scene.pbrt(), point) - expected).length(), 0.2) << words(one.eye);
      EXPECT_LT((test::mitsuba_pixel(scene.mitsuba(), point) - expected).length(), 0.2) << words(one.eye);
    }
  }
}

// A closed form, without our own camera: what is to the right of the target is in the right half.
TEST(RendererCameras, ArePictureOfTheWorldAndNotOfItsMirrorImage) {
  const ExportedScene scene(cube(),
                            "BPT_Scene scene.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\nBPT_FieldOfView 90\n"
                            "BPT_Image_Resolution 200 100\n");
  const Vec2d expected(100 + 50 * 1 / 5.0, 50 - 50 * 2 / 5.0);
  EXPECT_LT((test::pbrt_pixel(scene.pbrt(), {1, 2, 0}) - expected).length(), 1e-9);
  EXPECT_LT((test::mitsuba_pixel(scene.mitsuba(), {1, 2, 0}) - expected).length(), 1e-9);
}

TEST(RendererCameras, HaveFilmDepthSamplesAndLens) {
  const ExportedScene scene(cube(),
                            "BPT_Scene scene.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\nBPT_LensRadius 0.125\n"
                            "BPT_FocusDistance 3\nBPT_Depth 7\nBPT_Samples 48\nBPT_Image_Resolution 64 32\n"
                            "BPT_Background 0.25 0.5 1\n");
  const auto& options = scene.pbrt().options;
  EXPECT_EQ(options.at("Film").number("xresolution"), 64);
  EXPECT_EQ(options.at("Film").number("yresolution"), 32);
  EXPECT_EQ(options.at("Film").number("iso"), 100);
  EXPECT_EQ(options.at("Film").string("savefp16"), "false") << "halves end at 65504";
  EXPECT_EQ(options.at("Sampler").number("pixelsamples"), 48);
  EXPECT_EQ(options.at("Integrator").number("maxdepth"), 7) << "pbrt counts bounces, as we do";
  EXPECT_EQ(options.at("Camera").number("lensradius"), 0.125);
  EXPECT_EQ(options.at("Camera").number("focaldistance"), 3);
  EXPECT_EQ(scene.pbrt().lights.at(0).rgb("L"), Vec3d(0.25, 0.5, 1));
  const test::MitsubaElement& sensor = scene.mitsuba().child("sensor");
  EXPECT_EQ(sensor.type, "thinlens");
  EXPECT_EQ(sensor.number("aperture_radius"), 0.125);
  EXPECT_EQ(sensor.number("focus_distance"), 3);
  EXPECT_LT(sensor.number("near_clip"), 0.01);
  EXPECT_GT(sensor.number("far_clip"), 10);
  EXPECT_EQ(sensor.child("film").number("width"), 64);
  EXPECT_EQ(sensor.child("film").number("height"), 32);
  EXPECT_EQ(sensor.child("sampler").number("sample_count"), 48);
  EXPECT_EQ(scene.mitsuba().child("integrator").number("max_depth"), 8) << "Mitsuba counts segments";
  EXPECT_EQ(scene.mitsuba().child("emitter").lists.at("radiance"), (std::vector<double>{0.25, 0.5, 1}));
}

TEST(RendererCameras, AreFramedWithoutOpFileAsOurs) {
  const ExportedScene scene(cube());
  const transport::View view = transport::view_of({Vec3d(-1), Vec3d(1)}, 45, 500.0F / 400);
  CameraCase one;
  one.eye = grf::Vec3f(view.eye);
  one.target = grf::Vec3f(view.target);
  one.width = 500;
  one.height = 400;
  const Vec3d corner(1, 1, 1);
  EXPECT_LT((test::pbrt_pixel(scene.pbrt(), corner) - own_pixel(one, corner)).length(), 0.01);
  EXPECT_LT((test::mitsuba_pixel(scene.mitsuba(), corner) - own_pixel(one, corner)).length(), 0.01);
}

TEST(RendererCameras, TakeTheNamedCamera) {
  const ExportedScene scene(cube(),
                            "BPT_Scene scene.grf\nBPT_Cameras side 5 0 0 0 0 0 0 1 0 90 0 0\n"
                            "BPT_Camera side\nBPT_Image_Resolution 100 100\n");
  // Seen from +x, +z is on the left.
  EXPECT_LT((test::pbrt_pixel(scene.pbrt(), {0, 0, 1}) - Vec2d(40, 50)).length(), 1e-6);
}

/// A latitude-longitude image that varies smoothly.
image::Image smooth_image() {
  image::Image image{128, 64, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double phi = 2 * M_PI * (x + 0.5) / image.width;
      const double theta = M_PI * (y + 0.5) / image.height;
      image.pixels.emplace_back(grf::Vec3d(2 + std::sin(theta) * std::cos(phi), 2 + std::cos(theta),
                                           2 + std::sin(theta) * std::sin(phi)));
    }
  }
  return image;
}

/// Looks a direction up as pbrt does: the nearest texel of the equal-area octahedral square.
grf::Colour pbrt_radiance(const image::Image& image, const Vec3d& direction) {
  const Vec3d d(std::abs(direction.x), std::abs(direction.y), std::abs(direction.z));
  const double radius = std::sqrt(std::max(0.0, 1 - d.z));
  const double quarter = std::atan2(d.y, d.x) * 2 / M_PI;
  double v = quarter * radius;
  double u = radius - v;
  if (direction.z < 0) {
    std::swap(u, v);
    u = 1 - u;
    v = 1 - v;
  }
  u = std::copysign(u, direction.x);
  v = std::copysign(v, direction.y);
  const auto texel = [](double place, int count) {
    return std::min(count - 1, static_cast<int>((place + 1) / 2 * count));
  };
  return image.at(texel(u, image.width), texel(v, image.height));
}

/// Looks a direction up as Mitsuba does: bilinearly, with the rows from pole to pole.
grf::Colour mitsuba_radiance(const image::Image& image, const Vec3d& d) {
  double u = std::atan2(d.x, -d.z) / (2 * M_PI) - 0.5 / image.width;
  u = (u - std::floor(u)) * image.width;
  const double v = std::acos(d.y) / M_PI * (image.height - 1);
  const int x = std::min(image.width - 1, static_cast<int>(u));
  const int y = std::min(image.height - 2, static_cast<int>(v));
  const int right = (x + 1) % image.width;
  const auto fx = static_cast<float>(u - x);
  const auto fy = static_cast<float>(v - y);
  return (image.at(x, y) * (1 - fx) + image.at(right, y) * fx) * (1 - fy) +
         (image.at(x, y + 1) * (1 - fx) + image.at(right, y + 1) * fx) * fy;
}

TEST(RendererSurroundings, ShineFromTheDirectionsThatOursShineFrom) {
  const test::TemporaryFolder files;
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(image::write_image({smooth_image()}, files.path("sky.exr"), diagnostics));
  for (const float rotation : {0.0F, 50.0F, -120.0F}) {
    const ExportedScene scene(
        cube(),
        fmt::format("BPT_Scene scene.grf\nBPT_EM_Background sky.exr\nBPT_EM_Rotation {}\nBPT_EM_Scale 3\n",
                    rotation),
        files);
    const test::PbrtEntity& light = scene.pbrt().lights.at(0);
    const image::Image square = scene.image(light.string("filename"));
    EXPECT_EQ(square.width, square.height) << "pbrt refuses other images";
    EXPECT_EQ(light.number("scale"), 3);
    const test::MitsubaElement& emitter = scene.mitsuba().child("emitter");
    const image::Image map = scene.image(emitter.values.at("filename"));
    EXPECT_EQ(emitter.number("scale"), 3);
    EXPECT_EQ(emitter.to_world(), grf::Matrix44d());
    const transport::EnvironmentMap own(smooth_image(), rotation);
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 1000; ++i) {
      const Vec3d d = Vec3d(normal(random), normal(random), normal(random)).normalized();
      const grf::Colour expected = own.radiance(grf::Vec3f(d));
      EXPECT_LT((pbrt_radiance(square, d) - expected).length(), 0.1F) << d;
      EXPECT_LT((mitsuba_radiance(map, d) - expected).length(), 0.1F) << d;
    }
  }
}

// A texel of light, as the sun is, keeps its power.
TEST(RendererSurroundings, KeepTheIrradianceOfASun) {
  Surroundings sky;
  sky.image = {256, 128, std::vector<grf::Colour>(256 * 128, grf::Colour(0))};
  constexpr int Row = 40;
  sky.image.pixels[Row * 256 + 70] = grf::Colour(1000);
  const double solid_angle = 2 * M_PI / 256 * (std::cos(M_PI * Row / 128) - std::cos(M_PI * (Row + 1) / 128));
  const image::Image square = equal_area_image(sky);
  double total = 0;
  for (const grf::Colour& pixel : square.pixels) total += double(pixel.x);
  total *= 4 * M_PI / double(square.pixels.size());
  EXPECT_NEAR(total / (1000 * solid_angle), 1, 0.02);
  const image::Image map = mitsuba_latitude_longitude(sky);
  double mitsuba_total = 0;
  for (int y = 0; y < map.height; ++y) {
    const double theta = M_PI * y / (map.height - 1);
    for (int x = 0; x < map.width; ++x)
      mitsuba_total +=
          double(map.at(x, y).x) * std::sin(theta) * 2 * M_PI / map.width * M_PI / (map.height - 1);
  }
  EXPECT_NEAR(mitsuba_total / (1000 * solid_angle), 1, 0.02);
}

TEST(RendererSurroundings, LoseABackplate) {
  const test::TemporaryFolder files;
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(image::write_image({smooth_image()}, files.path("sky.exr"), diagnostics));
  const ExportedScene scene(
      cube(), "BPT_Scene scene.grf\nBPT_EM_Background sky.exr\nBPT_EM_Projection backplate\n", files);
  EXPECT_TRUE(scene.pbrt().lights.empty());
  EXPECT_THAT(scene.mitsuba_warnings(), testing::HasSubstr("1 backplate was left out"));
}

}  // namespace
}  // namespace convert
