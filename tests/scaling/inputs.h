// Input files with a large number of one kind of element.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace scaling {

using Text = std::function<std::string(std::size_t count)>;

/// A file that is written beside the measured one.
struct CompanionFile {
  std::string name;
  std::string text;
};

struct Input {
  std::string name;
  std::string extension;  ///< of the file's name; says which format reads it
  Text text;
  std::size_t largest = 500;  ///< to begin with; sixteen times as many are measured, too
  bool is_refused = false;    ///< it is wrong, so that nothing is made of it
  std::function<std::vector<CompanionFile>(std::size_t count)> companions = {};
};

std::vector<Input> grf_inputs();
std::vector<Input> model_inputs();
/// The inputs of formats that Assimp reads.
std::vector<Input> assimp_inputs();

/// Concatenates a text per number, between a beginning and an end.
inline Text pieces(std::string begin, Text piece, std::string end = "") {
  return [begin = std::move(begin), piece = std::move(piece), end = std::move(end)](std::size_t count) {
    std::string text = begin;
    for (std::size_t i = 0; i < count; ++i) text += piece(i);
    return text + end;
  };
}

/// Repeats a text, between a beginning and an end.
inline Text copies(std::string begin, std::string piece, std::string end = "") {
  return pieces(
      std::move(begin), [piece = std::move(piece)](std::size_t) { return piece; }, std::move(end));
}

/// Joins texts with commas.
inline std::string listed(std::size_t count, const Text& piece) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? "," : "") + piece(i);
  return text;
}

}  // namespace scaling
