// A strict parser of the part of MaterialX 1.39 that its specification describes (materialx.org), written
// apart from the writer.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace test {

struct MtlxInput {
  std::string type;
  std::string value;
  std::string node;  ///< the node that it is connected to; empty: none
  std::string colour_space;
};

struct MtlxNode {
  std::string category;
  std::string name;
  std::string type;
  std::string doc;
  std::map<std::string, MtlxInput> inputs;
};

struct MtlxDocument {
  std::map<std::string, MtlxNode> nodes;                     ///< by name
  std::map<std::string, std::vector<std::string>> geometry;  ///< paths of each material

  /// Returns the only node of a category; throws std::out_of_range if there is none.
  const MtlxNode& only(const std::string& category) const;
};

/// Parses a document. Throws std::runtime_error for text that is no XML, and for unknown categories, inputs,
/// types and values, and connections to nothing or to another type.
MtlxDocument parse_mtlx(std::string_view text);

}  // namespace test
