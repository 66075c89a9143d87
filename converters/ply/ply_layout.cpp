#include "converters/ply/ply_layout.h"

#include <algorithm>
#include <span>

namespace convert {
namespace {

struct SlotName {
  std::string_view name;
  PlySlot slot;
};

constexpr std::array ColourNames = {SlotName{"red", PlySlot::Red},
                                    SlotName{"green", PlySlot::Green},
                                    SlotName{"blue", PlySlot::Blue},
                                    SlotName{"alpha", PlySlot::Alpha},
                                    SlotName{"r", PlySlot::Red},
                                    SlotName{"g", PlySlot::Green},
                                    SlotName{"b", PlySlot::Blue},
                                    SlotName{"a", PlySlot::Alpha},
                                    SlotName{"diffuse_red", PlySlot::Red},
                                    SlotName{"diffuse_green", PlySlot::Green},
                                    SlotName{"diffuse_blue", PlySlot::Blue},
                                    SlotName{"diffuse_alpha", PlySlot::Alpha}};

// Names of texture coordinates are those of Blender (s, t), MeshLab (texture_u, texture_v) and others.
constexpr std::array VertexNames = {
    SlotName{"x", PlySlot::X},         SlotName{"y", PlySlot::Y},         SlotName{"z", PlySlot::Z},
    SlotName{"nx", PlySlot::NormalX},  SlotName{"ny", PlySlot::NormalY},  SlotName{"nz", PlySlot::NormalZ},
    SlotName{"u", PlySlot::U},         SlotName{"v", PlySlot::V},         SlotName{"s", PlySlot::U},
    SlotName{"t", PlySlot::V},         SlotName{"texture_u", PlySlot::U}, SlotName{"texture_v", PlySlot::V},
    SlotName{"texture_s", PlySlot::U}, SlotName{"texture_t", PlySlot::V}};

constexpr std::array FaceNames = {SlotName{"material_index", PlySlot::Material},
                                  SlotName{"texnumber", PlySlot::Texture}};

std::optional<PlySlot> find(std::span<const SlotName> names, std::string_view name) {
  const auto known =
      std::find_if(names.begin(), names.end(), [name](const SlotName& entry) { return entry.name == name; });
  return known == names.end() ? std::nullopt : std::optional(known->slot);
}

/// Ignores components of a vector that lacks other components, as if they were unknown.
void drop_incomplete(PlyLayout& layout) {
  const auto drop = [&layout](std::initializer_list<PlySlot> slots) {
    for (const PlySlot slot : slots) {
      layout.properties[static_cast<std::size_t>(slot)] = nullptr;
      for (PlyLayout::Meaning& meaning : layout.meanings) {
        if (meaning.slot == slot) meaning.slot.reset();
      }
    }
  };
  if (!layout.has_normal()) drop({PlySlot::NormalX, PlySlot::NormalY, PlySlot::NormalZ});
  if (!layout.has_colour()) drop({PlySlot::Red, PlySlot::Green, PlySlot::Blue});
  if (!layout.has_uv()) drop({PlySlot::U, PlySlot::V});
}

PlyLayout layout_of(const PlyElement& element, std::span<const SlotName> names, bool is_face) {
  PlyLayout layout;
  for (const PlyProperty& property : element.properties) {
    PlyLayout::Meaning& meaning = layout.meanings.emplace_back();
    if (property.count_type) {
      const bool is_corners = property.name == "vertex_indices" || property.name == "vertex_index";
      if (is_face && is_corners && layout.corners == nullptr && !is_float(property.type)) {
        meaning.list = PlyList::Corners;
        layout.corners = &property;
      } else if (is_face && property.name == "texcoord") {
        meaning.list = PlyList::CornerUvs;
      }
      continue;
    }
    meaning.slot = find(names, property.name);
    if (!meaning.slot) meaning.slot = find(ColourNames, property.name);
    const bool is_number = meaning.slot == PlySlot::Material || meaning.slot == PlySlot::Texture;
    if (is_number && is_float(property.type)) meaning.slot.reset();
    if (!meaning.slot) continue;
    const PlyProperty*& known = layout.properties[static_cast<std::size_t>(*meaning.slot)];
    if (known != nullptr) {
      meaning.slot.reset();
    } else {
      known = &property;
    }
  }
  drop_incomplete(layout);
  return layout;
}

}  // namespace

PlyLayout vertex_layout(const PlyElement& element) { return layout_of(element, VertexNames, false); }
PlyLayout face_layout(const PlyElement& element) { return layout_of(element, FaceNames, true); }

double full_component(PlyType type) {
  switch (type) {
    case PlyType::Int8:
      return 127;
    case PlyType::Int16:
      return 32767;
    case PlyType::UInt16:
      return 65535;
    case PlyType::Float32:
    case PlyType::Float64:
      return 1;
    default:
      return 255;
  }
}

}  // namespace convert
