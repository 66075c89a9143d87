// Non-negative factorisations, their lobes, and their files.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "grf/read.h"
#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/reflector.h"
#include "renderer/reflectance/scheme.h"
#include "renderer/reflectance/schemes/nonnegative_factors.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/degenerate_brdfs.h"
#include "tests/reflectance/scheme_cases.h"
#include "tests/support/temporary_folder.h"

namespace {

using Eigen::MatrixXd;
using reflectance::Brdf;
using reflectance::divergence;
using reflectance::FactoredScheme;
using reflectance::FactorFiles;
using reflectance::factorised;
using reflectance::Factors;
using reflectance::FactorSize;
using reflectance::NonnegativeFactors;
using reflectance::Vec3f;

MatrixXd product(const NonnegativeFactors& factors) { return factors.left.transpose() * factors.right; }

/// Returns a matrix of that rank without zeros.
MatrixXd matrix_of_rank(int rank) {
  MatrixXd left(rank, 20);
  MatrixXd right(rank, 30);
  for (int k = 0; k < rank; ++k) {
    for (int i = 0; i < 20; ++i) left(k, i) = 1.1 + std::sin(i * (k + 1) * 0.7);
    for (int i = 0; i < 30; ++i) right(k, i) = 1.1 + std::cos(i * (k + 2) * 0.4);
  }
  return left.transpose() * right;
}

TEST(NonnegativeFactors, OfRankOneAreExact) {
  const MatrixXd y = matrix_of_rank(1);
  EXPECT_LT((product(factorised(y, 1)) - y).cwiseAbs().maxCoeff(), 1e-12 * y.maxCoeff());
}

TEST(NonnegativeFactors, ComeNearAMatrixOfTheirRank) {
  const MatrixXd y = matrix_of_rank(3);
  double before = HUGE_VAL;
  for (int rank = 1; rank <= 3; ++rank) {
    const double now = divergence(y, factorised(y, rank));
    EXPECT_LT(now, 0.6 * before) << rank;
    before = now;
  }
  EXPECT_LT(before, 1e-2 * y.sum());
}

TEST(NonnegativeFactors, KeepSums) {
  const MatrixXd y = matrix_of_rank(4);
  const MatrixXd q = product(factorised(y, 2));
  EXPECT_GE(q.minCoeff(), 0);
  EXPECT_LT((q.rowwise().sum() - y.rowwise().sum()).cwiseAbs().maxCoeff(), 1e-9 * y.sum());
}

TEST(NonnegativeFactors, AreZeroWhereTheMatrixIs) {
  EXPECT_EQ(product(factorised(MatrixXd::Zero(5, 6), 2)), MatrixXd::Zero(5, 6));
  MatrixXd spike = MatrixXd::Zero(5, 6);
  spike(2, 3) = 1;
  EXPECT_LT((product(factorised(spike, 2)) - spike).cwiseAbs().maxCoeff(), 1e-12);
}

/// Makes two lobes over two rows and a column of cells: the first fills the upper row, the second the lower.
Factors of_two_rows(std::size_t view_angles, std::size_t view_azimuths, std::vector<float> weights) {
  return {
      {view_angles, view_azimuths, 2, 1, 2, 1, false}, std::move(weights), {0, 1, 1, 0, 1, 0, 0, 1, 0, 1}};
}

/// Returns the first lobe's fraction of a view's light, from the pdf in its row.
double first_fraction(const Factors& factors, const Vec3f& u) {
  const double solid_angle = 2 * M_PI * (1 - std::sqrt(0.5));
  const double even = Factors::Floor / (2 * M_PI);
  return (factors.pdf(u, Vec3f(0.1F, 0, std::sqrt(0.99F))) - even) * solid_angle / (1 - Factors::Floor);
}

TEST(Factors, AreInterpolatedBetweenTheAnglesOfViews) {
  const Factors factors = of_two_rows(2, 1, {1, 0, 0, 1});  // at 22.5 and 67.5 degrees
  for (const double degrees : {0.0, 10.0, 22.5, 30.0, 45.0, 60.0, 67.5, 80.0}) {
    const double angle = degrees * M_PI / 180;
    const Vec3f u(0, static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)));
    EXPECT_NEAR(first_fraction(factors, u), 1 - std::clamp((degrees - 22.5) / 45, 0.0, 1.0), 1e-5) << degrees;
  }
}

TEST(Factors, AreInterpolatedAroundTheAzimuthsOfViews) {
  const Factors factors =
      of_two_rows(1, 4, {1, 0, 0.75F, 0.25F, 0, 1, 0.5F, 0.5F});  // at 45, 135, 225 and 315
  const std::vector<std::pair<double, double>> expected = {
      {45, 1},          {90, 0.875}, {120, 0.75 + 0.25 / 6},    {180, 0.375}, {225, 0},
      {300, 0.5 / 1.2}, {0, 0.75},   {350, 0.5 + 0.5 * 35 / 90}};
  for (const auto& [degrees, share] : expected) {
    const double angle = degrees * M_PI / 180;
    const Vec3f u(static_cast<float>(0.6 * std::cos(angle)), static_cast<float>(0.6 * std::sin(angle)), 0.8F);
    EXPECT_NEAR(first_fraction(factors, u), share, 1e-5) << degrees;
  }
}

FactorSize size_of(std::size_t j, std::size_t k, bool by_half) { return {8, 1, 32, 16, j, k, by_half}; }

/// Returns the mean of |p - f cos / albedo| over directions, 0 to 2.
double error_of(const std::string& brdf_text, const FactorSize& size) {
  const Brdf brdf = test::brdf_of(brdf_text);
  FactoredScheme scheme;
  scheme.by_half = size.by_half;
  scheme.factors = std::make_shared<const Factors>(Factors::make(brdf, size));
  double error = 0;
  for (const double angle : {5.0, 40.0, 75.0}) {
    const Vec3f u = test::direction(angle, 25);
    std::vector<std::pair<double, double>> values;
    double albedo = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
      const Vec3f v = reflectance::uniform_direction(reflectance::halton_point(i).direction);
      values.emplace_back(scheme.pdf(brdf, u, v), reflectance::mean(evaluate(brdf, u, v)) * v.z);
      albedo += values.back().second * 2 * reflectance::Pi / 20000;
    }
    for (const auto& [p, value] : values) error += std::abs(p - value / albedo) * 2 * reflectance::Pi / 60000;
  }
  return error;
}

TEST(Factors, ReproduceABrdfThatIsAProduct) {
  // The uniform floor and the size of the cells remain.
  EXPECT_LT(error_of("diffuse kd=0.8", size_of(1, 1, false)), 0.05);
  EXPECT_LT(error_of("minnaert k=2 kd=1", size_of(1, 1, false)), 0.05);
}

TEST(Factors, ComeNearerWithMoreOfThem) {
  // The lobe moves with u, so J counts; at each position it is not a product, so K counts.
  const std::string brdf = "lewis n=10 ks=1 kd=0";
  const double one = error_of(brdf, size_of(1, 1, false));
  const double of_views = error_of(brdf, size_of(4, 1, false));
  const double of_both = error_of(brdf, size_of(4, 3, false));
  EXPECT_LT(of_views, 0.8 * one);
  EXPECT_LT(of_both, 0.95 * of_views);
  EXPECT_LT(error_of(brdf, size_of(2, 2, true)), error_of(brdf, size_of(2, 2, false)));
}

TEST(Factors, HaveDensitiesWhoseIntegralIsOne) {
  for (const std::string brdf : {"ward sx=0.2 ks=0.5 kd=0.5", "diffuse kd=0"}) {
    const Factors factors = Factors::make(test::brdf_of(brdf), size_of(3, 2, false));
    const reflectance::DirectionGrid grid(32, 16);
    for (const double angle : {0.0, 30.0, 89.9}) {
      double mass = 0;
      for (std::size_t i = 0; i < 32 * 16; ++i) {
        const Vec3f w = grid.direction(i / 16, i / 16 + 1, 0.5F, static_cast<float>(i % 16) + 0.5F);
        mass += factors.pdf(test::direction(angle, 0), w) * grid.solid_angle(i / 16, i / 16 + 1, 1);
      }
      EXPECT_NEAR(mass, 1, 1e-5) << brdf << angle;
    }
  }
}

TEST(Factors, AreTheSameOnAnyNumberOfThreads) {
  const Brdf brdf = test::brdf_of("ward sx=0.15 sy=0.4 ks=0.6 kd=0.3");
  const FactorSize size = {8, 4, 16, 8, 3, 2, true};
  const Factors on_many = Factors::make(brdf, size);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(Factors::make(brdf, size), on_many);
}

TEST(FactoredScheme, IsDefinedForDegenerateBrdfs) {
  for (const std::string scheme :
       {"factored uTh=1 uPh=1 pTh=1 pPh=1 J=1 K=1", "factored J=8 K=8 half=true", "factored"}) {
    test::expect_defined_for_degenerate_brdfs(scheme);
  }
}

TEST(FactoredScheme, WantsWholeNumbersAndNotTooMany) {
  FactoredScheme scheme;
  EXPECT_EQ(scheme.validate(), "");
  grf::Diagnostics diagnostics;
  const auto model = grf::read_pdf("factored pTh=10.5", "argument", diagnostics);
  EXPECT_FALSE(check(*model, reflectance::scheme_infos(), "PDF", diagnostics));
  EXPECT_NE(diagnostics.to_text().find("10.5 is not whole"), std::string::npos) << diagnostics.to_text();
  scheme.rows = scheme.columns = scheme.view_angles = 256;
  scheme.view_azimuths = 2;
  EXPECT_NE(scheme.validate(), "");
}

class Files : public testing::Test {
 protected:
  Files() { EXPECT_TRUE(files_.save(factors_, diagnostics_)) << diagnostics_.to_text(); }

  /// Expects that loading fails with one error, which it returns.
  grf::Diagnostic failure(const FactorFiles& files) {
    grf::Diagnostics diagnostics;
    EXPECT_FALSE(files.load(diagnostics));
    EXPECT_EQ(diagnostics.entries().size(), 1);
    return diagnostics.entries().empty() ? grf::Diagnostic() : diagnostics.entries().front();
  }
  grf::Diagnostic failure() { return failure(files_); }

  void replace(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  }

  /// Replaces the first numbers of a line.
  void change_line(const std::string& path, int line, const std::string& start) {
    std::string bytes = test::bytes_of(path);
    std::size_t begin = 0;
    for (int i = 1; i < line; ++i) begin = bytes.find('\n', begin) + 1;
    replace(path, bytes.replace(begin, bytes.find_first_of(" \n", begin) - begin, start));
  }

  test::TemporaryFolder folder_;
  Brdf brdf_ = test::brdf_of("ward sx=0.2 ks=0.5 kd=0.5");
  FactorSize size_ = {4, 1, 8, 6, 2, 2, true};
  Factors factors_ = Factors::make(brdf_, size_);
  FactorFiles files_ = {folder_.path("ward"), "1 ward sx=0.2 ks=0.5 kd=0.5", size_};
  grf::Diagnostics diagnostics_;
};

TEST_F(Files, GiveBackWhatWasWritten) {
  const auto loaded = files_.load(diagnostics_);
  ASSERT_TRUE(loaded) << diagnostics_.to_text();
  EXPECT_EQ(*loaded, factors_);
}

TEST_F(Files, AreOfOneBrdfAndSize) {
  FactorFiles others = files_;
  others.brdf_identity = "1 ward sx=0.3";
  EXPECT_EQ(failure(others).location.line, 2U);
  EXPECT_EQ(failure(others).message, "expected 'brdf 1 ward sx=0.3'");
  others = files_;
  others.size.view_factors = 3;
  EXPECT_EQ(failure(others).location.line, 3U);
}

TEST_F(Files, AreBothNeeded) {
  std::filesystem::remove(files_.curves_path());
  EXPECT_TRUE(files_.exist());
  EXPECT_EQ(failure().location.file->path, files_.curves_path());
}

TEST_F(Files, HaveNumbersThatMakeSense) {
  const std::string weights = test::bytes_of(files_.weights_path());
  for (const std::string number : {"nan", "inf", "-1", "-0", "1e99", "1.5", "x", "0x1", "", "1.0.0"}) {
    replace(files_.weights_path(), weights);
    change_line(files_.weights_path(), 5, number);
    EXPECT_EQ(failure().location.line, 5U) << number;
  }
  replace(files_.weights_path(), weights);
  change_line(files_.curves_path(), 4, "0.5");
  EXPECT_EQ(failure().location.line, 4U);
  EXPECT_EQ(failure().location.file->path, files_.curves_path());
  change_line(files_.curves_path(), 4, "0 0");
  EXPECT_NE(failure().message.find("there are more"), std::string::npos) << failure().message;
}

TEST_F(Files, ThatAreCutAreRefusedWhereverTheyAre) {
  for (const std::string& path : {files_.weights_path(), files_.curves_path()}) {
    const std::string whole = test::bytes_of(path);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      replace(path, whole.substr(0, length));
      ASSERT_GE(failure().location.line, 1U) << length;
    }
    replace(path, whole + "more");
    EXPECT_EQ(failure().message, "unexpected text after the end");
    replace(path, whole);
  }
}

TEST_F(Files, ThatAreGarbledAreRefusedOrHarmless) {
  std::mt19937 random(3);
  for (const std::string& path : {files_.weights_path(), files_.curves_path()}) {
    const std::string whole = test::bytes_of(path);
    for (int i = 0; i < 1000; ++i) {
      std::string bytes = whole;
      for (int k = 0; k <= i % 3; ++k) bytes[random() % bytes.size()] = "0 9-.e\n\0x\xff"[random() % 10];
      replace(path, bytes);
      grf::Diagnostics diagnostics;
      const auto loaded = files_.load(diagnostics);
      ASSERT_EQ(loaded.has_value(), diagnostics.entries().empty()) << diagnostics.to_text();
      if (!loaded) continue;
      for (std::uint32_t n = 0; n < 20; ++n) {
        const Vec3f w = loaded->direction(test::direction(40, 0), reflectance::halton_point(n));
        ASSERT_TRUE(std::isfinite(loaded->pdf(test::direction(40, 0), w)) && w.z >= 0);
      }
    }
    replace(path, whole);
  }
}

TEST_F(Files, AreWrittenByTheFirstAndTakenByTheNext) {
  const std::string name = folder_.path("next");
  FactoredScheme first;
  ASSERT_TRUE(first.use_files(name, brdf_, "1 ward", diagnostics_)) << diagnostics_.to_text();
  EXPECT_TRUE(std::filesystem::exists(name + ".txt") && std::filesystem::exists(name + "_cdf.txt"));
  FactoredScheme next;
  ASSERT_TRUE(next.use_files(name, brdf_, "1 ward", diagnostics_)) << diagnostics_.to_text();
  EXPECT_EQ(*next.given, *first.given);
  next.build(brdf_);
  EXPECT_EQ(next.factors, next.given);
  FactoredScheme other;
  EXPECT_FALSE(other.use_files(name, brdf_, "1 phong", diagnostics_));
  EXPECT_FALSE(other.use_files("/nowhere/at/all", brdf_, "1 ward", diagnostics_));
}

}  // namespace
