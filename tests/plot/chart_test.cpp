#include "renderer/plot/chart.h"

#include <algorithm>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/svg_reading.h"

namespace {

using plot::Axis;
using plot::Chart;
using plot::PolarChart;
using testing::Contains;
using testing::IsSupersetOf;
using testing::Not;

constexpr plot::Rectangle Whole = {{0, 0}, 400, 300};

template <class AnyChart>
test::Element drawn(const AnyChart& chart) {
  plot::Svg svg(400, 300);
  draw(chart, Whole, svg);
  return test::svg_of(svg.str());
}

Chart chart_of(const Axis& x, const Axis& y, const std::vector<plot::Point>& points) {
  return {"title", x, y, {{{}, points, {}, {}}}};
}

/// Returns the tick labels of a chart's two axes, whose titles are empty.
std::vector<std::string> ticks(const Axis& x, const Axis& y, const std::vector<plot::Point>& points) {
  std::vector<std::string> words = test::texts(drawn(chart_of(x, y, points)));
  std::erase(words, "title");
  std::erase(words, "");
  return words;
}

std::vector<std::string> ticks_of_y(const Axis& y, const std::vector<plot::Point>& points) {
  const std::vector<std::string> words = ticks({"", false, 0, 1, 1}, y, points);
  EXPECT_EQ((std::vector<std::string>(words.begin(), words.begin() + 2)),
            (std::vector<std::string>{"0", "1"}));
  return {words.begin() + 2, words.end()};
}

using Words = std::vector<std::string>;

TEST(Ticks, AreAtNumbersThatPeopleCountIn) {
  const auto between = [](double low, double high) {
    return ticks_of_y({"", false, low, high, 0}, {{0, low}, {1, high}});
  };
  EXPECT_EQ(between(0, 1), (Words{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_EQ(between(0, 2), (Words{"0", "0.5", "1", "1.5", "2"}));
  EXPECT_EQ(between(-90, 90), (Words{"-50", "0", "50"}));
  EXPECT_EQ(between(-0.3, 0.3), (Words{"-0.2", "0", "0.2"})) << "and never -0";
  EXPECT_EQ(between(0, 1234), (Words{"0", "250", "500", "750", "1000"}));
  EXPECT_EQ(between(0, 3e-6), (Words{"0", "1e-6", "2e-6", "3e-6"}));
  EXPECT_EQ(ticks_of_y({"", false, -90, 90, 30}, {{0, 0}}),
            (Words{"-90", "-60", "-30", "0", "30", "60", "90"}));
}

TEST(Ticks, OfALogarithmicAxisAreItsPowersOfTen) {
  const auto between = [](double low, double high) {
    return ticks_of_y({"", true, {}, {}, 0}, {{0, low}, {1, high}});
  };
  EXPECT_EQ(between(0.02, 30), (Words{"0.01", "0.1", "1", "10", "100"}));
  EXPECT_EQ(between(1e-6, 1), (Words{"1e-6", "1e-5", "1e-4", "0.001", "0.01", "0.1", "1"}));
  EXPECT_EQ(between(10, 1e5), (Words{"10", "100", "1000", "1e4", "1e5"}));
  EXPECT_EQ(between(1e-12, 1e12).size(), 7U) << "not all of them";
  EXPECT_THAT(between(1e-12, 1e12), IsSupersetOf({"1e-12", "1", "1e12"}));
}

TEST(Ticks, OfALogarithmicAxisWithOtherEndsAreAtOneTwoAndFive) {
  const auto between = [](double low, double high) {
    return ticks_of_y({"", true, low, high, 0}, {{0, low}, {1, high}});
  };
  EXPECT_EQ(between(2, 50), (Words{"2", "5", "10", "20", "50"}));
  EXPECT_EQ(between(0.5, 1000), (Words{"1", "10", "100", "1000"})) << "as far as there is place";
}

TEST(Chart, HasPlaceForWhatIsNotThere) {
  EXPECT_TRUE(test::lines(drawn(chart_of({}, {"f", true, {}, {}, 0}, {}))).at(0).empty());
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double far = std::numeric_limits<double>::infinity();
  const auto lines = test::lines(
      drawn(chart_of({}, {"f", true, {}, {}, 0}, {{0, 1}, {1, 0}, {2, -1}, {3, none}, {4, far}, {5, 10}})));
  ASSERT_EQ(lines.at(0).size(), 4U) << "only NaN is left out";
  EXPECT_GT(lines.at(0)[1].y, 1000) << "far under the axis";
  EXPECT_EQ(test::lines(drawn(chart_of({}, {}, {{1, 1}, {1, 1}}))).at(0).front(),
            test::lines(drawn(chart_of({}, {}, {{1, 1}}))).at(0).front())
      << "an axis from a value to itself";
}

TEST(Chart, PutsValuesWhereTheTicksSay) {
  const auto at = [](const Axis& y, double value) {
    return test::lines(drawn(chart_of({"", false, 0, 1, 0}, y, {{0.5, value}, {1, value}}))).at(0).at(0);
  };
  const Axis linear = {"", false, 0, 10, 0};
  EXPECT_NEAR((at(linear, 0).y + at(linear, 10).y) / 2, at(linear, 5).y, 0.011);
  const Axis logarithmic = {"", true, 0.1, 1000, 0};
  EXPECT_NEAR((at(logarithmic, 0.1).y + at(logarithmic, 1000).y) / 2, at(logarithmic, 10).y, 0.011);
  EXPECT_GT(at(linear, 0).y, at(linear, 10).y) << "upwards";
}

TEST(Chart, CutsLinesAtItsEnds) {
  const auto svg = drawn(chart_of({"", false, 0, 1, 0}, {"", false, 0, 2, 0}, {{0, 0}, {1, 20}}));
  const auto clips = test::elements(svg, "clipPath");
  ASSERT_EQ(clips.size(), 1U);
  const double top = clips[0].get<double>("rect.<xmlattr>.y");
  EXPECT_LT(test::lines(svg).at(0).back().y, top) << "it goes on where it is not seen, with its own slope";
}

TEST(Chart, FillsAPolygonUnderItsLines) {
  Chart chart = chart_of({"", false, 0, 1, 0}, {"", false, 0, 2, 0}, {{0, 0}, {1, 1}});
  chart.series.push_back({{}, {{0, 0}, {0, 2}, {1, 0}}, "#111"});
  chart.series.back().fill = "#abc";
  chart.series.back().has_line = false;
  plot::Svg svg(400, 300);
  draw(chart, Whole, svg);
  const test::Element root = test::svg_of(svg.str());
  EXPECT_EQ(test::lines(root).size(), 1U) << "no outline";
  std::vector<test::Element> fills = test::elements(root, "path");
  ASSERT_EQ(fills.size(), 1U) << "and no dots";
  EXPECT_EQ(fills[0].get<std::string>("<xmlattr>.fill"), "#abc");
  const plot::Rectangle area = plot::plot_area(chart, Whole);
  EXPECT_EQ(fills[0].get<std::string>("<xmlattr>.d"),
            fmt::format("M{0:.1f} {1:.1f}L{0:.1f} {2:.1f}L{3:.1f} {1:.1f}Z", area.corner.x,
                        area.corner.y + area.height, area.corner.y, area.corner.x + area.width));
  EXPECT_LT(svg.str().find("#abc"), svg.str().find("#0072b2")) << "lines are over it";
}

TEST(Chart, NamesItsLinesWhereThereAreSeveral) {
  Chart chart = chart_of({"", false, 0, 1, 0}, {"", false, 0, 1, 0}, {{0, 0}, {1, 1}});
  chart.series[0].name = "one";
  chart.series.push_back({{}, {{0, 1}, {1, 1}}, "#111", "2 3"});
  EXPECT_THAT(test::texts(drawn(chart)), Not(Contains("one"))) << "a nameless line does not count";
  chart.series.push_back({"two", {{0, 1}, {1, 1}}, {}, {}});
  EXPECT_THAT(test::texts(drawn(chart)), IsSupersetOf({"one", "two"}));
}

TEST(Apart, LeavesWhatHasPlaceAndSpreadsTheRest) {
  EXPECT_EQ(plot::spread_labels({50, 10, 90}, 15, 0, 100), (std::vector<double>{50, 10, 90}));
  EXPECT_EQ(plot::spread_labels({50, 50}, 10, 0, 100), (std::vector<double>{45, 55})) << "on both sides";
  EXPECT_EQ(plot::spread_labels({99, 98, 97}, 10, 0, 100), (std::vector<double>{100, 90, 80}))
      << "not over the end";
  EXPECT_EQ(plot::spread_labels({-5, 3}, 10, 0, 100), (std::vector<double>{0, 10}));
  EXPECT_EQ(plot::spread_labels({5, 5, 5}, 10, 0, 15), (std::vector<double>{0, 10, 20}))
      << "rather out than over";
  EXPECT_TRUE(plot::spread_labels({}, 10, 0, 100).empty());
}

TEST(Chart, PutsNamesBesideTheEndsOfTheirLines) {
  Chart chart = chart_of({"", false, 0, 1, 0}, {"", false, 0, 1, 0}, {{0, 0}, {1, 0.9}});
  chart.has_names_at_ends = true;
  chart.series[0].name = "high";
  chart.series.push_back({"low", {{0, 1}, {1, 0.301}}, {}, {}});
  chart.series.push_back({"lower", {{0, 1}, {0.5, 0.3}}, {}, {}});
  std::map<std::string, double> heights;
  for (const test::Element& text : test::elements(drawn(chart), "text")) {
    heights[text.data()] = text.get<double>("<xmlattr>.y");
  }
  EXPECT_LT(heights.at("high"), heights.at("0.8"));
  EXPECT_GT(heights.at("high"), heights.at("1"));
  EXPECT_LT(heights.at("high"), heights.at("low"));
  EXPECT_GE(heights.at("lower") - heights.at("low"), 14.9);
}

TEST(PolarChart, HasRingsAtRoundDistances) {
  const auto rings = [](double distance) {
    return test::texts(drawn(PolarChart{"", "", "", {{{}, {{0, distance}}, {}, {}}}, {}, {}}));
  };
  EXPECT_THAT(rings(1.22), IsSupersetOf({"0", "0.5", "1", "1.5"}));
  EXPECT_THAT(rings(1.22), Not(Contains("2")));
  EXPECT_THAT(rings(300), IsSupersetOf({"100", "200", "300"}));
  EXPECT_THAT(rings(0), Contains("1")) << "of nothing";
}

TEST(PolarChart, TurnsFromTheVertical) {
  const auto svg = drawn(PolarChart{"", "", "", {{{}, {{0, 1}, {90, 1}, {-90, 1}}, {}, {}}}, {}, {}});
  const auto line = test::lines(svg).at(0);
  const plot::Point centre = (line[1] + line[2]) / 2;
  EXPECT_NEAR(line[0].x, centre.x, 0.02);
  EXPECT_LT(line[0].y, centre.y);
  EXPECT_GT(line[1].x, centre.x);
  EXPECT_NEAR((line[0] - centre).length(), (line[1] - centre).length(), 0.02);
}

TEST(PolarChart, CutsLongLinesWithAWord) {
  PolarChart chart{"", "", "", {{"short", {{0, 1}}, {}, {}}, {"long", {{-1, 80}, {0, 123}, {1, 80}}, {}, {}}},
                   {}, 4};
  const auto svg = drawn(chart);
  EXPECT_THAT(test::texts(svg), IsSupersetOf({"short", "long, to 123", "4"}));
  for (const auto& line : test::lines(svg)) {
    for (const plot::Point& point : line) EXPECT_GT(point.y, 0);
  }
  chart.fractions = {{{}, {{60, 0}, {60, 0.5}}, {}, "5 3"}};
  chart.series = {{"one", {{60, 2}}, {}, {}}, {"two", {{60, 4}}, {}, {}}};
  const auto lines = test::lines(drawn(chart));
  EXPECT_NEAR((lines.at(2).back() - lines.at(0).back()).length(), 0, 0.02) << "half of the outermost ring";
}

}  // namespace
