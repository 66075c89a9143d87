#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "converters/format.h"
#include "grf/read.h"
#include "grf/summary.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

// Of Debian's packages glmark2-data and assimp-testmodels.
const std::string Bunny = "/usr/share/glmark2/models/bunny.obj";
const std::string CubeWithMaterials = "/usr/share/assimp/models/OBJ/cube_usemtl.obj";
const std::string Malformed = "/usr/share/assimp/models/invalid/malformed.obj";

const std::string Triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

// What stands in a mesh behind its attributes, up to its end.
const std::string Faces =
    " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin faces (0, 1, 2) end faces end mesh";
const std::string FacesWithUv =
    " begin vertexs uv (0, 0) (0, 0, 0) uv (1, 0) (1, 0, 0) uv (0, 1) (0, 1, 0) end vertexs begin faces (0, "
    "1, 2) end faces "
    "end mesh";

test::Outcome grfconvert(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), GRANADA_BIN_DIR "/grfconvert");
  return test::run(arguments);
}

TEST(Grfconvert, ConvertsARealModelAndLosesNothingOnTheWay) {
  const TemporaryFolder folder;
  const std::string output = folder.path("bunny.grf");
  const test::Outcome outcome = grfconvert({Bunny, "-o", output});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, output + ": 1 mesh, 69666 faces\n");
  EXPECT_EQ(outcome.err, Bunny + ": warning: faces without a BRDF: they are diffuse with kd=0.5\n");
  EXPECT_THAT(folder.names(), ElementsAre("bunny.grf"));

  grf::Diagnostics diagnostics;
  const auto written = grf::read(output, diagnostics);
  const auto imported = convert::read(*convert::find_format("obj"), Bunny, {}, diagnostics);
  ASSERT_TRUE(written.has_value()) << diagnostics.to_text();
  EXPECT_TRUE(written == imported);
  const grf::Summary summary = grf::summarize(*written);
  EXPECT_EQ(summary.vertices, 34835U);
  EXPECT_EQ(summary.faces, 69666U);
}

TEST(Grfconvert, WritesTheSameBytesAgain) {
  const TemporaryFolder folder;
  EXPECT_EQ(grfconvert({CubeWithMaterials, "-o", folder.path("a.grf")}).exit_code, 0);
  EXPECT_EQ(grfconvert({folder.path("a.grf"), "-o", folder.path("b.grf")}).exit_code, 0);
  EXPECT_EQ(grfconvert({folder.path("b.grf"), "-o", folder.path("b.grf")}).exit_code, 0) << "in its place";
  EXPECT_EQ(test::bytes_of(folder.path("a.grf")), test::bytes_of(folder.path("b.grf")));
}

TEST(Grfconvert, GivesFacesWithoutAMaterialTheBrdfOfTheOption) {
  const TemporaryFolder folder;
  const std::string output = folder.path("out.grf");
  const test::Outcome outcome =
      grfconvert({folder.add("t.obj", Triangle), "-o", output, "--brdf", "ward sx=0.15 ks=0.3"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(test::bytes_of(output), HasSubstr("brdf ward sx=0.15 ks=0.3\n"));
}

TEST(Grfconvert, QuietPrintsErrorsAlone) {
  const TemporaryFolder folder;
  const test::Outcome sound =
      grfconvert({"--quiet", folder.add("t.obj", Triangle), "-o", folder.path("out.grf")});
  EXPECT_EQ(sound.exit_code, 0);
  EXPECT_THAT(sound.out + sound.err, IsEmpty());
  const test::Outcome broken = grfconvert({"-q", Malformed, "-o", folder.path("out.grf")});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_THAT(broken.err, StartsWith(Malformed + ":28:3: error: "));
}

TEST(Grfconvert, BadInputWritesNothing) {
  const TemporaryFolder folder;
  const std::string cut = folder.add("cut.obj", Triangle + "f 1 2");
  const std::string bad_brdf = folder.add("bad.grf", "def a = brdf ward sx=100\nbegin end\n");
  for (const auto& [input, message] : std::vector<std::pair<std::string, std::string>>{
           {Malformed, ":28:3: error: found '0', expected a corner"},
           {cut, ":5:1: error: the file was cut off inside this statement"},
           {bad_brdf, ":1:19: error: 'sx' of 'ward': 100 is out of range"},
           {folder.path("missing.obj"), ": error: cannot read the file: No such file or directory\n"},
           {folder.path(), ": error: cannot read the file: it is a directory"},
           {folder.add("empty.obj", ""), ": error: the file is empty"},
           {folder.add("what.dat", "nothing known"),
            ": error: neither content nor name are those of a known format"},
       }) {
    const test::Outcome outcome = grfconvert({input, "-o", folder.path("out.grf")});
    EXPECT_EQ(outcome.exit_code, 1) << input;
    EXPECT_THAT(outcome.err, HasSubstr(input + message));
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(folder.names(), Not(testing::Contains(StartsWith("out")))) << input;
  }
}

TEST(Grfconvert, BadInputLeavesAnOlderOutputAsItWas) {
  const TemporaryFolder folder;
  const std::string output = folder.add("out.grf", "// older\n");
  EXPECT_EQ(grfconvert({Malformed, "-o", output}).exit_code, 1);
  EXPECT_EQ(test::bytes_of(output), "// older\n");
}

TEST(Grfconvert, SaysWhyAFileCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string input = folder.add("t.obj", Triangle);
  const std::string nowhere = folder.path("no/such/folder/out.grf");
  const test::Outcome outcome = grfconvert({input, "-o", nowhere, "-q"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, nowhere + ": error: cannot create the file: No such file or directory\n");
  EXPECT_EQ(grfconvert({input, "-o", folder.path(), "--to", "grf"}).exit_code, 1) << "a folder";
}

TEST(Grfconvert, NeverReplacesItsInputByAnotherFormat) {
  const TemporaryFolder folder;
  const std::string input = folder.add("t.obj", Triangle);
  const test::Outcome outcome = grfconvert({input, "-o", folder.path("./t.obj"), "--to", "grf"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("would be replaced by a file of another format"));
  EXPECT_EQ(test::bytes_of(input), Triangle);
}

TEST(Grfconvert, OptionsSayTheFormatsWhateverTheNames) {
  const TemporaryFolder folder;
  const std::string input = folder.add("model.txt", "# nothing that tells\n" + Triangle);
  EXPECT_EQ(grfconvert({input, "--from", "OBJ", "--to", "grf", "-o", folder.path("scene.txt")}).exit_code, 0);
  EXPECT_THAT(test::bytes_of(folder.path("scene.txt")), StartsWith("begin mesh\n"));
  EXPECT_THAT(grfconvert({input, "--from", "grf", "-o", folder.path("x.grf")}).err, HasSubstr("error: "));
}

TEST(Grfconvert, BadCommandLinesAreToldFromBadInput) {
  const TemporaryFolder folder;
  const std::string input = folder.add("t.obj", Triangle);
  const std::string output = folder.path("out.grf");
  for (const auto& [arguments, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{}, "the file to read is missing"},
           {{input}, "the file to write is missing"},
           {{"-o", output}, "the file to read is missing"},
           {{input, "-o", folder.path("out.obj")}, "obj files are not written; what is: grf"},
           {{input, "-o", folder.path("out.xyz")}, "does not say its format: give it by --to (grf)"},
           {{input, "-o", output, "--from", "xyz"}, "xyz not in {grf,obj}"},
           {{input, "-o", output, "--to", "xyz"}, "xyz not in {grf,obj}"},
           {{input, "-o", output, "--brdf", "wrad sx=1"},
            "--brdf:1:1: error: unknown BRDF 'wrad': did you mean 'ward'?"},
           {{input, "-o", output, "--brdf", "ward sx="}, "--brdf:1:9: error: "},
           {{input, "-o", output, "--unknown"}, "--unknown"},
           {{input, input, "-o", output}, "not expected"},
           {{"info"}, "FILE is required"},
           {{"check"}, "FILE is required"},
           {{"tidy"}, "FILE is required"},
       }) {
    const test::Outcome outcome = grfconvert(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << message;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_THAT(outcome.out, IsEmpty());
  }
  EXPECT_THAT(folder.names(), ElementsAre("t.obj"));
}

TEST(Grfconvert, HelpIsNoError) {
  const test::Outcome outcome = grfconvert({"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("grfconvert IN -o OUT"));
  EXPECT_THAT(outcome.out, HasSubstr("formats"));
}

TEST(GrfconvertInfo, PrintsTheFieldsThatScriptsRelyOn) {
  const test::Outcome outcome = grfconvert({"info", CubeWithMaterials, "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto json = nlohmann::ordered_json::parse(outcome.out);
  std::vector<std::string> names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  EXPECT_THAT(names, ElementsAre("format", "meshes", "vertices", "faces", "triangles", "instances", "lights",
                                 "brdfs", "pdfs", "textures", "bounds", "area", "boundary_edges",
                                 "nonmanifold_edges", "warnings"));
  EXPECT_EQ(json["format"], "obj");
  EXPECT_EQ(json["meshes"], 1);
  EXPECT_EQ(json["vertices"], 24);
  EXPECT_EQ(json["faces"], 12);
  EXPECT_EQ(json["triangles"], 12);
  EXPECT_EQ(json["instances"], 0);
  EXPECT_EQ(json["lights"], 0);
  EXPECT_EQ(json["brdfs"], 3);
  EXPECT_EQ(json["pdfs"], 0);
  EXPECT_EQ(json["textures"], 0);
  EXPECT_EQ(json["bounds"], nlohmann::ordered_json::parse(R"({"min": [0, 0, 0], "max": [1, 1, 1]})"));
  EXPECT_EQ(json["area"], 6.0);
  EXPECT_EQ(json["boundary_edges"], 0);
  EXPECT_EQ(json["nonmanifold_edges"], 0);
  EXPECT_EQ(json["warnings"], 1) << "of the material that the library does not define";
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
  EXPECT_EQ(outcome.out, sound + ": sound, with warnings\n");
  EXPECT_EQ(grfconvert({"check", sound}).exit_code, 0);
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
  EXPECT_EQ(outcome.out, path + ": sound, with warnings\n");
  EXPECT_EQ(outcome.err,
            path + ":1:5: warning: the BRDF 'a' is defined and never used\n  def a = brdf ward\n      ^\n");
  const test::Outcome quiet = grfconvert({"check", "--quiet", path});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_THAT(quiet.out + quiet.err, IsEmpty());
}

// The thesis measures with some of these: they are no errors.
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
  EXPECT_EQ(outcome.out, path + ": sound, with warnings\n");
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
  EXPECT_EQ(outcome.out, path + ": sound\n");
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
  EXPECT_EQ(second.out, path + ": was tidy\n");
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
  const std::string path = folder.add("a.grf", "def a=brdf unheard of=1 begin end");
  EXPECT_EQ(grfconvert({"tidy", path, "-q"}).exit_code, 0);
  EXPECT_EQ(test::bytes_of(path), "def a = brdf unheard of=1\nbegin\nend\n");
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

TEST(GrfconvertFlatten, WritesOneFile) {
  const TemporaryFolder folder;
  folder.add("parts/gold.brdf", "ward sx=0.1");
  folder.add("parts/wood.png", "an image");
  const std::string part = "begin mesh brdf \"gold.brdf\" texture \"wood.png\"" + FacesWithUv;
  folder.add("parts/part.grf", part);
  const std::string scene = folder.add("scene.grf", "include \"parts/part.grf\" // here\n");
  const std::string output = folder.path("out.grf");
  const test::Outcome outcome = grfconvert({scene, "-o", output, "--flatten"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_EQ(outcome.out, output + ": 1 mesh, 1 face\n");
  EXPECT_THAT(test::bytes_of(output),
              StartsWith("// here\nbegin mesh\n  brdf ward sx=0.1\n  texture \"parts/wood.png\"\n"));
  EXPECT_EQ(test::bytes_of(folder.path("parts/part.grf")), part);
  EXPECT_EQ(grfconvert({"check", output}).err, "");
}

TEST(GrfconvertFlatten, NamesFilesFromTheFolderOfTheOutput) {
  const TemporaryFolder folder;
  folder.add("in/parts/wood.png", "an image");
  folder.add("in/parts/part.grf", "begin mesh brdf ward texture \"wood.png\"" + FacesWithUv);
  folder.add("out/x", "");
  const std::string scene = folder.add("in/scene.grf", "include \"parts/part.grf\"");
  EXPECT_EQ(grfconvert({scene, "-o", folder.path("out/scene.grf"), "--flatten"}).exit_code, 0);
  EXPECT_THAT(test::bytes_of(folder.path("out/scene.grf")), HasSubstr("texture \"../in/parts/wood.png\"\n"));
  EXPECT_EQ(grfconvert({"check", folder.path("out/scene.grf")}).err, "");
}

TEST(Grfconvert, KeepsTexturesAndIncludesFoundInAnotherFolder) {
  const TemporaryFolder folder;
  folder.add("in/wood.png", "an image");
  folder.add("in/gold.brdf", "ward");
  const std::string part = "begin mesh brdf \"gold.brdf\" texture \"wood.png\"" + FacesWithUv;
  folder.add("in/part.grf", part);
  folder.add("out/x", "");
  const std::string scene = folder.add("in/scene.grf", "include \"part.grf\" " + part);
  const std::string output = folder.path("out/scene.grf");
  const test::Outcome outcome = grfconvert({scene, "-o", output});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, IsEmpty()) << "no other file is written";
  EXPECT_THAT(test::bytes_of(output), HasSubstr("include \"../in/part.grf\"\n"));
  EXPECT_EQ(grfconvert({"check", output}).err, "");
  EXPECT_EQ(test::bytes_of(folder.path("in/part.grf")), part);
}

TEST(Grfconvert, WritesIrradianceOnlyIntoIgrfFiles) {
  const TemporaryFolder folder;
  const std::string scene =
      folder.add("scene.igrf",
                 "begin mesh brdf ward begin vertexs irad (1, 1, 1) (0, 0, 0) end begin faces end end "
                 "params begin dependent view (0, 0, 5) end");
  const test::Outcome outcome = grfconvert({scene, "-o", folder.path("out.grf")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err,
              HasSubstr("expected the name of an IGRF file, such as '" + folder.path("out.igrf") + "'"));
  EXPECT_THAT(folder.names(), ElementsAre("scene.igrf"));
  EXPECT_EQ(grfconvert({scene, "-o", folder.path("out.igrf")}).err, "");
  EXPECT_THAT(folder.names(), ElementsAre("out.igrf", "scene.igrf"));
}

TEST(Grfconvert2008, WritesNoExtensions) {
  const TemporaryFolder folder;
  const std::string scene = folder.add("scene.grf", "begin mesh \"lamp\" light rgb (5, 5, 5)" + Faces +
                                                        "\nbegin mesh brdf ward" + FacesWithUv + "\n");
  const std::string output = folder.path("out.grf");
  const test::Outcome outcome = grfconvert({scene, "-o", output, "--grf2008"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err,
              HasSubstr(scene + ":1:1: warning: a mesh light of the grammar of 2008 has the radiance 1"));
  EXPECT_THAT(test::bytes_of(output), StartsWith("// lamp\nmesh light begin\n"));
}

TEST(Grfconvert2008, RefusesParametersOfThreeNumbers) {
  const TemporaryFolder folder;
  const std::string scene = folder.add("scene.grf", "begin mesh brdf diffuse kd=(1, 0, 0)" + Faces);
  const test::Outcome outcome = grfconvert({scene, "-o", folder.path("out.grf"), "--grf2008"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr(scene + ":1:25: error: 'kd' has three numbers"));
  EXPECT_THAT(folder.names(), ElementsAre("scene.grf"));
}

TEST(Grfconvert2008, WritesFilesAsOneWhereOneWouldHaveToChangeAndLeavesItAlone) {
  const TemporaryFolder folder;
  folder.add("in/wood.png", "an image");
  const std::string part = "begin mesh \"a\" brdf ward texture \"wood.png\"" + FacesWithUv;
  folder.add("in/part.grf", part);
  folder.add("out/x", "");
  const std::string scene = folder.add("in/scene.grf", "include \"part.grf\"");
  const std::string output = folder.path("out/scene.grf");
  const test::Outcome outcome = grfconvert({scene, "-o", output, "--grf2008"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("all files are written as one\n"));
  EXPECT_THAT(test::bytes_of(output),
              StartsWith("// a\nbegin mesh\n  brdf ward\n  texture \"../in/wood.png\"\n"));
  EXPECT_EQ(test::bytes_of(folder.path("in/part.grf")), part);
  EXPECT_EQ(grfconvert({"check", output}).err, "");
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
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["meshes"], 2);
  EXPECT_EQ(json["instances"], 2);
  EXPECT_EQ(json["lights"], 1);
  EXPECT_EQ(json["faces"], 3);
  EXPECT_EQ(json["brdfs"], 1);
  EXPECT_EQ(json["area"], 1.5);
  EXPECT_EQ(json["bounds"], nlohmann::json::parse(R"({"min": [0, 0, 0], "max": [1, 1, 3]})"));
  EXPECT_EQ(json["warnings"], 0);
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
