#include "tests/converters/renderers/mitsuba_scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace test {
namespace {

using grf::Matrix44d;
using grf::Vec3d;

[[noreturn]] void fail(const std::string& why) { throw std::runtime_error(why); }
void require(bool holds, const std::string& why) {
  if (!holds) fail(why);
}

/// A plugin: the types of its parameters by name, the tags of nested plugins, and their largest number.
struct Plugin {
  std::map<std::string, std::string> parameters;
  std::map<std::string, std::size_t> nested = {};
  std::set<std::string> required = {};
};

// A texture as a parameter has the type `texture` here; a reference to a BSDF counts as a nested one.
const std::map<std::string, Plugin>& plugins() {
  static const std::map<std::string, std::string> camera = {{"fov", "float"},
                                                            {"fov_axis", "string"},
                                                            {"near_clip", "float"},
                                                            {"far_clip", "float"},
                                                            {"to_world", "transform"}};
  static const auto with = [](std::map<std::string, std::string> all,
                              const std::map<std::string, std::string>& more) {
    all.insert(more.begin(), more.end());
    return all;
  };
  static const std::map<std::string, Plugin> all = {
      {"integrator path",
       {{{"max_depth", "integer"}, {"rr_depth", "integer"}, {"hide_emitters", "boolean"}}}},
      {"sensor perspective", {camera, {{"sampler", 1}, {"film", 1}}, {"fov", "to_world"}}},
      {"sensor thinlens",
       {with(camera, {{"aperture_radius", "float"}, {"focus_distance", "float"}}),
        {{"sampler", 1}, {"film", 1}},
        {"fov", "to_world", "aperture_radius"}}},
      {"sampler independent", {{{"sample_count", "integer"}, {"seed", "integer"}}}},
      {"film hdrfilm",
       {{{"width", "integer"},
         {"height", "integer"},
         {"file_format", "string"},
         {"pixel_format", "string"},
         {"component_format", "string"}},
        {{"rfilter", 1}}}},
      {"rfilter box", {{}}},
      {"emitter envmap",
       {{{"filename", "string"}, {"scale", "float"}, {"to_world", "transform"}}, {}, {"filename"}}},
      {"emitter constant", {{{"radiance", "rgb"}}}},
      {"emitter area", {{{"radiance", "rgb"}}, {}, {"radiance"}}},
      {"bsdf twosided", {{}, {{"bsdf", 1}}}},
      {"bsdf diffuse", {{{"reflectance", "rgb texture"}}}},
      {"bsdf measured", {{{"filename", "string"}}, {}, {"filename"}}},
      {"bsdf conductor", {{{"material", "string"}, {"specular_reflectance", "rgb texture"}}}},
      {"bsdf dielectric", {{{"int_ior", "float string"}, {"ext_ior", "float string"}}}},
      {"bsdf thindielectric",
       {{{"int_ior", "float string"},
         {"ext_ior", "float string"},
         {"specular_reflectance", "rgb texture"},
         {"specular_transmittance", "rgb texture"}}}},
      {"bsdf blendbsdf", {{{"weight", "float texture"}}, {{"bsdf", 2}}}},
      {"bsdf mask", {{{"opacity", "float texture"}}, {{"bsdf", 1}}}},
      {"texture bitmap",
       {{{"filename", "string"},
         {"filter_type", "string"},
         {"wrap_mode", "string"},
         {"raw", "boolean"},
         {"to_uv", "transform"}},
        {},
        {"filename"}}},
      {"texture mesh_attribute", {{{"name", "string"}, {"scale", "float"}}, {}, {"name"}}},
      {"shape ply",
       {{{"filename", "string"},
         {"face_normals", "boolean"},
         {"flip_tex_coords", "boolean"},
         {"flip_normals", "boolean"},
         {"to_world", "transform"}},
        {{"bsdf", 1}, {"emitter", 1}},
        {"filename"}}},
      {"shape shapegroup", {{}, {{"shape", 1'000'000}}}},
      {"shape instance", {{{"to_world", "transform"}}, {{"shape", 1}}}},
  };
  return all;
}

const std::set<std::string> Plain = {"integer", "float", "string", "boolean"};

std::vector<double> numbers_in(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (std::string word; stream >> word;) {
    std::size_t end = 0;
    numbers.push_back(std::stod(word, &end));
    require(end == word.size() && std::isfinite(numbers.back()), "no number: " + word);
  }
  return numbers;
}

/// An XML tag.
struct Tag {
  std::string name;
  std::map<std::string, std::string> attributes;
  bool closes = false;    ///< `</name>`
  bool is_empty = false;  ///< `<name/>`
};

/// Splits XML without character data into tags.
class Xml {
 public:
  explicit Xml(std::string_view text) : rest_(text) {}

  Tag next() {
    skip();
    require(take("<"), "expected a tag");
    Tag tag;
    tag.closes = take("/");
    tag.name = word();
    while (!rest_.starts_with('>') && !rest_.starts_with("/>")) {
      require(!tag.closes, "an end tag has attributes");
      require(take(" "), "expected a space before an attribute");
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
  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }
  std::string word() {
    std::size_t end = 0;
    while (end < rest_.size() &&
           (std::isalnum(static_cast<unsigned char>(rest_[end])) != 0 || rest_[end] == '_'))
      ++end;
    require(end > 0, "expected a name");
    const std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return text;
  }
  std::string value() {
    const std::size_t end = rest_.find('"');
    require(end != std::string_view::npos, "a value has no end");
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    require(text.find('<') == std::string::npos, "an unescaped <");
    const std::array<std::pair<std::string, std::string>, 4> entities = {
        {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}};
    for (const auto& [entity, meaning] : entities) {
      for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; at += meaning.size())
        text.replace(at, entity.size(), meaning);
    }
    return text;
  }
  void skip() {
    for (;;) {
      while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_[0])) != 0)
        rest_.remove_prefix(1);
      if (!take("<!--")) return;
      const std::size_t end = rest_.find("--");
      require(end != std::string_view::npos && rest_.substr(end).starts_with("-->"), "a comment has no end");
      rest_.remove_prefix(end + 3);
    }
  }

  std::string_view rest_;
};

class Parser {
 public:
  Parser(std::string_view text, std::string folder) : xml_(text), folder_(std::move(folder)) {}

  MitsubaElement parse() {
    const Tag tag = xml_.next();
    require(tag.name == "scene" && !tag.is_empty && tag.attributes.at("version").starts_with("3."), "scene");
    MitsubaElement scene;
    scene.tag = "scene";
    const Plugin contents = {
        {}, {{"integrator", 1}, {"sensor", 1}, {"emitter", 1}, {"bsdf", 1'000'000}, {"shape", 1'000'000}}};
    parse_inside(scene, contents);
    require(xml_.is_at_end(), "something follows the scene");
    for (const auto& [reference, kind] : references_)
      require(ids_.contains(kind + " " + reference), "a reference to nothing: " + reference);
    return scene;
  }

 private:
  void parse_inside(MitsubaElement& element, const Plugin& plugin);
  void parameter(MitsubaElement& element, const Plugin& plugin, const Tag& tag);
  void reference(MitsubaElement& element, const Plugin& plugin, const Tag& tag);
  void transform(MitsubaElement& element, const Plugin& plugin, const Tag& tag);
  void nested(MitsubaElement& element, const Plugin& plugin, const Tag& tag);
  void check_value(const MitsubaElement& element, const std::string& name, const Tag& tag);

  static void require_type(const Plugin& plugin, const std::string& name, const std::string& type) {
    require(plugin.parameters.contains(name), "unknown parameter " + name);
    require((" " + plugin.parameters.at(name) + " ").find(" " + type + " ") != std::string::npos,
            fmt::format("{} has no type {}", name, type));
  }

  Xml xml_;
  std::string folder_;
  std::set<std::string> ids_;
  std::vector<std::pair<std::string, std::string>> references_;
};

void Parser::check_value(const MitsubaElement& element, const std::string& name, const Tag& tag) {
  const std::string& value = tag.attributes.at("value");
  if (tag.name == "float" || tag.name == "integer")
    require(numbers_in(value).size() == 1, name + ": one number");
  if (tag.name == "integer") require(value.find_first_not_of("-0123456789") == std::string::npos, name);
  if (tag.name == "boolean") require(value == "true" || value == "false", name + ": a boolean");
  if (name == "fov_axis") {
    const std::set<std::string> axes = {"x", "y", "diagonal", "smaller", "larger"};
    require(axes.contains(value), "fov_axis");
  }
  if (name == "fov") require(std::stod(value) > 0 && std::stod(value) < 180, "fov");
  if (name == "opacity") require(std::stod(value) >= 0 && std::stod(value) <= 1, "opacity");
  if (name == "weight") require(std::stod(value) >= 0 && std::stod(value) <= 1, "weight");
  if (name == "material") require(value == "none", "only `none` is expected");
  if (name == "filename") {
    require(!std::filesystem::path(value).is_absolute(), "an absolute name");
    require(std::filesystem::is_regular_file(std::filesystem::path(folder_) / value), "no file " + value);
  }
  if (tag.name != "rgb") return;
  for (const double channel : element.lists.at(name)) {
    require(channel >= 0, name + ": negative");
    require(name == "radiance" || channel <= 1, name + ": over 1");
  }
}

void Parser::parameter(MitsubaElement& element, const Plugin& plugin, const Tag& tag) {
  require(tag.is_empty && tag.attributes.size() == 2, "a parameter has a name and a value");
  const std::string& name = tag.attributes.at("name");
  require_type(plugin, name, tag.name);
  require(!element.values.contains(name) && !element.lists.contains(name), name + " is given twice");
  if (tag.name == "rgb") {
    element.lists[name] = numbers_in(tag.attributes.at("value"));
    require(element.lists[name].size() == 3, name + ": three channels");
  } else {
    element.values[name] = tag.attributes.at("value");
  }
  check_value(element, name, tag);
}

void Parser::reference(MitsubaElement& element, const Plugin& plugin, const Tag& tag) {
  require(tag.is_empty && tag.attributes.size() == 1, "a reference has an id");
  const std::string kind = element.type == "instance" ? "shape" : "bsdf";
  require(plugin.nested.contains(kind), element.type + " takes no reference");
  const std::string& id = tag.attributes.at("id");
  require(kind == "shape" || ids_.contains("bsdf " + id), "a reference before its material");
  element.references.push_back(id);
  references_.emplace_back(id, kind);
}

void Parser::transform(MitsubaElement& element, const Plugin& plugin, const Tag& tag) {
  const std::string& name = tag.attributes.at("name");
  require_type(plugin, name, "transform");
  MitsubaElement transform;
  transform.tag = "transform";
  transform.name = name;
  for (Tag step = xml_.next(); !step.closes; step = xml_.next()) {
    const std::map<std::string, std::set<std::string>> steps = {{"lookat", {"origin", "target", "up"}},
                                                                {"matrix", {"value"}}};
    require(step.is_empty && steps.contains(step.name), "unknown step " + step.name);
    require(transform.lists.empty(), "one step is expected");
    for (const std::string& attribute : steps.at(step.name))
      transform.lists[attribute] = numbers_in(step.attributes.at(attribute));
    for (const auto& [key, numbers] : transform.lists)
      require(numbers.size() == (key == "value" ? 16U : 3U), key + ": wrong number of values");
    require(step.attributes.size() == transform.lists.size(), "an attribute is unknown");
  }
  element.children.push_back(std::move(transform));
}

void Parser::nested(MitsubaElement& element, const Plugin& plugin, const Tag& tag) {
  MitsubaElement child;
  child.tag = tag.name;
  for (const auto& [key, value] : tag.attributes) {
    const std::map<std::string, std::string MitsubaElement::*> fields = {
        {"type", &MitsubaElement::type}, {"id", &MitsubaElement::id}, {"name", &MitsubaElement::name}};
    require(fields.contains(key), "unknown attribute " + key);
    child.*fields.at(key) = value;
  }
  const std::string kind = child.tag + " " + child.type;
  require(plugins().contains(kind), "no plugin is called " + kind);
  if (child.tag == "texture") {
    require_type(plugin, child.name, "texture");
  } else {
    require(plugin.nested.contains(child.tag), fmt::format("{} has no nested {}", element.type, kind));
  }
  if (!child.id.empty()) require(ids_.insert(child.tag + " " + child.id).second, "an id is given twice");
  if (!tag.is_empty) parse_inside(child, plugins().at(kind));
  for (const std::string& name : plugins().at(kind).required) {
    const bool has_transform = std::any_of(child.children.begin(), child.children.end(),
                                           [&](const MitsubaElement& one) { return one.name == name; });
    require(child.values.contains(name) || child.lists.contains(name) || has_transform,
            kind + " lacks " + name);
  }
  element.children.push_back(std::move(child));
}

void Parser::parse_inside(MitsubaElement& element, const Plugin& plugin) {
  Tag tag = xml_.next();
  for (; !tag.closes; tag = xml_.next()) {
    if (Plain.contains(tag.name) || tag.name == "rgb") {
      parameter(element, plugin, tag);
    } else if (tag.name == "ref") {
      reference(element, plugin, tag);
    } else if (tag.name == "transform") {
      transform(element, plugin, tag);
    } else {
      nested(element, plugin, tag);
    }
  }
  require(tag.name == element.tag, fmt::format("</{}> closes <{}>", tag.name, element.tag));
  for (const auto& [kind, most] : plugin.nested) {
    std::size_t count = kind == "bsdf" || element.type == "instance" ? element.references.size() : 0;
    count += element.all(kind).size();
    require(count <= most, fmt::format("too many of {} in {}", kind, element.type));
    require(element.type != "twosided" || count == 1, "twosided needs a BSDF");
    require(element.type != "mask" || count == 1, "mask needs a BSDF");
    require(element.type != "blendbsdf" || count == 2, "blendbsdf needs two BSDFs");
  }
  // Emitters cannot be instanced.
  if (element.type != "shapegroup") return;
  for (const MitsubaElement& shape : element.children)
    require(shape.all("emitter").empty() && shape.type == "ply", "an emitter in a group");
}

}  // namespace

const MitsubaElement& MitsubaElement::child(const std::string& tag_of_child) const {
  for (const MitsubaElement& one : children) {
    if (one.tag == tag_of_child) return one;
  }
  throw std::out_of_range(tag + " has no " + tag_of_child);
}

std::vector<MitsubaElement> MitsubaElement::all(const std::string& tag_of_child) const {
  std::vector<MitsubaElement> found;
  for (const MitsubaElement& one : children) {
    if (one.tag == tag_of_child) found.push_back(one);
  }
  return found;
}

// The camera's x axis, up cross the direction, points to the left of the image.
Matrix44d MitsubaElement::to_world() const {
  const std::vector<MitsubaElement> transforms = all("transform");
  if (transforms.empty()) return {};
  const auto& steps = transforms[0].lists;
  const auto vector = [&](const char* key) {
    return Vec3d(steps.at(key)[0], steps.at(key)[1], steps.at(key)[2]);
  };
  if (steps.contains("origin")) {
    const Vec3d origin = vector("origin");
    const Vec3d direction = (vector("target") - origin).normalized();
    const Vec3d left = vector("up").cross(direction).normalized();
    const Vec3d up = direction.cross(left);
    return {left.x,      left.y,      left.z,      0, up.x,     up.y,     up.z,     0,
            direction.x, direction.y, direction.z, 0, origin.x, origin.y, origin.z, 1};
  }
  const std::vector<double>& rows = steps.at("value");
  Matrix44d matrix;
  for (int i = 0; i < 16; ++i) matrix[i % 4][i / 4] = rows[static_cast<std::size_t>(i)];
  return matrix;
}

MitsubaElement parse_mitsuba(std::string_view text, const std::string& folder) {
  return Parser(text, folder).parse();
}

grf::Vec2d mitsuba_pixel(const MitsubaElement& scene, const Vec3d& point) {
  const MitsubaElement& sensor = scene.child("sensor");
  const double width = sensor.child("film").number("width");
  const double height = sensor.child("film").number("height");
  if (sensor.values.at("fov_axis") != "y") fail("the vertical axis is expected");
  const double half_height = std::tan(sensor.number("fov") * std::numbers::pi / 360);
  const double half_width = half_height * width / height;
  const Vec3d seen = point * sensor.to_world().inverse();
  const double x = 0.5 - seen.x / (2 * seen.z * half_width);
  const double y = 0.5 - seen.y / (2 * seen.z * half_height);
  return {x * width, y * height};
}

}  // namespace test
