// Tests of the material tables: the example of each row is converted to the result in the row.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <assimp/material.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "converters/assimp/assimp_materials.h"
#include "converters/assimp/assimp_rules.h"
#include "converters/format.h"
#include "converters/materials.h"
#include "grf/write.h"
#include "renderer/image/image_file.h"
#include "tests/converters/gltf/gltf_maker.h"
#include "tests/converters/vrml/vrml_reading.h"

namespace convert {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> split(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end + separator.size());
  }
  parts.emplace_back(text);
  return parts;
}

std::string joined(const std::vector<std::string>& lines, std::string_view separator) {
  return fmt::format("{}", fmt::join(lines, separator));
}

std::string numbers_of(const grf::Colour& c) { return fmt::format("({}, {}, {})", c.x, c.y, c.z); }

/// A surface as GRF has it, with the BRDF that its name means.
std::string text_of(const grf::Surface& surface, const std::vector<grf::Definition>& definitions) {
  std::vector<std::string> words;
  if (surface.brdf) {
    const std::string& name = std::get<grf::Reference>(*surface.brdf).name;
    for (const grf::Definition& definition : definitions) {
      if (definition.name == name) words.push_back(brdf_text(definition));
    }
  }
  if (surface.colour) words.push_back("rgb " + numbers_of(std::get<grf::Colour>(*surface.colour)));
  if (surface.emission) words.push_back("light rgb " + numbers_of(*surface.emission));
  if (surface.texture)
    words.push_back(fmt::format("texture \"{}\"", std::get<grf::Texture>(*surface.texture).file));
  if (surface.opacity) words.push_back(grf::to_text(*surface.opacity));
  return joined(words, " ");
}

void expect_row(const MaterialRule& rule, const std::string& surface, const std::string& warnings) {
  EXPECT_EQ(surface, rule.gives) << rule.example;
  if (rule.loses.empty()) {
    EXPECT_THAT(warnings, IsEmpty()) << rule.example;
  } else {
    EXPECT_THAT(warnings, HasSubstr(std::string(rule.loses))) << rule.example;
  }
}

void expect_row(const MaterialRule& rule, const Reading& reading) {
  ASSERT_TRUE(reading.scene.has_value()) << rule.example << '\n' << reading.text();
  const auto meshes = meshes_of(*reading.scene);
  ASSERT_FALSE(meshes.empty()) << rule.example;
  expect_row(rule, text_of(meshes[0].surface(0), definitions_of(*reading.scene)), reading.text());
}

/// Reads a file beside which the image `wood.png` is.
Reading read_beside_image(const std::string& name, std::string_view text) {
  const test::TemporaryFolder folder;
  folder.add("wood.png", "");
  return read_path(folder.add(name, text));
}

TEST(MaterialRules, OfMtlHold) {
  for (const MaterialRule& rule : find_format("obj")->read_materials) {
    const test::TemporaryFolder folder;
    folder.add("wood.png", "");
    folder.add("model.mtl", "newmtl m\n" + joined(split(rule.example, "; "), "\n") + "\n");
    expect_row(rule,
               read_path(folder.add("model.obj",
                                    "mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                    "usemtl m\nf 1/1 2/2 3/3\n")));
  }
}

TEST(MaterialRules, OfGltfHold) {
  for (const MaterialRule& rule : find_format("gltf")->read_materials) {
    GltfMaker maker = GltfMaker::triangle();
    maker.attributes()["TEXCOORD_0"] = maker.floats({0, 0, 1, 0, 0, 1}, "VEC2");
    maker.primitive()["material"] = 0;
    maker.json["materials"] =
        nlohmann::json::array({nlohmann::json::parse(fmt::format("{{{}}}", rule.example))});
    maker.json["textures"] = {{{"source", 0}}};
    maker.json["images"] = {{{"uri", "wood.png"}}};
    expect_row(rule, read_beside_image("model.gltf", maker.gltf()));
  }
}

/// A file with the nodes of an example: those of VRML97 go into an appearance, and behind `; ` into a
/// geometry.
std::string vrml_file(std::string_view example) {
  const bool is_vrml97 = example.starts_with("material ") || example.starts_with("texture ");
  if (!is_vrml97) {
    return fmt::format(
        "#VRML V1.0 ascii\nSeparator {{ Coordinate3 {{ point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }} {} "
        "IndexedFaceSet {{ coordIndex [ 0, 1, 2, -1, 0, 2, 3, -1 ] }} }}\n",
        example);
  }
  const auto parts = split(example, "; ");
  return "#VRML V2.0 utf8\n" + shape(square(parts.size() > 1 ? parts[1] : ""), parts[0]);
}

TEST(MaterialRules, OfVrmlHold) {
  for (const MaterialRule& rule : find_format("vrml")->read_materials) {
    expect_row(rule, read_beside_image("model.wrl", vrml_file(rule.example)));
  }
}

// Assimp's properties, as the comments of definitions have them.

void add_colour(aiMaterial& material, const char* key, const std::string& value) {
  const float grey = std::stof(value);
  const aiColor3D colour(grey, grey, grey);
  material.AddProperty(&colour, 1, key, 0, 0);
}

void add_number(aiMaterial& material, const char* key, const std::string& value) {
  const float number = std::stof(value);
  material.AddProperty(&number, 1, key, 0, 0);
}

void add_file(aiMaterial& material, aiTextureType type, const std::string& value) {
  const aiString file(value);
  material.AddProperty(&file, AI_MATKEY_TEXTURE(type, 0));
}

void add_property(aiMaterial& material, const std::string& name, const std::string& value) {
  const std::map<std::string, std::string> colours = {{"diffuse", "$clr.diffuse"},
                                                      {"specular", "$clr.specular"},
                                                      {"ambient", "$clr.ambient"},
                                                      {"emissive", "$clr.emissive"}};
  const std::map<std::string, std::string> numbers = {{"shininess", "$mat.shininess"},
                                                      {"shinpercent", "$mat.shinpercent"},
                                                      {"opacity", "$mat.opacity"},
                                                      {"metallicFactor", "$mat.metallicFactor"},
                                                      {"roughnessFactor", "$mat.roughnessFactor"}};
  if (colours.contains(name)) {
    add_colour(material, colours.at(name).c_str(), value);
  } else if (numbers.contains(name)) {
    add_number(material, numbers.at(name).c_str(), value);
  } else if (name == "shadingm") {
    const int shading = std::stoi(value);
    material.AddProperty(&shading, 1, AI_MATKEY_SHADING_MODEL);
  } else if (name == "file") {
    add_file(material, aiTextureType_DIFFUSE, value);
  } else if (name == "bump") {
    add_file(material, aiTextureType_HEIGHT, value);
  } else {
    ADD_FAILURE() << "no property is called " << name;
  }
}

/// Reads an example, `FORMAT: NAME VALUE; NAME VALUE`, for one face.
void expect_assimp_row(const MaterialRule& rule) {
  constexpr std::array Formats = {ThreeDsRules, ColladaRules, FbxRules, LwoRules, Ac3dRules, XRules};
  const auto parts = split(rule.example, ": ");
  const auto* format = std::find_if(Formats.begin(), Formats.end(), [&](const AssimpRules& candidate) {
    return candidate.source == parts.at(0);
  });
  ASSERT_NE(format, Formats.end()) << rule.example;
  aiMaterial material;
  for (const std::string& property : split(parts.at(1), "; ")) {
    const auto words = split(property, " ");
    add_property(material, words.at(0), words.at(1));
  }
  DefinitionNames names;
  Materials materials(names);
  materials.add(map_material(read_material(material, *format).phong));
  Losses losses;
  const grf::Surface surface = materials.surface(0, 1, losses);
  grf::Diagnostics diagnostics;
  losses.report(grf::whole_file("example"), diagnostics);
  expect_row(rule, text_of(surface, materials.definitions()), diagnostics.to_text());
}

TEST(MaterialRules, OfAssimpHold) {
  for (const MaterialRule& rule : find_format("other")->read_materials) expect_assimp_row(rule);
}

TEST(AssimpMaterials, KeepPhysicallyBasedParameters) {
  aiMaterial material;
  add_colour(material, "$clr.base", "0.75");
  add_colour(material, "$clr.sheen.factor", "0.25");
  for (const auto& [key, value] :
       std::map<std::string, std::string>{{"$mat.roughnessFactor", "0.125"},
                                          {"$mat.anisotropyFactor", "0.375"},
                                          {"$mat.clearcoat.factor", "1"},
                                          {"$mat.clearcoat.roughnessFactor", "0.0625"},
                                          {"$mat.sheen.roughnessFactor", "0.875"},
                                          {"$mat.refracti", "1.25"}}) {
    add_number(material, key.c_str(), value);
  }
  EXPECT_EQ(brdf_text(map_material(read_material(material, FbxRules).phong).definition),
            "gltf baseColor=0.75 roughness=0.125 ior=1.25 anisotropy=0.375 clearcoat=1 coatRoughness=0.0625 "
            "sheenColor=0.25 sheenRoughness=0.875");
}

/// What a file is that the format writes of a triangle with the attributes.
std::string written(const char* format, std::string_view attributes, const std::string& file,
                    const std::string& part) {
  const test::TemporaryFolder folder;
  folder.add("wood.png", "");
  const grf::Scene scene =
      scene_of_grf(fmt::format("begin mesh {} begin vertexs uv (0,0) (0,0,0) uv (1,0) (1,0,0) uv (0,1) "
                               "(0,1,0) end vertexs begin faces (0,1,2) end faces "
                               "end mesh",
                               attributes));
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(find_format(format)->write(scene, folder.path(file), diagnostics)) << diagnostics.to_text();
  return test::bytes_of(folder.path(part));
}

TEST(MaterialRules, OfWrittenMtlHold) {
  for (const MaterialRule& rule : find_format("obj")->written_materials) {
    std::vector<std::string> lines;
    for (const std::string& line : split(written("obj", rule.example, "model.obj", "model.mtl"), "\n")) {
      const bool is_value = !line.empty() && !line.starts_with("#") && !line.starts_with("newmtl");
      if (is_value) lines.push_back(line);
    }
    EXPECT_EQ(joined(lines, "; "), rule.gives) << rule.example;
  }
}

/// Whether all that one has is in the other.
bool has_all(const nlohmann::json& whole, const nlohmann::json& part) {
  if (!part.is_object()) return whole == part;
  for (const auto& [key, value] : part.items()) {
    if (!whole.contains(key) || !has_all(whole.at(key), value)) return false;
  }
  return true;
}

TEST(MaterialRules, OfWrittenGltfHold) {
  for (const MaterialRule& rule : find_format("gltf")->written_materials) {
    const auto file = nlohmann::json::parse(written("gltf", rule.example, "model.gltf", "model.gltf"));
    const auto expected = nlohmann::json::parse(fmt::format("{{{}}}", rule.gives));
    EXPECT_TRUE(has_all(file.at("materials").at(0), expected)) << rule.example << '\n'
                                                               << file.at("materials");
  }
}

TEST(MaterialRules, OfWrittenRendererScenesHold) {
  for (const auto& [name, file] : std::map<std::string, std::string>{
           {"pbrt", "a.pbrt"}, {"mitsuba", "a.xml"}, {"usd", "a.usda"}, {"materialx", "a.mtlx"}}) {
    for (const MaterialRule& rule : find_format(name)->written_materials) {
      const test::TemporaryFolder folder;
      grf::Diagnostics diagnostics;
      const image::ImageFile wood{{1, 1, {{0.5F, 0.25F, 0.125F}}}};
      ASSERT_TRUE(image::write_image(wood, folder.path("wood.png"), diagnostics));
      const grf::Scene scene = scene_of_grf(
          fmt::format("def soft = brdf diffuse kd=0.5 shiny = brdf specular ks=0.25 begin begin mesh {} "
                      "begin vertexs uv (0,0) (0,0,0) uv (1,0) (1,0,0) uv (0,1) (0,1,0) end "
                      "begin faces (0,1,2) end end end",
                      rule.example));
      ASSERT_TRUE(find_format(name)->write(scene, folder.path(file), diagnostics)) << diagnostics.to_text();
      EXPECT_THAT(test::bytes_of(folder.path(file)), HasSubstr(std::string(rule.gives))) << rule.example;
      const std::string warnings = diagnostics.to_text();
      EXPECT_THAT(warnings, HasSubstr(std::string(rule.loses))) << rule.example;
      // MaterialX never has the mesh.
      const std::size_t usual = name == "materialx" ? 1 : 0;
      EXPECT_EQ(rule.loses.empty(), diagnostics.losses().size() == usual) << rule.example << warnings;
    }
  }
}

}  // namespace
}  // namespace convert
