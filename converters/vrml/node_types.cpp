#include "converters/vrml/node_types.h"

#include <algorithm>
#include <array>
#include <span>

namespace convert::vrml {
namespace {

// The node types of VRML97 (ISO/IEC 14772-1, chapter 6), without Script.
constexpr std::array<std::string_view, 53> Vrml97Types = {
    "Anchor",
    "Appearance",
    "AudioClip",
    "Background",
    "Billboard",
    "Box",
    "Collision",
    "Color",
    "ColorInterpolator",
    "Cone",
    "Coordinate",
    "CoordinateInterpolator",
    "Cylinder",
    "CylinderSensor",
    "DirectionalLight",
    "ElevationGrid",
    "Extrusion",
    "Fog",
    "FontStyle",
    "Group",
    "ImageTexture",
    "IndexedFaceSet",
    "IndexedLineSet",
    "Inline",
    "LOD",
    "Material",
    "MovieTexture",
    "NavigationInfo",
    "Normal",
    "NormalInterpolator",
    "OrientationInterpolator",
    "PixelTexture",
    "PlaneSensor",
    "PointLight",
    "PointSet",
    "PositionInterpolator",
    "ProximitySensor",
    "ScalarInterpolator",
    "Shape",
    "Sound",
    "Sphere",
    "SphereSensor",
    "SpotLight",
    "Switch",
    "Text",
    "TextureCoordinate",
    "TextureTransform",
    "TimeSensor",
    "TouchSensor",
    "Transform",
    "Viewpoint",
    "VisibilitySensor",
    "WorldInfo",
};

// The node types of VRML 1.0 (specification of 26 May 1995, section "Nodes").
constexpr std::array<std::string_view, 36> Vrml1Types = {
    "AsciiText",
    "Cone",
    "Coordinate3",
    "Cube",
    "Cylinder",
    "DirectionalLight",
    "FontStyle",
    "Group",
    "IndexedFaceSet",
    "IndexedLineSet",
    "Info",
    "LOD",
    "Material",
    "MaterialBinding",
    "MatrixTransform",
    "Normal",
    "NormalBinding",
    "OrthographicCamera",
    "PerspectiveCamera",
    "PointLight",
    "PointSet",
    "Rotation",
    "Scale",
    "Separator",
    "ShapeHints",
    "Sphere",
    "SpotLight",
    "Switch",
    "Texture2",
    "Texture2Transform",
    "TextureCoordinate2",
    "Transform",
    "TransformSeparator",
    "Translation",
    "WWWAnchor",
    "WWWInline",
};

bool is_one_of(std::string_view type, std::initializer_list<std::string_view> types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

bool is_standard_type(std::string_view type, Version version) {
  const std::span<const std::string_view> types =
      version == Version::Vrml1 ? std::span<const std::string_view>(Vrml1Types) : Vrml97Types;
  return std::binary_search(types.begin(), types.end(), type);
}

std::string_view reason_for_skipping(std::string_view type, Version version) {
  if (type == "Script" || type.ends_with("Sensor") || type.ends_with("Interpolator")) {
    return "GRF scenes are static";
  }
  if (!is_standard_type(type, version)) return "the standard has no node of that name";
  if (is_one_of(type, {"IndexedLineSet", "PointSet", "Text", "AsciiText"})) return "GRF has only faces";
  if (is_one_of(type, {"Sound", "AudioClip"})) return "GRF has no sound";
  if (is_one_of(type, {"Background", "Fog"})) return "GRF has none";
  if (is_one_of(type, {"MovieTexture", "PixelTexture"})) return "textures are images in files of their own";
  if (is_one_of(type, {"NavigationInfo", "WorldInfo", "Info", "FontStyle"})) {
    return "it has no geometry";
  }
  return "it is not allowed there";
}

bool is_light(std::string_view type) {
  return is_one_of(type, {"DirectionalLight", "PointLight", "SpotLight"});
}

bool is_camera(std::string_view type) {
  return is_one_of(type, {"Viewpoint", "PerspectiveCamera", "OrthographicCamera"});
}

}  // namespace convert::vrml
