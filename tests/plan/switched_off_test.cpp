// What replaces an effect that is switched off, as renderer/EFFECTS.md says: tests the remaining radiance
// against hand-computed values.
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/reflectance/merl_table.h"
#include "tests/plan/plan_helpers.h"
#include "tests/support/temporary_folder.h"

namespace {

using std::numbers::pi;
using test::Effect;
using test::PlannedRender;
using test::PlannedScene;
using transport::Rgb;
using transport::Vec3f;

/// The centre of what is at z = 0, from the front, under a white sky.
PlannedRender look_at_middle(int depth = 1) {
  PlannedRender setup;
  setup.width = setup.height = 2;
  setup.samples = 64;
  setup.depth = depth;
  setup.background = 1;
  setup.field_of_view = 0.01F;
  return setup;
}

std::string wall_of(const std::string& attributes, const std::string& of_vertex = "") {
  std::string corners;
  for (const char* corner : {"(-1,-1,0) ", "(1,-1,0) ", "(1,1,0) ", "(-1,1,0) "}) {
    corners += of_vertex + corner;
  }
  return test::quad(attributes, corners);
}

/// A dot, so small that it is practically invisible from elsewhere.
std::string dot_of(const std::string& attributes) {
  return test::quad(attributes, "(-0.01,-0.01,0) (0.01,-0.01,0) (0.01,0.01,0) (-0.01,0.01,0)");
}

/// A square of side 2 that faces the centre from a distance of 1.
std::string ceiling_of(const std::string& attributes) {
  return test::quad(attributes, "(-1,-1,1) (-1,1,1) (1,1,1) (1,-1,1)");
}
/// The cosine-weighted fraction of the hemisphere that this square covers: 4/pi s atan(s), s = sqrt(1/2).
double share_of_ceiling() { return 4 / pi * std::sqrt(0.5) * std::atan(std::sqrt(0.5)); }

Rgb shown(const std::string& text, const PlannedRender& setup) {
  const image::Image image = PlannedScene(text, setup).image();
  Rgb sum(0);
  for (const Rgb& pixel : image.pixels) sum += pixel / static_cast<float>(image.pixels.size());
  return sum;
}

void expect_shown(const std::string& text, const PlannedRender& setup, const Rgb& expected,
                  double tolerance) {
  const Rgb found = shown(text, setup);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(found[k], expected[k], tolerance * std::max(0.01F, expected[k])) << text.substr(0, 160);
  }
}

/// Tests the image with all effects, and without one.
void expect_with_and_without(const std::string& text, const PlannedRender& setup, Effect effect,
                             const Rgb& with, const Rgb& without, double tolerance = 1e-3) {
  expect_shown(text, setup, with, tolerance);
  expect_shown(text, test::without(setup, effect), without, tolerance);
}

TEST(SwitchedOff, TexturesAndVertexColoursLeaveTheColourOfTheFace) {
  const test::TemporaryFolder folder;
  const std::array<float, 3> half = {0.5F, 0.5F, 0.5F};
  std::string pixel(sizeof half, '\0');
  std::memcpy(pixel.data(), half.data(), sizeof half);
  const std::string file = folder.add("dark.pfm", "PF\n1 1\n-1.0\n" + pixel);
  const std::string paint = "rgb (0.5,1,1) brdf diffuse kd=0.8";
  expect_with_and_without(wall_of(paint + " texture \"" + file + "\""), look_at_middle(), Effect::Textures,
                          Rgb(0.2F, 0.4F, 0.4F), Rgb(0.4F, 0.8F, 0.8F), 1e-3);
  expect_with_and_without(wall_of(paint, "rgb (1,0,0.5) "), look_at_middle(), Effect::VertexColours,
                          Rgb(0.4F, 0, 0.4F), Rgb(0.4F, 0.8F, 0.8F));
}

TEST(SwitchedOff, OpacityIsThatOfOpaqueFaces) {
  PlannedRender setup = look_at_middle();
  setup.samples = 4096;
  expect_with_and_without(wall_of("brdf diffuse kd=0.5 opacity 0.25"), setup, Effect::Opacity,
                          Rgb(0.25F * 0.5F + 0.75F), Rgb(0.5F), 0.02);
}

TEST(SwitchedOff, MeasuredDataIsTheDiffuseBrdfOfAHalf) {
  const test::TemporaryFolder folder;
  const reflectance::MerlTable table([](const Vec3f&, const Vec3f&) { return Rgb(0.3F, 0.2F, 0.1F); });
  const std::string file = folder.path("measured.binary");
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(table.write(file, diagnostics)) << diagnostics.to_text();
  expect_with_and_without(wall_of("rgb (1,0.5,1) brdf measured \"" + file + "\""), look_at_middle(),
                          Effect::MeasuredData, Rgb(0.3F, 0.1F, 0.1F) * static_cast<float>(pi),
                          Rgb(0.5F, 0.25F, 0.5F), 0.02);
}

// Emissive faces still reflect; and a lamp hides the sky behind it.
TEST(SwitchedOff, AreaLightsStandWhereTheyAre) {
  expect_with_and_without(wall_of("brdf diffuse kd=0.8 light rgb (5,4,3)"), look_at_middle(),
                          Effect::AreaLights, Rgb(5.8F, 4.8F, 3.8F), Rgb(0.8F));
  const std::string lamp = "light begin rgb (9,9,9) (-1,-1,1) (0,2,0) (2,0,0) end ";
  PlannedRender setup = look_at_middle();
  setup.eye = Vec3f(4, 0, 0.5F);
  setup.samples = 1024;
  const auto f = static_cast<float>(share_of_ceiling());
  expect_with_and_without(dot_of("brdf diffuse kd=0.5") + lamp, setup, Effect::AreaLights,
                          Rgb(0.5F * (1 - f + 9 * f)), Rgb(0.5F * (1 - f)), 0.02);
}

// The map is 1 in its upper half, half of which an upright wall sees.
TEST(SwitchedOff, TheEnvironmentIsTheBackground) {
  PlannedRender setup = look_at_middle();
  setup.environment = 1;
  setup.background = 0.25F;
  setup.samples = 1024;
  expect_with_and_without(wall_of("brdf diffuse kd=0.8"), setup, Effect::Environment, Rgb(0.4F), Rgb(0.2F),
                          0.02);
}

TEST(SwitchedOff, TheBackgroundIsBlack) {
  expect_with_and_without(wall_of("brdf diffuse kd=0.8"), look_at_middle(), Effect::Background, Rgb(0.8F),
                          Rgb(0));
  transport::RenderSettings settings;
  settings.integrator.background = Rgb(1);
  settings.backplate = std::make_shared<const image::Image>();
  transport::EffectSet effects = transport::EffectSet::all();
  plan::keep_only(effects, settings);
  EXPECT_TRUE(settings.backplate);
  EXPECT_EQ(settings.integrator.background, Rgb(1));
  effects.remove(Effect::Background);
  plan::keep_only(effects, settings);
  EXPECT_FALSE(settings.backplate);
  EXPECT_EQ(settings.integrator.background, Rgb(0));
}

// A dot with a quarter of the lens' radius, halfway to the plane of focus: a ray from the point o of the lens
// to the middle of the view passes it at o / 2, so that the inner quarter of the lens' area sees it.
TEST(SwitchedOff, DepthOfFieldIsAPinhole) {
  PlannedRender setup = look_at_middle(0);
  setup.background = 0;
  setup.samples = 4096;
  setup.lens_radius = 0.5F;
  setup.focus_distance = 8;
  std::string corners;
  constexpr int Corners = 64;
  for (int i = 0; i < Corners; ++i) {
    const double angle = 2 * pi * i / Corners;
    corners += fmt::format("({},{},0) ", 0.125 * std::cos(angle), 0.125 * std::sin(angle));
  }
  std::string face;
  for (int i = 0; i < Corners; ++i) face += (i == 0 ? "" : ",") + std::to_string(i);
  const std::string dot = "begin mesh light rgb (1,1,1) begin vertexs " + corners +
                          "end vertexs begin faces (" + face + ") end faces end mesh ";
  expect_with_and_without(dot, setup, Effect::DepthOfField, Rgb(0.25F), Rgb(1), 0.01);
}

TEST(SwitchedOff, TheMirrorPartReflectsNothing) {
  expect_with_and_without(wall_of("brdf specular ks=0.9"), look_at_middle(), Effect::MirrorReflection,
                          Rgb(0.9F), Rgb(0));
  const std::string sum = "def matte = brdf diffuse kd=0.8 mirror = brdf specular ks=1 begin " +
                          wall_of("brdf combine 0.5 matte, 0.3 mirror") + "end ";
  PlannedRender setup = look_at_middle();
  setup.samples = 4096;
  expect_with_and_without(sum, setup, Effect::MirrorReflection, Rgb(0.7F), Rgb(0.4F), 0.02);
}

// Of a pane, 2 F/(1 + F) is reflected, and F is 0.04; the rest shines through.
TEST(SwitchedOff, TransmissionIsReflectionAlone) {
  PlannedRender setup = look_at_middle();
  setup.samples = 4096;
  expect_with_and_without(wall_of("brdf glass thin=true"), setup, Effect::Transmission, Rgb(1),
                          Rgb(0.08F / 1.04F), 0.02);
}

// A lamp of 4 m2 at a distance of 100 m, whose irradiance is pi: kd times the cosine.
TEST(SwitchedOff, InterpolatedNormalsAreThoseOfThePolygons) {
  const std::string lamp = "light begin rgb (7853.98,7853.98,7853.98) (-1,-1,100) (0,2,0) (2,0,0) end ";
  PlannedRender setup = look_at_middle();
  setup.background = 0;
  expect_with_and_without(wall_of("brdf diffuse kd=0.5", "normal (0.6,0,0.8) ") + lamp, setup,
                          Effect::InterpolatedNormals, Rgb(0.4F), Rgb(0.5F), 2e-3);
}

TEST(SwitchedOff, IrradianceIsEstimated) {
  PlannedRender setup = look_at_middle();
  setup.uses_irradiance = true;
  expect_with_and_without(wall_of("brdf diffuse kd=0.5", "irad (3,3,3) "), setup, Effect::Irradiance,
                          Rgb(static_cast<float>(0.5 * 3 / pi)), Rgb(0.5F));
}

// The dot sees the sky except where the ceiling hides it, and the sky once more by reflection there. A
// surface that reflects only to the eye is black from there.
TEST(SwitchedOff, InterreflectionLeavesWhatTheEyeSees) {
  PlannedRender setup = look_at_middle(2);
  setup.eye = Vec3f(4, 0, 0.5F);
  setup.samples = 1024;
  const auto f = static_cast<float>(share_of_ceiling());
  const std::string dot = dot_of("brdf diffuse kd=0.5");
  expect_with_and_without(dot + ceiling_of("brdf diffuse kd=0.6"), setup, Effect::DiffuseInterreflection,
                          Rgb(0.5F * (1 - f + 0.6F * f)), Rgb(0.5F * (1 - f)), 0.02);
  const std::string glossy = dot + ceiling_of("brdf ward sx=0.2 sy=0.2 ks=0.5 kd=0.3");
  EXPECT_GT(shown(glossy, setup).x, 0.5F * (1 - f + 0.2F * f));
  expect_shown(glossy, test::without(setup, Effect::GlossyInterreflection), Rgb(0.5F * (1 - f)), 0.02);
  // What a mirror sends to a scattering face is a caustic, not a mirror image that the eye sees.
  expect_with_and_without(dot + ceiling_of("brdf specular ks=0.9"), setup, Effect::GlossyInterreflection,
                          Rgb(0.5F * (1 - f + 0.9F * f)), Rgb(0.5F * (1 - f)), 0.02);
  // Each does not affect the other kind.
  EXPECT_GT(shown(glossy, test::without(setup, Effect::DiffuseInterreflection)).x, 0.5F * (1 - f + 0.2F * f));
  expect_shown(dot + ceiling_of("brdf diffuse kd=0.6"), test::without(setup, Effect::GlossyInterreflection),
               Rgb(0.5F * (1 - f + 0.6F * f)), 0.02);
}

// Without u, lobes follow the scene's x axis on a face with a normal along z: as where u runs along it.
TEST(SwitchedOff, AnisotropyFollowsTheScenesAxes) {
  const auto brushed = [](const std::string& corners) {
    return test::quad("brdf ward sx=0.05 sy=0.4 ks=0.9 kd=0", corners) +
           "light begin rgb (9,9,9) (59,-1,80) (0,2,0) (2,0,0) end ";
  };
  const std::string along_x =
      brushed("uv (0,0) (-1,-1,0) uv (1,0) (1,-1,0) uv (1,1) (1,1,0) uv (0,1) (-1,1,0)");
  const std::string along_y =
      brushed("uv (0,0) (-1,-1,0) uv (0,1) (1,-1,0) uv (-1,1) (1,1,0) uv (-1,0) (-1,1,0)");
  PlannedRender setup = look_at_middle();
  setup.background = 0;
  const Rgb expected = shown(along_x, setup);
  EXPECT_GT(shown(along_y, setup).x, 5 * expected.x) << "the light is along x, where sx is narrow";
  expect_shown(along_y, test::without(setup, Effect::Anisotropy), expected, 0.01);
}

}  // namespace
