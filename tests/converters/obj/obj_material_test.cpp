// The materials of OBJ files: their libraries, and which face has which.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/keywords.h"
#include "grf/read.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string Library = "mtllib model.mtl\n";

std::vector<std::string> materials_of(const grf::Mesh& mesh) {
  std::vector<std::string> materials;
  for (std::size_t i = 0; i < mesh.face_count(); ++i) materials.push_back(material_of(mesh, i));
  return materials;
}

std::vector<std::string> names_of(const std::vector<grf::Definition>& definitions) {
  std::vector<std::string> names;
  names.reserve(definitions.size());
  for (const grf::Definition& definition : definitions) names.push_back(definition.name);
  return names;
}

/// The warnings about a square with one material, `m`, of which the library says this.
std::string warnings_of_material(const std::string& statements) {
  const Reading reading =
      read_obj_text(Library + SquareVertices + "usemtl m\nf 1 2 3\nf 1 3 4\n", "newmtl m\n" + statements);
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  return reading.text();
}

TEST(ObjMaterials, BelongToFacesByName) {
  const Reading reading =
      read_obj_text(Library + SquareVertices +
                        "f 1 2 3\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 4\nf 2 3 4\nusemtl red\nf 1 3 4\n",
                    "newmtl red\nKd 0.8 0 0\nnewmtl blue\nKd 0 0 0.5\nnewmtl unused\nKd 1 1 1\n");
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  EXPECT_THAT(reading.text(), IsEmpty());
  const std::vector<grf::Mesh> meshes = meshes_of(*reading.scene);
  ASSERT_EQ(meshes.size(), 1U);
  // No material stands before the first `usemtl`, whatever the library ended with.
  EXPECT_THAT(materials_of(meshes[0]), ElementsAre("", "red", "blue", "blue", "red"));
  EXPECT_EQ(meshes[0].surfaces.size(), 3U);
  const std::vector<grf::Definition> definitions = definitions_of(*reading.scene);
  ASSERT_THAT(names_of(definitions), ElementsAre("red", "blue", "unused"));
  EXPECT_EQ(brdf_text(definitions[0]), "diffuse kd=(0.8, 0, 0)");
  EXPECT_EQ(brdf_text(definitions[2]), "diffuse kd=1");
}

TEST(ObjMaterials, GoOnFromOneObjectToTheNext) {
  const Reading reading =
      read_obj_text(SquareVertices + "o a\nusemtl m\nf 1 2 3\no b\nf 1 3 4\nmtllib model.mtl\no c\nf 2 3 4\n",
                    "newmtl z\nnewmtl m\n");
  ASSERT_TRUE(reading.scene.has_value());
  for (const grf::Mesh& mesh : meshes_of(*reading.scene)) EXPECT_THAT(materials_of(mesh), ElementsAre("m"));
}

TEST(ObjMaterials, AreNeverMerged) {
  const Reading reading = read_obj_text(Library + SquareVertices + "usemtl b\nf 1 2 3\n",
                                        "newmtl a\nKd 1 0 0\nnewmtl b\nKd 1 0 0\nnewmtl B\nKd 1 0 0\n");
  EXPECT_THAT(names_of(definitions_of(*reading.scene)), ElementsAre("a", "b", "B"));
}

TEST(ObjMaterials, KeepTheirNames) {
  for (const std::string name :
       {"Wall-inner", "many  spaces, and $ and #", "1", "none", "\u00E6/\"q\"\\ x", "ward"}) {
    const Reading reading = read_obj_text(Library + SquareVertices + "usemtl " + name + "\nf 1 2 3 4\n",
                                          "newmtl  " + name + " \nKd 0.25 0.25 0.25\n");
    ASSERT_TRUE(reading.scene.has_value()) << reading.text();
    EXPECT_THAT(reading.text(), IsEmpty());
    const std::vector<grf::Definition> definitions = definitions_of(*reading.scene);
    ASSERT_EQ(definitions.size(), 1U) << name;
    EXPECT_TRUE(grf::is_identifier(definitions[0].name));
    EXPECT_EQ(grf::from_identifier(definitions[0].name), name);
    EXPECT_EQ(material_of(meshes_of(*reading.scene)[0], 0), definitions[0].name);
    EXPECT_EQ(brdf_text(definitions[0]), "diffuse kd=0.25");
  }
}

TEST(ObjMaterials, WithoutANameBelongToFacesWithoutOne) {
  const Reading reading =
      read_obj_text(Library + SquareVertices + "usemtl\nf 1 2 3\n", "newmtl\nKd 0.25 0.25 0.25\n");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_THAT(names_of(definitions_of(*reading.scene)), ElementsAre("$$"));
  EXPECT_THAT(materials_of(meshes_of(*reading.scene)[0]), ElementsAre("$$"));
}

TEST(ObjMaterials, ThatEmitMakeTheirFacesLights) {
  const Reading reading =
      read_obj_text(Library + SquareVertices + "usemtl lamp\nf 1 2 3\nusemtl wall\nf 1 3 4\n",
                    "newmtl lamp\nKd 0.5 0.5 0.5\nKe 17 12 4\nnewmtl wall\nKe 0 0 0\n");
  ASSERT_TRUE(reading.scene.has_value());
  const grf::Mesh mesh = meshes_of(*reading.scene)[0];
  EXPECT_EQ(mesh.surface(0).emission, grf::Colour(17, 12, 4));
  EXPECT_EQ(material_of(mesh, 0), "lamp");
  EXPECT_FALSE(mesh.surface(1).emission.has_value());
}

TEST(ObjMaterials, OfALibraryThatIsMissingAreReportedWithItsName) {
  const Reading reading = read_obj_text("mtllib no where.mtl\nmtllib lost.mtl\n" + SquareVertices +
                                        "usemtl gold\nf 1 2 3\nf 1 3 4\n");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), HasSubstr("model.obj:2:1: warning: cannot read '"));
  EXPECT_THAT(reading.text(), HasSubstr("lost.mtl': No such file or directory"));
  EXPECT_THAT(reading.text(), HasSubstr("where.mtl': No such file or directory"));
  EXPECT_THAT(reading.text(),
              HasSubstr("warning: 2 faces are of materials that no library defines ('gold'): BRDF "
                        "diffuse kd=0.5"));
  const std::vector<grf::Definition> definitions = definitions_of(*reading.scene);
  ASSERT_THAT(names_of(definitions), ElementsAre("gold"));
  EXPECT_EQ(brdf_text(definitions[0]), "diffuse kd=0.5");
}

TEST(ObjMaterials, OfAFileWithoutLibrariesAreNamesAlone) {
  const Reading reading = read_obj_text(SquareVertices + "usemtl gold\nf 1 2 3 4\n");
  EXPECT_EQ(reading.diagnostics.warning_count(), 0U);
  EXPECT_THAT(reading.text(), HasSubstr("note: 1 face is of materials that no library defines ('gold')"));
}

TEST(ObjMaterials, ComeFromTheLibraryOfTheModelsNameIfTheirOwnIsMissing) {
  const Reading reading = read_obj_text("mtllib old_name.mtl\n" + SquareVertices + "usemtl m\nf 1 2 3\n",
                                        "newmtl m\nKd 0.75 0.75 0.75\n");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_THAT(reading.text(), HasSubstr("model.obj:1:1: warning: there is no "));
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene).at(0)), "diffuse kd=0.75");
}

TEST(ObjMaterials, ComeFromAllLibrariesAndOnceFromEach) {
  const test::TemporaryFolder folder;
  folder.add("a.mtl", "newmtl a\n");
  folder.add("with space.mtl", "newmtl s\n");
  folder.add("b.mtl", "newmtl b\nnewmtl a\nKd 1 1 1\n");
  const Reading reading =
      read_path(folder.add("model.obj", "mtllib a.mtl b.mtl\nmtllib with space.mtl\nmtllib a.mtl\n" +
                                            SquareVertices + "usemtl a\nf 1 2 3\n"));
  ASSERT_TRUE(reading.scene.has_value());
  const std::vector<grf::Definition> definitions = definitions_of(*reading.scene);
  EXPECT_THAT(names_of(definitions), ElementsAre("a", "b", "s"));
  EXPECT_EQ(brdf_text(definitions[0]), "diffuse kd=0.5");
  EXPECT_THAT(reading.text(), HasSubstr("materials are defined again ('a'): the first definition is used"));
}

TEST(ObjMaterials, TheOptionGivesABrdfToFacesThatHaveNone) {
  grf::Diagnostics diagnostics;
  const ReadOptions options{grf::read_brdf("ward sx=0.15 ks=0.3", "option", diagnostics)};
  const Reading reading =
      read_obj_text(Library + SquareVertices + "f 1 2 3\nusemtl known\nf 1 2 4\nusemtl unknown\nf 1 3 4\n",
                    "newmtl known\nKd 0.25 0.25 0.25\n", options);
  ASSERT_TRUE(reading.scene.has_value());
  const grf::Mesh mesh = meshes_of(*reading.scene)[0];
  EXPECT_EQ(std::get<grf::BrdfModel>(*mesh.surface(0).brdf), *options.brdf);
  const std::vector<grf::Definition> definitions = definitions_of(*reading.scene);
  ASSERT_THAT(names_of(definitions), ElementsAre("known", "unknown"));
  EXPECT_EQ(brdf_text(definitions[0]), "diffuse kd=0.25");
  EXPECT_EQ(std::get<grf::BrdfModel>(definitions[1].body), *options.brdf);
}

TEST(ObjMaterials, LossesAreCountedInFaces) {
  EXPECT_THAT(warnings_of_material("map_Kd -clamp on a.png\n"),
              HasSubstr("2 faces lost an option of their texture"));
  EXPECT_THAT(warnings_of_material("bump a.png\nnorm b.png\n"), HasSubstr("2 faces lost their bump map: "));
  EXPECT_THAT(warnings_of_material("map_Ns a.png\nmap_Ks b.png\n"), HasSubstr("2 faces lost their map of"));
  EXPECT_THAT(warnings_of_material("map_Ns a.png\n"), HasSubstr("2 faces lost their map of"));
  EXPECT_THAT(warnings_of_material("map_Kd a.png\nmap_Pr -s 2 2 b.png\n"),
              HasSubstr("2 faces lost their map of"));
  EXPECT_THAT(warnings_of_material("map_Pr -s 2 2 b.png\nmap_Pm -s 2 2 c.png\n"),
              testing::Not(HasSubstr("map of a parameter")));
  EXPECT_THAT(warnings_of_material("Kd 1 1 1\nKm 0.05\n"), IsEmpty());
}

// The names of the extension, each with what it becomes.
TEST(ObjMaterials, PhysicallyBasedParametersAreKept) {
  const std::string obj = "mtllib model.mtl\nusemtl paint\n" + SquareVertices + "f 1 2 3 4\n";
  const auto brdf_of = [&](const std::string& statements) {
    const Reading reading = read_obj_text(obj, "newmtl paint\n" + statements);
    return brdf_text(definitions_of(*reading.scene).at(0));
  };
  EXPECT_EQ(
      brdf_of("Kd 0.8 0.4 0.2\nPr 0.25\nPm 0.5\nPs 0.125\nPc 1\nPcr 0.0625\naniso 0.75\nanisor 0\nNi 1.25\n"),
      "gltf baseColor=(0.8, 0.4, 0.2) metallic=0.5 roughness=0.25 ior=1.25 anisotropy=0.75 clearcoat=1 "
      "coatRoughness=0.0625 sheenColor=0.125");
  EXPECT_EQ(brdf_of("Kd 1\nPM 1\n"), "gltf metallic=1");
  EXPECT_EQ(brdf_of("Kd 1\nPm 1\naniso 1\nanisor 0.25\n").substr(0, 43),
            "gltf metallic=1 anisotropy=1 rotation=1.570");
  EXPECT_EQ(brdf_of("Kd 1\nPm 1\naniso 1\nanisor 0.75\n").substr(0, 44),
            "gltf metallic=1 anisotropy=1 rotation=-1.570");
  EXPECT_EQ(brdf_of("Kd 1\nPm 1\nNi 0\n"), "gltf metallic=1") << "an index below that of air says nothing";
  EXPECT_EQ(brdf_of("Pr 0.5\nmap_Kd a.png\n"), "gltf");
  EXPECT_EQ(brdf_of("Kd 0.5\nKs 0.25\nNs 40\nNi 1.5\n"), "lewis n=40 ks=0.25 kd=0.5");
}

TEST(ObjMaterials, TransparencyThatIsNoOpacityIsLost) {
  for (const char* statement : {"d -halo 0.5", "map_d a.png", "map_Kd a.png\nmap_d b.png", "illum 4",
                                "illum 6", "illum 7", "illum 9"}) {
    EXPECT_THAT(warnings_of_material(std::string(statement) + "\n"),
                HasSubstr("2 faces lost their transparency"))
        << statement;
  }
  for (const char* statement :
       {"d 0.5", "Tr 0.25", "d 1", "Tr 0", "d 1\nTr 1", "Tr 1\nd 1", "illum 2", "illum 5"}) {
    EXPECT_THAT(warnings_of_material(std::string(statement) + "\n"), Not(HasSubstr("transparency")))
        << statement;
  }
}

TEST(ObjMaterials, ValuesThatAreNoneAreLeftOut) {
  const Reading reading = read_obj_text(Library + SquareVertices + "usemtl m\nf 1 2 3\n",
                                        "newmtl m\nKd 0.1 0.2\nKs spectral x.rfl\nNs\nKd 0.25 0.25 y\n");
  ASSERT_TRUE(reading.scene.has_value());
  EXPECT_EQ(brdf_text(definitions_of(*reading.scene).at(0)), "diffuse kd=0.5");
  EXPECT_THAT(reading.text(), HasSubstr("model.mtl:2:1: warning: 4 values were not read"));
  EXPECT_THAT(reading.text(), HasSubstr("included from "));
}

TEST(ObjMaterials, ValuesOutOfRangeAreClampedWithOneWarning) {
  EXPECT_THAT(warnings_of_material("Kd 1.5 1 -0.5\nKs 2 2 2\nNs 1e7\n"),
              HasSubstr("values of materials are out of range, and were clamped ('m')"));
}

}  // namespace
}  // namespace convert
