// Tables of the MERL data base become files of the RGL data base and tables again, and the other way.
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "renderer/reflectance/measured.h"
#include "renderer/reflectance/rgl_export.h"
#include "renderer/reflectance/scheme.h"
#include "tests/reflectance/brdf_cases.h"

namespace {

using reflectance::HalfAngles;
using reflectance::MerlTable;
using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Vec3f;

reflectance::RglExport rgl_of(const Reflector& reflector) {
  reflectance::RglExportSettings settings;
  settings.largest_error = 0.02;
  return reflectance::export_rgl(reflector, settings);
}

MerlTable merl_of(const Reflector& reflector) {
  return MerlTable([&](const Vec3f& u, const Vec3f& v) { return reflector.evaluate(u, v); });
}

/// Returns the mean difference between the cells of a table and a BRDF, as a fraction of the BRDF's mean,
/// over directions up to 85 degrees from the normal.
double difference_at_cells(const MerlTable& table, const Reflector& reflector) {
  double difference = 0;
  double total = 0;
  for (std::size_t half = 0; half < MerlTable::HalfCount; half += 3) {
    for (std::size_t angle = 1; angle < MerlTable::DifferenceCount; angle += 4) {
      for (std::size_t azimuth = 2; azimuth < MerlTable::AzimuthCount; azimuth += 7) {
        const HalfAngles angles = MerlTable::angles_of(half, angle, azimuth);
        const reflectance::DirectionPair pair = directions_of(angles);
        if (pair.u.z < std::cos(85 * M_PI / 180) || pair.v.z < std::cos(85 * M_PI / 180)) continue;
        // The solid angle of the cell: its rings of h are as wide as their angle's square root is far apart.
        const double weight = std::sqrt(angles.theta_half) * std::sin(angles.theta_half) *
                              std::sin(2 * angles.theta_difference) * pair.v.z;
        const Rgb value = reflector.evaluate(Vec3f(pair.u), Vec3f(pair.v));
        const Rgb apart = table.nearest(angles) - value;
        for (int k = 0; k < 3; ++k) {
          difference += weight * std::abs(double(apart[k]));
          total += weight * double(value[k]);
        }
      }
    }
  }
  return difference / total;
}

// At the centres of cells, a table made of the file has the error of the file alone.
TEST(MerlAndRgl, AgreeFromMerlToRglAndBack) {
  for (const char* model :
       {"table of blinn n=40 ks=0.3 kd=0.3", "table of torrance rough=0.35 ks=0.6 kd=(0.3, 0.2, 0.1)"}) {
    const Reflector merl(test::brdf_of(model), reflectance::OwnScheme());
    const reflectance::RglExport file = rgl_of(merl);
    EXPECT_TRUE(file.is_fine) << model;
    const double difference = difference_at_cells(merl_of(reflectance::reflector_of_rgl(file.bytes)), merl);
    EXPECT_LT(difference, 1.5 * file.error.relative) << model;
    EXPECT_GT(difference, 0) << model << ": the file is no copy";
  }
}

TEST(MerlAndRgl, AgreeFromRglToMerlAndBack) {
  const Reflector rgl(test::brdf_of("rgl matte"), reflectance::OwnScheme());
  const auto table = std::make_shared<const MerlTable>(merl_of(rgl));
  EXPECT_LT(difference_at_cells(*table, rgl), 1e-6) << "the table's cells are the file's values";
  reflectance::Measured measured;
  measured.data = std::make_shared<const reflectance::MeasuredData>(table);
  const Reflector merl(measured, reflectance::OwnScheme());
  const auto value = [&](const Vec3f& u, const Vec3f& v) { return merl.evaluate(u, v); };
  const double of_table = reflectance::interpolation_error(value, rgl).relative;
  const reflectance::RglExport file = rgl_of(merl);
  EXPECT_TRUE(file.is_fine);
  const double difference = difference_at_cells(merl_of(reflectance::reflector_of_rgl(file.bytes)), rgl);
  EXPECT_LT(difference, 1.5 * (file.error.relative + of_table));
}

}  // namespace
