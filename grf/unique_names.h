#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace grf {

/// Makes names unique: what was taken before gets `_2`, `_3` and so on. Many equal names take n log n.
class UniqueNames {
 public:
  enum class Case { Matters, Ignored };

  explicit UniqueNames(Case of_letters = Case::Matters) : case_(of_letters) {}

  /// Marks a name as taken; false if it was.
  bool add(std::string_view name);

  /// A name that was not taken: the wanted one, or with a number before the extension. It is taken then.
  std::string take(std::string_view wanted, std::string_view extension = {});

 private:
  std::string key_of(std::string_view name) const;

  Case case_;
  std::set<std::string, std::less<>> taken_;
  std::map<std::string, int, std::less<>> last_numbers_;  ///< of names that were wanted twice
};

}  // namespace grf
