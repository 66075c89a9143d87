#include "renderer/plot/svg.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/svg_reading.h"
#include "tests/support/temporary_folder.h"

namespace {

using plot::Point;
using plot::Svg;

TEST(Svg, EscapesWhatXmlHasNoPlaceFor) {
  Svg svg(100, 50);
  svg.text({1, 2}, "a < b & c > d \"e\" \n\x01 f\u00B0", {});
  EXPECT_EQ(test::texts(test::svg_of(svg.str())), std::vector<std::string>{"a < b & c > d \"e\"    f\u00B0"});
}

TEST(Svg, IsWellFormedWhateverIsInIt) {
  Svg svg(100, 50);
  svg.line({0, 0}, {1, 1}, {"#fff", 2, "3 1"});
  svg.circle({5, 5}, 3, {});
  svg.begin_clip({1, 2}, 3, 4);
  svg.polyline(std::vector<Point>{{0, 0}, {1, 5}, {2, 0}}, {});
  svg.end_clip();
  svg.image({0, 0}, 8, 8, "no image");
  svg.text({1, 2}, "turned", {12, "#000", plot::Anchor::End, -90});
  const test::Element root = test::svg_of(svg.str());
  EXPECT_EQ(root.get<std::string>("<xmlattr>.viewBox"), "0 0 100 50");
  const auto groups = test::elements(root, "g");
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(test::elements(groups[0], "polyline").size(), 1U);
  EXPECT_EQ(groups[0].get<std::string>("<xmlattr>.clip-path"),
            "url(#" + test::elements(root, "clipPath").at(0).get<std::string>("<xmlattr>.id") + ")");
}

double distance_to_segment(const Point& point, const Point& from, const Point& to) {
  const Point along = to - from;
  const double place =
      along.length() == 0 ? 0 : std::clamp(along.dot(point - from) / along.length2(), 0.0, 1.0);
  return (from + along * place - point).length();
}

// Simplification drops points that cannot be seen, and stays within its tolerance plus rounding.
TEST(Svg, SimplifiesLinesToWhatCanBeSeen) {
  std::vector<Point> wave;
  for (int i = 0; i <= 4000; ++i) wave.emplace_back(0.1 * i, 100 + 80 * std::sin(0.02 * i) / (1 + 0.001 * i));
  Svg svg(400, 200);
  svg.polyline(wave, {});
  const auto kept = test::lines(test::svg_of(svg.str())).at(0);
  EXPECT_LT(kept.size(), 600U);
  EXPECT_NEAR((kept.front() - wave.front()).length(), 0, 0.01);
  EXPECT_NEAR((kept.back() - wave.back()).length(), 0, 0.01);
  std::size_t segment = 0;
  for (const Point& point : wave) {
    while (segment + 2 < kept.size() && kept[segment + 1].x < point.x) ++segment;
    EXPECT_LT(distance_to_segment(point, kept[segment], kept[segment + 1]), 0.05 + 0.01);
  }
}

TEST(Svg, KeepsSpikesAndReturnsInLines) {
  Svg svg(400, 200);
  svg.polyline(std::vector<Point>{{0, 0}, {100, 0}, {100.01, 150}, {100.02, 0}, {200, 0}}, {});
  svg.polyline(std::vector<Point>{{0, 0}, {50, 0}, {0, 0}}, {});
  svg.polyline(std::vector<Point>{{0, 0}, {50, 0}, {10, 0}}, {});
  svg.polyline(std::vector<Point>{{0, 0}, {10, 0}, {20, 0}, {30, 0}}, {});
  const auto lines = test::lines(test::svg_of(svg.str()));
  EXPECT_EQ(lines.at(0).size(), 5U);
  EXPECT_EQ(lines.at(1).size(), 3U);
  EXPECT_EQ(lines.at(2).size(), 3U) << "the way out and back is longer than from end to end";
  EXPECT_EQ(lines.at(3).size(), 2U);
}

TEST(Svg, DrawsDotsInOneElement) {
  Svg svg(100, 50);
  svg.dots(std::vector<Point>{{1, 2}, {30.25, 4}}, 1.5, "#d55e00");
  svg.dots({}, 1, "#000");
  svg.rectangle({1, 2}, 3, 4, "#abcdef");
  const test::Element root = test::svg_of(svg.str());
  const auto paths = test::elements(root, "path");
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].get<std::string>("<xmlattr>.d"), "M1.0 2.0h0M30.2 4.0h0");
  EXPECT_EQ(paths[0].get<double>("<xmlattr>.stroke-width"), 3);
  EXPECT_EQ(test::elements(root, "rect").at(1).get<std::string>("<xmlattr>.fill"), "#abcdef");
}

TEST(Picture, IsWrittenAsItsNameSays) {
  const test::TemporaryFolder folder;
  Svg svg(30, 20);
  svg.line({0, 0}, {30, 20}, {});
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(write_picture(svg, folder.path("a.svg"), diagnostics));
  EXPECT_TRUE(write_picture(svg, folder.path("a.PNG"), diagnostics));
  EXPECT_EQ(diagnostics.to_text(), "");
  EXPECT_EQ(test::bytes_of(folder.path("a.svg")), svg.str());
  EXPECT_TRUE(test::bytes_of(folder.path("a.PNG")).starts_with("\x89PNG"));
  EXPECT_FALSE(write_picture(svg, folder.path("a.gif"), diagnostics));
  EXPECT_FALSE(write_picture(svg, folder.path("a"), diagnostics));
  EXPECT_FALSE(write_picture(svg, folder.path("none/a.svg"), diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 3U);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.PNG", "a.svg"}));
}

// Greys are those of the editor's dark theme, and colours keep their meaning.
TEST(Svg, IsDrawnOnDarkPaper) {
  Svg svg(100, 50, plot::Paper::Dark);
  svg.text({1, 2}, "black", {12, "#000", plot::Anchor::Start, 0});
  svg.line({0, 0}, {1, 1}, {"#0072b2", 2});
  svg.rectangle({0, 0}, 5, 5, "#081d58");
  svg.rectangle({0, 0}, 5, 5, "#fff");
  svg.line({0, 0}, {1, 1}, {"none", 2});
  const test::Element root = test::svg_of(svg.str());
  const auto rectangles = test::elements(root, "rect");
  ASSERT_EQ(rectangles.size(), 3U);
  EXPECT_EQ(rectangles[0].get<std::string>("<xmlattr>.fill"), "#1f2124");
  EXPECT_EQ(rectangles[1].get<std::string>("<xmlattr>.fill"), "#081d58") << "a colour map means what it says";
  EXPECT_EQ(rectangles[2].get<std::string>("<xmlattr>.fill"), "#1f2124");
  EXPECT_EQ(test::elements(root, "text").at(0).get<std::string>("<xmlattr>.fill"), "#ededed");
  const auto lines = test::elements(root, "line");
  EXPECT_NE(lines.at(0).get<std::string>("<xmlattr>.stroke"), "#0072b2") << "too dark for a line";
  EXPECT_EQ(lines.at(1).get<std::string>("<xmlattr>.stroke"), "none");
  EXPECT_EQ(test::elements(test::svg_of(Svg(1, 1).str()), "rect").at(0).get<std::string>("<xmlattr>.fill"),
            "#fff");
}

TEST(Svg, ParsesHexadecimalColours) {
  EXPECT_EQ(plot::colour_of("#f80"), grf::Colour(1, 136 / 255.0F, 0));
  EXPECT_EQ(plot::colour_of("#336699"), grf::Colour(51 / 255.0F, 102 / 255.0F, 153 / 255.0F));
  for (const char* other : {"", "#", "#12", "#1234", "#12345g", "red", "#-12", "112233"})
    EXPECT_FALSE(plot::colour_of(other)) << other;
}

// A disc of half the picture's width, clipped at the middle, leaves a known part of the pixels dark.
TEST(Svg, IsRenderedToABitmap) {
  Svg svg(40, 20);
  svg.begin_clip({20, 10}, 5);
  svg.rectangle({0, 0}, 40, 10, "#000");
  svg.end_clip();
  const auto bitmap = plot::to_bitmap(svg.str(), 2);
  ASSERT_TRUE(bitmap);
  EXPECT_EQ(bitmap->width, 80);
  EXPECT_EQ(bitmap->height, 40);
  ASSERT_EQ(bitmap->pixels.size(), 3200U);
  double dark = 0;
  for (const std::uint32_t pixel : bitmap->pixels) {
    EXPECT_EQ(pixel >> 24U, 0xffU);
    dark += 1 - (pixel & 0xffU) / 255.0;
  }
  EXPECT_NEAR(dark, 3.14159 * 10 * 10 / 2, 2) << "half of a circle of 10 pixels";
  EXPECT_FALSE(plot::to_bitmap("no picture", 1));
  EXPECT_FALSE(plot::to_pdf("no picture"));
}

}  // namespace
