// Seconds, bytes and nanoseconds.
#pragma once

#include <array>
#include <string>

#include "samples/studies/sampling/cases.h"
#include "samples/studies/sampling/technique.h"

namespace study {

/// The tables of a scheme: the least time of some builds, on all cores.
struct TableCost {
  double seconds = 0;
  std::size_t bytes = 0;
};

TableCost table_cost(const reflectance::Brdf& brdf, const std::string& scheme, int builds);

/// The bytes of one tree of `mode=reject` for a view at 45 degrees, without its table, for each of
/// `TriesOfTable`.
std::array<std::size_t, TriesOfTable.size()> tree_bytes(const reflectance::Brdf& brdf, int resolution);

/// Nanoseconds of one thread: the least time of some rounds.
struct SampleCost {
  double with_density = 0;
  double with_value = 0;  ///< of the BRDF as well
};

/// Of samples by the scheme alone, for views of cosine-distributed directions.
SampleCost sample_cost(const Technique& technique, int rounds);

}  // namespace study
