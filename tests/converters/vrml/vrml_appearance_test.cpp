// Materials and textures of VRML97.
#include <gmock/gmock.h>

#include "tests/converters/vrml/vrml_reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Reading read_material(std::string_view fields) {
  return read_vrml97(shape(square(), "material DEF m Material { " + std::string(fields) + "}"));
}

/// The BRDF of the only material.
std::string brdf_of(const Reading& reading) {
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  const auto definitions = definitions_of(*reading.scene);
  EXPECT_EQ(definitions.size(), 1U);
  return definitions.empty() ? "" : brdf_text(definitions[0]);
}

grf::Surface surface_of(const grf::Mesh& mesh) { return mesh.surface(0); }

TEST(VrmlMaterial, BecomesTheNearestBrdf) {
  EXPECT_EQ(brdf_of(read_material("")), "diffuse kd=0.8");
  EXPECT_EQ(brdf_of(read_material("diffuseColor 0.1 0.2 0.3")), "diffuse kd=(0.1, 0.2, 0.3)");
  EXPECT_EQ(brdf_of(read_material("diffuseColor 0.5 0.5 0.5 specularColor 0.25 0.25 0.25 shininess 0.5")),
            "lewis n=16 ks=0.25 kd=0.5");
  EXPECT_EQ(brdf_of(read_material("diffuseColor 0.5 0.5 0.5 specularColor 0.25 0.25 0.25")),
            "lewis n=6.4 ks=0.25 kd=0.5");
}

TEST(VrmlMaterial, KeepsWhatTheFileSaysInAComment) {
  const Reading reading = read_material("ambientIntensity 0.5 diffuseColor 0.1 0.2 0.3 shininess 0.25");
  const auto definitions = definitions_of(*reading.scene);
  EXPECT_EQ(definitions[0].name, "m");
  EXPECT_THAT(definitions[0].comments.before,
              ElementsAre(" VRML: diffuseColor 0.1 0.2 0.3; shininess 0.25; ambientIntensity 0.5"));
  EXPECT_EQ(material_of(meshes_of(*reading.scene)[0], 1), "m");
}

TEST(VrmlMaterial, ThatEmitsMakesItsFacesLights) {
  const Reading reading = read_material("emissiveColor 1 0.5 0");
  EXPECT_EQ(surface_of(meshes_of(*reading.scene)[0]).emission, grf::Colour(1, 0.5F, 0));
  EXPECT_THAT(reading.text(), IsEmpty());
  const Reading open = read_vrml97(shape(square("solid FALSE"), "material Material { emissiveColor 1 1 1 }"));
  EXPECT_THAT(open.text(), HasSubstr("2 faces emit only from their fronts"));
}

TEST(VrmlMaterial, ThatIsTransparentHasAnOpacity) {
  const Reading reading = read_material("transparency 0.75");
  EXPECT_EQ(surface_of(meshes_of(*reading.scene)[0]).opacity,
            (grf::Opacity{grf::Opacity::Kind::Number, 0.25F}));
  EXPECT_THAT(reading.text(), IsEmpty());
  EXPECT_EQ(surface_of(meshes_of(*read_material("transparency 0").scene)[0]).opacity, std::nullopt);
}

TEST(VrmlMaterial, SaysWhatItLoses) {
  EXPECT_THAT(read_material("diffuseColor 2 0 0").text(), HasSubstr("out of range, and were clamped ('m')"));
  EXPECT_THAT(read_material("diffuseColor 1 0 0 0 1 0").text(), HasSubstr("has 6 numbers, expected 3"));
}

TEST(VrmlMaterial, IsNamedByItselfOrItsAppearance) {
  const Reading reading = read_vrml97(
      "Shape { geometry Box {} appearance DEF a Appearance { material Material {} } }" +
      shape("Box {}", "material Material {}") + shape("Box {}", "material Material {}") + shape("Box {}"));
  std::vector<std::string> names;
  for (const grf::Mesh& mesh : meshes_of(*reading.scene)) names.push_back(material_of(mesh, 0));
  EXPECT_THAT(names, ElementsAre("a", "material", "material_2", ""));
}

TEST(VrmlMaterial, ThatIsUsedAgainIsOneDefinition) {
  const Reading reading =
      read_vrml97(shape("Box {}", "material DEF m Material {}") + shape("Cone {}", "material USE m"));
  EXPECT_EQ(definitions_of(*reading.scene).size(), 1U);
}

TEST(VrmlMaterial, IsWhiteBehindColoursAndImages) {
  const std::string red = "material Material { diffuseColor 1 0 0 specularColor 0.1 0.1 0.1 }";
  const std::string colours = "color Color { color [ 1 0 0 0 1 0 0 0 1 1 1 1 ] } ";
  EXPECT_EQ(brdf_of(read_vrml97(shape(square(colours), red))), "lewis n=6.4 ks=0.1 kd=0.9");
  EXPECT_EQ(brdf_of(read_vrml97(shape(square(colours + "colorPerVertex FALSE"), red))),
            "lewis n=6.4 ks=0.1 kd=0.9");
  EXPECT_EQ(brdf_of(read_vrml97(shape(square(), red + "texture ImageTexture { url \"a.png\" }"))),
            "lewis n=6.4 ks=0.1 kd=0.9");
  const Reading both = read_vrml97(shape(square(colours), red + "texture ImageTexture { url \"a.png\" }"));
  EXPECT_THAT(both.text(), HasSubstr("2 faces lost their colours: its texture replaces them"));
  EXPECT_TRUE(meshes_of(*both.scene)[0].geometry->colours.empty());
}

TEST(VrmlTexture, IsTheFirstThatIsThere) {
  const test::TemporaryFolder folder;
  folder.add("maps/b.png", "");
  const auto file_of = [&](std::string_view url) -> std::string {
    const Reading reading = read_path(folder.add(
        "model.wrl",
        "#VRML V2.0 utf8\n" + shape(square(), "texture ImageTexture { url " + std::string(url) + " }")));
    EXPECT_TRUE(reading.scene.has_value()) << reading.text();
    const auto texture = surface_of(meshes_of(*reading.scene)[0]).texture;
    return texture ? std::get<grf::Texture>(*texture).file : "none: " + reading.text();
  };
  EXPECT_EQ(file_of("\"a.png\""), "a.png");
  EXPECT_EQ(file_of("[ \"a.png\" \"maps\\\\b.png\" ]"), "maps/b.png");
  EXPECT_EQ(file_of("[ \"http://x/y.png\", \"file:a.png\" ]"), "a.png");
  EXPECT_EQ(file_of("\"file:///x/a.png\""), "/x/a.png");
  EXPECT_THAT(file_of("\"urn:a\""), HasSubstr("1 texture was left out: its address is not of a file"));
  EXPECT_EQ(file_of("[ ]"), "none: ");
  EXPECT_EQ(file_of("\"\""), "none: ");
}

TEST(VrmlTexture, OfAnotherKindIsPassedOver) {
  const Reading reading =
      read_vrml97(shape(square(), "texture PixelTexture { image 2 1 3 0xFF0000 0x00FF00 }") +
                  shape(square(), "texture MovieTexture { url \"a.mpg\" }") +
                  shape(square(), "texture ImageTexture { url \"a.png\" repeatS FALSE }"));
  EXPECT_THAT(reading.text(), HasSubstr("1 PixelTexture node was skipped"));
  EXPECT_THAT(reading.text(), HasSubstr("1 MovieTexture node was skipped"));
  EXPECT_THAT(reading.text(), HasSubstr("1 texture is repeated: the file clamps them"));
}

TEST(VrmlTexture, WithoutCoordinatesLiesOnTheLongestSides) {
  const std::string texture = "texture ImageTexture { url \"a.png\" }";
  const grf::Mesh mesh = mesh97(shape(
      "IndexedFaceSet { coord Coordinate { point [ 1 0 1 1 0 5 1 2 5 ] } coordIndex [ 0 1 2 ] }", texture));
  EXPECT_EQ(mesh.geometry->uvs[0], grf::Vec2f(0, 0));
  EXPECT_EQ(mesh.geometry->uvs[1], grf::Vec2f(1, 0));
  EXPECT_EQ(mesh.geometry->uvs[2], grf::Vec2f(1, 0.5F));
  EXPECT_TRUE(mesh97(shape(square())).geometry->uvs.empty());
}

TEST(VrmlTexture, IsMovedByItsTransform) {
  const auto uv_of = [](std::string_view transform) {
    const grf::Mesh mesh =
        mesh97(shape(square("texCoord TextureCoordinate { point [ 1 0 0 0 0 0 0 0 ] }"),
                     "texture ImageTexture { url \"a.png\" } textureTransform TextureTransform { " +
                         std::string(transform) + "}"));
    return mesh.geometry->uvs[0];
  };
  const auto near = [](const grf::Vec2f& a, float x, float y) {
    return (a - grf::Vec2f(x, y)).length() < 1e-6F;
  };
  EXPECT_TRUE(near(uv_of(""), 1, 0));
  EXPECT_TRUE(near(uv_of("translation 1 2"), 2, 2));
  EXPECT_TRUE(near(uv_of("scale 2 3 translation 0 1"), 2, 3)) << "moved first";
  EXPECT_TRUE(near(uv_of("rotation 1.57079633"), 0, 1));
  EXPECT_TRUE(near(uv_of("rotation 1.57079633 scale 1 3"), 0, 3)) << "turned before scaled";
  EXPECT_TRUE(near(uv_of("center 1 0 scale 3 3"), 5, 0)) << "-C S R C T, as the standard has it";
}

}  // namespace
}  // namespace convert
