// The whole catalogue, and the checks of each row.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/stability/hard_case.h"

namespace test {
namespace {

std::vector<HardCase> joined(std::initializer_list<std::vector<HardCase>> parts) {
  std::vector<HardCase> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Allows for rounding on other machines: the document's figures are from one.
void expect_is_about(double measured, double documented, double factor) {
  if (documented == 0 || std::isinf(documented)) {
    EXPECT_EQ(measured, documented);
  } else {
    EXPECT_GT(measured, documented / factor);
    EXPECT_LT(measured, documented * factor);
  }
}

}  // namespace

std::vector<Section> catalogue() {
  return {{"reflectance", joined({direction_cases(), fresnel_cases(), lobe_cases(), model_cases()})},
          {"lights", joined({light_cases(), environment_cases()})},
          {"geometry", joined({triangle_cases(), ray_cases()})},
          {"sums", joined({sampling_cases(), image_cases()})}};
}

std::vector<HardCase> cases_of_length(bool is_long) {
  std::vector<HardCase> cases;
  for (const Section& section : catalogue()) {
    std::copy_if(section.cases.begin(), section.cases.end(), std::back_inserter(cases),
                 [&](const HardCase& hard_case) { return (hard_case.kind == Kind::Long) == is_long; });
  }
  return cases;
}

void expect_holds(const HardCase& hard_case) {
  const Errors errors = hard_case.measure();
  SCOPED_TRACE(fmt::format("measured {}, and {} of naive code", errors.ours, errors.naive));
  EXPECT_LE(errors.ours, hard_case.bound);
  EXPECT_EQ(errors.naive <= hard_case.bound, hard_case.naive_holds()) << errors.naive;
  expect_is_about(errors.ours, hard_case.error, hard_case.kind == Kind::Noisy ? 4 : 2);
  expect_is_about(errors.naive, hard_case.naive_error, 4);
  EXPECT_TRUE(hard_case.naive_holds() || std::isinf(errors.naive) ||
              errors.naive_in_double < errors.naive / 10)
      << "the naive formula is wrong in double too: " << errors.naive_in_double;
}

std::string test_name(const HardCase& hard_case) {
  std::string name(hard_case.name);
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return name;
}

}  // namespace test
