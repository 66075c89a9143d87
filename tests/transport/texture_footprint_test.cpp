// Texture footprints of rays. The texture is 1 in its left half and a quarter in its right one: near u = 1/4
// that is 1 on all mip levels but the last, which has the mean. So the value there measures the footprint, if
// that is between half of the texture and all of it.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/transport/scene_helpers.h"

namespace {

using grf::Vec2f;
using image::Image;
using transport::CompiledScene;
using transport::Integrator;
using transport::RayCone;
using transport::Rgb;
using transport::Texture;
using transport::Vec3f;

constexpr float Bright = 1;
constexpr float Dark = 0.25F;
constexpr float MeanOfBoth = (Bright + Dark) / 2;

Image two_halves(int width, int height) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) image.pixels.emplace_back(i % width < width / 2 ? Bright : Dark);
  return image;
}

/// The footprint in uv coordinates, from the value.
double footprint_of(float seen) { return std::exp2((Bright - seen) / (Bright - MeanOfBoth) - 1); }

TEST(Texture, WeighsLevelsByTheLogarithmOfTheFootprint) {
  const Texture square(two_halves(64, 64));
  for (const float footprint : {0.0F, 0.03F, 0.25F, 0.5F})
    EXPECT_NEAR(square.lookup({0.25F, 0.3F}, footprint).x, Bright, 1e-4) << footprint;
  for (const float footprint : {0.55F, 0.70711F, 0.9F})
    EXPECT_NEAR(footprint_of(square.lookup({0.25F, 0.3F}, footprint).x), footprint, 1e-3);
  for (const float footprint : {1.0F, 3.0F, 1e9F})
    EXPECT_NEAR(square.lookup({0.25F, 0.3F}, footprint).x, MeanOfBoth, 1e-4) << footprint;
  // The number of texels is that of a square of 32: half a level more than 32 of them, of 64 across.
  const Texture wide(two_halves(64, 16));
  EXPECT_NEAR(wide.lookup({0.25F, 0.3F}, std::sqrt(2.0F)).x, (Bright + MeanOfBoth) / 2, 1e-3);
}

TEST(RayCone, WidensWithDistanceAndWithWhatIsRare) {
  const RayCone cone{0.5F, 0.01F};
  EXPECT_FLOAT_EQ(cone.at(20).width, 0.7F);
  EXPECT_FLOAT_EQ(cone.at(20).spread, 0.01F);
  // A quarter of the root of the solid angle, 1/pdf.
  EXPECT_FLOAT_EQ(cone.widened(4).spread, 0.125F);
  EXPECT_FLOAT_EQ(cone.widened(4).width, 0.5F);
  EXPECT_FLOAT_EQ(cone.widened(1e6F).spread, 0.01F) << "it never narrows";
}

class TextureFootprint : public testing::Test {
 protected:
  TextureFootprint() {
    const Image image = two_halves(64, 64);
    std::string bytes = "PF\n64 64\n-1\n";
    bytes.append(reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size() * sizeof(Rgb));
    texture_ = "texture \"" + folder_.add("halves.pfm", bytes) + "\" ";
  }

  /// A sheet from (0,0) to the size at z = 0, with this many repeats along each axis; five squares, two of
  /// which are instances.
  std::string sheet(const Vec2f& size, const Vec2f& repeats, bool faces_up = true) const {
    std::string text = "begin mesh brdf diffuse kd=1 " + texture_ + "begin vertexs\n";
    for (int i = 0; i < 12; ++i) {
      const Vec2f part(static_cast<float>(i / 2) / 5, static_cast<float>(i % 2));
      text += fmt::format("uv ({},{}) ({},{},0)\n", part.x * repeats.x, part.y * repeats.y, part.x * size.x,
                          part.y * size.y);
    }
    text += "end vertexs begin faces\n";
    for (int i = 0; i < 10; i += 2) {
      text += faces_up ? fmt::format("({},{},{},{})\n", i, i + 2, i + 3, i + 1)
                       : fmt::format("({},{},{},{})\n", i, i + 1, i + 3, i + 2);
    }
    return text + "end faces end mesh\n";
  }

  /// The value at the image's centre under a white sky.
  static float seen_in_the_middle(const CompiledScene& scene, test::RenderSetup setup, int pixels) {
    setup.width = setup.height = pixels;
    setup.samples = 2;
    setup.background = 1;
    transport::RenderSettings settings = test::settings_of(setup);
    settings.pixel_sampling = transport::PixelSampling::Centre;
    transport::Render render(scene, settings);
    render.run();
    return render.film().mean().at(pixels / 2, pixels / 2).x;
  }

  const test::TemporaryFolder folder_;
  std::string texture_;
};

TEST_F(TextureFootprint, IsTheConesWidthTimesTheRootOfTheRatioOfAreas) {
  struct Case {
    Vec2f size, repeats;
    float scale;  // sqrt(area in uv coordinates / area)
  };
  for (const Case& one : {Case{{2, 3}, {4, 1.5F}, 1}, Case{{1, 1}, {2, 8}, 4}, Case{{8, 2}, {1, 1}, 0.25F}}) {
    const CompiledScene scene = test::scene_of(sheet(one.size, one.repeats));
    for (const float footprint : {0.6F, 0.7F, 0.9F}) {
      // A third of it is there from the start, two thirds come with distance.
      const float width = footprint / one.scale;
      constexpr float Distance = 5;
      const Vec3f place(one.size.x / (4 * one.repeats.x), 0.3F * one.size.y, Distance);
      const auto point =
          scene.intersect({place, Vec3f(0, 0, -1), {}, {width / 3, 2 * width / (3 * Distance)}});
      ASSERT_TRUE(point);
      EXPECT_NEAR(footprint_of(point->colour.x), footprint, 2e-3) << one.scale;
    }
  }
}

TEST_F(TextureFootprint, FollowsTheScaleOfItsPlace) {
  const std::string text = "def sheet = " + sheet({1, 1}, {1, 1}) +
                           "begin transform scale (2,8,1) begin use sheet end "
                           "transform translation (0,0,-9) begin use sheet end end";
  for (const std::size_t most_copied : {0, 1'000'000}) {
    grf::Diagnostics diagnostics;
    transport::CompileSettings settings;
    settings.most_copied_triangles = most_copied;
    const auto scene =
        transport::compile(grf::read_text(text, "test.grf", diagnostics).value(), diagnostics, settings);
    ASSERT_TRUE(scene) << diagnostics.to_text();
    ASSERT_EQ(scene->instance_count(), most_copied == 0 ? 2U : 0U);
    const auto point = scene->intersect({Vec3f(0.5F, 3, 1), Vec3f(0, 0, -1), {}, {2.8F, 0}});
    ASSERT_TRUE(point);
    EXPECT_NEAR(footprint_of(point->colour.x), 2.8 / 4, 2e-3) << most_copied;
  }
}

TEST_F(TextureFootprint, OfACameraRayIsAPixelAtItsDistance) {
  const CompiledScene scene = test::scene_of(sheet({4, 4}, {2, 2}));  // half of a repeat per unit
  for (const auto& [pixels, degrees] : {std::pair(1, 20.0F), {3, 60.0F}}) {
    test::RenderSetup setup;
    setup.eye = Vec3f(0.5F, 2, 4);
    setup.target = Vec3f(0.5F, 2, 0);
    setup.field_of_view = degrees;
    setup.depth = 1;
    const double pixel = 4 * 2 * std::tan(degrees * M_PI / 360) / pixels;
    EXPECT_NEAR(footprint_of(seen_in_the_middle(scene, setup, pixels)), pixel / 2, 2e-3) << degrees;
  }
}

// Six units from the specular surface, two of which are behind the eye.
TEST_F(TextureFootprint, GrowsOnBehindAMirror) {
  const std::string mirror =
      test::quad("brdf specular ks=1", "(-0.01,-0.01,0) (0.01,-0.01,0) (0.01,0.01,0) (-0.01,0.01,0)");
  const CompiledScene scene = test::scene_of(mirror + "transform translation (-0.5,-2,6) begin " +
                                             sheet({4, 4}, {2, 2}, false) + "end");
  test::RenderSetup setup;
  setup.field_of_view = 8;
  setup.depth = 2;
  const double pixel = (4 + 6) * 2 * std::tan(8 * M_PI / 360);
  EXPECT_NEAR(footprint_of(seen_in_the_middle(scene, setup, 1)), pixel / 2, 2e-3);
}

// From a diffuse floor a path goes anywhere, in one of few directions: each sees the mean of a finely striped
// ceiling, which only the last level has.
TEST_F(TextureFootprint, OfAScatteredRayIsWide) {
  const std::string floor =
      test::quad("brdf diffuse kd=1", "(-0.01,-0.01,0) (0.01,-0.01,0) (0.01,0.01,0) (-0.01,0.01,0)");
  const CompiledScene scene = test::scene_of(floor + "transform translation (-1000,-1000,10) begin " +
                                             sheet({2000, 2000}, {2000, 2000}, false) + "end");
  for (const Integrator integrator : {Integrator::Path, Integrator::Naive}) {
    transport::IntegratorSettings settings;
    settings.integrator = integrator;
    settings.background = Rgb(1);
    settings.depth = 2;
    settings.split_count = settings.secondary_rays = 1;
    const transport::Kernel kernel = kernel_of(scene, settings);
    int means = 0;
    constexpr std::uint32_t Paths = 500;
    for (std::uint32_t i = 0; i < Paths; ++i) {
      transport::PathSampler sampler(3, i);
      transport::RayCounter counter;
      const transport::Ray ray{Vec3f(0, 0, 1), Vec3f(0, 0, -1), {}, {0, 1e-3F}};
      if (std::abs(kernel(scene, settings, ray, {}, sampler, counter).x - MeanOfBoth) < 1e-3F) ++means;
    }
    EXPECT_GT(means, 490) << static_cast<int>(integrator);
  }
}

}  // namespace
