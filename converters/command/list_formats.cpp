#include "converters/command/list_formats.h"

#include <cstdio>

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
  for (const Format& format : formats()) {
    fmt::print("{:<6} {} (.{}): {}\n", format.name, format.title, fmt::join(format.extensions, ", ."),
               directions(format));
    fmt::print("       keeps {}\n       loses {}\n", format.keeps, format.loses);
  }
}

}  // namespace convert
