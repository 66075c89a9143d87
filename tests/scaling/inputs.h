// Files that have many of one kind of thing.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace scaling {

struct Input {
  std::string name;
  std::string extension;  ///< of the file's name; says which format reads it
  std::function<std::string(std::size_t count)> text;
  std::size_t largest = 500;  ///< to begin with; sixteen times as many are measured, too
};

std::vector<Input> grf_inputs();
std::vector<Input> model_inputs();

}  // namespace scaling
