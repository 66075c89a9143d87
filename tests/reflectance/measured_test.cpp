// Files of the MERL data base: angles, reading, writing, and interpolation.
#include "renderer/reflectance/measured.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "renderer/reflectance/brdf_maker.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/support/temporary_folder.h"

namespace {

using reflectance::half_angles;
using reflectance::HalfAngles;
using reflectance::MerlTable;
using reflectance::Rgb;
using reflectance::Vec3f;

constexpr std::size_t FileSize = 34'992'012;

MerlTable table_of(const std::string& instance) {
  const reflectance::Brdf brdf = test::brdf_of(instance);
  return MerlTable([&](const Vec3f& u, const Vec3f& v) { return evaluate(brdf, u, v); });
}

/// Returns the message for a file with those bytes.
std::string said_of(const std::string& bytes) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  EXPECT_EQ(MerlTable::load(folder.add("a.binary", bytes), diagnostics), nullptr);
  return diagnostics.entries().at(0).message;
}

std::string header(std::int32_t azimuths) {
  const std::array<std::int32_t, 3> dimensions = {90, 90, azimuths};
  return {reinterpret_cast<const char*>(dimensions.data()), sizeof(dimensions)};
}

TEST(HalfAngles, AreThoseOfTheDirectionsThatTheyGive) {
  for (std::size_t half = 0; half < 90; half += 7) {
    for (std::size_t difference = 0; difference < 90; difference += 8) {
      for (std::size_t azimuth = 0; azimuth < 180; azimuth += 13) {
        const HalfAngles angles = MerlTable::angles_of(half, difference, azimuth);
        const auto [u, v] = directions_of(angles);
        const HalfAngles again = half_angles(u, v);
        ASSERT_NEAR(again.theta_half, angles.theta_half, 1e-12);
        ASSERT_NEAR(again.theta_difference, angles.theta_difference, 1e-12);
        ASSERT_NEAR(again.phi_difference, angles.phi_difference, 1e-9);
      }
    }
  }
}

TEST(HalfAngles, DoNotDependOnTheAzimuthOrOnWhichDirectionIsWhich) {
  const HalfAngles angles = half_angles(test::direction(30, 10), test::direction(70, 140));
  const HalfAngles turned = half_angles(test::direction(30, 100), test::direction(70, 230));
  const HalfAngles swapped = half_angles(test::direction(70, 140), test::direction(30, 10));
  for (const HalfAngles& other : {turned, swapped}) {
    EXPECT_NEAR(other.theta_half, angles.theta_half, 1e-6);
    EXPECT_NEAR(other.theta_difference, angles.theta_difference, 1e-6);
    EXPECT_NEAR(other.phi_difference, angles.phi_difference, 1e-6);
  }
}

TEST(HalfAngles, AreFoundWhereTheyAreNotDefined) {
  const Vec3f up(0, 0, 1);
  const Vec3f grazing = test::direction(89.99, 0);
  for (const auto& [u, v] : {std::pair(up, up), std::pair(grazing, grazing),
                             std::pair(grazing, Vec3f(-grazing.x, 0, grazing.z)), std::pair(up, -up)}) {
    const HalfAngles angles = half_angles(u, v);
    EXPECT_TRUE(std::isfinite(angles.theta_half + angles.theta_difference + angles.phi_difference));
    EXPECT_GE(angles.phi_difference, 0);
  }
}

TEST(MerlTable, HasTheValuesOfTheBrdfAtTheCentresOfCells) {
  const reflectance::Brdf brdf = test::brdf_of("blinn n=30 ks=(0.3, 0.2, 0.1) kd=0.2");
  const MerlTable table = table_of("blinn n=30 ks=(0.3, 0.2, 0.1) kd=0.2");
  for (std::size_t half = 0; half < 60; half += 5) {
    for (std::size_t difference = 0; difference < 25; difference += 4) {
      const HalfAngles angles = MerlTable::angles_of(half, difference, 7);
      const auto [u, v] = directions_of(angles);
      const Rgb expected = evaluate(brdf, Vec3f(u), Vec3f(v));
      EXPECT_NEAR(table.nearest(angles).x, expected.x, 1e-6);
      EXPECT_NEAR(table.linear(angles).y, expected.y, 1e-5);
    }
  }
}

/// Returns invariants of a pair of directions under common rotation, which differ for other pairs, mirror
/// images, and swapped ones.
Rgb invariants_of(const Vec3f& u, const Vec3f& v) { return {u.z, v.z, 1 + u.x * v.y - u.y * v.x}; }

/// Returns the invariants of a cell's centre, by spherical trigonometry.
Rgb invariants_of_cell(int half, int difference, int azimuth) {
  const double theta_half = M_PI / 2 * std::pow((half + 0.5) / 90, 2);
  const double theta_difference = M_PI / 2 * (difference + 0.5) / 90;
  const double phi = M_PI * (azimuth + 0.5) / 180;
  const double along = std::cos(theta_half) * std::cos(theta_difference);
  const double across = std::sin(theta_half) * std::sin(theta_difference) * std::cos(phi);
  const double turn = std::sin(theta_half) * std::sin(2 * theta_difference) * std::sin(phi);
  return {static_cast<float>(along + across), static_cast<float>(along - across),
          static_cast<float>(1 + turn)};
}

struct CellPlace {
  int half, difference, azimuth;
};
constexpr CellPlace SomeCells[] = {{0, 0, 0},    {1, 0, 0},    {0, 1, 0},    {0, 0, 1},     {40, 20, 5},
                                   {40, 20, 90}, {40, 20, 91}, {40, 21, 90}, {41, 20, 90},  {60, 30, 120},
                                   {30, 50, 60}, {20, 70, 30}, {5, 80, 170}, {55, 35, 100}, {70, 10, 179}};

TEST(MerlTable, IsMadeOfWhatABrdfIsAtEachCellsAngles) {
  const MerlTable table(invariants_of);
  for (const auto& [half, difference, azimuth] : SomeCells) {
    const double share = (half + 0.5) / 90;
    const HalfAngles centre = {M_PI / 2 * share * share, M_PI / 2 * (difference + 0.5) / 90,
                               M_PI * (azimuth + 0.5) / 180};
    const Rgb expected = invariants_of_cell(half, difference, azimuth);
    EXPECT_NEAR((table.nearest(centre) - expected).length(), 0, 1e-5)
        << half << " " << difference << " " << azimuth;
    EXPECT_NEAR((table.linear(centre) - expected).length(), 0, 1e-4)
        << half << " " << difference << " " << azimuth;
  }
}

// Tests index and scales as the data base publishes them.
TEST(MerlTable, IsWrittenInTheOrderOfTheDataBase) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(MerlTable(invariants_of).write(folder.path("a.binary"), diagnostics));
  const std::string bytes = test::bytes_of(folder.path("a.binary"));
  constexpr double ScaleOfChannel[] = {1 / 1500.0, 1.15 / 1500, 1.66 / 1500};
  for (const auto& [half, difference, azimuth] : SomeCells) {
    const Rgb expected = invariants_of_cell(half, difference, azimuth);
    for (int channel = 0; channel < 3; ++channel) {
      const int index = azimuth + 180 * (difference + 90 * half) + 90 * 90 * 180 * channel;
      double value = 0;
      std::memcpy(&value, bytes.data() + 12 + sizeof(value) * static_cast<std::size_t>(index), sizeof(value));
      EXPECT_NEAR(value * ScaleOfChannel[channel], expected[channel], 1e-5)
          << half << " " << difference << " " << azimuth;
    }
  }
}

TEST(MerlTable, IsReadAsItWasWritten) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  const MerlTable table = table_of("oren s=0.4 r=(0.9, 0.5, 0.1)");
  ASSERT_TRUE(table.write(folder.path("a.binary"), diagnostics)) << diagnostics.to_text();
  EXPECT_EQ(std::filesystem::file_size(folder.path("a.binary")), FileSize);
  const auto again = MerlTable::load(folder.path("a.binary"), diagnostics);
  ASSERT_NE(again, nullptr) << diagnostics.to_text();
  for (const test::Pair& pair : test::direction_pairs(2000, 3)) {
    if (pair.u.z <= 0 || pair.v.z <= 0) continue;
    const HalfAngles angles = half_angles(pair.u, pair.v);
    const Rgb expected = table.linear(angles);
    ASSERT_NEAR(again->linear(angles).x, expected.x, 1e-6F * expected.x + 1e-9F);
    ASSERT_NEAR(again->nearest(angles).z, table.nearest(angles).z, 1e-6F);
  }
}

TEST(MerlTable, ScalesTheChannelsAsTheDataBaseDoes) {
  std::string bytes = header(180);
  bytes.resize(FileSize);
  const double value = 1500;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::memcpy(bytes.data() + 12 + 8 * 1'458'000 * channel, &value, sizeof(value));
  }
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  const auto table = MerlTable::load(folder.add("a.binary", bytes), diagnostics);
  ASSERT_NE(table, nullptr);
  const Rgb first = table->nearest({0, 0, 0});
  EXPECT_FLOAT_EQ(first.x, 1);
  EXPECT_FLOAT_EQ(first.y, 1.15F);
  EXPECT_FLOAT_EQ(first.z, 1.66F);
}

TEST(MerlTable, LeavesInvalidCellsOut) {
  // The value exists only where the light is at the left of the view.
  const MerlTable table([](const Vec3f& u, const Vec3f& v) { return v.y < u.y ? Rgb(-1) : Rgb(0.5F); });
  bool found_invalid = false;
  for (const test::Pair& pair : test::direction_pairs(5000, 4)) {
    const HalfAngles angles = half_angles(pair.u, pair.v);
    const Rgb between = table.linear(angles);
    ASSERT_TRUE(between.x == 0 || std::abs(between.x - 0.5F) < 1e-6F) << between;
    found_invalid = found_invalid || table.nearest(angles).x == 0;
  }
  EXPECT_TRUE(found_invalid);
}

TEST(MerlTable, IsContinuousWhereTheAzimuthComesRound) {
  const MerlTable table = table_of("torrance rough=0.4");
  for (const double theta : {0.2, 0.7, 1.1}) {
    EXPECT_NEAR(table.linear({0.3, theta, 0}).x, table.linear({0.3, theta, 3.14159265}).x, 1e-6);
  }
}

TEST(MerlTable, SaysWhatIsWrongWithAFile) {
  EXPECT_NE(said_of("short").find("is not a MERL BRDF file: 5 bytes are too few"), std::string::npos);
  EXPECT_NE(said_of(header(360)).find("its dimensions are 90 x 90 x 360, expected 90 x 90 x 180"),
            std::string::npos);
  EXPECT_NE(said_of(header(180) + "0").find("it has 13 bytes, expected 34992012"), std::string::npos);
  grf::Diagnostics diagnostics;
  EXPECT_EQ(MerlTable::load("/no/such/file", diagnostics), nullptr);
  EXPECT_EQ(MerlTable::load("/dev/zero", diagnostics), nullptr);
  EXPECT_EQ(diagnostics.error_count(), 2U);
}

TEST(MerlTable, TakesValuesThatAreNotFiniteForInvalid) {
  std::string bytes = header(180);
  bytes.resize(FileSize);
  const double value = std::numeric_limits<double>::quiet_NaN();
  std::memcpy(bytes.data() + 12, &value, sizeof(value));
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  const auto table = MerlTable::load(folder.add("a.binary", bytes), diagnostics);
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->nearest({0, 0, 0}), Rgb(0));
}

TEST(Measured, IsNearTheBrdfThatWasTabulated) {
  const reflectance::Brdf brdf = test::brdf_of("blinn n=20 ks=0.3 kd=0.3");
  const reflectance::Brdf table = test::brdf_of("table of blinn n=20 ks=0.3 kd=0.3");
  for (const double theta : {0.0, 20.0, 50.0, 75.0}) {
    for (int phi = 0; phi < 180; phi += 17) {
      const Vec3f u = test::direction(40, 25);
      const Vec3f v = test::direction(theta, phi);
      const float expected = evaluate(brdf, u, v).x;
      EXPECT_NEAR(evaluate(table, u, v).x, expected, 2e-3F * expected);
    }
  }
}

TEST(Measured, IsLoadedOnceForAllThatNameItsFile) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(table_of("diffuse").write(folder.path("a.binary"), diagnostics));
  grf::BrdfModel data;
  data.keyword = "measured";
  data.data_file = folder.path("a.binary");
  grf::BrdfModel other = data;
  other.arguments.push_back({"linear", false, {}});
  reflectance::BrdfMaker maker(diagnostics);
  const auto first = maker.make(data, {});
  const auto second = maker.make(other, {});
  ASSERT_TRUE(first && second) << diagnostics.to_text();
  EXPECT_EQ(std::get<reflectance::Measured>(*first).data, std::get<reflectance::Measured>(*second).data);
  EXPECT_NE(maker.identity(data, {}), maker.identity(other, {}));
}

}  // namespace
