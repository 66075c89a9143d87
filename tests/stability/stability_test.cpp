// Each hard case of the catalogue, and the document that is made from it. To rewrite that after a change:
//   GRANADA_UPDATE_DOCUMENTS=1 build/release/bin/stability_test
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/stability/hard_case.h"
#include "tests/support/generated_document.h"

namespace test {
namespace {

std::vector<HardCase> all_cases() {
  std::vector<HardCase> all;
  for (const auto& cases : {direction_cases(), fresnel_cases(), lobe_cases(), model_cases()})
    all.insert(all.end(), cases.begin(), cases.end());
  return all;
}

/// The document's figures are those of one machine: another may round a little otherwise.
void expect_is_about(double measured, double documented, double factor) {
  if (documented == 0 || std::isinf(documented)) {
    EXPECT_EQ(measured, documented);
  } else {
    EXPECT_GT(measured, documented / factor);
    EXPECT_LT(measured, documented * factor);
  }
}

class Stability : public testing::TestWithParam<HardCase> {};

TEST_P(Stability, BoundHoldsAndNaiveCodeFails) {
  const HardCase& hard_case = GetParam();
  const Errors errors = hard_case.measure();
  EXPECT_LE(errors.ours, hard_case.bound);
  EXPECT_GT(errors.naive, hard_case.bound);
  expect_is_about(errors.ours, hard_case.error, 2);
  expect_is_about(errors.naive, hard_case.naive_error, 4);
  EXPECT_TRUE(std::isinf(errors.naive) || errors.naive_in_double < errors.naive / 10)
      << "the naive formula is wrong in double too: " << errors.naive_in_double;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Stability, testing::ValuesIn(all_cases()), [](const auto& instance) {
  std::string name(instance.param.name);
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return name;
});

std::string text_of(double error) {
  if (error == 0) return "0";
  return std::isinf(error) ? "not finite" : fmt::format("{:.0e}", error);
}

/// Text in a cell of a table, where a bar has to be escaped.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string rows() {
  std::string text = "| case | naive code | its error | here | bound | error |\n|---|---|---|---|---|---|\n";
  for (const HardCase& hard_case : all_cases()) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", cell(hard_case.name), cell(hard_case.naive_code),
                        text_of(hard_case.naive_error), cell(hard_case.our_code), text_of(hard_case.bound),
                        text_of(hard_case.error));
  }
  return text;
}

TEST(Documents, StabilityIsWhatTheCatalogueSays) {
  expect_generated("renderer/STABILITY.md", "stability_test", rows());
}

}  // namespace
}  // namespace test
