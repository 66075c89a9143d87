#include "tests/converters/renderers/pbrt_scene.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace test {
namespace {

using grf::Matrix44d;
using grf::Vec3d;

/// The parameters of a plugin: for each name, the types that it may have, separated by spaces.
using ParameterTypes = std::map<std::string, std::string>;

const std::string ColourTypes = "rgb spectrum blackbody";

/// The plugins of each kind of entity.
const std::map<std::string, std::map<std::string, ParameterTypes>>& plugins() {
  static const std::string reflectances = "rgb spectrum texture";
  static const std::map<std::string, std::map<std::string, ParameterTypes>> all = {
      {"Film",
       {{"rgb",
         {{"xresolution", "integer"},
          {"yresolution", "integer"},
          {"cropwindow", "float"},
          {"pixelbounds", "integer"},
          {"diagonal", "float"},
          {"filename", "string"},
          {"savefp16", "bool"},
          {"maxcomponentvalue", "float"},
          {"iso", "float"},
          {"whitebalance", "float"},
          {"sensor", "string"}}}}},
      {"PixelFilter", {{"box", {{"xradius", "float"}, {"yradius", "float"}}}}},
      {"Sampler",
       {{"halton", {{"pixelsamples", "integer"}, {"seed", "integer"}, {"randomization", "string"}}}}},
      {"Integrator",
       {{"path", {{"maxdepth", "integer"}, {"lightsampler", "string"}, {"regularize", "bool"}}}}},
      {"Camera",
       {{"perspective",
         {{"fov", "float"},
          {"frameaspectratio", "float"},
          {"screenwindow", "float"},
          {"shutteropen", "float"},
          {"shutterclose", "float"},
          {"lensradius", "float"},
          {"focaldistance", "float"}}}}},
      {"LightSource",
       {{"infinite",
         {{"filename", "string"},
          {"L", ColourTypes},
          {"scale", "float"},
          {"illuminance", "float"},
          {"portal", "point3"}}}}},
      {"AreaLightSource",
       {{"diffuse",
         {{"L", ColourTypes},
          {"filename", "string"},
          {"scale", "float"},
          {"power", "float"},
          {"twosided", "bool"}}}}},
      {"Shape",
       {{"plymesh",
         {{"filename", "string"},
          {"displacement", "texture"},
          {"edgelength", "float"},
          {"alpha", "float texture"}}}}},
      {"Material",
       {{"diffuse", {{"reflectance", reflectances}, {"displacement", "texture"}, {"normalmap", "string"}}},
        {"measured", {{"filename", "string"}, {"displacement", "texture"}, {"normalmap", "string"}}},
        {"dielectric",
         {{"eta", "float spectrum"}, {"roughness", "float texture"}, {"remaproughness", "bool"}}},
        {"thindielectric", {{"eta", "float spectrum"}}},
        {"mix", {{"materials", "string"}, {"amount", "float texture"}}},
        {"conductor",
         {{"eta", "spectrum texture"},
          {"k", "spectrum texture"},
          {"reflectance", reflectances},
          {"roughness", "float texture"},
          {"uroughness", "float texture"},
          {"vroughness", "float texture"},
          {"remaproughness", "bool"}}}}},
      {"Texture",
       {{"imagemap",
         {{"filename", "string"},
          {"filter", "string"},
          {"wrap", "string"},
          {"maxanisotropy", "float"},
          {"encoding", "string"},
          {"scale", "float"},
          {"invert", "bool"},
          {"mapping", "string"},
          {"uscale", "float"},
          {"vscale", "float"},
          {"udelta", "float"},
          {"vdelta", "float"}}}}},
  };
  return all;
}

/// Parameters that have more than one value, or that need not have one.
const std::map<std::string, std::size_t> CountOfType = {{"integer", 1}, {"float", 1},   {"bool", 1},
                                                        {"string", 1},  {"rgb", 3},     {"texture", 1},
                                                        {"point3", 3},  {"spectrum", 0}};

/// Words that parameters may have.
const std::map<std::string, std::set<std::string>> WordsOf = {
    {"filter", {"bilinear", "trilinear", "EWA", "point"}},
    {"sensor", {"cie1931"}},
};

struct Token {
  enum class Kind { Word, String, Number, Open, Close, End };
  Kind kind = Kind::End;
  std::string text;
  double number = 0;
};

class Parser {
 public:
  Parser(std::string_view text, std::string folder) : rest_(text), folder_(std::move(folder)) { next(); }

  PbrtScene parse();

 private:
  using Kind = Token::Kind;

  struct State {
    Matrix44d to_world;
    std::string material;
    std::optional<PbrtEntity> own;
    std::optional<PbrtEntity> emission;
  };

  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(fmt::format("line {}: {}", line_, why));
  }
  void require(bool holds, const std::string& why) const {
    if (!holds) fail(why);
  }

  void next();
  Token take(Kind kind, const std::string& what);
  std::string take_string() { return take(Kind::String, "a string").text; }
  double take_number() { return take(Kind::Number, "a number").number; }
  Vec3d take_vector();

  PbrtEntity entity(const std::string& kind, const std::string& plugin);
  void parameter(const std::string& kind, PbrtEntity& entity);
  void check_values(const std::string& name, const PbrtParameter& parameter) const;
  void check_file(const std::string& name) const;

  void directive(const std::string& name);
  bool option(const std::string& name);
  bool transform(const std::string& name);
  bool block(const std::string& name);
  void begin_object();
  void instance();
  void named_material();
  void texture();
  void look_at();
  void shape();
  void check_names() const;

  std::string_view rest_;
  std::string folder_;
  Token token_;
  int line_ = 1;
  bool in_world_ = false;
  std::string object_;
  std::set<std::string> objects_;
  std::set<std::string> float_textures_;
  std::vector<State> states_ = {State()};
  std::vector<std::string> blocks_;
  PbrtScene scene_;
};

void Parser::next() {
  while (!rest_.empty() && (std::isspace(static_cast<unsigned char>(rest_[0])) != 0 || rest_[0] == '#')) {
    if (rest_[0] == '#') {
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      continue;
    }
    line_ += rest_[0] == '\n' ? 1 : 0;
    rest_.remove_prefix(1);
  }
  token_ = Token();
  if (rest_.empty()) return;
  const char first = rest_[0];
  if (first == '[' || first == ']') {
    token_.kind = first == '[' ? Kind::Open : Kind::Close;
    rest_.remove_prefix(1);
  } else if (first == '"') {
    token_.kind = Kind::String;
    std::size_t end = 1;
    for (; end < rest_.size() && rest_[end] != '"'; ++end) {
      require(rest_[end] != '\n', "a string goes over the end of the line");
      if (rest_[end] == '\\') ++end;
      if (end < rest_.size()) token_.text += rest_[end];
    }
    require(end < rest_.size(), "a string has no end");
    rest_.remove_prefix(end + 1);
  } else {
    std::size_t end = 0;
    while (end < rest_.size() && std::string_view(" \t\r\n[]\"#").find(rest_[end]) == std::string_view::npos)
      ++end;
    token_.text = rest_.substr(0, end);
    const auto number =
        std::from_chars(token_.text.data(), token_.text.data() + token_.text.size(), token_.number);
    const bool is_number = number.ec == std::errc() && number.ptr == token_.text.data() + token_.text.size();
    require(!is_number || std::isfinite(token_.number), "a number is not finite");
    token_.kind = is_number ? Kind::Number : Kind::Word;
    rest_.remove_prefix(end);
  }
}

Token Parser::take(Kind kind, const std::string& what) {
  require(token_.kind == kind, fmt::format("found '{}', expected {}", token_.text, what));
  Token taken = token_;
  next();
  return taken;
}

Vec3d Parser::take_vector() {
  const double x = take_number();
  const double y = take_number();
  return {x, y, take_number()};
}

void Parser::check_file(const std::string& name) const {
  require(!std::filesystem::path(name).is_absolute(), "an absolute file name: " + name);
  require(std::filesystem::is_regular_file(std::filesystem::path(folder_) / name), "no file " + name);
}

void Parser::check_values(const std::string& name, const PbrtParameter& parameter) const {
  const std::string& type = parameter.type;
  const std::size_t count = parameter.numbers.size() + parameter.strings.size();
  const std::size_t expected = name == "materials" ? 2 : CountOfType.at(type);
  require(expected == 0 || count == expected, name + ": wrong number of values");
  if (type == "spectrum") {
    require(count >= 4 && count % 2 == 0, name + ": a spectrum is of pairs");
    for (std::size_t i = 2; i < count; i += 2)
      require(parameter.numbers[i] > parameter.numbers[i - 2], name + ": wavelengths have to ascend");
    require(parameter.numbers[0] <= 360 && parameter.numbers[count - 2] >= 830, name + ": 0 at some ends");
  }
  const bool is_text = type == "string" || type == "bool" || type == "texture";
  require(is_text ? parameter.numbers.empty() : parameter.strings.empty(), name + ": wrong kind of values");
  for (const double number : parameter.numbers) {
    require(type != "integer" || number == std::floor(number), name + ": no integer");
    require(type != "rgb" || number >= 0, name + ": a negative colour");
    require(name != "reflectance" || number <= 1, name + ": a reflectance over 1");
  }
  if (type == "bool") require(parameter.strings[0] == "true" || parameter.strings[0] == "false", name);
  if (const auto words = WordsOf.find(name); words != WordsOf.end())
    require(words->second.contains(parameter.strings[0]), name + ": unknown word");
  if (type == "texture") {
    require(scene_.textures.contains(parameter.strings[0]), name + ": no such texture");
    require((name == "alpha") == float_textures_.contains(parameter.strings[0]), name + ": of another type");
  }
  if (name == "alpha" && type == "float")
    require(parameter.numbers[0] >= 0 && parameter.numbers[0] <= 1, "an alpha out of range");
}

void Parser::parameter(const std::string& kind, PbrtEntity& entity) {
  const std::string declaration = take_string();
  const std::size_t space = declaration.find(' ');
  require(space != std::string::npos, fmt::format("'{}' is no type and name", declaration));
  const std::string name = declaration.substr(space + 1);
  PbrtParameter parameter;
  parameter.type = declaration.substr(0, space);
  const ParameterTypes& known = plugins().at(kind).at(entity.plugin);
  require(known.contains(name), fmt::format("{} {} has no parameter '{}'", kind, entity.plugin, name));
  const std::string types = " " + known.at(name) + " ";
  require(types.find(" " + parameter.type + " ") != std::string::npos,
          fmt::format("{} has no type '{}'", name, parameter.type));
  const bool is_list = token_.kind == Kind::Open;
  if (is_list) next();
  do {
    if (token_.kind == Kind::Number) {
      parameter.numbers.push_back(token_.number);
    } else {
      require(token_.kind == Kind::String || (token_.kind == Kind::Word && parameter.type == "bool"),
              name + ": expected a value");
      require(parameter.type != "bool" || token_.kind == Kind::Word, name + ": a boolean has no quotes");
      parameter.strings.push_back(token_.text);
    }
    next();
  } while (is_list && token_.kind != Kind::Close);
  if (is_list) next();
  check_values(name, parameter);
  if (name == "filename" && kind != "Film") check_file(parameter.strings[0]);
  require(entity.parameters.emplace(name, parameter).second, name + " is given twice");
}

PbrtEntity Parser::entity(const std::string& kind, const std::string& plugin) {
  require(plugins().at(kind).contains(plugin), fmt::format("no {} is called '{}'", kind, plugin));
  PbrtEntity entity;
  entity.plugin = plugin;
  while (token_.kind == Kind::String) parameter(kind, entity);
  return entity;
}

bool Parser::option(const std::string& name) {
  static const std::set<std::string> names = {"Film", "PixelFilter", "Sampler", "Integrator", "Camera"};
  if (!names.contains(name)) return false;
  require(!in_world_, name + " stands behind WorldBegin");
  const std::string plugin = take_string();
  require(scene_.options.emplace(name, entity(name, plugin)).second, name + " is given twice");
  if (name == "Camera") scene_.world_to_camera = states_.back().to_world;
  return true;
}

// The matrices of pbrt are for column vectors, and the last one is applied first.
bool Parser::transform(const std::string& name) {
  Matrix44d& current = states_.back().to_world;
  if (name == "Scale") {
    Matrix44d scale;
    scale.setScale(take_vector());
    current = scale * current;
  } else if (name == "Transform") {
    take(Kind::Open, "[");
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) current[column][row] = take_number();
    }
    take(Kind::Close, "]");
    require(current[0][3] == 0 && current[1][3] == 0 && current[2][3] == 0 && current[3][3] == 1,
            "the last row of an affine matrix is 0 0 0 1");
  } else if (name == "LookAt") {
    look_at();
  } else {
    return false;
  }
  return true;
}

// The axes of the camera are a left-handed cross product away: x is up cross the direction.
void Parser::look_at() {
  const Vec3d eye = take_vector();
  const Vec3d target = take_vector();
  const Vec3d up = take_vector().normalized();
  const Vec3d direction = (target - eye).normalized();
  require(up.cross(direction).length() > 1e-6, "up is along the view direction");
  const Vec3d x = up.cross(direction).normalized();
  const Vec3d y = direction.cross(x);
  const Matrix44d to_camera(x.x, y.x, direction.x, 0, x.y, y.y, direction.y, 0, x.z, y.z, direction.z, 0,
                            -eye.dot(x), -eye.dot(y), -eye.dot(direction), 1);
  states_.back().to_world = to_camera * states_.back().to_world;
}

bool Parser::block(const std::string& name) {
  if (name == "AttributeBegin") {
    states_.push_back(states_.back());
    blocks_.push_back(name);
  } else if (name == "AttributeEnd" || name == "ObjectEnd") {
    const std::string begin = name == "ObjectEnd" ? "ObjectBegin" : "AttributeBegin";
    require(!blocks_.empty() && blocks_.back() == begin, name + " without its begin");
    blocks_.pop_back();
    states_.pop_back();
    if (name == "ObjectEnd") object_.clear();
  } else if (name == "ObjectBegin") {
    begin_object();
  } else {
    return false;
  }
  return true;
}

void Parser::begin_object() {
  require(object_.empty(), "ObjectBegin in ObjectBegin");
  object_ = take_string();
  require(objects_.insert(object_).second, "two objects have one name");
  states_.push_back(states_.back());
  blocks_.emplace_back("ObjectBegin");
}

void Parser::instance() {
  require(object_.empty(), "ObjectInstance in ObjectBegin");
  const std::string name = take_string();
  require(objects_.contains(name), "no object is called " + name);
  scene_.instances.push_back({name, states_.back().to_world});
}

void Parser::named_material() {
  const std::string name = take_string();
  require(take_string() == "string type", "a named material begins with its type");
  take(Kind::Open, "[");
  const std::string plugin = take_string();
  take(Kind::Close, "]");
  require(scene_.materials.emplace(name, entity("Material", plugin)).second, name + " is made twice");
}

void Parser::texture() {
  const std::string name = take_string();
  const std::string type = take_string();
  require(type == "spectrum" || type == "float", "a texture is of spectra or of floats");
  const std::string plugin = take_string();
  require(scene_.textures.emplace(name, entity("Texture", plugin)).second, name + " is made twice");
  if (type == "float") float_textures_.insert(name);
}

void Parser::shape() {
  const std::string plugin = take_string();
  const State& state = states_.back();
  // pbrt leaves the light of instances out.
  require(object_.empty() || !state.emission, "an emitter in an object");
  scene_.shapes.push_back(
      {entity("Shape", plugin), state.material, state.own, state.emission, object_, state.to_world});
}

void Parser::directive(const std::string& name) {
  if (option(name) || transform(name)) return;
  if (name == "WorldBegin") {
    require(!in_world_, "WorldBegin is given twice");
    in_world_ = true;
    states_ = {State()};
    return;
  }
  require(in_world_, name + " stands before WorldBegin");
  if (block(name)) return;
  if (name == "NamedMaterial") {
    states_.back().material = take_string();
    states_.back().own.reset();
    require(scene_.materials.contains(states_.back().material), "no material is called so");
  } else if (name == "Material") {
    const std::string plugin = take_string();
    states_.back().own = entity("Material", plugin);
    states_.back().material.clear();
  } else if (name == "MakeNamedMaterial") {
    named_material();
  } else if (name == "Texture") {
    texture();
  } else if (name == "LightSource") {
    const std::string plugin = take_string();
    scene_.lights.push_back(entity("LightSource", plugin));
  } else if (name == "AreaLightSource") {
    const std::string plugin = take_string();
    states_.back().emission = entity("AreaLightSource", plugin);
  } else if (name == "Shape") {
    shape();
  } else if (name == "ObjectInstance") {
    instance();
  } else {
    fail("unknown directive " + name);
  }
}

void Parser::check_names() const {
  for (const auto& [name, material] : scene_.materials) {
    const PbrtParameters& parameters = material.parameters;
    const bool has_index = parameters.contains("eta") || parameters.contains("k");
    require(!has_index || !parameters.contains("reflectance"), name + ": eta or reflectance, not both");
    if (material.plugin != "mix") continue;
    for (const std::string& part : parameters.at("materials").strings)
      require(scene_.materials.contains(part), name + " mixes no material that there is");
  }
}

PbrtScene Parser::parse() {
  while (token_.kind != Kind::End) {
    const std::string name = take(Kind::Word, "a directive").text;
    directive(name);
  }
  require(in_world_, "there is no WorldBegin");
  require(blocks_.empty(), "a block has no end");
  require(scene_.options.size() == 5, "an option is missing");
  check_names();
  return std::move(scene_);
}

}  // namespace

PbrtScene parse_pbrt(std::string_view text, const std::string& folder) {
  return Parser(text, folder).parse();
}

grf::Vec2d pbrt_pixel(const PbrtScene& scene, const Vec3d& point) {
  const PbrtEntity& film = scene.options.at("Film");
  const double width = film.number("xresolution");
  const double height = film.number("yresolution");
  const Vec3d seen = point * scene.world_to_camera;
  const double tangent = std::tan(scene.options.at("Camera").number("fov") * std::numbers::pi / 360);
  const double half_width = std::max(1.0, width / height);
  const double half_height = std::max(1.0, height / width);
  const double x = seen.x / (seen.z * tangent * half_width);
  const double y = seen.y / (seen.z * tangent * half_height);
  return {(1 + x) / 2 * width, (1 - y) / 2 * height};
}

}  // namespace test
