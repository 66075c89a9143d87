#include "renderer/transport/scene/texture.h"

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <unistd.h>

#include "renderer/image/srgb.h"
#include "tests/transport/scene_helpers.h"

namespace {

using grf::Vec2f;
using image::Image;
using transport::Rgb;
using transport::Texture;
using transport::Vec3f;

Image random_image(int width, int height, bool bytes) {
  std::mt19937 random(1);
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    Rgb pixel;
    for (int k = 0; k < 3; ++k) {
      pixel[k] = bytes ? image::srgb_table()[random() % 256] : static_cast<float>(random() % 1000) / 8;
    }
    image.pixels.push_back(pixel);
  }
  return image;
}

Rgb mean_of(const Image& image) {
  Imath::V3d sum(0);
  for (const Rgb& pixel : image.pixels) sum += Imath::V3d(pixel);
  return Rgb(sum / static_cast<double>(image.pixels.size()));
}

TEST(Texture, GivesBackEachTexelAtItsCentreFromTheLowerLeft) {
  for (const bool bytes : {true, false}) {
    const Image image = random_image(7, 5, bytes);
    const Texture texture(image);
    EXPECT_EQ(texture.has_bytes(), bytes);
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 7; ++x) {
        const Vec2f uv((static_cast<float>(x) + 0.5F) / 7, 1 - (static_cast<float>(y) + 0.5F) / 5);
        for (const Vec2f& turns : {Vec2f(0), Vec2f(3, -2)}) {
          const Rgb found = texture.lookup(uv + turns, 0);
          EXPECT_NEAR((found - image.at(x, y)).length(), 0, 2e-5F * image.at(x, y).length() + 1e-4F);
        }
      }
    }
  }
}

TEST(Texture, InterpolatesBetweenTexelsAndOverItsEdges) {
  const Texture texture(Image{2, 1, {Rgb(0), Rgb(1)}});
  EXPECT_NEAR(texture.lookup({0.5F, 0.3F}, 0).x, 0.5F, 1e-6);
  EXPECT_NEAR(texture.lookup({0, 0.3F}, 0).x, 0.5F, 1e-6);
  EXPECT_NEAR(texture.lookup({0.375F, 0.3F}, 0).x, 0.25F, 1e-6);
}

TEST(Texture, KeepsTheMeanOverMipLevels) {
  Image image = random_image(37, 22, false);
  const Rgb mean = mean_of(image);
  const Texture texture(image);
  while (image.pixels.size() > 1) {
    image = transport::halved(image);
    // Odd sizes give their halves texels of equal area, which preserves the mean.
    EXPECT_NEAR((mean_of(image) - mean).length(), 0, 1e-4F * mean.length());
  }
  ASSERT_EQ(texture.level_count(), 7U);
  EXPECT_NEAR((texture.lookup({0.3F, 0.1F}, 4) - mean).length(), 0, 1e-3F * mean.length());
}

TEST(Texture, GoesFromLevelToLevelWithoutAStep) {
  const Texture texture(random_image(64, 64, false));
  Rgb before = texture.lookup({0.3F, 0.4F}, 1e-3F);
  for (int step = 0; step < 764; ++step) {  // up to 2
    const float footprint = 1e-3F * std::pow(1.01F, static_cast<float>(step));
    const Rgb now = texture.lookup({0.3F, 0.4F}, footprint);
    EXPECT_LT((now - before).length(), 4);
    before = now;
  }
}

TEST(Texture, CountsWhatIsNoReflectanceAsBlack) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Texture texture(Image{2, 1, {Rgb(nan, 1, 1), Rgb(1, -1, 1e30F)}});
  EXPECT_EQ(texture.invalid_texels(), 2U);
  EXPECT_EQ(texture.lookup({0.25F, 0.5F}, 0), Rgb(0, 1, 1));
  EXPECT_EQ(texture.lookup({0.75F, 0.5F}, 0).z, 65504);
  EXPECT_EQ(texture.lookup({nan, 3e38F}, nan).z, texture.lookup({0, 0}, 0).z);
}

/// A folder with a picture of four colours: red and green above blue and white.
class TexturedScene : public testing::Test {
 protected:
  TexturedScene() : path_(fmt::format("{}texture_test_{}.pfm", testing::TempDir(), ::getpid())) {
    const std::array<float, 12> rows_from_below = {0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0};
    std::ofstream file(path_, std::ios::binary);
    file << "PF\n2 2\n-1\n";
    file.write(reinterpret_cast<const char*>(rows_from_below.data()), sizeof(rows_from_below));
  }
  ~TexturedScene() override { ::unlink(path_.c_str()); }

  std::string quad(const std::string& file) const {
    return test::quad("rgb (0.5,0.5,0.5) brdf diffuse texture \"" + file + "\"",
                      "uv (0,0) (0,0,0) uv (1,0) (1,0,0) uv (1,1) (1,1,0) uv (0,1) (0,1,0)");
  }

  const std::string path_;
};

TEST_F(TexturedScene, MultipliesTheColour) {
  const transport::CompiledScene scene = test::scene_of(quad(path_));
  const auto colour_at = [&](float x, float y) {
    return scene.intersect({Vec3f(x, y, 1), Vec3f(0, 0, -1)})->colour;
  };
  EXPECT_NEAR((colour_at(0.25F, 0.75F) - Rgb(0.5F, 0, 0)).length(), 0, 1e-3);
  EXPECT_NEAR((colour_at(0.75F, 0.75F) - Rgb(0, 0.5F, 0)).length(), 0, 1e-3);
  EXPECT_NEAR((colour_at(0.25F, 0.25F) - Rgb(0, 0, 0.5F)).length(), 0, 1e-3);
  EXPECT_NEAR((colour_at(0.75F, 0.25F) - Rgb(0.5F)).length(), 0, 1e-3);
  EXPECT_EQ(scene.texture_count(), 1U);
}

// A cone as wide as the quad sees its mean.
TEST_F(TexturedScene, IsSeenByTheWidthOfTheCone) {
  const transport::CompiledScene scene = test::scene_of(quad(path_));
  const transport::Ray ray{Vec3f(0.25F, 0.75F, 1), Vec3f(0, 0, -1), {}, {0.5F, 0.5F}};
  // Half a step of sRGB-encoded bytes.
  EXPECT_NEAR((scene.intersect(ray)->colour - Rgb(0.25F)).length(), 0, 4e-3);
}

TEST_F(TexturedScene, IsAnErrorWhereTheImageIsMissing) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(quad("no.png") + quad("no.png"), "test.grf", diagnostics);
  EXPECT_FALSE(transport::compile(scene.value(), diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.to_text().rfind("test.grf:1:", 0), 0U) << diagnostics.to_text();
}

}  // namespace
