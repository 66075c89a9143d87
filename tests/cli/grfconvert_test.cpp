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
using testing::StartsWith;

// Of Debian's packages glmark2-data and assimp-testmodels.
const std::string Bunny = "/usr/share/glmark2/models/bunny.obj";
const std::string CubeWithMaterials = "/usr/share/assimp/models/OBJ/cube_usemtl.obj";
const std::string Malformed = "/usr/share/assimp/models/invalid/malformed.obj";

const std::string Triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

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
