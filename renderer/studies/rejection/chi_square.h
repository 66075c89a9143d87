#pragma once

#include <optional>
#include <vector>

namespace studies {

/// Returns the p-value of a chi-square goodness-of-fit test: the probability that counts are at least this
/// far off the probabilities of the classes, which sum to 1. Neighbouring classes are pooled until 5 counts
/// are expected. Nothing if fewer than two remain.
std::optional<double> chi_square_p_value(const std::vector<double>& probabilities,
                                         const std::vector<double>& counts);

}  // namespace studies
