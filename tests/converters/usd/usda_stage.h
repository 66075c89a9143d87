// A strict parser of the part of usda 1.0 and of the schemas (UsdGeom, UsdShade, UsdLux) that their
// documentation describes (openusd.org), written apart from the writer.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grf/math.h"

namespace test {

/// The value of an attribute: its elements in order, whatever the tuples.
struct UsdaValue {
  std::string type;
  bool is_uniform = false;
  std::vector<double> numbers;
  std::vector<std::string> strings;  ///< also of tokens, assets and paths
  std::size_t elements = 0;          ///< of an array
  std::string interpolation;
  std::string connection;  ///< the path of an output; empty: none
};

struct UsdaPrim {
  std::string specifier;  ///< def or class
  std::string type;
  std::string name;
  std::string path;
  bool is_instanceable = false;
  std::string reference;                      ///< path of a prim
  std::vector<std::string> schemas;           ///< applied
  std::map<std::string, std::string> custom;  ///< strings of customData, by name
  std::map<std::string, UsdaValue> attributes;
  std::vector<UsdaPrim> children;

  const UsdaValue& attribute(const std::string& key) const { return attributes.at(key); }
  double number(const std::string& key) const { return attribute(key).numbers.at(0); }
  const std::string& string(const std::string& key) const { return attribute(key).strings.at(0); }
  /// Returns the child with this name; throws std::out_of_range if there is none.
  const UsdaPrim& child(const std::string& key) const;
  /// Returns all prims of a type below it, in order.
  std::vector<const UsdaPrim*> all(const std::string& type_of_prims) const;
  /// Returns the transform to the parent, for row vectors.
  grf::Matrix44d to_parent() const;
};

struct UsdaStage {
  UsdaPrim root;  ///< the default prim

  const UsdaPrim* find(const std::string& path) const;
};

/// Parses a stage. Throws std::runtime_error for what USD's documentation does not have: unknown types of
/// prims or attributes, arrays of a wrong size, indices out of range, faces that are in no subset or in two,
/// bindings and connections to nothing or to another type, references to nothing, and images that do not
/// exist in the folder, unless that is empty.
UsdaStage parse_usda(std::string_view text, const std::string& folder = {});

}  // namespace test
