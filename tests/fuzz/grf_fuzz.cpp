// Fuzzes the GRF parser: any bytes are read as the text of a scene. A scene must survive a round trip, and
// everything that works on scenes must work on it.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "converters/grf2008.h"
#include "grf/check.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/summary.h"
#include "grf/write.h"

namespace {

void expect(bool condition, const char* what, const std::string& text) {
  if (condition) return;
  std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
  std::abort();
}

void expect_read_back(const grf::Scene& scene) {
  const std::string text = grf::to_text(scene);
  grf::Diagnostics diagnostics;
  const auto again = grf::read_text(text, "again.grf", diagnostics);
  expect(again.has_value(), "what was written cannot be read", text + diagnostics.to_text());
  expect(*again == scene, "another scene was read back", text);
  expect(grf::to_text(*again) == text, "the text is not the same again", text);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  grf::Diagnostics diagnostics;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto scene = grf::read_text(text, "fuzz.grf", diagnostics);
  diagnostics.to_text();
  expect(scene.has_value() != diagnostics.has_errors(), "a scene and errors, or neither", text);
  if (!scene) return 0;
  expect_read_back(*scene);
  expect_read_back(grf::flatten(*scene, "fuzz.grf"));
  if (const auto plain = convert::to_grf2008(*scene, "fuzz.grf", diagnostics)) expect_read_back(*plain);
  grf::check(*scene, {}, diagnostics);
  grf::summarize(*scene);
  return 0;
}
