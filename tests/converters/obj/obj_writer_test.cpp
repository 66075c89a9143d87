// Tests of the writer of OBJ and MTL.
#include "converters/obj/obj_writer.h"

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/summary.h"
#include "grf/write.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string GrfSquare = "begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs\n";

/// A GRF text written as OBJ in a folder of its own.
class Written {
 public:
  explicit Written(const std::string& grf, const std::string& name = "out.obj") {
    scene = grf::read_text(grf, folder.path("scene.grf"), diagnostics);
    EXPECT_TRUE(scene.has_value()) << diagnostics.to_text();
    path = folder.path(name);
    if (scene) written = write_obj(*scene, path, diagnostics);
    EXPECT_TRUE(written) << diagnostics.to_text();
    if (written) obj = test::bytes_of(path);
    const std::string library = std::filesystem::path(path).replace_extension(".mtl").string();
    if (std::filesystem::exists(library)) mtl = test::bytes_of(library);
  }

  std::optional<grf::Scene> read_again() const {
    const Reading reading = read_path(path);
    EXPECT_TRUE(reading.scene.has_value()) << reading.text();
    return reading.scene;
  }
  std::string messages() const { return diagnostics.to_text(); }

  test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  std::optional<grf::Scene> scene;
  std::string path;
  bool written = false;
  std::string obj;
  std::string mtl;
};

TEST(ObjWriter, WritesOneMeshPlainly) {
  const Written out("begin mesh \"a square\" " + GrfSquare +
                    "begin faces (0,1,2,3) (0,1,2) end faces end mesh");
  EXPECT_EQ(out.obj,
            "# Exported by grfconvert\no a square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3\n");
  EXPECT_THAT(out.mtl, IsEmpty());
  EXPECT_THAT(out.messages(), IsEmpty());
}

TEST(ObjWriter, SharesPositionsNormalsAndTextureCoordinates) {
  const Written out(
      "begin mesh begin vertexs normal (0,0,1) uv (0,1) (0,0,0) normal (0,0,1) uv (0,0) (1,0,0) normal "
      "(1,0,0) "
      "uv (0,1) (0,0,0) normal (0,0,1) uv (0,0) (0,1,0) end vertexs begin faces (0,1,3) (2,1,3) end faces "
      "end mesh");
  EXPECT_THAT(out.obj, HasSubstr("\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvt 0 0\nvn 0 0 1\nvn 1 0 0\n"
                                 "f 1/1/1 2/2/1 3/2/1\nf 1/1/2 2/2/1 3/2/1\n"));
}

TEST(ObjWriter, NumbersGoOnFromMeshToMesh) {
  const std::string mesh = "begin mesh \"m\" " + GrfSquare + "begin faces (0,1,2) end faces end mesh\n";
  const Written out(mesh + "transform translation (0,0,1) begin " + mesh + "end");
  EXPECT_THAT(out.obj, HasSubstr("v 0 1 1\nf 5 6 7\n"));
  EXPECT_EQ(meshes_of(*out.read_again()).size(), 2U);
}

TEST(ObjWriter, AppliesTransformsAndKeepsFrontsOfMirroredMeshes) {
  const Written out(
      "transform scale (-2,1,1) begin begin mesh begin vertexs normal (0,0,1) (0,0,0) normal (0,0,1) "
      "(1,0,0) normal (0,0,1) (1,1,0) end vertexs begin faces (0,1,2) end faces end mesh end");
  EXPECT_THAT(out.obj, HasSubstr("v 0 0 0\nv -2 0 0\nv -2 1 0\n"));
  EXPECT_THAT(out.obj, HasSubstr("f 1//1 3//1 2//1\n"));
  EXPECT_EQ(meshes_of(*out.read_again())[0].geometry->normals[0], grf::Vec3f(0, 0, 1));
}

TEST(ObjWriter, AppliesInstances) {
  const Written out("def box = begin mesh " + GrfSquare +
                    "begin faces (0,1,2,3) end faces end mesh begin\nuse box\n"
                    "transform translation (5,0,0) begin use box end end");
  const auto again = out.read_again();
  EXPECT_EQ(meshes_of(*again).size(), 2U);
  EXPECT_EQ(meshes_of(*again)[1].name, "box");
  EXPECT_EQ(grf::summarize(*again).bounds, grf::summarize(*out.scene).bounds);
}

TEST(ObjWriter, GivesAllVerticesAColourIfOneHasOne) {
  const Written out(
      "begin mesh begin vertexs rgb (0.5,0.25,0) (0,0,0) (1,0,0) (0,1,0) end vertexs "
      "begin faces (0,1,2) end faces end mesh");
  EXPECT_THAT(out.obj, HasSubstr("v 0 0 0 0.5 0.25 0\nv 1 0 0 1 1 1\n"));
}

TEST(ObjWriter, WritesMaterialsByTheNamesOfDefinitions) {
  const Written out(
      "def gold = brdf lewis n=40 ks=0.5 kd=0.25 a$20$b = brdf diffuse kd=(0.1,0.2,0.3)\n"
      "unused = brdf specular ks=0.9\nbegin begin mesh " +
      GrfSquare +
      "begin faces brdf a$20$b (0,1,2) brdf gold (0,2,3) brdf ward sx=0.2 (0,1,3) end faces end mesh end");
  EXPECT_THAT(out.obj, HasSubstr("mtllib out.mtl\n"));
  EXPECT_THAT(out.obj, HasSubstr("usemtl a b\nf 1 2 3\nusemtl gold\nf 1 3 4\nusemtl ward_sx_0.2\nf 1 2 4\n"));
  EXPECT_THAT(out.mtl,
              HasSubstr("newmtl gold\n# grf: lewis n=40 ks=0.5 kd=0.25\nKd 0.25 0.25 0.25\nKs 0.5 0.5 "
                        "0.5\nNs 40\nillum 2\n"));
  EXPECT_THAT(
      out.mtl,
      HasSubstr("newmtl a b\n# grf: diffuse kd=(0.1, 0.2, 0.3)\nKd 0.1 0.2 0.3\nKs 0 0 0\nillum 1\n"));
  EXPECT_THAT(
      out.mtl,
      HasSubstr("newmtl unused\n# grf: specular ks=0.9\nKd 0 0 0\nKs 0.9 0.9 0.9\nNs 1000\nillum 3\n"));
  EXPECT_THAT(out.messages(), HasSubstr("note: 1 face has a BRDF that MTL only approximates"));
  EXPECT_EQ(out.diagnostics.warning_count(), 0U);
}

TEST(ObjWriter, WritesWhatATextMeansAtEachPlaceOfAnIncludedFile) {
  const test::TemporaryFolder folder;
  folder.add("part.grf",
             "begin mesh brdf combine 1 a " + GrfSquare + "begin faces (0,1,2,3) end faces end mesh");
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(
      "def a = brdf diffuse kd=0.1 begin include \"part.grf\" end def a = brdf diffuse kd=0.9 begin include "
      "\"part.grf\" end",
      folder.path("scene.grf"), diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  ASSERT_TRUE(write_obj(*scene, folder.path("out.obj"), diagnostics)) << diagnostics.to_text();
  const std::string mtl = test::bytes_of(folder.path("out.mtl"));
  EXPECT_THAT(mtl, HasSubstr("newmtl combine_1_a\n# grf: combine 1 a\nKd 0.1 0.1 0.1\n"));
  EXPECT_THAT(mtl, HasSubstr("newmtl combine_1_a_2\n# grf: combine 1 a_2\nKd 0.9 0.9 0.9\n"));
  const std::string obj = test::bytes_of(folder.path("out.obj"));
  EXPECT_THAT(obj, HasSubstr("usemtl combine_1_a\nf 1 2 3 4\n"));
  EXPECT_THAT(obj, HasSubstr("usemtl combine_1_a_2\nf 5 6 7 8\n"));
}

TEST(ObjWriter, WritesSumsOfSumsHoweverLongTheirChainIs) {
  std::string text = "def c0 = brdf diffuse kd=0.5";
  for (int i = 1; i < 5000; ++i) text += fmt::format(" c{} = brdf combine 1 c{}", i, i - 1);
  const Written out(text + " begin begin mesh brdf c4999 " + GrfSquare +
                    "begin faces (0,1,2,3) end faces end mesh end");
  EXPECT_THAT(out.mtl, HasSubstr("newmtl c4999\n# grf: combine 1 c4998\nKd 0.5 0.5 0.5\n"));
}

TEST(ObjWriter, TakesExactBrdfsBack) {
  const Written out(
      "def a = brdf ward sx=0.2 sy=0.1 ks=(0.1,0.2,0.3) b = brdf coupled Ro=0.1\n"
      "sum = brdf combine 0.25 a, 0.75 b begin begin mesh " +
      GrfSquare + "begin faces brdf sum (0,1,2) brdf b (0,2,3) end faces end mesh end");
  const auto again = out.read_again();
  EXPECT_EQ(definitions_of(*again), definitions_of(*out.scene));
  EXPECT_EQ(material_of(meshes_of(*again)[0], 0), "sum");
  EXPECT_EQ(material_of(meshes_of(*again)[0], 1), "b");
}

TEST(ObjWriter, KeepsColoursEmissionAndTextures) {
  const Written out("def m = brdf ward sx=0.5 begin begin mesh " + GrfSquare +
                    "begin faces brdf m (0,1,2) rgb (0.5,0.25,1) (0,2,3) texture \"sub/a.png\" rgb none "
                    "(0,1,3) light rgb (5,4,3) texture none (1,2,3) brdf none (0,1,2) light none (0,1,2) end "
                    "faces end mesh end");
  EXPECT_THAT(out.obj,
              HasSubstr("usemtl m\nf 1 2 3\nusemtl m_2\nf 1 3 4\nusemtl m_3\nf 1 2 4\nusemtl m_4\nf 2 3 4\n"
                        "usemtl light\nf 1 2 3\nusemtl default\nf 1 2 3\n"));
  EXPECT_THAT(out.mtl, HasSubstr("# grf rgb: (0.5, 0.25, 1)\n"));
  EXPECT_THAT(out.mtl, HasSubstr("map_Kd sub/a.png\n"));
  EXPECT_THAT(out.mtl, HasSubstr("newmtl light\n# grf: none\nKd 0 0 0\nKs 0 0 0\nillum 1\nKe 5 4 3\n"));
  const auto again = out.read_again();
  const grf::Mesh before = meshes_of(*out.scene)[0];
  const grf::Mesh after = meshes_of(*again)[0];
  for (std::size_t i = 0; i < before.face_count(); ++i) {
    grf::Surface expected = before.surface(i);
    if (expected.brdf) expected.brdf = after.surface(i).brdf;  // its name is another one
    EXPECT_EQ(after.surface(i), expected) << i;
  }
  for (const grf::Definition& definition : definitions_of(*again))
    EXPECT_EQ(brdf_text(definition), "ward sx=0.5");
}

TEST(ObjWriter, FacesWithoutMaterialBeforeAllOthersNeedNone) {
  const Written out("def m = brdf diffuse begin begin mesh " + GrfSquare +
                    "begin faces (0,1,2) brdf m (0,2,3) end faces end mesh end");
  EXPECT_THAT(out.obj, HasSubstr("v 0 1 0\nf 1 2 3\nusemtl m\nf 1 3 4\n"));
  EXPECT_THAT(out.mtl, Not(HasSubstr("default")));
}

TEST(ObjWriter, WritesLightsAsFacesThatEmit) {
  const Written out(
      "light begin rgb (3,2,1) (0,0,0) (1,0,0) (0,1,0) end\n"
      "transform translation (0,0,1) begin mesh light begin rgb (7,7,7) " +
      GrfSquare + "begin faces (0,1,2,3) end faces end end");
  const auto again = out.read_again();
  const std::vector<grf::Mesh> meshes = meshes_of(*again);
  ASSERT_EQ(meshes.size(), 2U);
  EXPECT_EQ(meshes[0].surface(0).emission, grf::Colour(3, 2, 1));
  EXPECT_EQ(meshes[1].surface(0).emission, grf::Colour(7, 7, 7));
  EXPECT_FALSE(meshes[0].surface(0).brdf.has_value());
  EXPECT_EQ(meshes[0].geometry->positions[2], grf::Vec3f(1, 1, 0));
}

TEST(ObjWriter, SaysInOneLineAKindWhatIsLost) {
  const Written out(
      "params begin dependent view (1,2,3) end\nbegin mesh begin vertexs irad (1,1,1) (0,0,0) irad (1,1,1) "
      "normal (0,0,1) (1,0,0) (0,1,0) end vertexs begin faces pdf hemisphere (0,1,2) (0,2,1) end faces "
      "end mesh",
      "out.obj");
  EXPECT_THAT(out.messages(), HasSubstr("2 faces lost their sampling scheme: "));
  EXPECT_THAT(out.messages(), HasSubstr("2 vertices lost their irradiance: "));
  EXPECT_THAT(out.messages(), HasSubstr("2 faces lost the normals of some corners: "));
  EXPECT_THAT(out.messages(), HasSubstr("1 observer was left out: "));
  EXPECT_EQ(out.diagnostics.warning_count(), 4U);
}

TEST(ObjWriter, NamesAreReadBackWhateverTheyHave) {
  for (const std::string name : {"a \\ b # c", "ends with \\", "\u00E6 \u4E00", "# x", "usemtl"}) {
    grf::MeshDraft mesh;
    mesh.name = name;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.add_face(std::vector<std::uint32_t>{0, 1, 2}, 0);
    grf::Scene scene;
    scene.contents.blocks.push_back({grf::Shared<grf::Mesh>(grf::MeshDraft(mesh)), {}, {}});
    const test::TemporaryFolder folder;
    grf::Diagnostics diagnostics;
    ASSERT_TRUE(write_obj(scene, folder.path("x.obj"), diagnostics));
    EXPECT_EQ(meshes_of(*read_path(folder.path("x.obj")).scene)[0].name, name);
  }
}

TEST(ObjWriter, LeavesBothFilesAsTheyWereIfOneCannotBeWritten) {
  const test::TemporaryFolder folder;
  folder.add("out.mtl", "old library");
  folder.add("out.obj/in_the_way", "");  // a folder of the model's name
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text("def m = brdf diffuse begin begin mesh " + GrfSquare +
                                        "begin faces brdf m (0,1,2) end faces end mesh end",
                                    "scene.grf", diagnostics);
  EXPECT_FALSE(write_obj(*scene, folder.path("out.obj"), diagnostics));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("out.obj: error: cannot write the file: it is a directory"));
  EXPECT_EQ(test::bytes_of(folder.path("out.mtl")), "old library");
  EXPECT_THAT(folder.names(), ElementsAre("out.mtl", "out.obj"));
}

TEST(ObjWriter, ATransformBeyondFloatsIsAnError) {
  grf::Diagnostics diagnostics;
  const test::TemporaryFolder folder;
  const auto scene =
      grf::read_text("transform scale (1e30,1,1) begin transform scale (1e30,1,1) begin begin mesh " +
                         GrfSquare + "begin faces (0,1,2) end faces end mesh end end",
                     "scene.grf", diagnostics);
  ASSERT_TRUE(scene.has_value()) << diagnostics.to_text();
  EXPECT_FALSE(write_obj(*scene, folder.path("out.obj"), diagnostics));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("error: a transform moves a vertex out of the range"));
  EXPECT_THAT(folder.names(), IsEmpty());
}

}  // namespace
}  // namespace convert
