// A VRML file as a tree of nodes with fields. Values are kept as they were written: which fields a node has,
// and of which type, is the business of whoever looks at them (NodeReader).
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

/// As they stand between the quotes.
struct Strings {
  std::vector<std::string_view> texts;
};
/// TRUE, FALSE, and in VRML 1.0 enumerations and strings without quotes.
struct Words {
  std::vector<std::string_view> words;
};

/// NULL and an empty list are nothing.
using Value = std::variant<std::monostate, std::vector<double>, Strings, Words, std::vector<const Node*>>;

struct Field {
  std::string_view name;
  Value value;
  std::size_t offset = 0;        ///< of the name
  std::size_t value_offset = 0;  ///< of the value's first token
};

struct Node {
  std::string_view type;
  std::string_view name;  ///< by DEF; may be empty
  std::vector<Field> fields;
  std::vector<const Node*> children;  ///< in VRML 1.0, where they stand between the fields
  const Source* source = nullptr;
  std::size_t offset = 0;
  /// False of what is no node of the standard, such as an instance of a prototype. It has no fields.
  bool is_known = true;

  grf::SourceLocation location() const { return source->location(offset); }
};

/// A whole file. USE has become the node that it means, so that nodes may stand in several places, but none
/// inside itself.
struct Document {
  std::shared_ptr<const Source> source;
  std::deque<Node> nodes;  ///< each comes before those inside it
  std::vector<const Node*> roots;
  std::size_t routes = 0;
  std::vector<std::string_view> prototypes;  ///< names, in their order
};

/// Looks at the fields of a node. What a field lacks is an error that names its place, and gives the default.
/// A field that is written twice counts as it is written last.
class NodeReader {
 public:
  NodeReader(const Node& node, grf::Diagnostics& diagnostics) : node_(node), diagnostics_(diagnostics) {}

  /// Null if the field is not written.
  const Field* find(std::string_view name) const;

  double number(std::string_view name, double fallback) const;
  grf::Vec2d pair(std::string_view name, const grf::Vec2d& fallback) const;
  grf::Vec3d triple(std::string_view name, const grf::Vec3d& fallback) const;
  bool flag(std::string_view name, bool fallback) const;
  /// A whole number whose magnitude is not over 2^31.
  int integer(std::string_view name, int fallback) const;
  /// Any number of numbers, in groups of so many.
  std::span<const double> numbers(std::string_view name, std::size_t group_size = 1) const;
  /// So many numbers, or none if the field is not written.
  std::span<const double> exactly(std::string_view name, std::size_t count) const;
  std::vector<std::string> strings(std::string_view name) const;
  std::span<const std::string_view> words(std::string_view name) const;
  /// Null if there is none.
  const Node* node(std::string_view name) const;
  std::span<const Node* const> nodes(std::string_view name) const;

  /// Says what is wrong with a number of a field's list, at its place.
  void error_at_number(std::string_view name, std::size_t index, std::string_view message) const;
  /// Says what is wrong with a field, or with the node if the field is not written.
  void error_at(std::string_view name, std::string_view message) const;

 private:
  template <class T>
  const T* value(std::string_view name, std::string_view expected) const;

  const Node& node_;
  grf::Diagnostics& diagnostics_;
};

}  // namespace convert::vrml
