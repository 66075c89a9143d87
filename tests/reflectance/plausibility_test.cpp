// What a check says of a BRDF's reciprocity, energy, holes and negative values.
#include "renderer/reflectance/plausibility.h"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "renderer/reflectance/measured.h"
#include "renderer/reflectance/rgl_export.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/support/temporary_folder.h"

namespace {

using reflectance::AngleMap;
using reflectance::check_plausibility;
using reflectance::check_values;
using reflectance::CheckedValue;
using reflectance::DataState;
using reflectance::Plausibility;
using reflectance::Rgb;
using reflectance::Vec3f;

double cosine(std::size_t index) { return std::cos(AngleMap::degrees(index) * M_PI / 180); }

// f = cos(theta_u): |x - y| over (x + y)/2, and in the mean, weighted by x y dx dy, 1/15 over 1/6.
TEST(Plausibility, ComparesBothOrdersOfTheDirections) {
  const Plausibility found =
      check_values([](const Vec3f& u, const Vec3f&) { return CheckedValue{Rgb(u.z)}; }, false);
  for (std::size_t view = 0; view < AngleMap::Side; view += 4) {
    for (std::size_t light = 0; light < AngleMap::Side; light += 4) {
      const double expected = 2 * std::abs(cosine(view) - cosine(light)) / (cosine(view) + cosine(light));
      EXPECT_NEAR(found.asymmetry.at(view, light), expected, 1e-5);
    }
  }
  EXPECT_NEAR(found.mean_asymmetry, 0.4, 1e-3);
  EXPECT_FALSE(found.is_reciprocal());
  // The largest of (x - y) x y is at x = 1, y = 1/2.
  const auto& pair = found.worst_pair;
  EXPECT_NEAR(std::max(pair.u.z, pair.v.z), 1, 1e-3);
  EXPECT_NEAR(std::min(pair.u.z, pair.v.z), 0.5, 0.02);
  EXPECT_EQ(pair.value, Rgb(pair.u.z));
  EXPECT_EQ(pair.swapped, Rgb(pair.v.z));
}

// f depends on the azimuth of the view alone, which only an anisotropic check turns.
TEST(Plausibility, TurnsTheViewOfAnisotropicBrdfs) {
  const auto brdf = [](const Vec3f& u, const Vec3f&) { return CheckedValue{Rgb(u.y * u.y)}; };
  EXPECT_FALSE(check_values(brdf, true).is_reciprocal());
  const auto symmetric = [](const Vec3f& u, const Vec3f& v) {
    return CheckedValue{Rgb(u.y * u.y * v.y * v.y)};
  };
  EXPECT_LT(check_values(symmetric, true).mean_asymmetry, 1e-6);
}

// A quarter of the light, weighted by the cosine, comes from below 30 degrees over the horizon.
TEST(Plausibility, CountsWhatIsMissingByTheCosine) {
  const auto brdf = [](const Vec3f& u, const Vec3f&) {
    return CheckedValue{Rgb(1), u.z < 0.5F ? DataState::Missing : DataState::Sound};
  };
  const Plausibility found = check_values(brdf, false);
  EXPECT_NEAR(found.missing_fraction, 0.25, 1e-6);
  EXPECT_EQ(found.missing.at(29, 10), 0);
  EXPECT_EQ(found.missing.at(30, 10), 1);
  EXPECT_EQ(found.negative_fraction, 0);
}

// A table of the MERL format whose cells with a direction below 30 degrees over the horizon are not numbers.
TEST(Plausibility, FindsHolesOfMeasuredData) {
  const reflectance::MerlTable table([](const Vec3f& u, const Vec3f& v) {
    return std::min(u.z, v.z) < 0.5F ? Rgb(std::numeric_limits<float>::quiet_NaN()) : Rgb(0.2F);
  });
  const test::TemporaryFolder folder;
  const std::string path = folder.add("holes.binary", "");
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(table.write(path, diagnostics));
  reflectance::Measured measured;
  measured.data =
      std::make_shared<reflectance::MeasuredData>(reflectance::MerlTable::load(path, diagnostics));
  const Plausibility found = check_plausibility(measured);
  EXPECT_NEAR(found.missing_fraction, 1 - 0.75 * 0.75, 0.01);
  EXPECT_EQ(found.negative_fraction, 0);
  EXPECT_TRUE(found.is_reciprocal());
}

// A file of the RGL data base whose red is negative everywhere.
TEST(Plausibility, FindsNegativeValuesOfMeasuredData) {
  const reflectance::Reflector diffuse(test::brdf_of("diffuse kd=0.5"), reflectance::Scheme());
  reflectance::RglExportSettings settings;
  settings.resolution = 0.5;
  settings.colour = Rgb(-1, 1, 1);
  const reflectance::Reflector file =
      reflectance::reflector_of_rgl(reflectance::export_rgl(diffuse, settings).bytes);
  EXPECT_EQ(check_plausibility(file.brdf()).negative_fraction, 1);
  settings.colour = Rgb(1);
  const reflectance::Reflector sound =
      reflectance::reflector_of_rgl(reflectance::export_rgl(diffuse, settings).bytes);
  // Such files continue f cos below the horizon as an odd function: some of the coarse cells at it are
  // negative.
  EXPECT_LT(check_plausibility(sound.brdf()).negative_fraction, 0.01);
}

TEST(Plausibility, HasNothingAgainstALambertian) {
  const Plausibility found = check_plausibility(test::brdf_of("diffuse kd=0.5"));
  EXPECT_EQ(found.mean_asymmetry, 0);
  EXPECT_TRUE(found.is_reciprocal());
  EXPECT_TRUE(found.conserves_energy());
  EXPECT_NEAR(found.largest_albedo.albedo, 0.5, 1e-3);
  EXPECT_EQ(found.missing_fraction, 0);
}

}  // namespace
