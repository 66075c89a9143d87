// The BRDFs of the thesis' table 5.5, with the figures of its chapter 5.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace study {

/// Parameters of a factorisation, as in table 5.6. All have 16 x 16 views.
struct FactorParameters {
  int rows = 0;     ///< theta_p
  int columns = 0;  ///< phi_p
  int j = 0;
  int k = 0;
  bool half = false;  ///< "Reparam."

  bool operator==(const FactorParameters&) const = default;
};

/// Returns the scheme's text, `factored uTh=16 ...`.
std::string scheme_text(const FactorParameters& parameters);

/// The values of n_max in table 5.2.
constexpr std::array<double, 4> TriesOfTable = {1.3, 2, 2.5, 3};

struct ThesisFigures {
  double seconds_60 = 0, seconds_90 = 0;  ///< to build trees, table 5.1
  double factored_seconds = 0;            ///< table 5.1
  std::array<double, 4> tree_kb = {};     ///< table 5.2, for `TriesOfTable`
  double adaptive_kb = 0;                 ///< 60 trees, table 5.3
  double factored_kb = 0;                 ///< table 5.3
  FactorParameters factors;               ///< table 5.6
};

struct Case {
  std::string name;
  std::string brdf;  ///< GRF text
  ThesisFigures thesis;
};

/// Returns the cases in the order of the thesis.
const std::vector<Case>& cases();

}  // namespace study
