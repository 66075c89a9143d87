// Studies from the text of their state.
#pragma once

#include <stdexcept>
#include <string>

#include "renderer/studies/study.h"
#include "tests/support/svg_reading.h"

namespace test {

/// The study of a text, or the messages of why there is none.
struct StudyOutcome {
  std::optional<studies::Study> study;
  std::string messages;
};

inline StudyOutcome outcome_of(const std::string& text, const std::string& path = "a.study") {
  grf::Diagnostics diagnostics;
  const auto state = studies::read_state(text, path, diagnostics);
  StudyOutcome outcome;
  if (state) outcome.study = studies::study_of(*state, {}, diagnostics);
  outcome.messages = diagnostics.to_text();
  return outcome;
}

inline studies::Study study_of_text(const std::string& text, const std::string& path = "a.study") {
  StudyOutcome outcome = outcome_of(text, path);
  if (!outcome.study) throw std::runtime_error(outcome.messages);
  return std::move(*outcome.study);
}

inline std::vector<std::string> words_of(const studies::Study& study) {
  return texts(svg_of(study.figure.str()));
}

}  // namespace test
