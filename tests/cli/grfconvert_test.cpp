// Tests of conversion by `grfconvert`.
#include "tests/cli/grfconvert.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/format.h"
#include "converters/scene_building.h"
#include "grf/read.h"
#include "grf/summary.h"
#include "renderer/options/op_file.h"
#include "tests/support/temporary_folder.h"

namespace {

using test::Bunny;
using test::CubeWithMaterials;
using test::Faces;
using test::FacesWithUv;
using test::grfconvert;
using test::Malformed;
using test::TemporaryFolder;
using test::Triangle;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

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
  auto imported = convert::read(*convert::find_format("obj"), Bunny, {}, diagnostics);
  ASSERT_TRUE(written.has_value()) << diagnostics.to_text();
  ASSERT_TRUE(imported.has_value());
  convert::name_meshes(imported->scene, Bunny);
  EXPECT_TRUE(*written == imported->scene);
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

TEST(Grfconvert, WritesTheCamerasOfAModelAsAnOpFile) {
  const TemporaryFolder folder;
  const std::string model = folder.add("m.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0, 1, 2]}],
    "nodes": [{"mesh": 0}, {"name": "front", "camera": 0, "translation": [0.5, 0.5, 4]},
              {"name": "close", "camera": 0, "translation": [0.5, 0.5, 2]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.01}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  const std::string op = folder.path("out.op");
  const test::Outcome outcome = grfconvert({model, "-o", op, "--unit", "cm", "--up", "z"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("camera")));
  grf::Diagnostics diagnostics;
  const auto view = options::read_op_file(op, diagnostics);
  ASSERT_TRUE(view.has_value()) << diagnostics.to_text();
  EXPECT_EQ(view->scene, folder.path("out.grf"));
  EXPECT_TRUE(grf::read(view->scene, diagnostics).has_value()) << diagnostics.to_text();
  EXPECT_EQ(view->camera, "front");
  ASSERT_EQ(view->cameras.size(), 2U);
  // z up becomes y up: (x, y, z) to (x, z, -y). Centimetres become metres.
  EXPECT_NEAR(view->cameras[0].eye.x, 0.005, 1e-7);
  EXPECT_NEAR(view->cameras[0].eye.y, 0.04, 1e-7);
  EXPECT_NEAR(view->cameras[0].eye.z, -0.005, 1e-7);
  EXPECT_NEAR(view->cameras[0].up.z, -1, 1e-6);
  EXPECT_EQ(view->cameras[1].name, "close");
  EXPECT_NEAR(view->cameras[1].target.y, 0, 1e-7);
  // In a GRF file there is no place for them.
  const test::Outcome lost = grfconvert({model, "-o", folder.path("other.grf")});
  EXPECT_EQ(lost.exit_code, 0);
  EXPECT_THAT(lost.err, HasSubstr("2 cameras were left out"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("other.op")));
  const test::Outcome dry = grfconvert({model, "-o", folder.path("dry.op"), "--dry-run"});
  EXPECT_EQ(dry.exit_code, 0) << dry.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path("dry.op")));
  EXPECT_FALSE(std::filesystem::exists(folder.path("dry.grf")));
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
           {cut, ":5:1: error: the file is truncated in this statement"},
           {bad_brdf, ":1:19: error: 'sx' of 'ward': 100 is out of range"},
           {folder.path("missing.obj"), ": error: cannot read the file: No such file or directory\n"},
           {folder.path(), ": error: cannot read the file: it is a directory"},
           {folder.add("empty.obj", ""), ": error: the file is empty"},
           {folder.add("what.dat", "nothing known"),
            ": error: the format is unknown, by content and by name"},
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
}

TEST(Grfconvert, NeverReplacesItsInputByAnotherFormat) {
  const TemporaryFolder folder;
  const std::string input = folder.add("t.obj", Triangle);
  const test::Outcome outcome = grfconvert({input, "-o", folder.path("./t.obj"), "--to", "grf"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("would be replaced by a file of another format"));
  EXPECT_EQ(test::bytes_of(input), Triangle);
}

TEST(Grfconvert, NamesMeshesAfterTheirFileWhereItDoesNot) {
  const TemporaryFolder folder;
  const auto grf_of = [&](const std::string& name, const std::string& bytes) {
    const std::string output = folder.path("out.grf");
    const test::Outcome outcome = grfconvert({folder.add(name, bytes), "-o", output});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return test::bytes_of(output);
  };
  folder.add("wood.mtl", "newmtl Old oak\nKd 0.4 0.3 0.2\n");
  const std::string obj = grf_of("chair.obj", "mtllib wood.mtl\nusemtl Old oak\n" + Triangle);
  EXPECT_THAT(obj, HasSubstr("begin mesh \"chair\"\n"));
  EXPECT_THAT(obj, HasSubstr("Old$20$oak = brdf diffuse kd=(0.4, 0.3, 0.2)")) << "names of materials stay";
  const std::string ply = grf_of("my chair.ply",
                                 "ply\nformat ascii 1.0\ncomment material 0 oak\nelement vertex 3\n"
                                 "property float x\nproperty float y\nproperty float z\nelement face 1\n"
                                 "property list uchar int vertex_indices\nproperty int material_index\n"
                                 "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0\n");
  EXPECT_THAT(ply, HasSubstr("begin mesh \"my chair\"\n"));
  EXPECT_THAT(ply, HasSubstr("oak = brdf diffuse"));
  EXPECT_THAT(grf_of("stool.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
              HasSubstr("begin mesh \"stool\"\n"));
  EXPECT_THAT(grfconvert({folder.path("stool.off"), "-o", folder.path("out.ply")}).err,
              Not(HasSubstr("name")))
      << "names that were not there cannot be lost";
  const std::string named = grf_of("chair.obj", "o seat\n" + Triangle);
  EXPECT_THAT(named, HasSubstr("begin mesh \"seat\"\n"));
  const std::string models = "/usr/share/assimp/models/";
  for (const auto& [file, material] :
       {std::pair("3DS/fels.3ds", "Default = brdf diffuse kd=0.7843138\n"),
        std::pair("glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", "Texture = brdf gltf roughness=1\n")}) {
    EXPECT_EQ(grfconvert({models + file, "-o", folder.path("out.grf")}).exit_code, 0);
    EXPECT_THAT(test::bytes_of(folder.path("out.grf")), HasSubstr(material)) << file;
  }
}

TEST(Grfconvert, NumbersFurtherMeshesWithoutAName) {
  const TemporaryFolder folder;
  // Two meshes without a name, of which the first is used twice, and one called as the file.
  const std::string text = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
    "nodes": [{"mesh": 0}, {"mesh": 0, "translation": [2, 0, 0]}, {"mesh": 1}, {"mesh": 2, "name": "lamp"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]},
               {"primitives": [{"attributes": {"POSITION": 0}}]},
               {"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
                           "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}";
  const std::string model = folder.add("lamp.gltf", text);
  EXPECT_EQ(grfconvert({model, "-o", folder.path("out.grf")}).exit_code, 0);
  const std::string grf = test::bytes_of(folder.path("out.grf"));
  EXPECT_THAT(grf, HasSubstr("def lamp = begin mesh \"lamp_2\"\n"));
  EXPECT_THAT(grf, HasSubstr("begin mesh \"lamp_3\"\n"));
  EXPECT_THAT(grf, HasSubstr("begin mesh \"lamp\"\n"));
  const std::string plain = folder.add("plain.grf", "begin mesh brdf ward" + Faces);
  EXPECT_EQ(grfconvert({plain, "-o", folder.path("plain.glb")}).exit_code, 0);
  EXPECT_EQ(grfconvert({folder.path("plain.glb"), "-o", folder.path("back.grf")}).exit_code, 0);
  EXPECT_THAT(test::bytes_of(folder.path("back.grf")), StartsWith("begin mesh\n"))
      << "a scene of GRF stays as it is";
}

TEST(Grfconvert, OptionsSayTheFormatsWhateverTheNames) {
  const TemporaryFolder folder;
  const std::string input = folder.add("model.txt", "# nothing that tells\n" + Triangle);
  EXPECT_EQ(grfconvert({input, "--from", "OBJ", "--to", "grf", "-o", folder.path("scene.txt")}).exit_code, 0);
  EXPECT_THAT(test::bytes_of(folder.path("scene.txt")), StartsWith("begin mesh \"model\"\n"));
  EXPECT_THAT(grfconvert({input, "--from", "grf", "-o", folder.path("x.grf")}).err, HasSubstr("error: "));
}

TEST(Grfconvert, BadCommandLinesAreToldFromBadInput) {
  const TemporaryFolder folder;
  const std::string input = folder.add("t.obj", Triangle);
  const std::string output = folder.path("out.grf");
  for (const auto& [arguments, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{}, "no input file is given"},
           {{input}, "no output file is given"},
           {{"-o", output}, "no input file is given"},
           {{input, "-o", folder.path("out.xyz")}, "is unknown: give it by --to (grf"},
           {{input, "-o", output, "--from", "xyz"}, "xyz not in {grf,obj,"},
           {{input, "-o", output, "--to", "xyz"}, "xyz not in {grf,obj,"},
           {{input, "-o", output, "--brdf", "wrad sx=1"},
            "--brdf:1:1: error: unknown BRDF 'wrad': did you mean 'ward'?"},
           {{input, "-o", output, "--brdf", "ward sx="}, "--brdf:1:9: error: "},
           {{input, "-o", output, "--unknown"}, "--unknown"},
           {{input, "-o", output, "--options", folder.path("none.op")}, "--options"},
           {{folder.path("view.op"), "-o", output},
            "an OP file cannot become grf; the formats that take one are gltf, glb, usd, materialx, pbrt, "
            "mitsuba"},
           {{input, input, "-o", folder.path()}, "would both be written to '" + folder.path("t.grf") + "'"},
           {{input, folder.path("b.obj"), "-o", output},
            "several files need an output folder, and '" + output},
           {{input, folder.path("b.obj"), "-o", input}, "several files need an output folder, and '" + input},
           {{input, "-o", folder.path("made/"), "--to", "3ds"},
            "3ds not in {grf,obj,ply,ply-ascii,gltf,glb,usd,materialx,pbrt,mitsuba,stl}"},
           {{input, "-o", output, "--weld", "-1"},
            "--weld: -1 is out of range, expected a length of 0 or more"},
           {{input, "-o", output, "--weld", "x"}, "--weld"},
           {{input, "-o", output, "--decimate", "0"},
            "--decimate: 0 is out of range, expected over 0, up to 1"},
           {{input, "-o", output, "--decimate", "1.5"}, "--decimate: 1.5 is out of range"},
           {{input, "-o", output, "--subdivide", "butterfly"},
            "--subdivide: found 'butterfly', expected loop:LEVELS or catmull-clark:LEVELS, of 1 to 10"},
           {{input, "-o", output, "--subdivide", "loop:0"}, "--subdivide: found 'loop:0', expected"},
           {{input, "-o", output, "--subdivide", "loop:11"}, "--subdivide: found 'loop:11', expected"},
           {{input, "-o", output, "--subdivide", "loop:2x"}, "--subdivide: found 'loop:2x', expected"},
           {{input, "-o", output, "--subdivide", "catmull-clark:"}, "found 'catmull-clark:', expected"},
           {{input, "-o", output, "--smooth", "-1"}, "--smooth"},
           {{input, "-o", output, "--scale", "0"}, "--scale: 0 is out of range, expected over 0"},
           {{input, "-o", output, "--up", "x"}, "--up"},
           {{input, "-o", output, "--normals", "round"}, "expected keep, flat or smooth:ANGLE, of 0 to 180"},
           {{input, "-o", output, "--normals", "smooth"}, "--normals: found 'smooth', expected"},
           {{input, "-o", output, "--normals", "smooth:200"}, "--normals: found 'smooth:200', expected"},
           {{input, "-o", output, "--normals", "smooth:30x"}, "--normals: found 'smooth:30x', expected"},
           {{input, "-o", output, "--transform", "turn 1"}, "--transform: found 'turn', expected scale"},
           {{input, "-o", output, "--jobs", "-1"}, "--jobs"},
           {{input, "-o", output, "--max-time", "-1"}, "--max-time"},
           {{input, "-o", output, "--max-memory", "much"}, "--max-memory"},
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

TEST(GrfconvertRenderers, TakeTheViewOfAnOpFile) {
  const TemporaryFolder folder;
  folder.add("in/scene.grf", "begin mesh" + test::Faces);
  const std::string op = folder.add("in/view.op", "BPT_Scene scene.grf\nBPT_Image_Resolution 72 36\n");
  const std::string other = folder.add("other.op", "BPT_Scene in/scene.grf\nBPT_Image_Resolution 80 40\n");
  const auto text = [&](const std::vector<std::string>& arguments, const std::string& output) {
    const test::Outcome outcome = grfconvert(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return test::bytes_of(output);
  };
  const std::string pbrt = folder.path("a.pbrt");
  EXPECT_THAT(text({op, "-o", pbrt}, pbrt), HasSubstr("\"integer xresolution\" [ 72 ]"));
  EXPECT_THAT(folder.names(), testing::Contains("a_pbrt"));
  const std::string xml = folder.path("a.xml");
  EXPECT_THAT(text({folder.path("in/scene.grf"), "--options", op, "-o", xml}, xml),
              HasSubstr("<integer name=\"width\" value=\"72\"/>"));
  EXPECT_THAT(text({op, "--options", other, "-o", xml}, xml),
              HasSubstr("<integer name=\"width\" value=\"80\"/>"));
  EXPECT_THAT(text({folder.path("in/scene.grf"), "-o", xml}, xml), HasSubstr("value=\"500\"/>"));

  const std::string bad = folder.add("bad.op", "BPT_Depth -1\n");
  const test::Outcome outcome = grfconvert({bad, "-o", folder.path("b.pbrt")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("bad.op:1"));
  const test::Outcome reading = grfconvert({xml, "-o", folder.path("b.grf")});
  EXPECT_EQ(reading.exit_code, 1);
  EXPECT_THAT(reading.err, HasSubstr("mitsuba files are only written, and cannot be read"));
}

TEST(Grfconvert, HelpIsNoError) {
  const test::Outcome outcome = grfconvert({"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("grfconvert IN -o OUT"));
  EXPECT_THAT(outcome.out, HasSubstr("--max-memory"));
  EXPECT_THAT(outcome.out, HasSubstr("formats"));
}

// The thesis uses some of these values, so they are not errors.
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
              HasSubstr(scene + ":1:1: warning: mesh lights have the radiance 1 in the grammar of 2008"));
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

}  // namespace
