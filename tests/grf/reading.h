// Helpers to read text in tests.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "grf/read.h"

namespace grf {

/// Parses a valid text without warnings.
inline Scene scene_of(std::string text) {
  Diagnostics diagnostics;
  auto scene = read_text(std::move(text), "scene.grf", diagnostics);
  EXPECT_EQ(diagnostics.to_text(), "");
  return scene ? *scene : Scene();
}

/// Returns the diagnostics of a text, and in a last line whether it was read.
inline std::string said_about(std::string text) {
  Diagnostics diagnostics;
  const bool is_read = read_text(std::move(text), "scene.grf", diagnostics).has_value();
  return diagnostics.to_text() + (is_read ? "read\n" : "not read\n");
}

/// Returns the message of the only error in a text.
inline std::string error_in(std::string text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_text(std::move(text), "scene.grf", diagnostics).has_value());
  EXPECT_EQ(diagnostics.entries().size(), 1U) << diagnostics.to_text();
  return diagnostics.entries().empty() ? "" : diagnostics.entries().front().message;
}

/// Returns the block with that index of a scene, or of the body of a block, which must be of that type.
template <class Content>
const Content& block(const BlockList& list, std::size_t index = 0) {
  return std::get<Content>(list.blocks.at(index).content);
}

inline const Mesh& mesh_of(const Scene& scene, std::size_t index = 0) {
  return *block<Shared<Mesh>>(scene.contents, index);
}

/// Returns the text of a mesh of one triangle, with something before its vertices and before its face.
inline std::string triangle(const std::string& attributes = {}, const std::string& face_attributes = {}) {
  return "begin mesh " + attributes +
         " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin faces " + face_attributes +
         " (0, 1, 2) end faces end mesh\n";
}

}  // namespace grf
