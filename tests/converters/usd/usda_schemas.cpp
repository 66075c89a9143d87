#include "tests/converters/usd/usda_schemas.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

namespace test {
namespace {

[[noreturn]] void fail(const std::string& why) { throw std::runtime_error(why); }
void require(bool holds, const std::string& why) {
  if (!holds) fail(why);
}

using Attributes = std::map<std::string, std::string>;

/// Attributes of prims by type, with `uniform` before the type where the schema has it.
const std::map<std::string, Attributes>& schemas() {
  static const std::map<std::string, Attributes> all = {
      {"", {}},
      {"Scope", {}},
      {"Xform", {{"xformOp:transform", "matrix4d"}, {"xformOpOrder", "uniform token[]"}}},
      {"Material",
       {{"config:mtlx:version", "string"}, {"outputs:surface", "token"}, {"outputs:mtlx:surface", "token"}}},
      {"GeomSubset",
       {{"elementType", "uniform token"},
        {"familyName", "uniform token"},
        {"indices", "int[]"},
        {"material:binding", "rel"}}},
      {"Mesh",
       {{"doubleSided", "uniform bool"},
        {"orientation", "uniform token"},
        {"subdivisionScheme", "uniform token"},
        {"extent", "float3[]"},
        {"faceVertexCounts", "int[]"},
        {"faceVertexIndices", "int[]"},
        {"points", "point3f[]"},
        {"normals", "normal3f[]"},
        {"primvars:st", "texCoord2f[]"},
        {"primvars:displayColor", "color3f[]"},
        {"primvars:vertexColor", "color3f[]"},
        {"subsetFamily:materialBind:familyType", "uniform token"}}},
      {"Camera",
       {{"projection", "token"},
        {"focalLength", "float"},
        {"verticalAperture", "float"},
        {"horizontalAperture", "float"},
        {"clippingRange", "float2"},
        {"focusDistance", "float"},
        {"fStop", "float"},
        {"xformOp:transform", "matrix4d"},
        {"xformOpOrder", "uniform token[]"}}},
      {"RenderSettings", {{"camera", "rel"}, {"resolution", "uniform int2"}}},
      {"DomeLight",
       {{"inputs:color", "color3f"},
        {"inputs:intensity", "float"},
        {"inputs:texture:file", "asset"},
        {"inputs:texture:format", "token"},
        {"xformOp:rotateY", "float"},
        {"xformOpOrder", "uniform token[]"}}},
      {"RectLight",
       {{"inputs:color", "color3f"},
        {"inputs:intensity", "float"},
        {"inputs:width", "float"},
        {"inputs:height", "float"},
        {"inputs:normalize", "bool"},
        {"xformOp:transform", "matrix4d"},
        {"xformOpOrder", "uniform token[]"}}},
  };
  return all;
}

/// Attributes of shaders by identifier; those of nodes of MaterialX are checked by their document.
const std::map<std::string, Attributes>& shaders() {
  static const std::map<std::string, Attributes> all = {
      {"UsdPreviewSurface",
       {{"inputs:diffuseColor", "color3f"},
        {"inputs:emissiveColor", "color3f"},
        {"inputs:useSpecularWorkflow", "int"},
        {"inputs:specularColor", "color3f"},
        {"inputs:metallic", "float"},
        {"inputs:roughness", "float"},
        {"inputs:clearcoat", "float"},
        {"inputs:clearcoatRoughness", "float"},
        {"inputs:opacity", "float"},
        {"inputs:opacityMode", "token"},
        {"inputs:opacityThreshold", "float"},
        {"inputs:ior", "float"},
        {"outputs:surface", "token"}}},
      {"UsdUVTexture",
       {{"inputs:file", "asset"},
        {"inputs:st", "float2"},
        {"inputs:wrapS", "token"},
        {"inputs:wrapT", "token"},
        {"inputs:scale", "float4"},
        {"inputs:sourceColorSpace", "token"},
        {"outputs:rgb", "float3"},
        {"outputs:a", "float"}}},
      {"UsdPrimvarReader_float2", {{"inputs:varname", "string"}, {"outputs:result", "float2"}}},
      {"UsdPrimvarReader_float3", {{"inputs:varname", "string"}, {"outputs:result", "float3"}}},
  };
  return all;
}

const std::map<std::string, std::set<std::string>> Tokens = {
    {"orientation", {"rightHanded", "leftHanded"}},
    {"subdivisionScheme", {"none"}},
    {"elementType", {"face"}},
    {"familyName", {"materialBind"}},
    {"subsetFamily:materialBind:familyType", {"partition"}},
    {"projection", {"perspective"}},
    {"inputs:wrapS", {"repeat", "clamp", "mirror", "black"}},
    {"inputs:wrapT", {"repeat", "clamp", "mirror", "black"}},
    {"inputs:sourceColorSpace", {"raw", "sRGB", "auto"}},
    {"inputs:opacityMode", {"transparent", "presence"}},
    {"inputs:texture:format", {"latlong", "automatic"}},
};

/// Checks the prims of one stage.
class UsdaChecker {
 public:
  UsdaChecker(const UsdaStage& stage, const std::string& folder) : stage_(stage), folder_(folder) {}

  void check(const UsdaPrim& prim);

 private:
  void check_attributes(const UsdaPrim& prim, const Attributes& known);
  void check_transform(const UsdaPrim& prim);
  void check_mesh(const UsdaPrim& prim);
  void check_subsets(const UsdaPrim& prim, std::size_t faces);
  void check_connection(const UsdaValue& value);

  const UsdaStage& stage_;
  const std::string& folder_;
};

void UsdaChecker::check_connection(const UsdaValue& value) {
  const std::size_t dot = value.connection.rfind('.');
  require(dot != std::string::npos, "a connection names no attribute: " + value.connection);
  const UsdaPrim* source = stage_.find(value.connection.substr(0, dot));
  const std::string output = value.connection.substr(dot + 1);
  require(source != nullptr && source->attributes.contains(output), "no output " + value.connection);
  const auto base = [](const std::string& type) {
    return type == "color3f" ? "float3" : type == "color4f" ? "float4" : type;
  };
  require(base(source->attribute(output).type) == base(value.type), "another type than " + value.connection);
}

void UsdaChecker::check_attributes(const UsdaPrim& prim, const Attributes& known) {
  for (const auto& [name, value] : prim.attributes) {
    const auto expected = known.find(name);
    require(expected != known.end(), "unknown attribute of " + prim.path + ": " + name);
    require(expected->second == (value.is_uniform ? "uniform " : "") + value.type,
            "wrong type of " + prim.path + "." + name + ": " + value.type);
    const auto tokens = Tokens.find(name);
    require(tokens == Tokens.end() || tokens->second.contains(value.strings.at(0)),
            "unknown token of " + prim.path + "." + name);
  }
}

void UsdaChecker::check_transform(const UsdaPrim& prim) {
  const auto order = prim.attributes.find("xformOpOrder");
  std::size_t operations = 0;
  for (const auto& [name, value] : prim.attributes) operations += name.starts_with("xformOp:") ? 1 : 0;
  require((order == prim.attributes.end()) == (operations == 0),
          "a transform without its order: " + prim.path);
  if (order == prim.attributes.end()) return;
  require(order->second.strings.size() == operations, "another number of operations: " + prim.path);
  for (const std::string& name : order->second.strings)
    require(prim.attributes.contains(name), "no operation " + name);
}

std::size_t size_for(const std::string& interpolation, std::size_t faces, std::size_t corners,
                     std::size_t points) {
  if (interpolation == "uniform") return faces;
  if (interpolation == "faceVarying") return corners;
  require(interpolation == "vertex", "no interpolation: " + interpolation);
  return points;
}

void UsdaChecker::check_subsets(const UsdaPrim& prim, std::size_t faces) {
  std::vector<int> count(faces);
  for (const UsdaPrim& subset : prim.children) {
    require(subset.type == "GeomSubset", "a mesh has another child than subsets");
    require(subset.schemas == std::vector<std::string>{"MaterialBindingAPI"}, "a subset is not bound");
    for (const double index : subset.attribute("indices").numbers) {
      require(index >= 0 && index < static_cast<double>(faces), "a subset has a face that does not exist");
      ++count[static_cast<std::size_t>(index)];
    }
    const UsdaPrim* material = stage_.find(subset.string("material:binding"));
    require(material != nullptr && material->type == "Material", "no material: " + subset.path);
  }
  require(std::all_of(count.begin(), count.end(), [](int n) { return n == 1; }),
          "a face is in no subset or in two: " + prim.path);
}

void UsdaChecker::check_mesh(const UsdaPrim& prim) {
  const std::vector<double>& counts = prim.attribute("faceVertexCounts").numbers;
  const std::vector<double>& indices = prim.attribute("faceVertexIndices").numbers;
  const std::size_t points = prim.attribute("points").elements;
  double corners = 0;
  for (const double n : counts) {
    require(n >= 3, "a face has fewer than three corners");
    corners += n;
  }
  require(corners == static_cast<double>(indices.size()), "another number of corners: " + prim.path);
  for (const double index : indices)
    require(index >= 0 && index < static_cast<double>(points), "a corner without a point: " + prim.path);
  require(prim.attribute("extent").elements == 2, "an extent has two points");
  for (const auto& [name, value] : prim.attributes) {
    if (name != "normals" && !name.starts_with("primvars:")) continue;
    require(value.elements == size_for(value.interpolation, counts.size(), indices.size(), points),
            "wrong size of " + prim.path + "." + name);
  }
  require(prim.attributes.contains("subsetFamily:materialBind:familyType"),
          "no type of the family of subsets");
  require(prim.attributes.contains("subdivisionScheme"), "the mesh would be subdivided");
  check_subsets(prim, counts.size());
}

void UsdaChecker::check(const UsdaPrim& prim) {
  if (prim.type == "Shader") {
    const std::string& id = prim.string("info:id");
    UsdaPrim others = prim;
    others.attributes.erase("info:id");
    const auto known = shaders().find(id);
    require(known != shaders().end() || id.starts_with("ND_"), "unknown shader " + id);
    if (known != shaders().end()) check_attributes(others, known->second);
  } else {
    const auto known = schemas().find(prim.type);
    require(known != schemas().end(), "unknown type of prims: " + prim.type);
    check_attributes(prim, known->second);
  }
  if (prim.type == "Mesh") check_mesh(prim);
  check_transform(prim);
  require(prim.reference.empty() || (stage_.find(prim.reference) != nullptr && prim.is_instanceable),
          "a reference to nothing: " + prim.reference);
  for (const auto& [name, value] : prim.attributes) {
    if (!value.connection.empty()) check_connection(value);
    if (value.type == "rel") require(stage_.find(value.strings.at(0)) != nullptr, "a target does not exist");
    if (value.type != "asset" || folder_.empty()) continue;
    require(std::filesystem::exists(std::filesystem::path(folder_) / value.strings.at(0)),
            "no file " + value.strings.at(0));
  }
  for (const UsdaPrim& child : prim.children) check(child);
}

}  // namespace

const UsdaType& usda_type(const std::string& name) {
  using Kind = UsdaType::Kind;
  static const std::map<std::string, UsdaType> types = {
      {"bool", {Kind::Number, 1, 1, true}},
      {"int", {Kind::Number, 1, 1, true}},
      {"int2", {Kind::Number, 1, 2, true}},
      {"float", {}},
      {"float2", {Kind::Number, 1, 2}},
      {"float3", {Kind::Number, 1, 3}},
      {"float4", {Kind::Number, 1, 4}},
      {"point3f", {Kind::Number, 1, 3}},
      {"normal3f", {Kind::Number, 1, 3}},
      {"color3f", {Kind::Number, 1, 3}},
      {"color4f", {Kind::Number, 1, 4}},
      {"texCoord2f", {Kind::Number, 1, 2}},
      {"matrix4d", {Kind::Number, 4, 4}},
      {"token", {Kind::String}},
      {"string", {Kind::String}},
      {"asset", {Kind::Asset}},
      {"rel", {Kind::String}},
  };
  const auto found = types.find(name);
  require(found != types.end(), "unknown type: " + name);
  return found->second;
}

void check_usda(const UsdaStage& stage, const std::string& folder) {
  UsdaChecker(stage, folder).check(stage.root);
}

}  // namespace test
