#include "editor/image/screen_colours.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "editor/image/image_statistics.h"
#include "editor/image/shown_image.h"
#include "renderer/image/srgb.h"

namespace editor {
namespace {

using grf::Colour;
using image::Image;

constexpr float NotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float Infinite = std::numeric_limits<float>::infinity();

QRgb colour_of(const Colour& pixel, const ScreenSettings& settings = {}) {
  return ScreenColours(settings)(pixel);
}

TEST(ScreenColours, EncodeKnownRadiancesInSrgb) {
  // IEC 61966-2-1: the middle of sRGB is 21.4 % of white, and 18 % grey is 118.
  EXPECT_EQ(colour_of(Colour(0)), qRgb(0, 0, 0));
  EXPECT_EQ(colour_of(Colour(1)), qRgb(255, 255, 255));
  EXPECT_EQ(colour_of(Colour(0.18F, 0.2158605F, 0.5F)), qRgb(118, 128, 188));
  EXPECT_EQ(colour_of(Colour(0.0031308F, -1, 7)), qRgb(10, 0, 255));
  EXPECT_EQ(colour_of(Colour(0.045F), {.exposure = 2}), qRgb(118, 118, 118));
  EXPECT_EQ(colour_of(Colour(1), {.curve = ToneCurve::Reinhard}), qRgb(188, 188, 188));
  EXPECT_EQ(colour_of(Colour(0.18F), {.curve = ToneCurve::Filmic}), qRgb(141, 141, 141));
}

// The table equals the formula over the whole range.
TEST(ScreenColours, TableIsTheFormula) {
  const ByteCurve curve(ToneCurve::Srgb);
  float value = 1e-6F;
  while (value < 2) {
    EXPECT_EQ(curve(value), image::to_srgb_byte(value)) << value;
    value *= 1.00037F;
  }
  EXPECT_EQ(curve(1e30F), 255);
  EXPECT_EQ(curve(std::numeric_limits<float>::denorm_min()), 0);
  EXPECT_EQ(curve(-1), 0);
  EXPECT_EQ(curve(NotANumber), 0);
}

TEST(ScreenColours, CurvesRise) {
  for (const ToneCurve kind : {ToneCurve::Srgb, ToneCurve::Filmic, ToneCurve::Reinhard}) {
    const ByteCurve curve(kind);
    int last = 0;
    float value = 1e-7F;
    while (value < 1e5F) {
      EXPECT_GE(curve(value), last) << value;
      last = curve(value);
      value *= 1.003F;
    }
    EXPECT_EQ(last, 255);
  }
}

TEST(ScreenColours, ShowChannelsInGrey) {
  const Colour pixel(1, 0.2158605F, 0);
  EXPECT_EQ(colour_of(pixel, {.channel = ImageChannel::Red}), qRgb(255, 255, 255));
  EXPECT_EQ(colour_of(pixel, {.channel = ImageChannel::Green}), qRgb(128, 128, 128));
  EXPECT_EQ(colour_of(pixel, {.channel = ImageChannel::Blue}), qRgb(0, 0, 0));
  const int luminance = image::to_srgb_byte(0.2126F + 0.7152F * 0.2158605F);
  EXPECT_EQ(colour_of(pixel, {.channel = ImageChannel::Luminance}), qRgb(luminance, luminance, luminance));
}

TEST(ScreenColours, MarkWhatIsNoColour) {
  for (const Colouring colouring : {Colouring::Natural, Colouring::FalseColour, Colouring::Signed}) {
    const ScreenSettings settings{.colouring = colouring};
    EXPECT_EQ(colour_of(Colour(1, NotANumber, 0), settings), NanColour);
    EXPECT_EQ(colour_of(Colour(NotANumber, Infinite, 0), settings), NanColour);
    EXPECT_EQ(colour_of(Colour(0, 0, -Infinite), settings), InfiniteColour);
    const float large = std::numeric_limits<float>::max();
    EXPECT_NE(colour_of(Colour(large), settings), InfiniteColour) << "large, but a number";
  }
}

TEST(ScreenColours, FalseColoursFollowTheScale) {
  const ScreenSettings settings{.colouring = Colouring::FalseColour, .least = 0.01, .largest = 1};
  const ScreenColours colours(settings);
  EXPECT_EQ(colours.scale().highest(), 1);
  EXPECT_EQ(colours.scale().lowest(), 0.01);
  int last = -1;
  for (const float value : {0.0F, 0.011F, 0.03F, 0.1F, 0.3F, 0.99F}) {
    const int grey = qGray(colours(Colour(value)));
    EXPECT_GT(grey, last) << "more light is lighter, " << value;
    last = grey;
  }
  for (const float value : {0.005F, 0.02F, 0.1F, 0.7F, 3.0F}) {
    const QRgb exact = colours.false_colour(value);
    EXPECT_NEAR(qRed(colours(Colour(value))), qRed(exact), 2);
    EXPECT_NEAR(qBlue(colours(Colour(value))), qBlue(exact), 2);
  }
  ScreenSettings brighter = settings;
  brighter.exposure = 1;
  EXPECT_EQ(ScreenColours(brighter).scale().highest(), 0.5);
}

TEST(ScreenColours, OfErrorsAreFalseAndInPercent) {
  for (const char* name : {"error", "diffuse.error"}) {
    ScreenSettings settings = default_settings(name);
    EXPECT_EQ(settings.colouring, Colouring::FalseColour) << name;
    ShownImage layer;
    layer.layer = name;
    fit_range(layer, {}, settings);
    EXPECT_TRUE(settings.is_relative_error);
    EXPECT_FALSE(settings.is_radiance);
    layer.layer = "samples";
    fit_range(layer, {}, settings);
    EXPECT_FALSE(settings.is_relative_error);
  }
  EXPECT_EQ(default_settings("samples").colouring, Colouring::Natural);
}

TEST(ScreenColours, SignsHaveColours) {
  const ScreenSettings settings{.colouring = Colouring::Signed};
  const QRgb above = colour_of(Colour(0.5F), settings);
  const QRgb below = colour_of(Colour(-0.5F), settings);
  EXPECT_GT(qRed(above), qBlue(above));
  EXPECT_GT(qBlue(below), qRed(below));
  EXPECT_EQ(colour_of(Colour(0), settings), qRgb(0, 0, 0));
}

TEST(ScreenColours, BlocksAreMeans) {
  Image image{5, 3, std::vector<Colour>(15, Colour(0))};
  image.pixels[0] = Colour(0.8F);
  image.pixels[4] = Colour(0.2F);
  image.pixels[14] = Colour(NotANumber, 0, 0);
  const ScreenColours colours({});
  const QImage halved = colours.convert(image, QRect(0, 0, 5, 3), 2);
  ASSERT_EQ(halved.size(), QSize(3, 2));
  EXPECT_EQ(halved.pixel(0, 0), colours(Colour(0.2F)));
  EXPECT_EQ(halved.pixel(2, 0), colours(Colour(0.1F)));
  EXPECT_EQ(halved.pixel(1, 1), qRgb(0, 0, 0));
  EXPECT_EQ(halved.pixel(2, 1), NanColour);
  const QImage part = colours.convert(image, QRect(4, 0, 1, 2));
  ASSERT_EQ(part.size(), QSize(1, 2));
  EXPECT_EQ(part.pixel(0, 0), colours(Colour(0.2F)));
}

TEST(ImageStatistics, CountAndRank) {
  Image image{100, 100, std::vector<Colour>(10000, Colour(1))};
  image.pixels[0] = Colour(NotANumber);
  image.pixels[1] = Colour(1, Infinite, 1);
  image.pixels[2] = Colour(1, -1, 1);
  for (std::size_t i = 3; i < 103; ++i) image.pixels[i] = Colour(0.25F);
  image.pixels[200] = Colour(1e6F);
  const ImageStatistics statistics = statistics_of(image);
  EXPECT_EQ(statistics.nan_pixels, 1U);
  EXPECT_EQ(statistics.infinite_pixels, 1U);
  EXPECT_EQ(statistics.negative_pixels, 1U);
  EXPECT_NEAR(statistics.dark_luminance, 0.25, 1e-6);
  EXPECT_NEAR(statistics.bright_luminance, 1, 1e-6) << "one firefly is no measure";
  EXPECT_EQ(statistics_of({2, 1, {Colour(0), Colour(0)}}).bright_luminance, 0);
}

TEST(ImageStatistics, DifferencesAreWhatTheySay) {
  const Image a{1, 1, {Colour(1, 2, 0.5F)}};
  const Image b{1, 1, {Colour(2, 2, 0)}};
  EXPECT_EQ(difference_of(a, b, Difference::Signed).pixels[0], Colour(-1, 0, 0.5F));
  EXPECT_EQ(difference_of(a, b, Difference::Absolute).pixels[0], Colour(1, 0, 0.5F));
  const Colour relative = difference_of(a, b, Difference::Relative).pixels[0];
  EXPECT_NEAR(relative.x, 1 / std::sqrt(4.01), 1e-6);
  EXPECT_NEAR(relative.z, 5, 1e-5);
}

}  // namespace
}  // namespace editor
