#include "converters/wording.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

namespace convert {

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t MostNames = 3;
  const auto shown = std::span(names).first(std::min(names.size(), MostNames));
  const std::string list = fmt::format("'{}'", fmt::join(shown, "', '"));
  return names.size() > MostNames ? fmt::format("{} and {} more", list, names.size() - MostNames) : list;
}

}  // namespace convert
