// Tests of the commands of `grfconvert` that do not convert: info, check, tidy and formats.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "converters/format.h"
#include "tests/cli/grfconvert.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::CubeWithMaterials;
using test::Faces;
using test::grfconvert;
using test::Malformed;
using test::TemporaryFolder;
using test::Triangle;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST(GrfconvertInfo, PrintsTheFieldsThatScriptsRelyOn) {
  const test::Outcome outcome = grfconvert({"info", CubeWithMaterials, "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto answer = nlohmann::ordered_json::parse(outcome.out);
  std::vector<std::string> names;
  for (const auto& [name, value] : answer.items()) names.push_back(name);
  EXPECT_THAT(
      names, ElementsAre("format", "meshes", "vertices", "faces", "triangles", "instances", "lights", "brdfs",
                         "pdfs", "textures", "bounds", "area", "boundary_edges", "boundary_loops",
                         "nonmanifold_edges", "nonmanifold_vertices", "different_meshes", "warnings"));
  EXPECT_EQ(answer["format"], "obj");
  EXPECT_EQ(answer["meshes"], 1);
  EXPECT_EQ(answer["vertices"], 24);
  EXPECT_EQ(answer["faces"], 12);
  EXPECT_EQ(answer["triangles"], 12);
  EXPECT_EQ(answer["instances"], 0);
  EXPECT_EQ(answer["lights"], 0);
  EXPECT_EQ(answer["brdfs"], 3);
  EXPECT_EQ(answer["pdfs"], 0);
  EXPECT_EQ(answer["textures"], 0);
  EXPECT_EQ(answer["bounds"], nlohmann::ordered_json::parse(R"({"min": [0, 0, 0], "max": [1, 1, 1]})"));
  EXPECT_EQ(answer["area"], 6.0);
  EXPECT_EQ(answer["boundary_edges"], 0);
  EXPECT_EQ(answer["nonmanifold_edges"], 0);
  EXPECT_EQ(answer["warnings"], 1) << "of the material that the library does not define";
}

TEST(GrfconvertInfo, ReportsHolesAndNonManifoldPartsOfEachMesh) {
  const TemporaryFolder folder;
  const std::string input = folder.add("t.obj",
                                       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\nv 0 -1 0\n"
                                       "o tetrahedron\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
                                       "o tie\nf 1 2 3\nf 1 5 6\n"
                                       "o fins\nf 1 2 3\nf 2 1 4\nf 1 2 6\n");
  const auto answer = nlohmann::json::parse(grfconvert({"info", "--json", input}).out);
  EXPECT_EQ(answer["boundary_loops"], 2 + 1) << "the fins hang together at their edge";
  EXPECT_EQ(answer["nonmanifold_edges"], 1);
  EXPECT_EQ(answer["nonmanifold_vertices"], 1);
  ASSERT_EQ(answer["different_meshes"].size(), 3U);
  EXPECT_EQ(answer["different_meshes"][1], nlohmann::json::parse(R"({"name": "tie", "vertices": 5, "faces": 2,
      "boundary_edges": 6, "boundary_loops": 2, "nonmanifold_edges": 0, "nonmanifold_vertices": 1})"));
  const std::string text = grfconvert({"info", input}).out;
  EXPECT_THAT(text, Not(HasSubstr("'tetrahedron'"))) << "nothing is wrong with it";
  EXPECT_THAT(text, HasSubstr("  mesh 2 'tie'     2 boundary loops, 0 non-manifold edges, 1 non-manifold "
                              "vertex\n"));
}

TEST(GrfconvertInfo, KeepsNumbersAsShortAsTheyAreInTheFile) {
  const TemporaryFolder folder;
  const std::string input = folder.add("t.obj", "v 0.1 0.2 0.3\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THAT(grfconvert({"info", input, "--json"}).out, HasSubstr("0.3\n"));
}

TEST(GrfconvertInfo, AnEmptySceneHasNoBounds) {
  const TemporaryFolder folder;
  const test::Outcome outcome = grfconvert({"info", "--json", folder.add("empty.grf", "// nothing\n")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(nlohmann::json::parse(outcome.out)["bounds"].is_null());
}

TEST(GrfconvertInfo, PrintsATableForPeople) {
  const test::Outcome outcome = grfconvert({"info", CubeWithMaterials});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out,
              StartsWith(CubeWithMaterials + "\n  format             Wavefront OBJ with MTL materials\n"
                                             "  meshes             1\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\n  bounds             (0, 0, 0) to (1, 1, 1)\n"));
  EXPECT_THAT(outcome.out, EndsWith("\n  warnings           1\n"));
}

TEST(GrfconvertInfo, PrintsNothingOfBadInputButTheError) {
  const test::Outcome outcome = grfconvert({"info", "--json", Malformed});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, HasSubstr("error: "));
}

TEST(GrfconvertCheck, GoesOnAfterABadFile) {
  const TemporaryFolder folder;
  const std::string sound = folder.add("t.obj", Triangle);
  const test::Outcome outcome = grfconvert({"check", Malformed, sound});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("malformed.obj:28:3: error: "));
  EXPECT_EQ(outcome.out, sound + ": valid, with warnings\n");
  EXPECT_EQ(grfconvert({"check", sound}).exit_code, 0);
}

TEST(GrfconvertCheck, RanksRisksOnRequest) {
  const TemporaryFolder folder;
  // A lamp inside a tetrahedron with outward fronts, in which a face is written twice.
  const std::string path = folder.add("s.grf", R"(light begin
  (0.2, 0.2, 0.2) (0.05, 0, 0) (0, 0.05, 0)
end
begin mesh "solid"
  brdf diffuse kd=0.5
  begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) (0, 0, 1) end vertexs
  begin faces (0, 2, 1) (0, 1, 3) (0, 3, 2) (1, 2, 3) end faces
end mesh
begin mesh "needle"
  brdf diffuse kd=0.5
  begin vertexs (5, 0, 0) (6, 0, 0) (7, 0, 0) (5, 1, 0) end vertexs
  begin faces (0, 2, 1) (0, 1, 3) end faces
end mesh
)");
  const test::Outcome text = grfconvert({"check", "--deep", path});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out, path +
                          ": valid, with warnings, 2 risks\n"
                          "  1. a lamp is inside the mesh 'solid': it illuminates nothing outside (line 1)\n"
                          "     Move the lamp out, or open the solid.\n"
                          "  2. 1 face of the mesh 'needle' has no area (line 9); the first is face 0\n"
                          "     Delete the faces.\n");
  const test::Outcome listed = grfconvert({"check", "--deep", "--json", path});
  const auto risks = nlohmann::json::parse(listed.out)["files"][0]["risks"];
  ASSERT_EQ(risks.size(), 2U);
  EXPECT_EQ(risks[0]["kind"], "lamp_in_solid");
  EXPECT_EQ(risks[0]["line"], 1);
  EXPECT_EQ(risks[1]["faces"], nlohmann::json::array({0}));
  EXPECT_EQ(risks[1]["share"], 0.5);
  EXPECT_EQ(nlohmann::json::parse(grfconvert({"check", "--json", path}).out)["files"][0].count("risks"), 0U);
}

TEST(GrfconvertCheck, CountsForScripts) {
  const TemporaryFolder folder;
  const std::string sound = folder.add("t.obj", Triangle);
  const test::Outcome outcome = grfconvert({"check", "--json", Malformed, sound});
  EXPECT_EQ(outcome.exit_code, 1);
  const auto files = nlohmann::json::parse(outcome.out)["files"];
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0], nlohmann::json({{"file", Malformed}, {"errors", 1}, {"warnings", 0}}));
  EXPECT_EQ(files[1], nlohmann::json({{"file", sound}, {"errors", 0}, {"warnings", 1}}));
}

TEST(GrfconvertCheck, PrintsWarningsAndStillCallsTheFileSound) {
  const TemporaryFolder folder;
  const std::string path = folder.add("a.grf", "def a = brdf ward\nbegin\nend\n");
  const test::Outcome outcome = grfconvert({"check", path});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, path + ": valid, with warnings\n");
  EXPECT_EQ(outcome.err,
            path + ":1:5: warning: the BRDF 'a' is defined and never used\n  def a = brdf ward\n      ^\n");
  const test::Outcome quiet = grfconvert({"check", "--quiet", path});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_THAT(quiet.out + quiet.err, IsEmpty());
}

TEST(GrfconvertCheck, WarnsOfBrdfsThatReflectMoreThanTheyReceive) {
  const TemporaryFolder folder;
  const auto mesh = [](const std::string& brdf) {
    return "begin mesh brdf " + brdf +
           "\nbegin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs begin faces (0,1,2) end faces end mesh\n";
  };
  const std::string path =
      folder.add("a.grf", mesh("minnaert k=0.8 kd=1") + mesh("diffuse kd=1") + mesh("phong n=100 ks=1 kd=1"));
  const test::Outcome outcome = grfconvert({"check", path});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, path + ": valid, with warnings\n");
  EXPECT_THAT(outcome.err, HasSubstr(":1:17: warning: 'minnaert' reflects up to 1.81 times the light it "
                                     "receives (at 85 degrees)\n"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("'diffuse'")));
  EXPECT_THAT(outcome.err, HasSubstr(":5:17: warning: 'phong' reflects up to 1.06 times the light it "
                                     "receives (at 0 degrees)\n"));
}

TEST(GrfconvertCheck, SaysNothingOfWhatIsRight) {
  const TemporaryFolder folder;
  const std::string path = folder.add("a.grf", "begin mesh brdf ward" + Faces + "\n");
  const test::Outcome outcome = grfconvert({"check", path});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_EQ(outcome.out, path + ": valid\n");
}

TEST(GrfconvertTidy, WritesFilesInTheOneStyleOnce) {
  const TemporaryFolder folder;
  const std::string path = folder.add("a.grf", "// lamp\nlight   begin (0,2,0)(1,0,0)(0,0,1) end // on\n");
  const test::Outcome first = grfconvert({"tidy", path});
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_EQ(first.out, path + ": tidied\n");
  EXPECT_THAT(first.err, IsEmpty());
  const std::string tidy = "// lamp\nlight begin\n  (0, 2, 0)\n  (1, 0, 0)\n  (0, 0, 1)\nend  // on\n";
  EXPECT_EQ(test::bytes_of(path), tidy);
  const test::Outcome second = grfconvert({"tidy", path});
  EXPECT_EQ(second.exit_code, 0);
  EXPECT_EQ(second.out, path + ": already tidy\n");
  EXPECT_EQ(test::bytes_of(path), tidy);
  EXPECT_THAT(folder.names(), ElementsAre("a.grf"));
}

TEST(GrfconvertTidy, GoesOnAfterABadFileAndLeavesThatAlone) {
  const TemporaryFolder folder;
  const std::string bad = folder.add("bad.grf", "light begin end\n");
  const std::string obj = folder.add("t.obj", Triangle);
  const std::string good = folder.add("good.grf", "params   begin end");
  const test::Outcome outcome = grfconvert({"tidy", bad, obj, folder.path("missing.grf"), good});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr(bad + ":1:13: error: "));
  EXPECT_THAT(outcome.err, HasSubstr(obj + ": error: this is obj, expected GRF\n"));
  EXPECT_THAT(outcome.err, HasSubstr(folder.path("missing.grf") + ": error: "));
  EXPECT_EQ(outcome.out, good + ": tidied\n");
  EXPECT_EQ(test::bytes_of(bad), "light begin end\n");
  EXPECT_EQ(test::bytes_of(obj), Triangle);
}

TEST(GrfconvertTidy, KeepsModelsThatNobodyKnows) {
  const TemporaryFolder folder;
  const std::string path = folder.add("a.grf", "def a=brdf ignored_diagnostics of=1 begin end");
  EXPECT_EQ(grfconvert({"tidy", path, "-q"}).exit_code, 0);
  EXPECT_EQ(test::bytes_of(path), "def a = brdf ignored_diagnostics of=1\nbegin\nend\n");
}

TEST(GrfconvertTidy, LeavesIncludedFilesAsTheyAre) {
  const TemporaryFolder folder;
  const std::string part = folder.add("part.grf", "params   begin end");
  const std::string path = folder.add("a.grf", "include   \"part.grf\"");
  EXPECT_EQ(grfconvert({"tidy", path}).out, path + ": tidied\n");
  EXPECT_EQ(test::bytes_of(part), "params   begin end");
}

TEST(GrfconvertTidy, WarnsOfCommentsThatItCannotKeep) {
  const TemporaryFolder folder;
  const std::string path =
      folder.add("a.grf", "begin mesh begin vertexs // one\n(0, 0, 0) // two\n end begin faces end end\n");
  const test::Outcome outcome = grfconvert({"tidy", path});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err,
            path + ": warning: 2 comments inside lists of vertices or faces: the scene does not keep them\n");
}

TEST(GrfconvertTidy, RefusesIrradianceInAFileThatIsNotCalledIgrf) {
  const TemporaryFolder folder;
  const std::string text = "begin mesh begin vertexs irad (1, 1, 1) (0, 0, 0) end begin faces end end";
  const std::string path = folder.add("a.grf", text);
  const test::Outcome outcome = grfconvert({"tidy", path});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr(folder.path("a.igrf")));
  EXPECT_EQ(test::bytes_of(path), text);
  EXPECT_EQ(grfconvert({"tidy", folder.add("b.igrf", text)}).exit_code, 0);
}

TEST(GrfconvertInfo, CountsInstancesAndMeshLights) {
  const TemporaryFolder folder;
  const std::string scene = folder.add(
      "scene.grf",
      "def m = begin mesh brdf ward" + Faces +
          " begin use m transform translation (0, 0, 3) begin use m end\nmesh light begin begin vertexs "
          "(0, 0, 1) (0, 1, 1) (1, 0, 1) end begin faces (0, 1, 2) end end end");
  const test::Outcome outcome = grfconvert({"info", "--json", scene});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto answer = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(answer["meshes"], 2);
  EXPECT_EQ(answer["instances"], 2);
  EXPECT_EQ(answer["lights"], 1);
  EXPECT_EQ(answer["faces"], 3);
  EXPECT_EQ(answer["brdfs"], 1);
  EXPECT_EQ(answer["area"], 1.5);
  EXPECT_EQ(answer["bounds"], nlohmann::json::parse(R"({"min": [0, 0, 0], "max": [1, 1, 3]})"));
  EXPECT_EQ(answer["warnings"], 0);
}

TEST(GrfconvertFormats, ListsThemAll) {
  const test::Outcome outcome = grfconvert({"formats"});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto list = nlohmann::json::parse(grfconvert({"formats", "--json"}).out)["formats"];
  ASSERT_EQ(list.size(), convert::formats().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const convert::Format& format = convert::formats()[i];
    EXPECT_THAT(outcome.out, HasSubstr(std::string(format.title)));
    EXPECT_EQ(list[i]["name"], format.name);
    EXPECT_EQ(list[i]["reads"], format.read != nullptr);
    EXPECT_EQ(list[i]["writes"], format.write != nullptr);
  }
}

}  // namespace
