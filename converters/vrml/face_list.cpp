#include "converters/vrml/face_list.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "converters/wording.h"

namespace convert::vrml {
namespace {

constexpr std::string_view CoordinateIndices = "coordIndex";
constexpr double EndOfFace = -1;

}  // namespace

std::optional<FaceList> FaceList::read(const NodeReader& node, std::size_t position_count) {
  const std::span<const double> indices = node.numbers(CoordinateIndices);
  FaceList list;
  std::size_t face_number = 0;
  for (std::size_t begin = 0; begin < indices.size(); ++face_number) {
    std::size_t end = begin;
    for (; end < indices.size() && indices[end] != EndOfFace; ++end) {
      if (is_index(indices[end], position_count)) continue;
      node.error_at_number(
          CoordinateIndices, end,
          fmt::format("the index {} is of no coordinate: there are {}", indices[end], position_count));
      return std::nullopt;
    }
    if (end - begin < 3) {
      ++list.degenerate_faces_;
    } else {
      const auto face = static_cast<std::uint32_t>(list.face_ends_.size());
      for (std::size_t i = begin; i < end; ++i) {
        list.corners_.push_back(static_cast<std::uint32_t>(indices[i]));
        list.places_.push_back(i);
        list.face_of_corner_.push_back(face);
      }
      list.face_ends_.push_back(list.corners_.size());
      list.face_numbers_.push_back(face_number);
    }
    begin = end + 1;
  }
  return list;
}

bool FaceList::is_index(double value, std::size_t count) {
  return value >= 0 && value < static_cast<double>(count) && value == std::floor(value);
}

std::size_t FaceList::count_of(Binding binding) const {
  return is_of_corners(binding) ? corners_.size() : face_ends_.size();
}

FaceList::BoundIndex FaceList::bound_index(Binding binding, std::span<const double> indices,
                                           std::size_t i) const {
  const std::size_t number = face_numbers_[is_of_corners(binding) ? face_of_corner_[i] : i];
  const auto in_order = [](std::size_t value) { return BoundIndex{static_cast<double>(value), value}; };
  switch (binding) {
    case Binding::IndexedCorners:
      if (indices.empty()) return {static_cast<double>(corners_[i]), places_[i]};
      return {places_[i] < indices.size() ? indices[places_[i]] : EndOfFace, places_[i]};
    case Binding::CornersInOrder:
      return in_order(places_[i] - number);  // a -1 ends each previous face
    case Binding::IndexedFaces:
      if (indices.empty()) return in_order(number);
      return {number < indices.size() ? indices[number] : EndOfFace, number};
    case Binding::FacesInOrder:
      break;
  }
  return in_order(number);
}

std::optional<std::vector<std::uint32_t>> FaceList::bound(const NodeReader& node, Binding binding,
                                                          std::string_view index_field,
                                                          std::size_t value_count) const {
  const std::span<const double> indices = index_list(node, index_field);
  std::vector<std::uint32_t> bound;
  bound.reserve(count_of(binding));
  for (std::size_t i = 0; i < count_of(binding); ++i) {
    const auto [value, place] = bound_index(binding, indices, i);
    if (!is_index(value, value_count)) {
      if (indices.empty()) {
        node.error_at(index_field, fmt::format("there {} {} for '{}', too few for the faces",
                                               value_count == 1 ? "is" : "are",
                                               counted(value_count, "value", "values"), index_field));
      } else if (place >= indices.size()) {
        node.error_at(index_field, fmt::format("the list '{}' has {}, too few for the faces", index_field,
                                               counted(indices.size(), "index", "indices")));
      } else {
        node.error_at_number(index_field, place,
                             fmt::format("the index {} in '{}' is of no value: there are {}", value,
                                         index_field, value_count));
      }
      return std::nullopt;
    }
    bound.push_back(static_cast<std::uint32_t>(value));
  }
  return bound;
}

bool FaceList::has_enough(const NodeReader& node, Binding binding, std::string_view index_field,
                          std::size_t value_count) const {
  const std::span<const double> indices = index_list(node, index_field);
  for (std::size_t i = 0; i < count_of(binding); ++i) {
    if (!is_index(bound_index(binding, indices, i).value, value_count)) return false;
  }
  return true;
}

std::span<const double> index_list(const NodeReader& node, std::string_view field) {
  const std::span<const double> indices = node.numbers(field);
  const bool is_none = indices.size() == 1 && indices[0] == EndOfFace;
  return is_none ? std::span<const double>() : indices;
}

}  // namespace convert::vrml
