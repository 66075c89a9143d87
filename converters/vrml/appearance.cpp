#include "converters/vrml/appearance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "converters/vrml/addresses.h"

namespace convert::vrml {
namespace {

using grf::Vec2d;
using grf::Vec3d;

/// Returns the numbers of one material in a list field of VRML 1.0; empty if the field is missing.
std::span<const double> values_at(const NodeReader& material, std::string_view field, std::size_t size,
                                  std::size_t index) {
  const auto numbers = material.numbers(field, size);
  if (numbers.empty()) return numbers;
  return numbers.subspan(std::min(index, numbers.size() / size - 1) * size, size);
}

/// The table of conversions by `MaterialReader`, the readers of shapes and the mapping.
constexpr std::array<MaterialRule, 13> Rules = {{
    {"`specularColor` = 0, as by default", "`diffuse kd=diffuseColor`, by default 0.8",
     "material Material {}", "diffuse kd=0.8", ""},
    {"`specularColor` > 0",
     "`lewis n=32*shininess ks=specularColor kd=diffuseColor`, since 128 times shininess is the exponent of "
     "the half vector",
     "material Material { specularColor 0.1 0.1 0.1 shininess 0.5 }", "lewis n=16 ks=0.1 kd=0.8", ""},
    {"`emissiveColor` > 0", "`light rgb` on the faces, which keep their BRDF",
     "material Material { emissiveColor 1 0.5 0 }", "diffuse kd=0.8 light rgb (1, 0.5, 0)", ""},
    {"colours of vertices or faces",
     "colours of vertices or faces, and `kd` = 1; in GRF they tint the highlight too",
     "material Material {}; color Color { color [ 1 0 0, 0 1 0 ] } colorPerVertex FALSE",
     "diffuse kd=1 rgb (1, 0, 0)", ""},
    {"`ImageTexture`", "`texture`, and `kd` = 1, since an image replaces `diffuseColor` and colours",
     "material Material {} texture ImageTexture { url \"wood.png\" }", "diffuse kd=1 texture \"wood.png\"",
     ""},
    {"`Texture2` of VRML 1.0", "`texture`, and `kd` = `diffuseColor`",
     "Material {} Texture2 { filename \"wood.png\" }", "diffuse kd=0.8 texture \"wood.png\"", ""},
    {"no `Material`", "no BRDF, or what `--brdf` says", "texture ImageTexture { url \"wood.png\" }",
     "texture \"wood.png\"", ""},
    {"`transparency` > 0", "`opacity`, 1 - `transparency`", "material Material { transparency 0.75 }",
     "diffuse kd=0.8 opacity 0.25", ""},
    {"`PixelTexture`, `MovieTexture`, `image` of `Texture2`", "lost",
     "material Material {} texture PixelTexture {}", "diffuse kd=0.8", "PixelTexture node was skipped"},
    {"`ambientIntensity`, `ambientColor`", "kept only in the comment",
     "material Material { ambientIntensity 0.5 }", "diffuse kd=0.8", ""},
    {"several values in a `Material` of VRML 1.0, bound to faces, that differ only in `diffuseColor` and "
     "have no highlight",
     "colours of faces", "Material { diffuseColor [ 1 0 0, 0 1 0 ] } MaterialBinding { value PER_FACE }",
     "diffuse kd=1 rgb (1, 0, 0)", ""},
    {"others bound to faces", "one definition per value, `name_0` and so on",
     "Material { diffuseColor [ 1 0 0, 0 1 0 ] shininess [ 0.5, 1 ] specularColor 0.1 0.1 0.1 } "
     "MaterialBinding { value PER_FACE }",
     "lewis n=16 ks=0.1 kd=(0.9, 0, 0)", ""},
    {"bound to vertices", "colours of vertices, from `diffuseColor`; the rest is of the first value",
     "Material { diffuseColor [ 1 0 0, 0 1 0, 0 0 1, 1 1 1 ] } MaterialBinding { value PER_VERTEX }",
     "diffuse kd=1", ""},
}};

/// Reads one material of a Material node, and records its original values.
class MaterialReader {
 public:
  MaterialReader(const SurfaceInputs& inputs, Report& report)
      : inputs_(inputs), reader_(*inputs.material, report.diagnostics()) {
    material_.source = "VRML";
    material_.location = inputs.material->source->lasting_location(inputs.material->offset);
  }

  PhongMaterial run(std::size_t count) {
    const Node& node = *inputs_.material;
    const std::string_view own_name = node.name.empty() ? inputs_.name : node.name;
    material_.name = own_name.empty() ? "material" : own_name;
    if (count > 1) material_.name += fmt::format("_{}", inputs_.index);
    const Vec3d diffuse = colour("diffuseColor", Vec3d(0.8));
    // The lighting model of VRML97 (ISO/IEC 14772-1, 4.14.2): an image, or a colour of vertices or faces,
    // replaces the diffuse reflectance. In VRML 1.0, images multiply it, as in Open Inventor.
    const bool image_replaces = inputs_.texture && node.source->version() == Version::Vrml97;
    material_.diffuse = inputs_.has_colours || image_replaces ? Vec3d(1) : diffuse;
    material_.specular = colour("specularColor", Vec3d(0));
    material_.emission = colour("emissiveColor", Vec3d(0));
    // The lighting equations (4.14.4) have the Blinn-Phong exponent 128 shininess; that of `lewis` is a Phong
    // exponent.
    constexpr double HalfVectorExponent = 128;
    material_.exponent = to_phong_exponent(number("shininess", 0.2) * HalfVectorExponent);
    material_.opacity = 1 - number("transparency", 0);
    number("ambientIntensity", 0.2);
    colour("ambientColor", Vec3d(0.2));
    if (inputs_.texture) material_.diffuse_map = grf::Texture{*inputs_.texture, material_.location};
    return std::move(material_);
  }

 private:
  Vec3d colour(std::string_view field, const Vec3d& fallback) {
    const auto values = taken_down(field, 3);
    return values.empty() ? fallback : Vec3d(values[0], values[1], values[2]);
  }
  double number(std::string_view field, double fallback) {
    const auto values = taken_down(field, 1);
    return values.empty() ? fallback : values[0];
  }
  std::span<const double> taken_down(std::string_view field, std::size_t size) {
    const bool is_vrml97 = inputs_.material->source->version() == Version::Vrml97;
    const auto values =
        is_vrml97 ? reader_.exactly(field, size) : values_at(reader_, field, size, inputs_.index);
    if (!values.empty()) {
      material_.source_values.push_back(
          fmt::format("{} {}", field, fmt::join(values.begin(), values.end(), " ")));
    }
    return values;
  }

  const SurfaceInputs& inputs_;
  NodeReader reader_;
  PhongMaterial material_;
};

constexpr std::array<std::pair<std::string_view, std::size_t>, 6> MaterialFields = {{{"ambientColor", 3},
                                                                                     {"diffuseColor", 3},
                                                                                     {"specularColor", 3},
                                                                                     {"emissiveColor", 3},
                                                                                     {"shininess", 1},
                                                                                     {"transparency", 1}}};

bool is_repeated(const Node& texture, Report& report) {
  const NodeReader reader(texture, report.diagnostics());
  if (texture.source->version() == Version::Vrml97) {
    return reader.flag("repeatS", true) && reader.flag("repeatT", true);
  }
  const auto clamps = [&reader](std::string_view field) {
    const auto words = reader.words(field);
    return !words.empty() && words[0] == "CLAMP";
  };
  return !clamps("wrapS") && !clamps("wrapT");
}

}  // namespace

grf::Surface Appearances::surface(const SurfaceInputs& inputs, std::size_t faces) {
  if (inputs.material == nullptr) {
    grf::Surface surface;
    if (inputs.texture) surface.texture = grf::Texture{*inputs.texture, {}};
    return surface;
  }
  const auto [known, is_new] =
      known_.emplace(Key{inputs.material, inputs.index, inputs.has_colours, inputs.texture}, 0);
  if (is_new) {
    const bool is_vrml97 = inputs.material->source->version() == Version::Vrml97;
    const std::size_t count = is_vrml97 ? 1 : material_count(*inputs.material, report_);
    known->second = materials_.add(map_material(MaterialReader(inputs, report_).run(count)));
  }
  return materials_.surface(known->second, faces, report_.losses());
}

std::size_t material_count(const Node& material, Report& report) {
  const NodeReader reader(material, report.diagnostics());
  std::size_t count = 1;
  for (const auto& [field, size] : MaterialFields) {
    count = std::max(count, reader.numbers(field, size).size() / size);
  }
  return count;
}

std::vector<grf::Colour> diffuse_colours(const Node& material, Report& report) {
  const NodeReader reader(material, report.diagnostics());
  std::vector<grf::Colour> colours;
  const std::size_t count = material_count(material, report);
  for (std::size_t i = 0; i < count; ++i) {
    const auto values = values_at(reader, "diffuseColor", 3, i);
    grf::Vec3d colour = values.empty() ? Vec3d(0.8) : Vec3d(values[0], values[1], values[2]);
    for (int k = 0; k < 3; ++k) colour[k] = std::clamp(colour[k], 0.0, 1.0);
    colours.emplace_back(colour);
  }
  return colours;
}

bool differs_in_diffuse_colour_alone(const Node& material, Report& report) {
  const NodeReader reader(material, report.diagnostics());
  const bool one_value = std::all_of(MaterialFields.begin(), MaterialFields.end(), [&](const auto& field) {
    return field.first == "diffuseColor" || field.first == "ambientColor" ||
           reader.numbers(field.first, field.second).size() <= field.second;
  });
  const auto specular = reader.numbers("specularColor", 3);
  return one_value && std::all_of(specular.begin(), specular.end(), [](double value) { return value == 0; });
}

void transform_uvs(std::vector<grf::Vec2f>& uvs, const Node& transform, Report& report) {
  const NodeReader reader(transform, report.diagnostics());
  const bool is_vrml97 = transform.source->version() == Version::Vrml97;
  const Vec2d translation = reader.pair("translation", Vec2d(0));
  const Vec2d center = reader.pair("center", Vec2d(0));
  const Vec2d scale = reader.pair(is_vrml97 ? "scale" : "scaleFactor", Vec2d(1));
  const double angle = reader.number("rotation", 0);
  const auto turned = [angle](const Vec2d& v) {
    return Vec2d(std::cos(angle) * v.x - std::sin(angle) * v.y,
                 std::sin(angle) * v.x + std::cos(angle) * v.y);
  };
  for (grf::Vec2f& uv : uvs) {
    const Vec2d given(uv);
    // The order of transforms in VRML97 (6.50) is the reverse of that in VRML 1.0.
    const Vec2d moved = is_vrml97 ? turned(given + translation + center) * scale - center
                                  : turned((given - center) * scale) + center + translation;
    uv = grf::Vec2f(moved);
  }
}

std::optional<std::string> texture_of(const Node* texture, const std::string& folder,
                                      const std::string& main_path, Report& report) {
  if (texture == nullptr) return std::nullopt;
  const bool is_image = texture->type == "ImageTexture" || texture->type == "Texture2";
  if (!is_image) {
    report.skip(*texture);
    return std::nullopt;
  }
  const NodeReader reader(*texture, report.diagnostics());
  if (const Field* image = reader.find("image"); image != nullptr && texture->type == "Texture2") {
    const bool has_pixels = reader.numbers("image").size() > 3;
    report.add("image of a Texture2 was left out", "images of Texture2 nodes were left out",
               "textures are images in files of their own", has_pixels ? 1 : 0);
  }
  const auto addresses = reader.strings(texture->type == "ImageTexture" ? "url" : "filename");
  if (std::all_of(addresses.begin(), addresses.end(), [](const auto& address) { return address.empty(); })) {
    return std::nullopt;
  }
  auto file = local_file(addresses, folder, main_path);
  if (!file) report.add("texture was left out", "textures were left out", "its address is not of a file");
  if (file && !is_repeated(*texture, report)) {
    report.add("texture is repeated", "textures are repeated", "the file clamps them, and GRF repeats all");
  }
  return file;
}

std::span<const MaterialRule> material_rules() { return Rules; }

}  // namespace convert::vrml
