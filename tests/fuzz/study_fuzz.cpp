// Fuzzes the readers of study tools: states, which must be read again as they were written, and FIT files.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "renderer/plot/fit_file.h"
#include "renderer/studies/study.h"

namespace {

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  grf::Diagnostics diagnostics;
  const auto state = studies::read_state(text, "a.study", diagnostics);
  expect(state.has_value() != diagnostics.has_errors(),
         "an error without a message, or a message without an error");
  if (state) {
    grf::Diagnostics again;
    const auto same = studies::read_state(to_text(*state, "a.study"), "a.study", again);
    expect(same.has_value(), "the written state cannot be read");
    expect(same->brdfs == state->brdfs && same->pdfs == state->pdfs && same->settings == state->settings,
           "the written state is another one");
    for (const studies::StudyTool& tool : studies::study_tools()) check(*state, tool, again);
  }
  plot::read_fit(text, "a.fit", diagnostics);
  return 0;
}
