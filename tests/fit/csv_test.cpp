#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/fit/observations.h"
#include "tests/support/temporary_folder.h"

namespace {

using fit::Observations;
using testing::EndsWith;
using testing::HasSubstr;

class CsvData : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  grf::Diagnostics diagnostics_;

  std::optional<Observations> read(const std::string& text) {
    return fit::read_csv(folder_.add("data.csv", text), diagnostics_);
  }
  std::optional<Observations> read_usable(const std::string& text) {
    const auto all = read(text);
    return all ? fit::usable(*all, folder_.path("data.csv"), diagnostics_) : std::nullopt;
  }
  /// Expects one error at a line and column, with a text in it.
  void expect_error(const std::string& text, const std::string& place, const std::string& message) {
    diagnostics_ = {};
    EXPECT_FALSE(read(text));
    EXPECT_EQ(diagnostics_.error_count(), 1U);
    EXPECT_THAT(diagnostics_.to_text(), HasSubstr("data.csv" + place + " error: ")) << text;
    EXPECT_THAT(diagnostics_.to_text(), HasSubstr(message)) << text;
  }
};

constexpr const char* Header = "theta_u,phi_u,theta_v,phi_v,r,g,b\n";

TEST_F(CsvData, AnglesAreInRadians) {
  const auto data =
      read("# measured by hand\n" + std::string(Header) + "0.5, 0, 1, 3.141592653589793, 1, 2, 3\n");
  ASSERT_TRUE(data) << diagnostics_.to_text();
  ASSERT_EQ(data->list.size(), 1U);
  const fit::Observation& one = data->list[0];
  EXPECT_NEAR(one.u.x, 0.479425538604203, 1e-12);
  EXPECT_NEAR(one.u.z, 0.877582561890373, 1e-12);
  EXPECT_NEAR(one.v.x, -0.841470984807897, 1e-12);
  EXPECT_NEAR(one.v.y, 0, 1e-12);
  EXPECT_EQ(one.value, grf::Vec3d(1, 2, 3));
  EXPECT_EQ(one.line, 3U);
}

TEST_F(CsvData, ColumnsHaveAnyOrderAndLineEnds) {
  const auto data = read("value,weight,vx,vy,vz,ux,uy,uz\r\n\r\n0.25,4,0,0,2,3,0,4\r\n");
  ASSERT_TRUE(data) << diagnostics_.to_text();
  ASSERT_EQ(data->list.size(), 1U);
  EXPECT_EQ(data->list[0].u, grf::Vec3d(0.6, 0, 0.8));
  EXPECT_EQ(data->list[0].v, grf::Vec3d(0, 0, 1));
  EXPECT_EQ(data->list[0].value, grf::Vec3d(0.25));
  EXPECT_EQ(data->list[0].weight, 4);
}

TEST_F(CsvData, ErrorsHaveLineAndColumn) {
  expect_error("", ":", "the file is empty");
  expect_error("theta_u,phi_u,theta_v,phi_v,r,g\n", ":1:1:", "the columns of the value are missing");
  expect_error("theta_u,phi_u,theta_v,r,g,b\n", ":1:1:", "the columns of two directions are missing");
  expect_error("theta_u,phi_u,theta_v,phi_v,red\n", ":1:29:", "unknown column 'red'");
  expect_error("value,value\n", ":1:7:", "the column 'value' is repeated");
  expect_error(std::string(Header) + "0,0,0,0,1,1,1\n0,0,0,x,1,1,1\n",
               ":3:7:", "'x' is no number, in the column 'phi_v'");
  expect_error(std::string(Header) + "0,0,0,0,1,1\n",
               ":2:11:", "the line has 6 values, and the first line names 7");
  expect_error(std::string(Header) + "0,0,0,0,1,1,1,1\n", ":2:15:", "the line has 8 values");
  expect_error("theta_u,phi_u,theta_v,phi_v,value,deviation\n0,0,0,0,1,0\n",
               ":2:11:", "a standard deviation is over 0");
  expect_error("ux,uy,uz,vx,vy,vz,value\n0,0,1,0,0,0,1\n", ":2:7:", "a direction has no length");
}

TEST_F(CsvData, ViewsAtSeveralAzimuthsAreAnisotropic) {
  const std::string one = std::string(Header) + "0.5,0,0.3,1,1,1,1\n0.7,3.14159265,0.3,2,1,1,1\n";
  EXPECT_TRUE(read(one)->is_isotropic);
  EXPECT_FALSE(read(one + "0.5,1,0.3,1,1,1,1\n")->is_isotropic);
}

TEST_F(CsvData, ValuesThatCannotBeUsedAreCountedAndLeftOut) {
  const auto data = read_usable(std::string(Header) +
                                "0.1,0,0,0,1,1,1\n0.4,0,0,0,nan,1,1\n0.5,0,0,0,inf,1,1\n0.6,0,0,0,-1,1,1\n"
                                "0.7,0,1.6,0,1,1,1\n0.8,0,0,0,2,1,1\n");
  ASSERT_TRUE(data);
  EXPECT_EQ(data->list.size(), 2U);
  EXPECT_FALSE(data->is_grey);
  const std::string text = diagnostics_.to_text();
  EXPECT_THAT(text, HasSubstr("data.csv:3:1: warning: 2 of 6 values are not finite: they are left out"));
  EXPECT_THAT(text, HasSubstr("data.csv:5:1: warning: 1 of 4 values are negative"));
  EXPECT_THAT(text,
              HasSubstr("data.csv:6:1: warning: 1 of 3 values are of directions at or below the horizon"));
}

TEST_F(CsvData, NothingToFitIsAnError) {
  EXPECT_FALSE(read_usable(Header));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("no value can be used"));
  diagnostics_ = {};
  EXPECT_FALSE(read_usable(std::string(Header) + "0.1,0,0,0,0,0,0\n0.2,0,0,0,0,0,0\n"));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("all values are 0"));
}

TEST_F(CsvData, OneViewIsSaid) {
  EXPECT_TRUE(read_usable(std::string(Header) + "0.5,0,0,0,1,1,1\n0.5,2,0.7,1,1,1,1\n"));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("warning: all values are of one view angle"));
}

}  // namespace
