#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace grf {

/// Makes names unique: a repeated name gets `_2`, `_3` and so on. n equal names take O(n log n).
class UniqueNames {
 public:
  enum class Case { Matters, Ignored };  ///< Whether names that differ only in case are the same.

  explicit UniqueNames(Case of_letters = Case::Matters) : case_(of_letters) {}

  /// Marks a name as taken; returns false if it already was.
  bool add(std::string_view name);

  /// Takes and returns a free name: the wanted one, or one with a number before the extension.
  std::string take(std::string_view wanted, std::string_view extension = {});

 private:
  std::string key_of(std::string_view name) const;

  Case case_;
  std::set<std::string, std::less<>> taken_;
  std::map<std::string, int, std::less<>> last_numbers_;  ///< by name that was wanted repeatedly
};

}  // namespace grf
