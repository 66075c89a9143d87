// Any bytes at all as a VRML file. What is read must be a scene that GRF can hold: written and read back, it
// is the same.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "converters/vrml/vrml.h"
#include "grf/read.h"
#include "grf/summary.h"
#include "grf/write.h"

namespace {

/// Solids of many faces take their time to write, and tell nothing new.
constexpr std::size_t MostFaces = 20'000;

void expect(bool condition, const char* what, const std::string& text) {
  if (condition) return;
  std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
  std::abort();
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  grf::Diagnostics diagnostics;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto import = convert::read_vrml_bytes(bytes, "folder_that_is_not_there/fuzz.wrl", diagnostics);
  diagnostics.to_text();
  expect(import.has_value() != diagnostics.has_errors(), "a scene and errors, or neither",
         diagnostics.to_text());
  if (!import || grf::summarize(import->scene).faces > MostFaces) return 0;
  const std::string text = grf::to_text(import->scene);
  const auto again = grf::read_text(text, "again.grf", diagnostics);
  expect(again.has_value(), "what was written cannot be read", text + diagnostics.to_text());
  expect(*again == import->scene, "another scene was read back", text);
  return 0;
}
