// Renders with the baked irradiance of a scene.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "grf/write.h"
#include "tests/bake/bake_helpers.h"

namespace {

using bake::Bake;
using test::bake_settings;
using test::BakeScene;
using test::RenderSetup;
using transport::CompiledScene;
using transport::Rgb;
using transport::Vec3f;

constexpr double Pi = std::numbers::pi;

/// Compiles the text with its irradiance.
CompiledScene compiled_with_irradiance(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(text, "test.igrf", diagnostics);
  transport::CompileSettings settings;
  settings.has_irradiance = true;
  auto compiled = scene ? transport::compile(*scene, diagnostics, settings) : std::nullopt;
  if (!compiled) throw std::runtime_error(diagnostics.to_text());
  return std::move(*compiled);
}

image::Image image_of(const CompiledScene& scene, const RenderSetup& setup, bool uses_irradiance) {
  transport::RenderSettings settings = test::settings_of(setup);
  settings.integrator.uses_irradiance = uses_irradiance;
  transport::Render render(scene, settings);
  render.run();
  return render.film().mean();
}

/// A floor at z = 0 with irradiance from 1 to 3 along x, without lights.
std::string floor_with_irradiance(const std::string& attributes) {
  return test::quad(
      attributes, "irad (1,1,1) (-9,-9,0) irad (3,3,3) (9,-9,0) irad (3,3,3) (9,9,0) irad (1,1,1) (-9,9,0)");
}

/// The radiance from that floor's point (0,0,0) towards the eye.
Rgb seen(const std::string& text, const Vec3f& eye, bool uses_irradiance = true, int depth = 5) {
  RenderSetup setup;
  setup.eye = eye;
  setup.width = setup.height = 1;
  setup.field_of_view = 0.01F;
  setup.depth = depth;
  return image_of(compiled_with_irradiance(text), setup, uses_irradiance).pixels[0];
}

TEST(Irradiance, IsTheLightOfAMatteSurface) {
  const std::string matte = floor_with_irradiance("brdf diffuse kd=0.5 rgb (1,0.5,0)");
  for (const Vec3f& eye : {Vec3f(0, 0, 4), Vec3f(3, 1, 2)}) {
    const Rgb radiance = seen(matte, eye);
    EXPECT_NEAR(radiance.x, 2 * 0.5 / Pi, 1e-4);
    EXPECT_NEAR(radiance.y, 2 * 0.25 / Pi, 1e-4);
    EXPECT_EQ(radiance.z, 0);
  }
  EXPECT_EQ(seen(matte, Vec3f(0, 0, 4), false), Rgb(0));
  EXPECT_EQ(seen(matte, Vec3f(0, 0, 4), true, 0), Rgb(0)) << "depth 0 is emission alone";
  EXPECT_EQ(seen(matte, Vec3f(0, 0, -4)), Rgb(0)) << "the other side is lit by something else";
}

TEST(Irradiance, ComesOnTopOfEmission) {
  const Rgb radiance = seen(floor_with_irradiance("brdf diffuse kd=0.5 light rgb (7,7,7)"), Vec3f(0, 0, 4));
  EXPECT_NEAR(radiance.x, 7 + 2 * 0.5 / Pi, 1e-3);
}

TEST(Irradiance, IsNotForGlossySurfaces) {
  EXPECT_EQ(seen(floor_with_irradiance("brdf phong n=20 ks=0.3 kd=0.3"), Vec3f(0, 0, 4)), Rgb(0));
}

TEST(Irradiance, IsNotForSurfacesThatMirror) {
  const std::string sum = "def matte = brdf diffuse kd=0.5 mirror = brdf specular begin " +
                          floor_with_irradiance("brdf combine 0.5 matte, 0.5 mirror") + "end";
  EXPECT_EQ(seen(sum, Vec3f(0, 0, 4)), Rgb(0));
}

// Radiance via a glossy lobe is estimated: from a wall with irradiance but without lights, it is 0.
TEST(Irradiance, IsNotForPathsThatWereScattered) {
  const std::string wall = floor_with_irradiance("brdf diffuse kd=0.5");
  const std::string glossy = test::quad("brdf ward sx=0.1 ks=0.9", "(-9,-9,5) (-9,9,5) (9,9,5) (9,-9,5)");
  RenderSetup setup;
  setup.eye = Vec3f(0, 0, 1);
  setup.target = Vec3f(0, 0, 5);
  setup.width = setup.height = 4;
  for (const Rgb& pixel : image_of(compiled_with_irradiance(wall + glossy), setup, true).pixels) {
    EXPECT_EQ(pixel, Rgb(0));
  }
}

TEST(Irradiance, IsSeenInMirrors) {
  const std::string mirror = test::quad("brdf specular", "(-9,-9,5) (-9,9,5) (9,9,5) (9,-9,5)");
  const std::string text = floor_with_irradiance("brdf diffuse kd=0.5") + mirror;
  RenderSetup setup;
  setup.eye = Vec3f(0, 0, 1);
  setup.target = Vec3f(0, 0, 5);
  setup.width = setup.height = 1;
  setup.field_of_view = 0.01F;
  const Rgb in_mirror = image_of(compiled_with_irradiance(text), setup, true).pixels[0];
  const Rgb directly = seen(text, Vec3f(0, 0, 4));
  EXPECT_NEAR(directly.x, 2 * 0.5 / Pi, 1e-4);
  EXPECT_GT(in_mirror.x, 0.5F * directly.x);
  EXPECT_LE(in_mirror.x, 1.0001F * directly.x);
}

// A finely tessellated room looks the same with irradiance: to 1 % in the mean, and 4 % per pixel except
// where light varies within a cell.
TEST(Irradiance, ShowsTheRoomAsItIs) {
  const std::string text = test::room("brdf diffuse kd=0.6 rgb (1,0.8,0.6)", 16) +
                           "light begin rgb (4,4,4) (0.25,0.9,0.25) (0.5,0,0) (0,0,0.5) end\n";
  const BakeScene room(text);
  Bake bake(room.compiled, room.points, bake_settings(512, 4));
  bake.run();
  const CompiledScene baked =
      compiled_with_irradiance(grf::to_text(bake::with_irradiance(room.scene, bake).scene));
  RenderSetup setup;
  setup.eye = Vec3f(0.5F, 0.4F, 0.97F);
  setup.target = Vec3f(0.5F, 0.4F, 0);
  setup.field_of_view = 70;
  setup.depth = 4;
  setup.samples = 1024;
  const image::Image direct = image_of(baked, setup, false);
  setup.samples = 16;
  const image::Image shown = image_of(baked, setup, true);
  double sum = 0;
  double shown_sum = 0;
  int far_off = 0;
  for (std::size_t i = 0; i < direct.pixels.size(); ++i) {
    const double a = direct.pixels[i].y;
    const double b = shown.pixels[i].y;
    sum += a;
    shown_sum += b;
    if (std::abs(a - b) > 0.04 * a) ++far_off;
  }
  EXPECT_NEAR(shown_sum / sum, 1, 0.01);
  EXPECT_LT(far_off, static_cast<int>(direct.pixels.size()) / 10);
}

}  // namespace
