// Costs of schemes in seconds, bytes and nanoseconds.
#pragma once

#include <array>
#include <string>

#include "samples/studies/sampling/cases.h"
#include "samples/studies/sampling/technique.h"

namespace study {

/// The cost of a scheme's tables: the minimum time of some builds, on all cores.
struct TableCost {
  double seconds = 0;
  std::size_t bytes = 0;
};

TableCost table_cost(const reflectance::Brdf& brdf, const std::string& scheme, int builds);

/// Returns the bytes of a tree of `mode=reject` for a view at 45 degrees, without its table, for each of
/// `TriesOfTable`.
std::array<std::size_t, TriesOfTable.size()> tree_bytes(const reflectance::Brdf& brdf, int resolution);

/// The time per sample in nanoseconds on one thread, the minimum of some rounds.
struct SampleCost {
  double with_pdf = 0;
  double with_value = 0;  ///< with evaluation of the BRDF
};

/// Measures samples of only the scheme, for cosine-distributed views.
SampleCost sample_cost(const Technique& technique, int rounds);

}  // namespace study
