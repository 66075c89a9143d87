#pragma once

#include <string>

#include <gtest/gtest.h>

#include "grf/check.h"
#include "tests/grf/reading.h"
#include "tests/grf/small_catalogue.h"

namespace grf {

/// Returns the messages about a text that can be read, one per line, with the severity of warnings.
inline std::string said_of(const std::string& text) {
  const Scene scene = scene_of(text);
  Diagnostics diagnostics;
  const bool valid = check(scene, catalogue(), diagnostics);
  EXPECT_EQ(valid, !diagnostics.has_errors());
  std::string messages;
  for (const Diagnostic& entry : diagnostics.entries()) {
    messages += (entry.severity == Severity::Warning ? "warning: " : "") + entry.message + "\n";
  }
  return messages;
}

inline const std::string Square = "begin vertexs (0, 0, 0) (1, 0, 0) (1, 1, 0) (0, 1, 0) end vertexs ";

inline std::string faces(const std::string& list) { return "begin faces " + list + " end faces "; }

inline std::string mesh(const std::string& vertices, const std::string& list) {
  return "begin mesh brdf flat begin vertexs " + vertices + " end vertexs " + faces(list) + "end mesh ";
}

}  // namespace grf
