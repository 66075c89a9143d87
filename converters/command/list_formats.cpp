#include "converters/command/list_formats.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "converters/format.h"

namespace convert {
namespace {

nlohmann::ordered_json to_json(const Format& format) {
  return {{"name", format.name},
          {"title", format.title},
          {"extensions", format.extensions},
          {"reads", format.read != nullptr},
          {"writes", format.write != nullptr},
          {"keeps", format.keeps},
          {"loses", format.loses}};
}

std::string_view directions(const Format& format) {
  if (format.read == nullptr) return "writes";
  return format.write == nullptr ? "reads" : "reads, writes";
}

}  // namespace

void print_formats(bool json) {
  if (json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Format& format : formats()) list.push_back(to_json(format));
    fmt::print("{}\n", nlohmann::ordered_json{{"formats", list}}.dump(2));
    return;
  }
  std::size_t width = 0;
  for (const Format& format : formats()) width = std::max(width, format.name.size());
  for (const Format& format : formats()) {
    fmt::print("{:<{}}  {} (.{}): {}\n", format.name, width, format.title,
               fmt::join(format.extensions, ", ."), directions(format));
    fmt::print("{:{}}  keeps {}\n", "", width, format.keeps);
    fmt::print("{:{}}  loses {}\n", "", width, format.loses);
  }
}

}  // namespace convert
