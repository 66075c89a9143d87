#include "grf/unique_names.h"

#include <fmt/format.h>

#include "grf/keywords.h"

namespace grf {

std::string UniqueNames::key_of(std::string_view name) const {
  return case_ == Case::Matters ? std::string(name) : lower_case(name);
}

bool UniqueNames::add(std::string_view name) { return taken_.insert(key_of(name)).second; }

std::string UniqueNames::take(std::string_view wanted, std::string_view extension) {
  std::string name = fmt::format("{}{}", wanted, extension);
  if (add(name)) return name;
  int& number = last_numbers_.try_emplace(key_of(name), 1).first->second;
  do {
    name = fmt::format("{}_{}{}", wanted, ++number, extension);
  } while (!add(name));
  return name;
}

}  // namespace grf
