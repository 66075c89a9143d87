// Cumulative distribution curves, plain and compressed, and the tables made of them.
#include <cmath>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "grf/read.h"
#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/reflector.h"
#include "renderer/reflectance/scheme.h"
#include "renderer/reflectance/schemes/cumulative.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/degenerate_brdfs.h"
#include "tests/reflectance/scheme_cases.h"

namespace {

using reflectance::Brdf;
using reflectance::CascadeTables;
using reflectance::CdfPosition;
using reflectance::cumulative;
using reflectance::DirectionGrid;
using reflectance::inverted;
using reflectance::Vec3f;

TEST(Cumulative, RisesFromZeroToOne) {
  const std::vector<double> masses = {1, 3, 0, 4};
  EXPECT_EQ(cumulative(masses), (std::vector<float>{0, 0.125F, 0.5F, 0.5F, 1}));
  const std::vector<double> none = {0, 0, 0, 0};
  EXPECT_EQ(cumulative(none), (std::vector<float>{0, 0.25F, 0.5F, 0.75F, 1}));
}

TEST(Cumulative, KeepsEmptyCellsEmptyAtTheEnd) {
  const std::vector<double> masses = {1.0 / 3, 1.0 / 7, 1e-9, 0, 0};
  const std::vector<float> curve = cumulative(masses);
  EXPECT_EQ(curve[3], 1);
  EXPECT_EQ(curve[4], 1);
  EXPECT_LT(inverted(curve, 0x1.fffffep-1F).cell, 3U);
}

TEST(Inversion, TakesACurvesValueBackToItsPlace) {
  const std::vector<double> masses = {0, 2, 0, 0, 1, 5, 0};
  const std::vector<float> curve = cumulative(masses);
  float before = -1;
  for (int i = 0; i < 1000; ++i) {
    const float xi = static_cast<float>(i) / 1000;
    const CdfPosition place = inverted(curve, xi);
    ASSERT_GT(masses[place.cell], 0);
    ASSERT_GE(place.fraction, 0);
    ASSERT_LE(place.fraction, 1);
    ASSERT_NEAR(curve[place.cell] + place.fraction * (curve[place.cell + 1] - curve[place.cell]), xi, 1e-6);
    const float at = static_cast<float>(place.cell) + place.fraction;
    ASSERT_GT(at, before);
    before = at;
  }
}

TEST(Simplification, StaysWithinItsTolerance) {
  std::vector<float> x;
  std::vector<float> y;
  for (int i = 0; i <= 500; ++i) {
    x.push_back(static_cast<float>(i * i));
    y.push_back(0.5F + std::atan(static_cast<float>(i - 200) * 0.03F) / reflectance::Pi);
  }
  std::size_t before = x.size() + 1;
  for (const float tolerance : {0.0001F, 0.001F, 0.01F, 0.1F}) {
    const auto kept = reflectance::simplified(x, y, tolerance);
    EXPECT_EQ(kept.front(), 0);
    EXPECT_EQ(kept.back(), 500);
    EXPECT_LT(kept.size(), before);
    before = kept.size();
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
      ASSERT_LT(kept[i], kept[i + 1]);
      for (std::size_t k = kept[i]; k <= kept[i + 1]; ++k) {
        const float share = (x[k] - x[kept[i]]) / (x[kept[i + 1]] - x[kept[i]]);
        ASSERT_NEAR(y[k], y[kept[i]] + share * (y[kept[i + 1]] - y[kept[i]]), tolerance * 1.001F);
      }
    }
  }
}

TEST(Simplification, OfALineIsItsEnds) {
  const std::vector<float> line = {0, 0.25F, 0.5F, 0.75F, 1};
  EXPECT_EQ(reflectance::simplified(line, line, 1e-6F), (std::vector<std::uint16_t>{0, 4}));
}

TEST(DirectionGrid, FindsTheCellOfADirectionThatItMade) {
  for (const std::size_t rows : {1, 7, 32, 4096}) {
    const DirectionGrid grid(rows, 12);
    double sum = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < 12; ++column) {
        const Vec3f w = grid.direction(row, row + 1, 0.5F, static_cast<float>(column) + 0.5F);
        ASSERT_EQ(grid.row_of(w), row);
        ASSERT_EQ(grid.column_of(w), column);
        sum += grid.solid_angle(row, row + 1, 1);
      }
    }
    EXPECT_NEAR(sum, 2 * reflectance::Pi, 1e-4);
  }
}

double mass_over_half_vectors(const CascadeTables& tables, const Vec3f& u) {
  const DirectionGrid grid(64, 64);  // divides all cells
  double mass = 0;
  for (std::size_t i = 0; i < 64 * 64; ++i) {
    const Vec3f h = grid.direction(i / 64, i / 64 + 1, 0.5F, static_cast<float>(i % 64) + 0.5F);
    mass += tables.half_pdf(u, h) * grid.solid_angle(i / 64, i / 64 + 1, 1);
  }
  return mass;
}

TEST(CascadeTables, HaveDensitiesWhoseIntegralIsOne) {
  for (const std::string brdf :
       {"ward sx=0.15 sy=0.4 ks=0.6 kd=0.3", "lewis n=100 ks=1 kd=0", "diffuse kd=0"}) {
    for (const bool compress : {false, true}) {
      const CascadeTables tables(test::brdf_of(brdf), {32, 16}, compress);
      for (const double angle : {0.0, 30.0, 89.9}) {
        EXPECT_NEAR(mass_over_half_vectors(tables, test::direction(angle, 0)), 1, 1e-4) << brdf << angle;
      }
    }
  }
}

TEST(CascadeTables, AreMuchSmallerCompressed) {
  // With doubles and 16 view azimuths, the thesis' tables of this size take 33,792 KB.
  for (const std::string brdf : {"diffuse kd=1", "ward sx=0.2 ks=0.5 kd=0.5", "lewis n=100 ks=1 kd=0",
                                 "table of torrance rough=0.3"}) {
    const CascadeTables plain(test::brdf_of(brdf), {256, 32}, false);
    const CascadeTables compressed(test::brdf_of(brdf), {256, 32}, true);
    EXPECT_GT(plain.bytes(), 32 * 256 * 33 * sizeof(float));
    EXPECT_LT(plain.bytes(), 1200U << 10U);
    EXPECT_LT(compressed.bytes(), plain.bytes() / 5) << brdf;
    RecordProperty(brdf, static_cast<int>(compressed.bytes()));
  }
}

/// Returns the mean over directions of |p - q| for the pdfs of plain and compressed tables.
double difference(const CascadeTables& a, const CascadeTables& b, const Vec3f& u) {
  double sum = 0;
  constexpr std::uint32_t Count = 20000;
  for (std::uint32_t i = 0; i < Count; ++i) {
    const Vec3f h = a.half_vector(u, reflectance::halton_point(i).direction);
    sum += std::abs(1 - b.half_pdf(u, h) / a.half_pdf(u, h));
  }
  return sum / Count;
}

TEST(CascadeTables, AreNearlyTheSameCompressed) {
  for (const std::string brdf : {"diffuse kd=1", "ward sx=0.2 ks=0.5 kd=0.5", "lewis n=100 ks=1 kd=0"}) {
    const CascadeTables plain(test::brdf_of(brdf), {128, 32}, false);
    const CascadeTables compressed(test::brdf_of(brdf), {128, 32}, true);
    for (const double angle : {10.0, 45.0, 80.0}) {
      EXPECT_LT(difference(plain, compressed, test::direction(angle, 33)), 0.15) << brdf << angle;
    }
  }
}

TEST(CascadeTables, AreTheSameOnAnyNumberOfThreads) {
  const Brdf brdf = test::brdf_of("ward sx=0.15 sy=0.4 ks=0.6 kd=0.3");
  for (const bool compress : {false, true}) {
    const CascadeTables on_many(brdf, {16, 8}, compress);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(CascadeTables(brdf, {16, 8}, compress), on_many);
  }
}

TEST(CascadeScheme, IsDefinedForDegenerateBrdfs) {
  for (const std::string scheme : {"cascadeCDF nTh=1 nPh=1", "cascadeCDF nTh=1 nPh=1 compress=true",
                                   "cascadeCDF nTh=4096 nPh=2 compress=true", "cascadeCDF nTh=2 nPh=512"}) {
    test::expect_defined_for_degenerate_brdfs(scheme);
  }
}

TEST(CascadeScheme, WantsWholeNumbersAndNotTooMany) {
  reflectance::CascadeScheme scheme;
  EXPECT_EQ(scheme.validate(), "");
  grf::Diagnostics diagnostics;
  const auto model = grf::read_pdf("cascadeCDF nPh=10.5", "argument", diagnostics);
  EXPECT_FALSE(check(*model, reflectance::scheme_infos(), "PDF", diagnostics));
  EXPECT_NE(diagnostics.to_text().find("10.5 is not whole"), std::string::npos) << diagnostics.to_text();
  scheme.theta_count = scheme.phi_count = 1024;
  EXPECT_NE(scheme.validate(), "");
}

}  // namespace
