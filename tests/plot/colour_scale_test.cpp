#include "renderer/plot/colour_scale.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/svg_reading.h"

namespace {

using plot::ColourScale;

float lightness(const grf::Colour& colour) { return 0.3F * colour.x + 0.59F * colour.y + 0.11F * colour.z; }

TEST(ColourScale, HasRoundEnds) {
  const auto ends = [](double least, double largest) {
    const ColourScale scale(least, largest);
    return std::pair(scale.lowest(), scale.highest());
  };
  const auto near = [](double low, double high) {
    return testing::Pair(testing::DoubleNear(low, 1e-9 * low), testing::DoubleNear(high, 1e-9 * high));
  };
  EXPECT_THAT(ends(0.03, 7), near(0.02, 10));
  EXPECT_THAT(ends(0.02, 5), near(0.02, 5)) << "as they are";
  EXPECT_THAT(ends(0.3183, 0.3183), near(0.05, 0.5)) << "not less than ten times";
  EXPECT_THAT(ends(1e-9, 3000), near(0.5, 5000)) << "nor more than ten thousand times";
  EXPECT_THAT(ends(0, 3000), near(0.5, 5000));
  EXPECT_THAT(ends(0, 0), near(0.1, 1));
  EXPECT_THAT(ends(0, std::numeric_limits<double>::infinity()), near(0.1, 1));
}

TEST(ColourScale, DarkensAllTheWay) {
  const ColourScale scale(0.001, 10);
  float before = lightness(scale.colour(0));
  EXPECT_EQ(scale.colour(0), scale.colour(0.001));
  for (int step = 1; step <= 96; ++step) {
    const double value = 0.001 * std::pow(1.1, step);
    const float now = lightness(scale.colour(value));
    EXPECT_LT(now, before) << value;
    before = now;
  }
  EXPECT_EQ(scale.colour(10), scale.colour(1e9));
  EXPECT_EQ(plot::hexadecimal(scale.colour(10)), "#081d58");
  EXPECT_EQ(plot::hexadecimal(scale.colour(0)), "#ffffd9");
}

TEST(ColourScale, IsDrawnWithItsPowersOfTen) {
  const auto drawn = [](const ColourScale& scale) {
    plot::Svg svg(100, 200);
    draw(scale, {{10, 10}, 20, 180}, svg);
    return test::svg_of(svg.str());
  };
  EXPECT_THAT(test::texts(drawn(ColourScale(0.002, 20))), testing::ElementsAre("0.01", "0.1", "1", "10"));
  EXPECT_THAT(test::texts(drawn(ColourScale(0.002, 0.05))),
              testing::ElementsAre("2e-3", "5e-3", "0.01", "0.02", "0.05"));
  EXPECT_THAT(test::texts(drawn(ColourScale(1, 1e4))), testing::ElementsAre("1", "10", "100", "1000", "1e4"));
  EXPECT_THAT(test::texts(drawn(ColourScale(1e-9, 1e-3))),
              testing::ElementsAre("1e-7", "1e-6", "1e-5", "1e-4", "1e-3"));
  EXPECT_THAT(test::texts(drawn(ColourScale(0.3, 3))), testing::ElementsAre("0.2", "0.5", "1", "2", "5"))
      << "with more where there are few";
  EXPECT_GT(test::elements(drawn(ColourScale(0.3, 3)), "rect").size(), 50U);
}

TEST(LinearColourScale, GoesFromTheFirstColourToTheLast) {
  using plot::LinearColourScale;
  const LinearColourScale diverging(-4, 4, LinearColourScale::Palette::Diverging);
  EXPECT_EQ(plot::hexadecimal(diverging.colour(-4)), "#2166ac");
  EXPECT_EQ(plot::hexadecimal(diverging.colour(-9)), "#2166ac") << "and beyond";
  EXPECT_EQ(plot::hexadecimal(diverging.colour(0)), "#f7f7f7");
  EXPECT_EQ(plot::hexadecimal(diverging.colour(1)), "#fddbc7");
  EXPECT_EQ(plot::hexadecimal(diverging.colour(4)), "#b2182b");
  const LinearColourScale sequential(0, 1, LinearColourScale::Palette::Sequential);
  EXPECT_EQ(plot::hexadecimal(sequential.colour(0)), "#ffffd9");
  EXPECT_EQ(plot::hexadecimal(sequential.colour(0.5)), "#41b6c4");
  EXPECT_EQ(plot::hexadecimal(sequential.colour(1)), "#081d58");
  const LinearColourScale one_value(3, 3, LinearColourScale::Palette::Sequential);
  EXPECT_EQ(plot::hexadecimal(one_value.colour(3)), "#ffffd9");
}

TEST(LinearColourScale, IsDrawnWithFiveValues) {
  plot::Svg svg(100, 200);
  draw(plot::LinearColourScale(-4, 4, plot::LinearColourScale::Palette::Diverging), {{10, 10}, 20, 180}, svg);
  const auto drawn = test::svg_of(svg.str());
  EXPECT_THAT(test::texts(drawn), testing::ElementsAre("-4", "-2", "0", "2", "4"));
  std::vector<double> heights;
  for (const auto& text : test::elements(drawn, "text")) heights.push_back(text.get<double>("<xmlattr>.y"));
  EXPECT_THAT(heights, testing::ElementsAre(194, 149, 104, 59, 14)) << "from below";
}

}  // namespace
