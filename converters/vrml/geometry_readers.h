// Readers of geometry nodes that both versions share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "converters/vrml/polygons.h"
#include "converters/vrml/report.h"

namespace convert::vrml {

/// Reads the vectors of a field of a Coordinate, Coordinate3 or Normal node.
std::vector<grf::Vec3f> read_vectors(const Node& node, std::string_view field, Report& report);

/// Reads the texture coordinates of a TextureCoordinate or TextureCoordinate2 node.
std::vector<grf::Vec2f> read_uvs(const Node& node, Report& report);

/// Reads a size of a solid; a value that is not above 0 is an error.
double read_size(const Node& node, std::string_view field, double fallback, Report& report);

/// Counts a curved solid that was tessellated.
void note_tessellation(Report& report);

/// Returns the values at indices.
template <class T>
std::vector<T> picked(const std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
  std::vector<T> result;
  result.reserve(indices.size());
  for (const std::uint32_t index : indices) result.push_back(values[index]);
  return result;
}

/// Expands values per face to values per corner.
template <class T>
std::vector<T> spread_over_corners(const std::vector<T>& of_faces, const Polygons& polygons) {
  std::vector<T> result;
  result.reserve(polygons.corners.size());
  for (std::size_t i = 0; i < of_faces.size(); ++i) result.resize(polygons.face_ends[i], of_faces[i]);
  return result;
}

}  // namespace convert::vrml
