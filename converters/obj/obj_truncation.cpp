#include "converters/obj/obj_truncation.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "converters/wording.h"

namespace convert {
namespace {

constexpr std::array<std::string_view, 14> Keywords = {"v",      "vt",     "vn", "vp", "f", "l",  "p",
                                                       "usemtl", "mtllib", "o",  "g",  "s", "mg", "end"};

bool has_numbers(std::string_view keyword) { return keyword == "v" || keyword == "vt" || keyword == "vn"; }

std::size_t decimals_of(std::string_view number) {
  const std::size_t point = number.find('.');
  if (point == std::string_view::npos) return 0;
  const std::size_t end = number.find_first_of("eE", point);
  return std::min(end, number.size()) - point - 1;
}

std::size_t separators_of(std::string_view corner) {
  return static_cast<std::size_t>(std::count(corner.begin(), corner.end(), '/'));
}

}  // namespace

void TruncationDetector::add(const Statement& statement) {
  auto usage = usages_.find(statement.keyword);
  if (usage == usages_.end()) usage = usages_.emplace(statement.keyword, Usage()).first;
  Usage& u = usage->second;
  u.fewest_arguments = std::min(u.fewest_arguments, statement.arguments.size());
  for (const std::string_view word : statement.arguments) {
    u.fewest_separators = std::min(u.fewest_separators, separators_of(word));
    u.fewest_decimals = std::min(u.fewest_decimals, decimals_of(word));
    u.most_decimals = std::max(u.most_decimals, decimals_of(word));
  }
}

const TruncationDetector::Usage* TruncationDetector::usage_of(std::string_view keyword) const {
  const auto found = usages_.find(keyword);
  return found == usages_.end() ? nullptr : &found->second;
}

std::string TruncationDetector::evidence_of_truncation(const Statement& statement) const {
  const std::string_view keyword = statement.keyword;
  const bool known = std::find(Keywords.begin(), Keywords.end(), keyword) != Keywords.end();
  if (!known && usage_of(keyword) == nullptr) return fmt::format("'{}' is not a keyword", keyword);
  if (statement.rest.ends_with('\\')) return "the line that continues it is missing";
  if (has_numbers(keyword)) return evidence_in_numbers(statement);
  if (keyword == "f" || keyword == "l" || keyword == "p") return evidence_in_corners(statement);
  const bool takes_name = keyword == "usemtl" || keyword == "mtllib" || keyword == "o";
  return takes_name && statement.rest.empty() ? "its name is missing" : "";
}

std::string TruncationDetector::evidence_in_numbers(const Statement& statement) const {
  const std::size_t count = statement.arguments.size();
  const Usage* usage = usage_of(statement.keyword);
  const std::size_t least = statement.keyword == "vt" ? 2 : 3;
  // Statements without any numbers are a different error.
  const std::size_t expected = usage == nullptr ? least : std::max<std::size_t>(usage->fewest_arguments, 1);
  if (count < expected) return fmt::format("it has {} of {} numbers", count, expected);
  const std::string_view last = statement.arguments.back();
  if (!parse_number(last) || last.ends_with('.')) return fmt::format("the number '{}' is incomplete", last);
  const bool uniform = usage != nullptr && usage->fewest_decimals == usage->most_decimals;
  if (uniform && decimals_of(last) < usage->most_decimals) {
    return fmt::format("the number '{}' has fewer than the {} of all others", last,
                       counted(usage->most_decimals, "decimal", "decimals"));
  }
  return "";
}

std::string TruncationDetector::evidence_in_corners(const Statement& statement) const {
  const std::size_t least = statement.keyword == "f" ? 3 : statement.keyword == "l" ? 2 : 1;
  if (statement.arguments.size() < least) {
    return fmt::format("it has {} of at least {} corners", statement.arguments.size(), least);
  }
  const std::string_view last = statement.arguments.back();
  std::size_t separators = separators_of(statement.arguments.front());
  if (const Usage* usage = usage_of(statement.keyword)) {
    separators = std::max(separators, usage->fewest_separators);
  }
  if (last.ends_with('/') || last.ends_with('-') || separators_of(last) < separators) {
    return fmt::format("its last corner '{}' is incomplete", last);
  }
  return "";
}

}  // namespace convert
