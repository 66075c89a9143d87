#include "renderer/plot/fit_file.h"

#include <gtest/gtest.h>

#include "grf/read.h"

namespace {

using grf::Diagnostics;
using plot::FitFile;
using plot::FitPoint;
using plot::read_fit;

grf::BrdfModel brdf_of(const std::string& text) {
  Diagnostics diagnostics;
  return grf::read_brdf(text, "argument", diagnostics).value();
}

FitFile file_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto file = read_fit(text, "a.fit", diagnostics);
  EXPECT_EQ(diagnostics.to_text(), "");
  return file.value_or(FitFile());
}

std::string error_in(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_fit(text, "a.fit", diagnostics));
  return diagnostics.to_text();
}

// The thesis' example on one line; its phi cannot be in radians.
TEST(FitFile, OfTheThesisIsRead) {
  const std::string text =
      "ashikhmin nu = 25 nv = 25 ks =0.39 kd =0.6 viewer (1.33763, 344.888) begin "
      "(0.344659,-0.331753,0.878151) 1 (0.048125,0.00957266,0.998795) 0.85 (0.327274,-0.329171,0.885742) 1 "
      "(0.0407984,0.0272606,0.998795) 0.85 (0.312922,-0.319833,0.894308) 1 "
      "(0.0272606,0.0407984,0.998795) 0.85 (0.30379,-0.30516,0.902546) 1 end";
  Diagnostics diagnostics;
  const auto file = read_fit(text, "thesis.fit", diagnostics);
  ASSERT_TRUE(file);
  EXPECT_TRUE(diagnostics.to_text().starts_with(
      "thesis.fit:1:61: warning: the view's phi, 344.888, is more than a full turn: angles are in radians\n"))
      << diagnostics.to_text();
  EXPECT_EQ(file->brdf, brdf_of("ashikhmin nu=25 nv=25 ks=0.39 kd=0.6"));
  EXPECT_EQ(file->theta, 1.33763F);
  EXPECT_EQ(file->phi, 344.888F);
  ASSERT_EQ(file->points.size(), 7U);
  EXPECT_EQ(file->points[1], (FitPoint{{0.048125F, 0.00957266F, 0.998795F}, 0.85F}));
  EXPECT_EQ(file->points[6].value, 1);
}

TEST(FitFile, IsWrittenAsItIsRead) {
  FitFile file;
  file.brdf = brdf_of("measured \"a b.binary\" linear=false");
  file.theta = 1.0F / 3;
  file.phi = -1e-30F;
  for (const float x : {0.1F, -0.0F, 3e38F, 1e-45F}) file.points.push_back({{x, 1 - x, 0}, x / 3});
  const std::string text = to_text(file);
  EXPECT_EQ(file_of(text), file) << text;
  EXPECT_EQ(to_text(file_of(text)), text);
  file.points.clear();
  EXPECT_EQ(file_of(to_text(file)), file);
}

TEST(FitFile, HasFreeSpaceAndAnyCase) {
  const FitFile file = file_of(
      "\xEF\xBB\xBF// a comment\r\nbrdf Odd viewer=1 Viewer = 2\r\nVIEWER(1 , // theta\n-6.28)Begin(1,2,3)4 "
      "END");
  EXPECT_EQ(file.brdf.arguments.size(), 2U) << "a parameter of that name is no view";
  EXPECT_EQ(file.points, (std::vector<FitPoint>{{{1, 2, 3}, 4}}));
  EXPECT_EQ(file.phi, -6.28F);
}

TEST(FitFile, ReportsMistakesAtTheirPlace) {
  EXPECT_EQ(error_in(""),
            "a.fit:1:1: error: found the end of the file, expected 'viewer' and the view "
            "direction after the BRDF\n");
  const auto first_line = [](const std::string& text) {
    const std::string error = error_in(text);
    return error.substr(0, error.find('\n'));
  };
  EXPECT_EQ(first_line("ward sx=\nviewer (0, 0) begin end"),
            "a.fit:1:9: error: found the end of the file, expected a number, 'true', 'false', a word, three "
            "numbers in parentheses or 'texture' for 'sx'");
  EXPECT_EQ(first_line("ward\nviewer 0"),
            "a.fit:2:8: error: found '0', expected '(' and the angles of the view");
  EXPECT_EQ(first_line("ward viewer (1)"),
            "a.fit:1:15: error: found ')', expected ',' and the second angle of "
            "the view");
  EXPECT_EQ(first_line("ward viewer (1, 2) end"),
            "a.fit:1:20: error: found 'end', expected 'begin' and directions with their values");
  EXPECT_EQ(first_line("ward viewer (1, 2) begin\n (1, 2) 3 end"),
            "a.fit:2:7: error: found ')', expected ',' and one more number");
  EXPECT_EQ(first_line("ward viewer (1, 2) begin\n (1, 2, 3)\n(1, 2, 3) 1 end"),
            "a.fit:3:1: error: found '(', expected a number");
  EXPECT_EQ(first_line("ward viewer (1, 2) begin (1, 2, 1e99) 1 end"),
            "a.fit:1:33: error: found '1e99', expected a number in the range of a float");
  EXPECT_EQ(first_line("ward viewer (1, 2) begin"),
            "a.fit:1:25: error: found the end of the file, expected '(' and a direction, or 'end'");
  EXPECT_EQ(first_line("ward viewer (1, 2) begin end more"),
            "a.fit:1:30: error: found 'more', expected nothing after 'end'");
  EXPECT_EQ(first_line("combine 1 a viewer (1, 2) begin end"),
            "a.fit:1:1: error: a 'combine' of names, but a single BRDF has no definitions");
}

// Reading must return for any truncation.
TEST(FitFile, MayEndAnywhere) {
  const std::string text = "ward sx=0.1 viewer (1, 2) begin (0, 0, 1) 1 end";
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_NE(error_in(text.substr(0, length)), "") << length;
  }
}

}  // namespace
