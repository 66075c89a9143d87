#include "renderer/image/visible_difference.h"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "grf/cie_colour.h"

namespace {

using grf::Colour;
using image::Image;
using image::Lab;
using image::Viewing;

struct Pair {
  Lab first;
  Lab second;
  double difference;
};

// Table 1 of Sharma, Wu and Dalal (2005), "The CIEDE2000 color-difference formula".
constexpr std::array<Pair, 34> SharmaPairs = {{
    {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
    {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
    {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
    {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
    {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
    {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
    {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
    {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
    {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
}};

TEST(Ciede2000, HasThePublishedDifferences) {
  for (const auto& [first, second, difference] : SharmaPairs) {
    const auto text = testing::Message() << first.lightness << ' ' << first.a << ' ' << first.b << " and "
                                         << second.lightness << ' ' << second.a << ' ' << second.b;
    EXPECT_NEAR(ciede2000(first, second), difference, 5.1e-5) << text;
    EXPECT_NEAR(ciede2000(second, first), difference, 5.1e-5) << text;
  }
}

// Lindbloom's calculator gives these for sRGB with the white D65.
TEST(Ciede2000, IsOfCielab) {
  const grf::Vec3d white = grf::xyz_of_srgb({1, 1, 1});
  const Lab red = image::lab_of(grf::xyz_of_srgb({1, 0, 0}), white);
  EXPECT_NEAR(red.lightness, 53.2408, 1e-3);
  EXPECT_NEAR(red.a, 80.0925, 2e-3);
  EXPECT_NEAR(red.b, 67.2032, 2e-3);
  const Lab dark = image::lab_of(grf::xyz_of_srgb({0.001, 0.001, 0.001}), white);
  EXPECT_NEAR(dark.lightness, 0.9033, 1e-4) << "903.3 Y below 0.008856";
}

// Zhang and Wandell (1996), table 1, and the opponent colours of Poirson and Wandell (1993).
TEST(VisibleDifference, HasThePublishedFilters) {
  struct Row {
    std::size_t channel;
    std::size_t gaussian;
    double weight;
    double spread;
  };
  constexpr std::array<Row, 7> Table = {{{0, 0, 0.921, 0.0283},
                                         {0, 1, 0.105, 0.133},
                                         {0, 2, -0.108, 4.336},
                                         {1, 0, 0.531, 0.0392},
                                         {1, 1, 0.330, 0.494},
                                         {2, 0, 0.488, 0.0536},
                                         {2, 1, 0.371, 0.386}}};
  for (const Row& row : Table) {
    const auto& gaussian = image::opponent_filters().at(row.channel).gaussians.at(row.gaussian);
    EXPECT_EQ(gaussian.weight, row.weight);
    EXPECT_EQ(gaussian.spread, row.spread);
  }
  const grf::Vec3d of_x = image::opponent_of({1, 0, 0});
  const grf::Vec3d of_y = image::opponent_of({0, 1, 0});
  const grf::Vec3d of_z = image::opponent_of({0, 0, 1});
  EXPECT_EQ(of_x, grf::Vec3d(0.279, -0.449, 0.086));
  EXPECT_EQ(of_y, grf::Vec3d(0.720, 0.290, -0.590));
  EXPECT_EQ(of_z, grf::Vec3d(-0.107, -0.077, 0.501));
}

/// XYZ relative to the white D65 of a colour of CIELAB: the inverse of its definition.
grf::Vec3d xyz_of(const Lab& colour) {
  const grf::Vec3d white = grf::xyz_of_srgb({1, 1, 1});
  const auto inverse = [](double f) { return f > 6.0 / 29 ? f * f * f : 3 * 36.0 / 841 * (f - 4.0 / 29); };
  const double y = (colour.lightness + 16) / 116;
  return {white.x * inverse(y + colour.a / 500), white.y * inverse(y), white.z * inverse(y - colour.b / 200)};
}

/// The amplitude of a wave in the middle of a row of values, relative to one.
double amplitude(const std::vector<double>& values, double cycles_per_pixel) {
  std::complex<double> sum = 0;
  const auto period = static_cast<std::size_t>(std::lround(1 / cycles_per_pixel));
  const std::size_t periods = std::max<std::size_t>(1, 160 / period);
  const std::size_t start = (values.size() - periods * period) / 2;
  for (std::size_t x = start; x < start + periods * period; ++x) {
    sum += values[x] * std::polar(1.0, -2 * std::numbers::pi * cycles_per_pixel * static_cast<double>(x));
  }
  return 2 * std::abs(sum) / static_cast<double>(periods * period);
}

/// A filter's transfer of a frequency in cycles per degree: that of exp(-(r/s)^2) is exp(-(pi s f)^2).
double transfer(const std::vector<std::pair<double, double>>& gaussians, double frequency) {
  double sum = 0;
  double weights = 0;
  for (const auto& [weight, spread] : gaussians) {
    sum += weight * std::exp(-std::pow(std::numbers::pi * spread * frequency, 2));
    weights += weight;
  }
  return sum / weights;
}

// Gratings across and down an image, with the contrast that each channel's filter passes.
TEST(VisibleDifference, PassesGratingsAsTheFiltersDo) {
  const std::array<std::vector<std::pair<double, double>>, 3> filters = {
      {{{0.921, 0.0283}, {0.105, 0.133}, {-0.108, 4.336}},
       {{0.531, 0.0392}, {0.330, 0.494}},
       {{0.488, 0.0536}, {0.371, 0.386}}}};
  constexpr int Length = 2400;
  const Viewing viewing = {0, 40};
  const grf::Vec3d middle(0.5, 0.4, 0.45);
  const grf::Vec3d wave(0.2, -0.2, 0.3);
  for (const int period : {160, 40, 16, 8, 4}) {  // 0.25 to 10 cycles per degree
    for (const bool is_across : {true, false}) {
      Image image{is_across ? Length : 3, is_across ? 3 : Length, {}};
      for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
          const double phase = 2 * std::numbers::pi * (is_across ? x : y) / period;
          image.pixels.emplace_back(middle + wave * std::cos(phase));
        }
      }
      const image::SeenImage seen = image::seen(image, viewing);
      for (int channel = 0; channel < 3; ++channel) {
        std::vector<double> values;
        for (int i = 0; i < Length; ++i) {
          const auto pixel = static_cast<std::size_t>(is_across ? Length + i : 3 * i + 1);
          values.push_back(image::opponent_of(xyz_of(seen[pixel]))[channel]);
        }
        const double before = std::abs(image::opponent_of(grf::xyz_of_srgb(wave))[channel]);
        const double expected = transfer(filters[static_cast<std::size_t>(channel)], 40.0 / period);
        EXPECT_NEAR(amplitude(values, 1.0 / period) / before, expected, 0.01)
            << "channel " << channel << ", period " << period << (is_across ? " across" : " down");
      }
    }
  }
}

Image plain(int width, int height, const Colour& colour) {
  return {width, height, std::vector<Colour>(static_cast<std::size_t>(width * height), colour)};
}

// The filters keep areas of one colour, up to the image's border.
TEST(VisibleDifference, OfPlainImagesIsThatOfTheirColours) {
  const Colour one(0.2F, 0.5F, 0.4F);
  const Colour other(0.25F, 0.5F, 0.4F);
  const grf::Vec3d white = grf::xyz_of_srgb({1, 1, 1});
  const double expected = ciede2000(image::lab_of(grf::xyz_of_srgb(grf::Vec3d(one)), white),
                                    image::lab_of(grf::xyz_of_srgb(grf::Vec3d(other)), white));
  ASSERT_GT(expected, 1);
  const auto differences = visible_differences(seen(plain(70, 30, one), {}), seen(plain(70, 30, other), {}));
  for (const float difference : differences) ASSERT_NEAR(double(difference), expected, 1e-3);
}

TEST(VisibleDifference, IsOfWhatTheScreenShows) {
  const auto difference = [](const Colour& one, const Colour& other, double exposure) {
    const Viewing viewing = {exposure, 40};
    return image::summary_of(
               visible_differences(seen(plain(8, 8, one), viewing), seen(plain(8, 8, other), viewing)))
        .mean;
  };
  EXPECT_EQ(difference(Colour(2), Colour(3), 0), 0) << "both are white";
  EXPECT_GT(difference(Colour(2), Colour(3), -2), 1);
  EXPECT_NEAR(difference(Colour(0.5F), Colour(0.75F), 0), difference(Colour(2), Colour(3), -2), 1e-4);
  EXPECT_EQ(difference(Colour(-1), Colour(0), 0), 0) << "both are black";
}

// The eye sees less of fine noise than of coarse noise, and less from farther away.
TEST(VisibleDifference, IsLessWhereTheEyeBlurs) {
  const auto checkered = [](int size) {
    Image image = plain(128, 128, Colour(0.4F));
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) {
        if ((x / size + y / size) % 2 == 0)
          image.pixels[static_cast<std::size_t>(y * 128 + x)] = Colour(0.5F);
      }
    }
    return image;
  };
  const auto difference = [&](int size, double pixels_per_degree) {
    const Viewing viewing = {0, pixels_per_degree};
    return image::summary_of(visible_differences(seen(checkered(size), viewing),
                                                 seen(plain(128, 128, Colour(0.45F)), viewing)))
        .percentile_95;
  };
  EXPECT_LT(difference(1, 40), 0.5 * difference(8, 40));
  EXPECT_LT(difference(2, 80), 0.5 * difference(2, 20));
}

TEST(VisibleDifference, IsSummarisedByMeanAndPercentile) {
  std::vector<float> values;
  for (int i = 100; i > 0; --i) values.push_back(static_cast<float>(i));
  const image::VisibleDifference summary = image::summary_of(values);
  EXPECT_NEAR(summary.mean, 50.5, 1e-9);
  EXPECT_EQ(summary.percentile_95, 95);
  EXPECT_EQ(image::summary_of({3}).percentile_95, 3);
}

}  // namespace
