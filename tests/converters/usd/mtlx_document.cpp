#include "tests/converters/usd/mtlx_document.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace test {
namespace {

[[noreturn]] void fail(const std::string& why) { throw std::runtime_error(why); }
void require(bool holds, const std::string& why) {
  if (!holds) fail(why);
}

/// The type of a node's output, and the types of its inputs by name.
struct Category {
  std::set<std::string> types;
  std::map<std::string, std::string> inputs;
};

// An input `same` has the type of the output.
const std::map<std::string, Category>& categories() {
  static const std::map<std::string, std::string> facets = {{"weight", "float"},
                                                            {"roughness", "vector2"},
                                                            {"distribution", "string"},
                                                            {"normal", "vector3"},
                                                            {"tangent", "vector3"}};
  static const auto with = [](std::map<std::string, std::string> all,
                              const std::map<std::string, std::string>& more) {
    all.insert(more.begin(), more.end());
    return all;
  };
  static const std::map<std::string, Category> all = {
      {"surfacematerial",
       {{"material"}, {{"surfaceshader", "surfaceshader"}, {"displacementshader", "displacementshader"}}}},
      {"surface",
       {{"surfaceshader"},
        {{"bsdf", "BSDF"}, {"edf", "EDF"}, {"opacity", "float"}, {"thin_walled", "boolean"}}}},
      {"oren_nayar_diffuse_bsdf",
       {{"BSDF"},
        {{"weight", "float"},
         {"color", "color3"},
         {"roughness", "float"},
         {"normal", "vector3"},
         {"energy_compensation", "boolean"}}}},
      {"conductor_bsdf", {{"BSDF"}, with(facets, {{"ior", "color3"}, {"extinction", "color3"}})}},
      {"generalized_schlick_bsdf",
       {{"BSDF"},
        with(facets, {{"color0", "color3"},
                      {"color82", "color3"},
                      {"color90", "color3"},
                      {"exponent", "float"},
                      {"scatter_mode", "string"}})}},
      {"sheen_bsdf",
       {{"BSDF"},
        {{"weight", "float"},
         {"color", "color3"},
         {"roughness", "float"},
         {"normal", "vector3"},
         {"mode", "string"}}}},
      {"uniform_edf", {{"EDF"}, {{"color", "color3"}}}},
      {"add", {{"BSDF"}, {{"in1", "BSDF"}, {"in2", "BSDF"}}}},
      {"multiply", {{"BSDF", "float", "color3"}, {{"in1", "same"}, {"in2", "factor"}}}},
      {"image",
       {{"color3", "color4", "float"},
        {{"file", "filename"},
         {"default", "same"},
         {"texcoord", "vector2"},
         {"uaddressmode", "string"},
         {"vaddressmode", "string"},
         {"filtertype", "string"}}}},
      {"geompropvalue", {{"color3"}, {{"geomprop", "string"}, {"default", "same"}}}},
      {"extract", {{"float"}, {{"in", "color4"}, {"index", "integer"}}}},
      {"ifgreatereq",
       {{"float"}, {{"value1", "float"}, {"value2", "float"}, {"in1", "float"}, {"in2", "float"}}}},
      {"open_pbr_surface",
       {{"surfaceshader"},
        {{"base_weight", "float"},
         {"base_color", "color3"},
         {"base_diffuse_roughness", "float"},
         {"base_metalness", "float"},
         {"specular_weight", "float"},
         {"specular_color", "color3"},
         {"specular_roughness", "float"},
         {"specular_ior", "float"},
         {"specular_roughness_anisotropy", "float"},
         {"fuzz_weight", "float"},
         {"fuzz_color", "color3"},
         {"fuzz_roughness", "float"},
         {"coat_weight", "float"},
         {"coat_color", "color3"},
         {"coat_roughness", "float"},
         {"coat_roughness_anisotropy", "float"},
         {"coat_ior", "float"},
         {"coat_darkening", "float"},
         {"thin_film_weight", "float"},
         {"thin_film_thickness", "float"},
         {"thin_film_ior", "float"},
         {"transmission_weight", "float"},
         {"transmission_color", "color3"},
         {"transmission_depth", "float"},
         {"geometry_thin_walled", "boolean"},
         {"emission_luminance", "float"},
         {"emission_color", "color3"},
         {"geometry_opacity", "float"}}}},
      {"gltf_pbr",
       {{"surfaceshader"},
        {{"base_color", "color3"},
         {"metallic", "float"},
         {"roughness", "float"},
         {"specular", "float"},
         {"specular_color", "color3"},
         {"ior", "float"},
         {"alpha", "float"},
         {"alpha_mode", "integer"},
         {"alpha_cutoff", "float"},
         {"anisotropy_strength", "float"},
         {"anisotropy_rotation", "float"},
         {"clearcoat", "float"},
         {"clearcoat_roughness", "float"},
         {"sheen_color", "color3"},
         {"sheen_roughness", "float"},
         {"iridescence", "float"},
         {"iridescence_ior", "float"},
         {"iridescence_thickness", "float"},
         {"emissive", "color3"},
         {"emissive_strength", "float"}}}},
  };
  return all;
}

const std::map<std::string, std::set<std::string>> Words = {
    {"distribution", {"ggx"}},
    {"mode", {"conty_kulla", "zeltner"}},
    {"uaddressmode", {"periodic", "clamp", "mirror", "constant"}},
    {"vaddressmode", {"periodic", "clamp", "mirror", "constant"}},
};

struct MtlxTag {
  std::string name;
  std::map<std::string, std::string> attributes;
  bool closes = false;
  bool is_empty = false;
};

/// Splits XML without character data into tags.
class MtlxXml {
 public:
  explicit MtlxXml(std::string_view text) : rest_(text) {
    require(take("<?xml version=\"1.0\"?>"), "no declaration of XML");
  }
  MtlxTag next() {
    skip();
    require(take("<"), "expected a tag");
    MtlxTag tag;
    tag.closes = take("/");
    tag.name = word();
    while (!rest_.starts_with('>') && !rest_.starts_with("/>")) {
      require(!tag.closes && take(" "), "expected an attribute");
      const std::string name = word();
      require(take("=\""), "an attribute needs a value in quotes");
      require(tag.attributes.emplace(name, value()).second, "an attribute is given twice: " + name);
    }
    tag.is_empty = take("/");
    require(take(">"), "a tag has no end");
    return tag;
  }
  bool is_at_end() {
    skip();
    return rest_.empty();
  }

 private:
  void skip() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\n')) rest_.remove_prefix(1);
  }
  bool take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  std::string word() {
    std::string result;
    while (!rest_.empty() && (std::isalnum(static_cast<unsigned char>(rest_[0])) != 0 || rest_[0] == '_')) {
      result += rest_[0];
      rest_.remove_prefix(1);
    }
    require(!result.empty(), "expected a name");
    return result;
  }
  std::string value() {
    static const std::map<std::string, std::string> entities = {
        {"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#10;", "\n"}};
    std::string result;
    while (!take("\"")) {
      require(!rest_.empty() && rest_[0] != '<', "a value has no end");
      if (rest_[0] == '&') {
        const auto found = std::find_if(entities.begin(), entities.end(),
                                        [&](const auto& entity) { return take(entity.first); });
        require(found != entities.end(), "unknown entity");
        result += found->second;
      } else {
        require(static_cast<unsigned char>(rest_[0]) >= ' ', "a control character");
        result += rest_[0];
        rest_.remove_prefix(1);
      }
    }
    return result;
  }
  std::string_view rest_;
};

void check_value(const std::string& name, const std::string& type, const std::string& value) {
  static const std::map<std::string, std::size_t> sizes = {
      {"float", 1}, {"integer", 1}, {"vector2", 2}, {"color3", 3}, {"color4", 4}};
  const auto words = Words.find(name);
  require(words == Words.end() || words->second.contains(value), "unknown value of " + name + ": " + value);
  if (type == "boolean") return require(value == "true" || value == "false", "no boolean: " + value);
  if (type == "string" || type == "filename") return require(!value.empty(), "an empty value of " + name);
  require(sizes.contains(type), "a value of the type " + type);
  std::istringstream stream(value);
  std::size_t count = 0;
  for (std::string part; std::getline(stream, part, ',');) {
    part.erase(0, part.find_first_not_of(' '));
    double number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    require(error == std::errc() && end == part.data() + part.size() && std::isfinite(number),
            "no number: " + part);
    require(type != "integer" || number == std::floor(number), "no integer: " + part);
    ++count;
  }
  require(count == sizes.at(type), "wrong number of components: " + value);
}

/// Reads the nodes and the look.
class MtlxReader {
 public:
  explicit MtlxReader(std::string_view text) : xml_(text) {}

  MtlxDocument read() {
    const MtlxTag root = xml_.next();
    require(root.name == "materialx" && attribute(root, "version") == "1.39",
            "no document of MaterialX 1.39");
    for (MtlxTag tag = xml_.next(); !is_end(tag, "materialx"); tag = xml_.next()) {
      if (tag.name == "look") {
        read_look(tag);
      } else {
        read_node(tag);
      }
    }
    require(xml_.is_at_end(), "there is text after the document");
    for (const auto& [name, node] : document_.nodes) check(node);
    return document_;
  }

 private:
  static bool is_end(const MtlxTag& tag, const std::string& name) {
    require(!tag.closes || tag.name == name, "another element is closed: " + tag.name);
    return tag.closes;
  }
  static std::string attribute(const MtlxTag& tag, const std::string& name) {
    require(tag.attributes.contains(name), tag.name + " has no " + name);
    return tag.attributes.at(name);
  }
  void read_node(const MtlxTag& tag) {
    MtlxNode node{tag.name, attribute(tag, "name"), attribute(tag, "type"), "", {}};
    if (tag.attributes.contains("doc")) node.doc = tag.attributes.at("doc");
    for (MtlxTag input = xml_.next(); !is_end(input, tag.name); input = xml_.next()) {
      require(input.name == "input" && input.is_empty, "a node has another child than inputs");
      MtlxInput read;
      read.type = attribute(input, "type");
      const bool has_value = input.attributes.contains("value");
      require(has_value != input.attributes.contains("nodename"), "an input has a value or a node");
      (has_value ? read.value : read.node) = attribute(input, has_value ? "value" : "nodename");
      if (input.attributes.contains("colorspace")) read.colour_space = input.attributes.at("colorspace");
      require(node.inputs.emplace(attribute(input, "name"), read).second, "an input is given twice");
    }
    require(document_.nodes.emplace(node.name, node).second, "two nodes have one name: " + node.name);
  }
  void read_look(const MtlxTag& look) {
    for (MtlxTag tag = xml_.next(); !look.is_empty && !is_end(tag, "look"); tag = xml_.next()) {
      require(tag.name == "materialassign" && tag.is_empty, "unknown part of a look: " + tag.name);
      const auto found = document_.nodes.find(attribute(tag, "material"));
      require(found != document_.nodes.end() && found->second.category == "surfacematerial", "no material");
      std::istringstream paths(attribute(tag, "geom"));
      for (std::string path; std::getline(paths >> std::ws, path, ',');) {
        require(path.starts_with('/'), "no path: " + path);
        document_.geometry[found->first].push_back(path);
      }
    }
  }
  void check(const MtlxNode& node) const {
    const auto found = categories().find(node.category);
    require(found != categories().end(), "unknown category: " + node.category);
    require(found->second.types.contains(node.type), "unknown type of " + node.category + ": " + node.type);
    for (const auto& [name, input] : node.inputs) {
      const auto known = found->second.inputs.find(name);
      require(known != found->second.inputs.end(), "unknown input of " + node.category + ": " + name);
      const std::string& type = known->second;
      const bool is_factor = type == "factor" && node.type == "BSDF";
      require(is_factor ? input.type == "float" || input.type == "color3"
                        : input.type == (type == "same" || type == "factor" ? node.type : type),
              "wrong type of " + node.category + "." + name + ": " + input.type);
      if (input.node.empty()) {
        check_value(name, input.type, input.value);
        continue;
      }
      const auto source = document_.nodes.find(input.node);
      require(source != document_.nodes.end(), "a connection to nothing: " + input.node);
      require(source->second.type == input.type, "a connection to another type: " + input.node);
    }
  }

  MtlxXml xml_;
  MtlxDocument document_;
};

}  // namespace

const MtlxNode& MtlxDocument::only(const std::string& category) const {
  const MtlxNode* found = nullptr;
  for (const auto& [name, node] : nodes) {
    if (node.category != category) continue;
    if (found != nullptr) throw std::out_of_range("two nodes are " + category);
    found = &node;
  }
  if (found == nullptr) throw std::out_of_range("no node is " + category);
  return *found;
}

MtlxDocument parse_mtlx(std::string_view text) { return MtlxReader(text).read(); }

}  // namespace test
