// The efficiencies of the lines of a cost study are compared with regard to their uncertainty.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace command {

/// One render of a row.
struct CostRound {
  double seconds = 0;
  double relmse = 0;
};

/// The renders of one line by sample count.
using CostRounds = std::map<int, std::vector<CostRound>>;

/// An efficiency, 1 / (relMSE x render seconds), with its 95 % confidence interval.
struct CostEfficiency {
  double value = 0;
  double low = 0;
  double high = 0;
};

/// Returns the efficiency of each line: the geometric mean over the sample counts that all lines have and at
/// which no line's relMSE is less than four times the reference's own. The interval is Student's, of the
/// logarithms over rounds, which have different seeds. Nothing with less than two rounds.
std::vector<std::optional<CostEfficiency>> efficiencies_of(std::span<const CostRounds> lines,
                                                           double reference_relmse);

/// Returns the index of the line whose interval is above those of all others; nothing if none is, if a line
/// has no interval, or if there is only one line.
std::optional<std::size_t> winner_of(std::span<const std::optional<CostEfficiency>> efficiencies);

}  // namespace command
