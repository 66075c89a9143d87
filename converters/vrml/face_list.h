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

/// How values of a list belong to faces.
enum class Binding {
  IndexedCorners,  ///< a list of indices has one where coordIndex has one; without it, coordIndex is that
                   ///< list
  CornersInOrder,  ///< each corner of the file has the next value
  IndexedFaces,    ///< a list of indices has one for each face; without it, each face has the next value
  FacesInOrder,    ///< each face of the file has the next value
};

inline constexpr bool is_of_corners(Binding binding) {
  return binding == Binding::IndexedCorners || binding == Binding::CornersInOrder;
}

/// The faces of an IndexedFaceSet, by indices of which each face but the last ends with -1. Faces of fewer
/// than three corners are left out.
class FaceList {
 public:
  /// Nothing after an error: an index of no position.
  static std::optional<FaceList> read(const NodeReader& node, std::size_t position_count);

  const std::vector<std::uint32_t>& corners() const { return corners_; }
  const std::vector<std::size_t>& face_ends() const { return face_ends_; }
  std::size_t short_faces() const { return short_faces_; }

  /// For each corner, or for each face, which of the bound values it has; `index_field` is the list of
  /// indices. Nothing after an error: too short a list, or an index that is none of `value_count`.
  std::optional<std::vector<std::uint32_t>> bound(const NodeReader& node, Binding binding,
                                                  std::string_view index_field,
                                                  std::size_t value_count) const;

  /// Whether there are values for all: what `bound` would say of them, in silence.
  bool has_enough(const NodeReader& node, Binding binding, std::string_view index_field,
                  std::size_t value_count) const;

 private:
  struct BoundIndex {
    double value;       // as the file has it
    std::size_t place;  // in its list
  };
  std::size_t count_of(Binding binding) const;
  BoundIndex bound_index(Binding binding, std::span<const double> indices, std::size_t i) const;
  static bool is_index(double value, std::size_t count);

  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> face_ends_;
  std::vector<std::size_t> places_;  // of each corner in coordIndex
  std::vector<std::uint32_t> face_of_corner_;
  std::vector<std::size_t> face_numbers_;  // of each face among all of the file, those left out included
  std::size_t short_faces_ = 0;
};

/// The list of indices of a field. One that is -1 alone, as VRML 1.0 has it by default, is none.
std::span<const double> index_list(const NodeReader& node, std::string_view field);

}  // namespace convert::vrml
