// The layout of a PLY file says what the properties of its vertices and faces mean.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "converters/ply/ply_header.h"
#include "grf/math.h"

namespace convert {

/// The meaning of a scalar property of a vertex or a face.
enum class PlySlot {
  X,
  Y,
  Z,
  NormalX,
  NormalY,
  NormalZ,
  Red,
  Green,
  Blue,
  Alpha,
  U,
  V,
  Material,  ///< of a face: the number of a material that a comment names
  Texture,   ///< of a face: the index of a file that a comment names
  Count
};

/// The meaning of a list property of a face.
enum class PlyList { Corners, CornerUvs };

/// The layout of an element: the meaning of its properties.
struct PlyLayout {
  struct Meaning {
    std::optional<PlySlot> slot;
    std::optional<PlyList> list;
  };
  std::vector<Meaning> meanings;  ///< by property; ignored ones have none

  /// The property of each slot, or null.
  std::array<const PlyProperty*, static_cast<std::size_t>(PlySlot::Count)> properties = {};
  const PlyProperty* corners = nullptr;

  const PlyProperty* of(PlySlot slot) const { return properties[static_cast<std::size_t>(slot)]; }
  bool has_position() const { return has(PlySlot::X) && has(PlySlot::Y) && has(PlySlot::Z); }
  bool has_normal() const { return has(PlySlot::NormalX) && has(PlySlot::NormalY) && has(PlySlot::NormalZ); }
  bool has_colour() const { return has(PlySlot::Red) && has(PlySlot::Green) && has(PlySlot::Blue); }
  bool has_uv() const { return has(PlySlot::U) && has(PlySlot::V); }
  bool has(PlySlot slot) const { return of(slot) != nullptr; }
};

/// Finds the layout of an element, which must outlive it. Of two properties with one meaning, the first
/// counts.
PlyLayout vertex_layout(const PlyElement& element);
PlyLayout face_layout(const PlyElement& element);

/// The values of the slots of one vertex or face.
using PlySlotValues = std::array<double, static_cast<std::size_t>(PlySlot::Count)>;

inline double at(const PlySlotValues& values, PlySlot slot) { return values[static_cast<std::size_t>(slot)]; }

/// Returns the value of a full colour component, 1: 255 in bytes, and in 32-bit integers, which exporters use
/// for the same range; floats are not scaled.
double full_component(PlyType type);

/// Converts the value of a property to a colour component.
inline float to_component(double value, PlyType type) {
  return static_cast<float>(value / full_component(type));
}

}  // namespace convert
