// Fuzzes the reader of the format FUZZED_FORMAT with any bytes. A scene must survive a round trip through
// GRF. For formats that Assimp reads from memory, only our own code is called, since Assimp is known to
// crash.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "converters/assimp/stl_check.h"
#include "converters/assimp/three_ds.h"
#include "converters/format.h"
#include "grf/read.h"
#include "grf/summary.h"
#include "grf/write.h"
#include "tests/support/temporary_folder.h"

namespace {

constexpr std::string_view FormatName = FUZZED_FORMAT;

/// The limit of faces: large solids take long to write, and test nothing new.
constexpr std::size_t MostFaces = 20'000;

void expect(bool condition, const char* what, const std::string& text) {
  if (condition) return;
  std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
  std::abort();
}

void expect_either(bool is_read, const grf::Diagnostics& diagnostics) {
  expect(is_read != diagnostics.has_errors(), "a scene and errors, or neither", diagnostics.to_text());
}

void read_file(const std::string& bytes) {
  static const test::TemporaryFolder folder;
  const convert::Format& format = *convert::find_format(FormatName);
  grf::Diagnostics diagnostics;
  const auto import = format.read(folder.add("model", bytes), {}, diagnostics);
  expect_either(import.has_value(), diagnostics);
  if (!import || grf::summarize(import->scene).faces > MostFaces) return;
  const std::string text = grf::to_text(import->scene);
  const auto again = grf::read_text(text, "again.grf", diagnostics);
  expect(again.has_value(), "what was written cannot be read", text + diagnostics.to_text());
  expect(*again == import->scene, "another scene was read back", text);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const grf::SourceLocation location = grf::whole_file("fuzz");
  grf::Diagnostics diagnostics;
  if (FormatName == "3ds") {
    expect_either(convert::read_three_ds(bytes, location, diagnostics).has_value(), diagnostics);
  } else if (FormatName == "stl") {
    expect_either(convert::check_stl(bytes, location, diagnostics).has_value(), diagnostics);
  } else {
    read_file(bytes);
  }
  return 0;
}
