// Faces that are absent, in part or where the alpha of their texture says so.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/transport/integrators/feature_layers.h"
#include "tests/transport/scene_helpers.h"

namespace {

using image::Alpha;
using image::Image;
using std::numbers::pi;
using test::RenderSetup;
using transport::CompiledScene;
using transport::CompileSettings;
using transport::Integrator;
using transport::Rgb;
using transport::Vec3f;

/// Any texture is red, and absent in its left half; over black it is black there.
std::optional<Image> half_red(const std::string&, grf::Diagnostics&, const grf::SourceLocation&,
                              Alpha alpha) {
  Image image{2, 1, {Rgb(0), Rgb(1, 0, 0)}};
  if (alpha == Alpha::Kept) image.alpha = {0, 1};
  return image;
}

CompileSettings with_texture(std::size_t most_copied_triangles = 10'000) {
  CompileSettings settings;
  settings.image_reader = half_red;
  settings.most_copied_triangles = most_copied_triangles;
  return settings;
}

/// A square of side 2 `half`, upright at z, facing +z, whose texture has u = 0 at its left side.
std::string upright(const std::string& attributes, float z, float half = 1) {
  return fmt::format(
      "begin mesh {0} begin vertexs uv (0,0) (-{1},-{1},{2}) uv (1,0) ({1},-{1},{2}) uv (1,1) ({1},{1},{2}) "
      "uv (0,1) (-{1},{1},{2}) end vertexs begin faces (0,1,2,3) end faces end mesh\n",
      attributes, half, z);
}

const std::string Black = "rgb (0,0,0) brdf diffuse ";
/// A white lamp at z = 1 that shines down on the origin.
const std::string Lamp = "light begin (-1,-1,1) (0,2,0) (2,0,0) end\n";
/// What the origin of `upright("brdf diffuse kd=0.5", 0)` reflects of it: half of the cosine-weighted share
/// of the hemisphere that it covers, 4/pi s atan(s) with s = sqrt(1/2).
double lit_by_lamp() { return 0.5 * 4 / pi * std::sqrt(0.5) * std::atan(std::sqrt(0.5)); }

/// The origin from close above, so that what is over it is not in the way.
RenderSetup look_at_origin(int samples) {
  RenderSetup setup;
  setup.eye = Vec3f(0, 0, 0.1F);
  setup.width = setup.height = 2;
  setup.field_of_view = 0.01F;
  setup.samples = samples;
  setup.depth = 1;
  return setup;
}

test::Estimate seen(const std::string& text, const RenderSetup& setup,
                    Integrator integrator = Integrator::Path,
                    const CompileSettings& compile_settings = with_texture()) {
  const CompiledScene scene = test::scene_of(text, compile_settings);
  transport::RenderSettings settings = test::settings_of(setup);
  settings.integrator.integrator = integrator;
  settings.integrator.secondary_rays = 16;
  transport::Render render(scene, settings);
  render.run();
  EXPECT_EQ(render.rejected_samples(), 0U);
  return test::mean_radiance(render.film());
}

/// All integrators must show this.
void expect_seen(const std::string& text, RenderSetup setup, double expected) {
  for (const Integrator integrator : {Integrator::Path, Integrator::Naive}) {
    const test::Estimate estimate = seen(text, setup, integrator);
    EXPECT_NEAR(estimate.mean, expected, 5 * estimate.deviation + 1e-6) << text;
    EXPECT_LT(estimate.deviation, 0.02) << text;
  }
}

TEST(Opacity, LetsCameraRaysPassByItsFraction) {
  RenderSetup setup;
  setup.background = 1;
  setup.samples = 32;
  const auto sheet = [](const std::string& opacity, float z) { return upright(Black + opacity, z, 9); };
  expect_seen(sheet("opacity 0", 0), setup, 1);
  expect_seen(sheet("opacity 0.25", 0), setup, 0.75);
  expect_seen(sheet("opacity 0.25", 0) + sheet("opacity 0.5", 1), setup, 0.375);
  expect_seen(sheet("opacity 1", 0), setup, 0);
  expect_seen(sheet("texture \"a\" opacity blend 0.5", 0), setup, 0.75);
  expect_seen(sheet("texture \"a\" opacity mask 0.5", 0), setup, 0.5);
  expect_seen(sheet("opacity mask 0.5", 0), setup, 0);
}

TEST(Opacity, LetsLightOfLampsPassByItsFraction) {
  const std::string floor = upright("brdf diffuse kd=0.5", 0);
  const auto sheet = [](const std::string& opacity, float z) { return upright(Black + opacity, z, 9); };
  const RenderSetup setup = look_at_origin(1024);
  expect_seen(floor + Lamp, setup, lit_by_lamp());
  expect_seen(floor + sheet("opacity 0.25", 0.5F) + Lamp, setup, 0.75 * lit_by_lamp());
  expect_seen(floor + sheet("opacity 0.25", 0.5F) + sheet("opacity 0.5", 0.75F) + Lamp, setup,
              0.375 * lit_by_lamp());
  expect_seen(floor + sheet("texture \"a\" opacity mask 0.5", 0.5F) + Lamp, setup, 0.5 * lit_by_lamp());
  expect_seen(floor + sheet("texture \"a\" opacity blend 0.5", 0.5F) + Lamp, setup, 0.75 * lit_by_lamp());
}

// The sky over a floor, through a sheet so large that it covers all of it.
TEST(Opacity, LetsLightOfAnEnvironmentPassByItsFraction) {
  const std::string text = upright("brdf diffuse kd=0.5", 0) + upright(Black + "opacity 0.25", 0.5F, 1e4F);
  const CompiledScene scene = test::scene_of(text);
  transport::RenderSettings settings = test::settings_of(look_at_origin(1024));
  settings.integrator.environment = test::environment_of(Image{4, 2, std::vector<Rgb>(8, Rgb(1))});
  for (const bool resamples : {false, true}) {
    if (resamples) settings.integrator.resampling.emplace();
    transport::Render render(scene, settings);
    render.run();
    const test::Estimate estimate = test::mean_radiance(render.film());
    EXPECT_NEAR(estimate.mean, 0.375, 5 * estimate.deviation + 1e-3) << resamples;
    EXPECT_LT(estimate.deviation, 0.01);
  }
}

TEST(Opacity, IsThatOfWhatEmits) {
  const std::string floor = upright("brdf diffuse kd=0.5", 0);
  const auto lamp = [](const std::string& opacity) {
    return "transform rotation (3.14159265,0,0) begin " + upright("light rgb (1,1,1) " + opacity, -1) +
           "end ";
  };
  RenderSetup at_lamp;
  at_lamp.target = Vec3f(0, 0, 1);
  at_lamp.eye = Vec3f(0, 0, 0.9F);
  at_lamp.samples = 64;
  const RenderSetup at_floor = look_at_origin(1024);
  for (const auto& [opacity, fraction] :
       std::initializer_list<std::pair<std::string, double>>{{"", 1},
                                                             {"opacity 0", 0},
                                                             {"opacity 0.25", 0.25},
                                                             {"texture \"a\" opacity mask 0.5", 0.5},
                                                             {"texture \"a\" opacity blend 0.5", 0.25}}) {
    expect_seen(floor + lamp(opacity), at_floor, fraction * lit_by_lamp());
    expect_seen(lamp(opacity), at_lamp, fraction);
  }
}

/// An emitter with a corner cut off, above a floor beside it.
std::string cut_lamp(const std::string& placement) {
  return "def lamp = begin mesh light rgb (3,3,3) texture \"a\" opacity mask 0.5 begin vertexs uv (0,0) "
         "(0,0,0) "
         "uv (0.4,0) (0,0,-2) uv (1,0) (2,0,0) end vertexs begin faces (0,2,1) end faces end mesh begin " +
         placement + " translation (0,1,0) begin use lamp end " + placement +
         " translation (0,100,0) begin use lamp end end " +
         test::quad("brdf diffuse kd=0.5", "(-3,0,3) (3,0,3) (3,0,-3) (-3,0,-3)");
}

TEST(Opacity, OfEmittersIsThatOfTheirCopies) {
  for (const char* placement : {"transform rotation (3.14159265,0,0)", "transform scale (1,-1,1)"}) {
    RenderSetup setup;
    setup.eye = Vec3f(0, 0.5F, 5);
    setup.samples = 256;
    setup.depth = 1;
    const test::Estimate copied = seen(cut_lamp(placement), setup);
    const test::Estimate instanced = seen(cut_lamp(placement), setup, Integrator::Path, with_texture(0));
    const test::Estimate naive = seen(cut_lamp(placement), setup, Integrator::Naive);
    EXPECT_GT(copied.mean, 0.01) << placement;
    EXPECT_NEAR(instanced.mean, copied.mean, 5 * std::hypot(instanced.deviation, copied.deviation));
    EXPECT_NEAR(naive.mean, copied.mean, 5 * std::hypot(naive.deviation, copied.deviation)) << placement;
  }
}

TEST(Opacity, OfAMaskIsAHoleWithSharpEdges) {
  const CompiledScene scene = test::scene_of(upright("texture \"a\" opacity mask 0.5", 0), with_texture());
  for (float x = -0.995F; x < 1; x += 0.01F) {
    const transport::Ray ray{Vec3f(x, 0.3F, 1), Vec3f(0, 0, -1), {}, {0.5F, 0}};
    EXPECT_EQ(scene.is_unoccluded(ray), x < 0) << x;
    EXPECT_EQ(scene.is_occluded({ray.origin, Vec3f(0, 0, -2)}), x > 0) << x;
    for (const std::uint32_t chance : {0U, 1U, 0xffffffffU}) {
      const auto point = scene.intersect(ray, chance);
      EXPECT_EQ(point.has_value(), x > 0) << x;
      if (point) {
        EXPECT_EQ(point->colour, Rgb(1, 0, 0)) << "no black comes from absent texels";
      }
    }
  }
  const CompiledScene whole = test::scene_of(upright("texture \"a\" opacity mask 0", 0), with_texture());
  EXPECT_FALSE(whole.is_unoccluded({Vec3f(-0.5F, 0, 1), Vec3f(0, 0, -1)})) << "no alpha is below 0";
}

TEST(Opacity, HasNoLoopholesForLightWhereFacesLieInOnePlane) {
  const CompiledScene scene = test::scene_of(upright("opacity 0.5", 0) + upright("brdf diffuse", 0));
  for (float x = -0.9F; x < 1; x += 0.1F) {
    const transport::Ray ray{Vec3f(x, 0.35F, 1), Vec3f(0, 0, -1)};
    EXPECT_EQ(scene.transmittance(ray), Rgb(0));
    for (std::uint32_t chance = 0; chance < 8; ++chance) EXPECT_TRUE(scene.intersect(ray, chance));
  }
}

TEST(Opacity, MultipliesWhatFacesLetPass) {
  const CompiledScene scene =
      test::scene_of(upright("opacity 0.25", 0) + upright("opacity 0.5", 1) + upright("opacity 0", 2));
  const transport::Ray ray{Vec3f(0.1F, 0.3F, 3), Vec3f(0, 0, -1)};
  EXPECT_EQ(scene.transmittance(ray), Rgb(0.375F));
  EXPECT_EQ(scene.transmittance_to_end({ray.origin, Vec3f(0, 0, -2.5F)}), Rgb(0.5F));
  const auto front = scene.intersect(ray, 1);
  int hits = 0;
  for (std::uint32_t chance = 0; chance < 10'000; ++chance) hits += scene.intersect(ray, chance) ? 1 : 0;
  EXPECT_NEAR(hits, 6250, 5 * std::sqrt(10'000 * 0.625 * 0.375));
  EXPECT_EQ(front.has_value(), scene.intersect(ray, 1).has_value()) << "the same chance is the same decision";
}

// Whatever the sphere is, it reflects or lets pass all light.
TEST(Opacity, KeepsAFurnaceWhite) {
  RenderSetup setup;
  setup.background = 1;
  setup.depth = 60;
  setup.width = setup.height = 16;
  setup.samples = 64;
  for (const char* opacity : {"0.25", "0.5"}) {
    const test::Estimate estimate =
        seen(test::sphere(std::string("brdf diffuse kd=1 opacity ") + opacity, 8, false), setup);
    EXPECT_NEAR(estimate.mean, 1, 5 * estimate.deviation + 1e-4) << opacity;
    EXPECT_LT(estimate.deviation, 0.01);
  }
}

/// A room with a lamp behind sheets of all kinds.
const std::string Room = test::quad("brdf phong kd=0.5 ks=0.4 n=20", "(-1,-1,1)(1,-1,1)(1,-1,-1)(-1,-1,-1)") +
                         test::quad("brdf diffuse kd=0.8", "(-1,-1,-1)(1,-1,-1)(1,1,-1)(-1,1,-1)") +
                         upright("brdf diffuse kd=0.6 opacity 0.4", -0.5F) +
                         upright("brdf diffuse kd=0.6 texture \"a\" opacity blend 0.7", 0.1F) +
                         upright("brdf ward texture \"a\" opacity mask 0.5", 0.5F, 0.6F) +
                         "begin mesh light rgb (2,3,4) brdf diffuse opacity 0.5 begin vertexs (-1,1,-1) "
                         "(1,1,-1) (1,1,1) (-1,1,1) end "
                         "vertexs begin faces (0,1,2,3) end faces end mesh\n";

TEST(Opacity, IsTheSameForAllIntegrators) {
  RenderSetup setup;
  setup.depth = 4;
  setup.background = 0.3F;
  setup.samples = 256;
  const test::Estimate path = seen(Room, setup);
  setup.samples = 64;
  setup.seed = 1;
  const test::Estimate naive = seen(Room, setup, Integrator::Naive);
  EXPECT_NEAR(path.mean, naive.mean, 5 * std::hypot(path.deviation, naive.deviation));
  EXPECT_LT(std::hypot(path.deviation, naive.deviation), 0.01 * path.mean);
}

TEST(Opacity, GivesTheSameImageForAnyNumberOfThreads) {
  RenderSetup setup;
  setup.samples = 8;
  std::vector<Image> images;
  for (const int threads : {1, 2, 7}) {
    setup.threads = threads;
    CompileSettings settings = with_texture();
    settings.threads = threads;
    images.push_back(test::render(test::scene_of(Room, settings), setup).mean());
    EXPECT_EQ(images.back().pixels, images.front().pixels) << threads;
  }
  setup.seed = 1;
  EXPECT_NE(test::render(test::scene_of(Room, with_texture()), setup).mean().pixels, images.front().pixels);
}

TEST(Opacity, OfOneChangesNoBit) {
  const auto image = [](const std::string& opacity) {
    const std::string text = test::LitFloor + upright("brdf diffuse kd=0.6 texture \"a\" " + opacity, 1);
    CompileSettings settings;
    settings.image_reader = [](const std::string&, grf::Diagnostics&, const grf::SourceLocation&,
                               Alpha alpha) {
      return Image{2, 1, {Rgb(0.25F), Rgb(1, 0, 0)}, std::vector<float>(alpha == Alpha::Kept ? 2 : 0, 1.0F)};
    };
    return test::render(test::scene_of(text, settings), test::floor_setup(32, 24, 8)).mean().pixels;
  };
  const auto opaque = image("");
  for (const char* opacity : {"opacity 1", "opacity mask 0", "opacity mask 1", "opacity blend 1"}) {
    EXPECT_EQ(image(opacity), opaque) << opacity;
  }
}

TEST(Opacity, IsSeenThroughByFeatureLayers) {
  transport::View view;
  view.eye = Vec3f(0, 0, 4);
  view.field_of_view = 20;
  const auto layers = [&](const std::string& opacity, int samples) {
    const CompiledScene scene = test::scene_of(
        upright("brdf diffuse kd=0.5 " + opacity, 1, 9) + upright("brdf diffuse kd=0.25", 0, 9),
        with_texture());
    return transport::feature_layers(scene, view, 8, 8, samples, 3, 1);
  };
  const transport::FeatureLayers mask = layers("texture \"a\" opacity mask 0.5", 4);
  EXPECT_NEAR(mask.depth[8 * 4 + 1], 4, 1e-4F);
  EXPECT_NEAR(mask.depth[8 * 4 + 6], 3, 1e-4F);
  EXPECT_NEAR(mask.albedo.pixels[8 * 4 + 1].y, 0.25F, 1e-5F);
  EXPECT_NEAR(mask.albedo.pixels[8 * 4 + 6].x, 0.5F, 1e-5F);
  const transport::FeatureLayers thin = layers("opacity 0.25", 1024);
  double depth = 0;
  double albedo = 0;
  for (std::size_t i = 0; i < 64; ++i) {
    depth += thin.depth[i] / 64;
    albedo += thin.albedo.pixels[i].x / 64;
  }
  EXPECT_NEAR(depth, 0.25 * 3 + 0.75 * 4, 0.01);
  EXPECT_NEAR(albedo, 0.25 * 0.5 + 0.75 * 0.25, 0.003);
}

TEST(Opacity, ChangesTheAccelerationStructureOnlyWhereItAppears) {
  const CompiledScene opaque = test::scene_of(upright("brdf diffuse", 0));
  const auto again = [&](const std::string& attributes, const CompiledScene& before) {
    grf::Diagnostics diagnostics;
    const auto scene = grf::read_text(upright(attributes, 0), "test.grf", diagnostics);
    return transport::compile(*scene, diagnostics, {}, &before).value();
  };
  const CompiledScene cut = again("opacity 0.5", opaque);
  EXPECT_FALSE(cut.caster().shares(opaque.caster()));
  EXPECT_TRUE(again("opacity 0.25", cut).caster().shares(cut.caster()));
  EXPECT_FALSE(opaque.has_cutouts());
  EXPECT_TRUE(cut.has_cutouts());
}

TEST(TextureWithAlpha, CountsTexelsByTheirAlpha) {
  Image image{4, 2, {}};
  for (int i = 0; i < 8; ++i) {
    const float alpha = i % 4 < 2 ? 0 : 0.5F;
    image.pixels.push_back(Rgb(0.8F, 0.4F, 0) * alpha);
    image.alpha.push_back(alpha);
  }
  const transport::Texture texture(image);
  for (const float footprint : {0.0F, 0.4F, 1.0F, 9.0F}) {
    for (const float u : {0.45F, 0.55F, 0.75F, 0.95F}) {
      const Rgb colour = texture.lookup({u, 0.5F}, footprint);
      EXPECT_NEAR(colour.x, 0.8F, 1e-3F) << u << " " << footprint;
      EXPECT_NEAR(colour.y, 0.4F, 1e-3F) << u << " " << footprint;
    }
  }
  EXPECT_EQ(texture.lookup({0.25F, 0.5F}, 0), Rgb(0)) << "nothing is there";
  EXPECT_EQ(texture.alpha({0.25F, 0.5F}, 0), 0);
  EXPECT_EQ(texture.alpha({0.75F, 0.5F}, 0), 0.5F);
  EXPECT_FLOAT_EQ(texture.alpha({0.5F, 0.5F}, 0), 0.25F) << "between two texels";
  EXPECT_FLOAT_EQ(texture.alpha({0.75F, 0.5F}, 9), 0.25F) << "the mean";
  EXPECT_EQ(transport::Texture(Image{1, 1, {Rgb(0.5F)}}).alpha({0, 0}, 0), 1);
  const float nan = std::nanf("");
  const transport::Texture wrong(Image{2, 1, {Rgb(1), Rgb(1)}, {nan, 7}});
  EXPECT_EQ(wrong.alpha({0.25F, 0.5F}, 0), 0);
  EXPECT_EQ(wrong.alpha({0.75F, 0.5F}, 0), 1);
}

}  // namespace
