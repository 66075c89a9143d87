#include "converters/usd/usd_material.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace convert {
namespace {

using grf::Vec3d;

std::string usd_type(const std::string& type) {
  static const std::map<std::string, std::string> types = {
      {"float", "float"}, {"color3", "color3f"}, {"color4", "color4f"},      {"vector2", "float2"},
      {"integer", "int"}, {"boolean", "bool"},   {"string", "string"},       {"filename", "asset"},
      {"BSDF", "token"},  {"EDF", "token"},      {"surfaceshader", "token"},
  };
  return types.at(type);
}

std::string usd_value(const ShadingInput& input) {
  if (input.type == "string") return usd_string(input.text);
  if (input.type == "filename") return usd_asset(input.text);
  if (input.numbers.size() == 1) return usd_number(input.numbers[0]);
  return fmt::format("({})", fmt::join(input.numbers, ", "));
}

/// Puts the shaders of one material.
class UsdMaterialWriter {
 public:
  UsdMaterialWriter(UsdText& text, const std::string& parent, const ExchangeMaterial& material)
      : text_(text), path_(parent + "/" + material.name), material_(material) {}

  void put();

 private:
  void begin_shader(const std::string& name, const char* id) {
    text_.begin(fmt::format("def Shader \"{}\"", name));
    text_.line(fmt::format("uniform token info:id = \"{}\"", id));
  }
  bool is_textured() const { return !material_.shaded.texture.empty(); }
  bool has_colour_reader() const { return material_.shaded.has_vertex_colours && !is_textured(); }
  void put_preview();
  void put_preview_colours();
  void put_preview_opacity();
  void put_readers();
  void put_graph();

  UsdText& text_;
  std::string path_;
  const ExchangeMaterial& material_;
};

void UsdMaterialWriter::put_preview_colours() {
  const GltfBrdf& values = material_.preview;
  if (is_textured()) {
    text_.line(fmt::format("color3f inputs:diffuseColor.connect = <{}/PreviewTexture.outputs:rgb>", path_));
  } else if (has_colour_reader()) {
    text_.line(fmt::format("color3f inputs:diffuseColor.connect = <{}/PreviewColor.outputs:result>", path_));
  } else {
    text_.line("color3f inputs:diffuseColor = " + usd_tuple(values.base));
  }
  // The reflectance at normal incidence of a dielectric is that of its index, unless it is said.
  const bool has_specular = values.specular != 1 || values.specular_colour != Vec3d(1);
  if (has_specular && values.metallic == 0) {
    const double root = (values.ior - 1) / (values.ior + 1);
    Vec3d specular = values.specular_colour * (root * root);
    for (int k = 0; k < 3; ++k) specular[k] = values.specular * std::min(1.0, specular[k]);
    text_.line("int inputs:useSpecularWorkflow = 1");
    text_.line("color3f inputs:specularColor = " + usd_tuple(specular));
  } else {
    text_.line("int inputs:useSpecularWorkflow = 0");
    text_.line("float inputs:metallic = " + usd_number(values.metallic));
  }
}

// GRF's faces are absent where they are not opaque, and with them their highlight.
void UsdMaterialWriter::put_preview_opacity() {
  const grf::Opacity& opacity = material_.shaded.surface.opacity;
  if (opacity == grf::Opacity()) {
    if (!material_.preview.is_glass()) return;
    // The highlight of glass stays.
    text_.line("float inputs:opacity = 0");
    text_.line("token inputs:opacityMode = \"transparent\"");
    return;
  }
  if (opacity.reads_alpha() && is_textured()) {
    text_.line(fmt::format("float inputs:opacity.connect = <{}/PreviewTexture.outputs:a>", path_));
    if (opacity.kind == grf::Opacity::Kind::Mask)
      text_.line("float inputs:opacityThreshold = " + usd_number(opacity.value));
  } else if (!opacity.reads_alpha()) {
    text_.line("float inputs:opacity = " + usd_number(opacity.value));
  }
  text_.line("token inputs:opacityMode = \"presence\"");
}

void UsdMaterialWriter::put_preview() {
  const GltfBrdf& values = material_.preview;
  begin_shader("PreviewSurface", "UsdPreviewSurface");
  put_preview_colours();
  text_.line("float inputs:roughness = " + usd_number(values.roughness));
  text_.line("float inputs:ior = " + usd_number(values.ior));
  if (values.clearcoat > 0) {
    text_.line("float inputs:clearcoat = " + usd_number(values.clearcoat));
    text_.line("float inputs:clearcoatRoughness = " + usd_number(values.coat_roughness));
  }
  if (const auto& emission = material_.shaded.surface.emission)
    text_.line("color3f inputs:emissiveColor = " + usd_tuple(*emission));
  put_preview_opacity();
  text_.line("token outputs:surface");
  text_.end();
}

void UsdMaterialWriter::put_readers() {
  if (has_colour_reader()) {
    begin_shader("PreviewColor", "UsdPrimvarReader_float3");
    text_.line("string inputs:varname = \"displayColor\"");
    text_.line("float3 outputs:result");
    text_.end();
  }
  if (!is_textured()) return;
  begin_shader("PreviewCoordinates", "UsdPrimvarReader_float2");
  text_.line("string inputs:varname = \"st\"");
  text_.line("float2 outputs:result");
  text_.end();
  const grf::Opacity& opacity = material_.shaded.surface.opacity;
  const bool is_blended = opacity.kind == grf::Opacity::Kind::Blend;
  const Vec3d& base = material_.preview.base;
  begin_shader("PreviewTexture", "UsdUVTexture");
  text_.line("asset inputs:file = " + usd_asset(material_.shaded.texture));
  text_.line(fmt::format("float2 inputs:st.connect = <{}/PreviewCoordinates.outputs:result>", path_));
  text_.line("token inputs:wrapS = \"repeat\"");
  text_.line("token inputs:wrapT = \"repeat\"");
  text_.line(fmt::format("token inputs:sourceColorSpace = \"{}\"",
                         is_linear_image(material_.shaded.texture) ? "raw" : "sRGB"));
  text_.line(fmt::format("float4 inputs:scale = ({}, {}, {}, {})", usd_number(base.x), usd_number(base.y),
                         usd_number(base.z), is_blended ? opacity.value : 1.0F));
  text_.line("float3 outputs:rgb");
  text_.line("float outputs:a");
  text_.end();
}

void UsdMaterialWriter::put_graph() {
  const std::vector<ShadingNode>& nodes = material_.graph.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    begin_shader(fmt::format("Node_{}", i + 1), nodes[i].definition.c_str());
    for (const ShadingInput& input : nodes[i].inputs) {
      const std::string name = fmt::format("{} inputs:{}", usd_type(input.type), input.name);
      if (input.node) {
        text_.line(fmt::format("{}.connect = <{}/Node_{}.outputs:out>", name, path_, *input.node + 1));
      } else if (input.type == "filename") {
        text_.line(fmt::format("{} = {} ( colorSpace = \"{}\" )", name, usd_value(input),
                               is_linear_image(input.text) ? "lin_rec709" : "srgb_texture"));
      } else {
        text_.line(name + " = " + usd_value(input));
      }
    }
    text_.line(usd_type(nodes[i].type) + " outputs:out");
    text_.end();
  }
}

void UsdMaterialWriter::put() {
  std::vector<std::string> metadata = usd_custom_data(std::array{
      "string name = " + usd_string(material_.original), "string surface = " + usd_string(material_.grf)});
  metadata.insert(metadata.begin(), "prepend apiSchemas = [\"MaterialXConfigAPI\"]");
  text_.begin(fmt::format("def Material \"{}\"", material_.name), metadata);
  text_.line("string config:mtlx:version = \"1.39\"");
  text_.line(fmt::format("token outputs:surface.connect = <{}/PreviewSurface.outputs:surface>", path_));
  text_.line(fmt::format("token outputs:mtlx:surface.connect = <{}/Node_{}.outputs:out>", path_,
                         material_.graph.nodes.size()));
  put_preview();
  put_readers();
  put_graph();
  text_.end();
}

}  // namespace

void put_usd_material(UsdText& text, const std::string& parent, const ExchangeMaterial& material) {
  UsdMaterialWriter(text, parent, material).put();
}

}  // namespace convert
