// What the properties of vertices and faces mean.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "converters/ply/ply_header.h"
#include "grf/math.h"

namespace convert {

/// What one number of a vertex or a face says.
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
  Material,  ///< of a face: a number under which a comment has a name
  Texture,   ///< of a face: among the files that comments name
  Count
};

/// What a list of a face says.
enum class PlyList { Corners, CornerUvs };

/// The properties of an element, seen as what they mean.
struct PlyLayout {
  struct Meaning {
    std::optional<PlySlot> slot;
    std::optional<PlyList> list;
  };
  std::vector<Meaning> meanings;  ///< of each property; those that are not read have none

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

/// The element outlives what is given. Where two properties mean one thing, the first one holds.
PlyLayout vertex_layout(const PlyElement& element);
PlyLayout face_layout(const PlyElement& element);

/// The values of the slots of one vertex or face.
using PlySlotValues = std::array<double, static_cast<std::size_t>(PlySlot::Count)>;

inline double at(const PlySlotValues& values, PlySlot slot) { return values[static_cast<std::size_t>(slot)]; }

/// The value that stands for a component of 1: 255 in bytes, and in integers of 32 bits, which exporters use
/// for the same range. Floats are as they are.
double full_component(PlyType type);

/// A component of a colour from the value of a property.
inline float to_component(double value, PlyType type) {
  return static_cast<float>(value / full_component(type));
}

}  // namespace convert
