#include "renderer/command/cost_efficiency.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/command/cost_fit.h"

namespace command {
namespace {

/// Returns Student's quantile of 97.5 %: from a table, since transport::student_quantile is too small for two
/// or three rounds; and beyond it that of the table's last row, which is too wide rather than too narrow.
double tabulated_student_quantile(std::size_t degrees_of_freedom) {
  constexpr std::array Quantiles = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                    2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086};
  return Quantiles.at(std::min(degrees_of_freedom, Quantiles.size()) - 1);
}

double mean_relmse(const std::vector<CostRound>& rounds) {
  double sum = 0;
  for (const CostRound& round : rounds) sum += round.relmse;
  return sum / static_cast<double>(rounds.size());
}

/// Returns the sample counts at which the lines can be compared.
std::vector<int> common_samples(std::span<const CostRounds> lines, double reference_relmse) {
  std::vector<int> common;
  if (lines.empty()) return common;
  for (const auto& [samples, rounds_of_first] : lines.front()) {
    const bool is_common = std::ranges::all_of(lines, [&, samples = samples](const CostRounds& line) {
      const auto found = line.find(samples);
      if (found == line.end() || found->second.empty()) return false;
      const double relmse = mean_relmse(found->second);
      return relmse > 0 && relmse >= WellAboveReference * reference_relmse;
    });
    if (is_common) common.push_back(samples);
  }
  return common;
}

std::optional<CostEfficiency> efficiency_of(const CostRounds& line, const std::vector<int>& samples) {
  if (samples.empty()) return std::nullopt;
  std::size_t rounds = line.at(samples.front()).size();
  for (const int count : samples) rounds = std::min(rounds, line.at(count).size());
  if (rounds < 2) return std::nullopt;
  std::vector<double> logarithms(rounds, 0);
  for (std::size_t i = 0; i < rounds; ++i) {
    for (const int count : samples) {
      const CostRound& round = line.at(count)[i];
      if (!(round.seconds > 0 && round.relmse > 0)) return std::nullopt;
      logarithms[i] -= std::log(round.seconds * round.relmse) / static_cast<double>(samples.size());
    }
  }
  const auto count = static_cast<double>(rounds);
  double mean = 0;
  for (const double one : logarithms) mean += one / count;
  double square = 0;
  for (const double one : logarithms) square += (one - mean) * (one - mean);
  const double half = tabulated_student_quantile(rounds - 1) * std::sqrt(square / (count - 1) / count);
  return CostEfficiency{std::exp(mean), std::exp(mean - half), std::exp(mean + half)};
}

}  // namespace

std::vector<std::optional<CostEfficiency>> efficiencies_of(std::span<const CostRounds> lines,
                                                           double reference_relmse) {
  const std::vector<int> samples = common_samples(lines, reference_relmse);
  std::vector<std::optional<CostEfficiency>> efficiencies;
  for (const CostRounds& line : lines) efficiencies.push_back(efficiency_of(line, samples));
  return efficiencies;
}

std::optional<std::size_t> winner_of(std::span<const std::optional<CostEfficiency>> efficiencies) {
  if (efficiencies.size() < 2) return std::nullopt;
  std::size_t best = 0;
  for (std::size_t i = 0; i < efficiencies.size(); ++i) {
    if (!efficiencies[i]) return std::nullopt;
    if (efficiencies[i]->value > efficiencies[best]->value) best = i;
  }
  for (std::size_t i = 0; i < efficiencies.size(); ++i) {
    if (i != best && efficiencies[i]->high >= efficiencies[best]->low) return std::nullopt;
  }
  return best;
}

}  // namespace command
