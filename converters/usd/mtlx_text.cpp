#include "converters/usd/mtlx_text.h"

#include <map>
#include <vector>

#include <fmt/format.h>

#include "converters/text_encoding.h"
#include "grf/unique_names.h"

namespace convert {
namespace {

std::string value_of(const ShadingInput& input) {
  if (input.type == "string" || input.type == "filename") return xml_value(input.text);
  if (input.type == "boolean") return input.numbers[0] != 0 ? "true" : "false";
  return fmt::format("{}", fmt::join(input.numbers, ", "));
}

/// Composes one document.
class MtlxWriter {
 public:
  explicit MtlxWriter(const UsdScene& scene) : scene_(scene) {
    for (const ExchangeMaterial& material : scene.materials.all()) names_.add(material.name);
  }

  std::string text() {
    text_ = "<?xml version=\"1.0\"?>\n<materialx version=\"1.39\" colorspace=\"lin_rec709\">\n";
    for (const ExchangeMaterial& material : scene_.materials.all()) put(material);
    put_look();
    return text_ + "</materialx>\n";
  }

 private:
  void put(const ExchangeMaterial& material);
  void put_node(const ShadingNode& node, const std::vector<std::string>& names, const std::string& name);
  void put_look();

  const UsdScene& scene_;
  grf::UniqueNames names_;
  std::string text_;
};

void MtlxWriter::put_node(const ShadingNode& node, const std::vector<std::string>& names,
                          const std::string& name) {
  text_ += fmt::format("  <{} name=\"{}\" type=\"{}\">\n", node.category, name, node.type);
  for (const ShadingInput& input : node.inputs) {
    text_ += fmt::format("    <input name=\"{}\" type=\"{}\" ", input.name, input.type);
    if (input.node) {
      text_ += fmt::format("nodename=\"{}\"/>\n", names[*input.node]);
      continue;
    }
    text_ += fmt::format("value=\"{}\"", value_of(input));
    if (input.type == "filename") {
      text_ += fmt::format(" colorspace=\"{}\"", is_linear_image(input.text) ? "lin_rec709" : "srgb_texture");
    }
    text_ += "/>\n";
  }
  text_ += fmt::format("  </{}>\n", node.category);
}

void MtlxWriter::put(const ExchangeMaterial& material) {
  const std::vector<ShadingNode>& nodes = material.graph.nodes;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool is_shader = i + 1 == nodes.size();
    names.push_back(names_.take(material.name + (is_shader ? "_shader" : fmt::format("_node_{}", i + 1))));
    put_node(nodes[i], names, names.back());
  }
  text_ += fmt::format("  <surfacematerial name=\"{}\" type=\"material\" doc=\"{}\">\n", material.name,
                       xml_value(material.grf));
  text_ += fmt::format("    <input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"{}\"/>\n",
                       names.back());
  text_ += "  </surfacematerial>\n";
}

void MtlxWriter::put_look() {
  std::map<std::size_t, std::string> paths_of_material;
  for (const auto& [material, path] : scene_.assignments) {
    std::string& paths = paths_of_material[material];
    paths += (paths.empty() ? "" : ", ") + path;
  }
  text_ += fmt::format("  <look name=\"{}\">\n", names_.take("look"));
  for (const auto& [material, paths] : paths_of_material) {
    const std::string& name = scene_.materials.all()[material].name;
    text_ +=
        fmt::format("    <materialassign name=\"assign_{0}\" material=\"{0}\" geom=\"{1}\"/>\n", name, paths);
  }
  text_ += "  </look>\n";
}

}  // namespace

std::string mtlx_text(const UsdScene& scene) { return MtlxWriter(scene).text(); }

}  // namespace convert
