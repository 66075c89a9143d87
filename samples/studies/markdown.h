// What the reports of studies are made of.
#pragma once

#include <string>
#include <vector>

namespace study {

/// A table in Markdown; the first column is words, the others are numbers.
class Table {
 public:
  explicit Table(const std::vector<std::string>& header);
  void add(const std::vector<std::string>& row);
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

/// A number with so many digits as tell something.
std::string figure(double value);

/// A claim, decided by the figures.
struct Verdict {
  std::string claim;
  bool holds = false;
  std::string figures;
};

/// "**Holds:** claim. Figures." or the opposite.
std::string sentence(const Verdict& verdict);
/// One after the other, after an empty line.
std::string sentences(const std::vector<Verdict>& verdicts);

/// "2 cores of ...".
std::string machine_name();

}  // namespace study
