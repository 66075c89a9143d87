// The scene graph of a VRML file consists of nodes with fields. Values are kept as written; NodeReader
// validates the names and types of fields.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "converters/vrml/source.h"
#include "grf/diagnostics.h"
#include "grf/math.h"

namespace convert::vrml {

struct Node;

/// Strings, as written between the quotes.
struct Strings {
  std::vector<std::string_view> texts;
};
/// Words: TRUE, FALSE, and in VRML 1.0 enumerations and unquoted strings.
struct Words {
  std::vector<std::string_view> words;
};

/// The value of a field; NULL and an empty list are std::monostate.
using Value = std::variant<std::monostate, std::vector<double>, Strings, Words, std::vector<const Node*>>;

struct Field {
  std::string_view name;
  Value value;
  std::size_t offset = 0;        ///< byte offset of the name
  std::size_t value_offset = 0;  ///< byte offset of the value's first token
};

struct Node {
  std::string_view type;
  std::string_view name;  ///< name from DEF; may be empty
  std::vector<Field> fields;
  std::vector<const Node*> children;  ///< children between the fields, in VRML 1.0
  const Source* source = nullptr;
  std::size_t offset = 0;
  /// Whether the standard defines the node's type: false for an instance of a prototype, which has no fields.
  bool is_known = true;

  grf::SourceLocation location() const { return source->location(offset); }
};

/// The nodes of a whole file, as a directed acyclic graph: USE is replaced by a pointer to its node.
struct Document {
  std::shared_ptr<const Source> source;
  std::deque<Node> nodes;  ///< parents before their children
  std::vector<const Node*> roots;
  std::size_t routes = 0;
  std::vector<std::string_view> prototypes;  ///< names, in order
};

/// Reads typed fields of a node. An invalid field is an error at its location, and returns the default. Of a
/// repeated field the last one counts.
class NodeReader {
 public:
  NodeReader(const Node& node, grf::Diagnostics& diagnostics) : node_(node), diagnostics_(diagnostics) {}

  /// Finds a field; null if the file does not have it.
  const Field* find(std::string_view name) const;

  double number(std::string_view name, double fallback) const;
  grf::Vec2d pair(std::string_view name, const grf::Vec2d& fallback) const;
  grf::Vec3d triple(std::string_view name, const grf::Vec3d& fallback) const;
  bool flag(std::string_view name, bool fallback) const;
  /// Reads an integer of a magnitude up to 2^31.
  int integer(std::string_view name, int fallback) const;
  /// Reads a list of numbers whose length is a multiple of the group size.
  std::span<const double> numbers(std::string_view name, std::size_t group_size = 1) const;
  /// Reads that many numbers, or none if the file does not have the field.
  std::span<const double> exactly(std::string_view name, std::size_t count) const;
  std::vector<std::string> strings(std::string_view name) const;
  std::span<const std::string_view> words(std::string_view name) const;
  /// Reads a node; null if there is none.
  const Node* node(std::string_view name) const;
  std::span<const Node* const> nodes(std::string_view name) const;

  /// Reports an error of a number in a field's list, at its location.
  void error_at_number(std::string_view name, std::size_t index, std::string_view message) const;
  /// Reports an error of a field, or of the node if the file does not have the field.
  void error_at(std::string_view name, std::string_view message) const;

 private:
  template <class T>
  const T* value(std::string_view name, std::string_view expected) const;

  const Node& node_;
  grf::Diagnostics& diagnostics_;
};

}  // namespace convert::vrml
