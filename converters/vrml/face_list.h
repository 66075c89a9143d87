#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "converters/vrml/node.h"
#include "converters/vrml/polygons.h"

namespace convert::vrml {

/// The binding of a list of values to faces or corners.
enum class Binding {
  IndexedCorners,  ///< an index list parallel to coordIndex; without it, coordIndex itself
  CornersInOrder,  ///< a value per corner of the file, in order
  IndexedFaces,    ///< an index list with an entry per face; without it, a value per face in order
  FacesInOrder,    ///< a value per face of the file, in order
};

inline constexpr bool is_of_corners(Binding binding) {
  return binding == Binding::IndexedCorners || binding == Binding::CornersInOrder;
}

/// The faces of an IndexedFaceSet: a list of indices in which -1 terminates each face (optional for the
/// last). Faces of fewer than three corners are skipped.
class FaceList {
 public:
  /// Reads the faces; returns nothing after an error: an index out of range.
  static std::optional<FaceList> read(const NodeReader& node, std::size_t position_count);

  const std::vector<std::uint32_t>& corners() const { return corners_; }
  const std::vector<std::size_t>& face_ends() const { return face_ends_; }
  std::size_t degenerate_faces() const { return degenerate_faces_; }

  /// Returns the index of the bound value per corner or per face; `index_field` is the list of indices.
  /// Returns nothing after an error: a list that is too short, or an index not below `value_count`.
  std::optional<std::vector<std::uint32_t>> bound(const NodeReader& node, Binding binding,
                                                  std::string_view index_field,
                                                  std::size_t value_count) const;

  /// Returns whether there are enough values for `bound`, without reporting an error.
  bool has_enough(const NodeReader& node, Binding binding, std::string_view index_field,
                  std::size_t value_count) const;

 private:
  struct BoundIndex {
    double value;       // as the file has it
    std::size_t place;  // index in its list
  };
  std::size_t count_of(Binding binding) const;
  BoundIndex bound_index(Binding binding, std::span<const double> indices, std::size_t i) const;
  static bool is_index(double value, std::size_t count);

  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> face_ends_;
  std::vector<std::size_t> places_;  // index of each corner in coordIndex
  std::vector<std::uint32_t> face_of_corner_;
  std::vector<std::size_t> face_numbers_;  // index of each face in the file, counting skipped ones
  std::size_t degenerate_faces_ = 0;
};

/// Returns the list of indices of a field; the default of VRML 1.0, only -1, counts as empty.
std::span<const double> index_list(const NodeReader& node, std::string_view field);

}  // namespace convert::vrml
