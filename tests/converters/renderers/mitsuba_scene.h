// A strict parser of the part of Mitsuba 3's scenes that its documentation describes
// (mitsuba.readthedocs.io), written apart from the writer.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grf/math.h"

namespace test {

/// An element: a plugin with a type, or a transform.
struct MitsubaElement {
  std::string tag;   ///< bsdf, shape and so on
  std::string type;  ///< of a plugin
  std::string id;
  std::string name;                                  ///< as a parameter of another one
  std::map<std::string, std::string> values;         ///< of plain parameters, by name
  std::map<std::string, std::vector<double>> lists;  ///< of colours, vectors and matrices, by name
  std::vector<std::string> references;
  std::vector<MitsubaElement> children;

  double number(const std::string& key) const { return std::stod(values.at(key)); }
  /// Returns the child with this tag; throws std::out_of_range if there is none.
  const MitsubaElement& child(const std::string& tag_of_child) const;
  std::vector<MitsubaElement> all(const std::string& tag_of_child) const;
  /// Returns the transform to world space, for row vectors; the identity if there is none.
  grf::Matrix44d to_world() const;
};

/// Parses a scene. Throws std::runtime_error for anything that Mitsuba's documentation does not have: unknown
/// plugins or parameters, wrong types, colours out of range, references to nothing, and files that do not
/// exist in the folder.
MitsubaElement parse_mitsuba(std::string_view text, const std::string& folder);

/// Returns where Mitsuba's camera sees a point, in pixels from the upper left corner.
grf::Vec2d mitsuba_pixel(const MitsubaElement& scene, const grf::Vec3d& point);

}  // namespace test
