// Studies of rejection sampling, and what their summaries say.
#pragma once

#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/studies/study_of_text.h"

// Files of this folder are compiled together.
namespace rejection_test {

constexpr double Pi = std::numbers::pi;

inline std::string state_of(const std::string& distribution, const std::string& settings = {},
                            const std::string& brdf = "diffuse kd=0.5") {
  return fmt::format("tool rejection {}\ndistribution {}\nbrdf {}\n", settings, distribution, brdf);
}

inline studies::Study study_of(const std::string& distribution, const std::string& settings = {},
                               const std::string& brdf = "diffuse kd=0.5") {
  return test::study_of_text(state_of(distribution, settings, brdf));
}

inline std::string messages_of(const std::string& distribution, const std::string& settings = {},
                               const std::string& brdf = "diffuse kd=0.5") {
  const test::StudyOutcome outcome = test::outcome_of(state_of(distribution, settings, brdf));
  EXPECT_FALSE(outcome.study) << distribution;
  return outcome.messages;
}

struct Counts {
  double samples = 0;
  double tries = 0;
};

inline Counts counts_of(const studies::Study& study) {
  std::smatch found;
  if (!std::regex_search(study.summary, found, std::regex("(\\d+) samples from (\\d+) tries")))
    throw std::runtime_error(study.summary);
  return {std::stod(found[1]), std::stod(found[2])};
}

inline double p_value_of(const studies::Study& study) {
  std::smatch found;
  if (!std::regex_search(study.summary, found, std::regex("chi-square p [=<] ([0-9.e-]+)")))
    throw std::runtime_error(study.summary);
  return std::stod(found[1]);
}

/// Returns the p-value of the samples of the subdivision, the second one of the table.
inline double p_value_of_tree(const studies::Study& study) {
  std::vector<double> found;
  for (const std::string& words : test::words_of(study)) {
    if (words.starts_with("p = ") || words.starts_with("p < ")) found.push_back(std::stod(words.substr(4)));
  }
  return found.at(1);
}

/// Returns the first column of a CSV text.
inline std::vector<double> column(const std::string& csv) {
  std::istringstream stream(csv);
  std::vector<double> values;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) values.push_back(std::stod(line));
  return values;
}

/// Expects that so many tries of an acceptance rate gave the samples, within 4 standard deviations.
inline void expect_acceptance(const Counts& counts, double acceptance, const std::string& what) {
  const double sigma = std::sqrt(acceptance * (1 - acceptance) / counts.tries);
  EXPECT_NEAR(counts.samples / counts.tries, acceptance, 4 * sigma + 1e-12) << what;
}

inline std::string expected_text(double acceptance) {
  return fmt::format("{:.3g} % expected", 100 * acceptance);
}

}  // namespace rejection_test
