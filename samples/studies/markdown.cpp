#include "samples/studies/markdown.h"

#include <cmath>
#include <fstream>
#include <thread>

#include <fmt/format.h>

namespace study {

Table::Table(const std::vector<std::string>& header) {
  add(header);
  text_ += "|---|";
  for (std::size_t i = 1; i < header.size(); ++i) text_ += "---:|";
  text_ += '\n';
}

void Table::add(const std::vector<std::string>& row) {
  text_ += fmt::format("| {} |\n", fmt::join(row, " | "));
}

std::string figure(double value) {
  const double size = std::abs(value);
  if (size == 0) return "0";
  if (size >= 99.95) return fmt::format("{:.0f}", value);
  if (size >= 0.01) return fmt::format("{:.3g}", value);
  return fmt::format("{:.2g}", value);
}

std::string sentence(const Verdict& verdict) {
  return fmt::format("- **{}**: {}: {}.\n", verdict.holds ? "Holds" : "Does not hold", verdict.claim,
                     verdict.figures);
}

std::string sentences(const std::vector<Verdict>& verdicts) {
  std::string text = "\n";
  for (const Verdict& one : verdicts) text += sentence(one);
  return text;
}

std::string machine_name() {
  std::string processor = "unknown processor";
  std::ifstream lines("/proc/cpuinfo");
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("model name")) continue;
    processor = line.substr(line.find(':') + 2);
    break;
  }
  return fmt::format("{} core{} of {}", std::thread::hardware_concurrency(),
                     std::thread::hardware_concurrency() == 1 ? "" : "s", processor);
}

}  // namespace study
