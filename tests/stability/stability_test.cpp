// The hard cases that take seconds, and the document generated from all. To regenerate it after a change:
//   GRANADA_UPDATE_DOCUMENTS=1 build/release/bin/stability_test
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/stability/hard_case.h"
#include "tests/support/generated_document.h"

namespace test {
namespace {

class Stability : public testing::TestWithParam<HardCase> {};

TEST_P(Stability, BoundHoldsAndNaiveCodeFails) { expect_holds(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Catalogue, Stability, testing::ValuesIn(cases_of_length(false)),
                         [](const auto& instance) { return test_name(instance.param); });

std::string text_of(double error) {
  if (error == 0) return "0";
  if (std::isinf(error)) return "not finite";
  return error >= 1e-3 && error < 1e3 ? fmt::format("{:.3g}", error) : fmt::format("{:.0e}", error);
}

/// Escapes bars in a table's cell.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string naive_error_of(const HardCase& hard_case) {
  return text_of(hard_case.naive_error) + (hard_case.naive_holds() ? ", which will do" : "");
}

/// Adds a column for the measured quantity, unless it is the relative error for all.
std::string table_of(const std::vector<HardCase>& cases) {
  const bool names_measures = std::any_of(cases.begin(), cases.end(), [](const HardCase& hard_case) {
    return hard_case.measured != RelativeError;
  });
  std::string text = names_measures
                         ? "| case | measured | naive code | its figure | here | bound | figure |\n"
                           "|---|---|---|---|---|---|---|\n"
                         : "| case | naive code | its error | here | bound | error |\n"
                           "|---|---|---|---|---|---|\n";
  for (const HardCase& hard_case : cases) {
    text += "| " + cell(hard_case.name) + " | ";
    if (names_measures) text += cell(hard_case.measured) + " | ";
    text += fmt::format("{} | {} | {} | {} | {} |\n", cell(hard_case.naive_code), naive_error_of(hard_case),
                        cell(hard_case.our_code), text_of(hard_case.bound), text_of(hard_case.error));
  }
  return text;
}

TEST(Documents, StabilityIsWhatTheCatalogueSays) {
  for (const Section& section : catalogue()) {
    expect_generated("renderer/STABILITY.md", "stability_test " + std::string(section.mark),
                     table_of(section.cases));
  }
}

}  // namespace
}  // namespace test
