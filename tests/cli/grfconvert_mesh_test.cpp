// Tests of the options of `grfconvert` that process meshes and transform the scene.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/grfconvert.h"
#include "tests/support/temporary_folder.h"

namespace {

using nlohmann::json;
using test::Bunny;
using test::grfconvert;
using test::TemporaryFolder;
using test::Triangle;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string Square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

/// Converts an OBJ text with the options and returns the `info` of the result.
json converted(const std::string& obj, std::vector<std::string> options) {
  const TemporaryFolder folder;
  const std::string output = folder.path("out.grf");
  options.insert(options.end(), {folder.add("in.obj", obj), "-o", output, "--brdf", "ward"});
  const test::Outcome outcome = grfconvert(options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return json::parse(grfconvert({"info", "--json", output}).out);
}

TEST(GrfconvertMeshes, AreWelded) {
  const std::string torn = Triangle + "v 1.001 0 0\nv 1 1 0\nv 0 1 0.001\nf 4 5 6\n";
  EXPECT_EQ(converted(torn, {})["boundary_loops"], 2);
  const json welded = converted(torn, {"--weld", "0.01"});
  EXPECT_EQ(welded["vertices"], 4);
  EXPECT_EQ(welded["boundary_loops"], 1);
}

TEST(GrfconvertMeshes, ReportFacesThatWeldingCollapses) {
  const TemporaryFolder folder;
  const test::Outcome outcome = grfconvert({folder.add("in.obj", Square + "v 0 0.001 0\nf 1 2 5\n"), "-o",
                                            folder.path("out.grf"), "--weld", "0.01"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err,
              HasSubstr("in.obj: warning: 1 face was left out: fewer than three distinct corners remain"));
  EXPECT_THAT(outcome.out, HasSubstr("1 mesh, 1 face\n"));
}

TEST(GrfconvertMeshes, AreCutIntoTriangles) {
  EXPECT_EQ(converted(Square, {})["faces"], 1);
  EXPECT_EQ(converted(Square, {"--triangulate"})["faces"], 2);
}

TEST(GrfconvertMeshes, AreDecimated) {
  const TemporaryFolder folder;
  const std::string output = folder.path("bunny.grf");
  const test::Outcome outcome =
      grfconvert({Bunny, "-o", output, "--decimate", "0.1", "--brdf", "ward", "--normals", "smooth:60"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr(" of 69666 triangles are left"));
  const json before = json::parse(grfconvert({"info", "--json", Bunny}).out);
  const json after = json::parse(grfconvert({"info", "--json", output}).out);
  EXPECT_NEAR(after["faces"].get<double>(), 6967, 1);
  EXPECT_NEAR(after["area"].get<double>(), before["area"].get<double>(), 0.01 * before["area"].get<double>());
  EXPECT_EQ(after["boundary_loops"], before["boundary_loops"]);
  EXPECT_EQ(after["nonmanifold_edges"], 0);
}

TEST(GrfconvertMeshes, AreSubdivided) {
  EXPECT_EQ(converted(Square, {"--subdivide", "catmull-clark:3"})["faces"], 64);
  EXPECT_EQ(converted(Square, {"--subdivide", "catmull-clark"})["faces"], 4);
  const json loop = converted(Square, {"--subdivide", "loop:2"});
  EXPECT_EQ(loop["faces"], 32);
  EXPECT_EQ(loop["boundary_edges"], 16);
  const TemporaryFolder folder;
  const test::Outcome outcome = grfconvert({Bunny, "-o", folder.path("out.grf"), "--subdivide", "loop:10"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("bunny.obj: error: a mesh would have 7.31e+10 faces after subdivision"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("out.grf")));
}

TEST(GrfconvertMeshes, AreSmoothed) {
  // Four triangles around a tip, whose neighbours are all on the boundary.
  const std::string tip =
      "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  const double factor = 0.5 * (1 + 1 / 1.9);
  EXPECT_NEAR(converted(tip, {"--smooth", "2"})["bounds"]["max"][2].get<double>(), factor * factor, 1e-6);
  EXPECT_EQ(converted(tip, {"--smooth", "0"})["bounds"]["max"][2], 1);
}

TEST(GrfconvertMeshes, GetNormals) {
  const std::string roof = "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 1\nv 1 2 0\nv 0 2 0\nf 1 2 3 4\nf 4 3 5 6\n";
  EXPECT_EQ(converted(roof, {"--normals", "smooth:91"})["vertices"], 6);
  EXPECT_EQ(converted(roof, {"--normals", "smooth:89"})["vertices"], 8);
  EXPECT_EQ(converted(roof, {"--normals", "keep"})["vertices"], 6);
  const std::string with_normals = Triangle + "vn 0 0 1\nf 1//1 2//1 3//1\n";
  const TemporaryFolder folder;
  const std::string input = folder.add("in.obj", with_normals);
  EXPECT_EQ(grfconvert({input, "-o", folder.path("flat.grf"), "--normals", "flat"}).exit_code, 0);
  EXPECT_THAT(test::bytes_of(folder.path("flat.grf")), Not(HasSubstr("normal")));
}

TEST(GrfconvertMeshes, OfIncludedFilesAreWrittenIntoTheOneFile) {
  const TemporaryFolder folder;
  const std::string part = "begin mesh brdf ward" + test::Faces;
  folder.add("in/part.grf", part);
  folder.add("out/x", "");
  const std::string scene = folder.add("in/scene.grf", "include \"part.grf\"");
  const std::string output = folder.path("out/scene.grf");
  const test::Outcome outcome = grfconvert({scene, "-o", output, "--normals", "smooth:30"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, scene + ": note: meshes are changed: all files are written as one\n");
  EXPECT_THAT(test::bytes_of(output), Not(HasSubstr("include")));
  EXPECT_THAT(test::bytes_of(output), HasSubstr("normal (0, 0, 1)"));
  EXPECT_EQ(test::bytes_of(folder.path("in/part.grf")), part);
}

TEST(GrfconvertScene, IsTurnedScaledAndMovedInThisOrder) {
  const TemporaryFolder folder;
  const std::string output = folder.path("out.grf");
  const std::string input = folder.add("in.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
  EXPECT_EQ(grfconvert({input, "-o", output, "--up", "z", "--scale", "2", "--transform",
                        "rotation 0 0 90 translation 0 0 5", "-q"})
                .exit_code,
            0);
  EXPECT_THAT(test::bytes_of(output),
              HasSubstr("transform rotation (-1.5707964, 0, 0) scale (2, 2, 2) rotation (0, 0, 1.5707964) "
                        "translation (0, 0, 5) begin"));
  // The x axis is mapped to y, and the up axis first to y and then to -x.
  const json bounds = json::parse(grfconvert({"info", "--json", output}).out)["bounds"];
  const std::vector<double> least = {-2, 0, 5};
  const std::vector<double> most = {0, 2, 5};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(bounds["min"][i].get<double>(), least[i], 1e-6);
    EXPECT_NEAR(bounds["max"][i].get<double>(), most[i], 1e-6);
  }
}

TEST(GrfconvertScene, IsScaledFromItsUnitToMetres) {
  const TemporaryFolder folder;
  const std::string input = folder.add("in.obj", "v 0 0 0\nv 1000 0 0\nv 0 1000 0\nf 1 2 3\n");
  const std::string output = folder.path("out.grf");
  // The international inch is 25.4 mm, the foot 12 inches.
  for (const auto& [unit, size] : std::vector<std::pair<std::string, double>>{
           {"mm", 1}, {"cm", 10}, {"inch", 25.4}, {"foot", 304.8}, {"m", 1000}}) {
    ASSERT_EQ(grfconvert({input, "-o", output, "--unit", unit, "-q"}).exit_code, 0);
    const json bounds = json::parse(grfconvert({"info", "--json", output}).out)["bounds"];
    EXPECT_NEAR(bounds["max"][0].get<double>(), size, size * 1e-6) << unit;
  }
  EXPECT_EQ(grfconvert({input, "-o", output, "--unit", "mile"}).exit_code, 2);
}

TEST(GrfconvertScene, KeepsOnlyTheMeshesThatAreNamed) {
  const TemporaryFolder folder;
  const std::string output = folder.path("out.grf");
  const std::string input = folder.add(
      "in.grf",
      "def leg = begin mesh \"leg\"" + test::Faces + " def paint = rgb (1, 0, 0) begin begin mesh \"seat\"" +
          test::Faces +
          " transform translation (1, 0, 0) begin use leg end use leg begin mesh \"back\" rgb paint" +
          test::Faces + " end");
  ASSERT_EQ(grfconvert({input, "-o", output, "-q", "--only", "seat", "--only", "back"}).exit_code, 0);
  std::string kept = test::bytes_of(output);
  EXPECT_THAT(kept, AllOf(HasSubstr("\"seat\""), HasSubstr("\"back\""), HasSubstr("def paint")));
  EXPECT_THAT(kept, AllOf(Not(HasSubstr("leg")), Not(HasSubstr("transform"))));
  ASSERT_EQ(grfconvert({"--only", "leg", input, "-o", output, "-q"}).exit_code, 0);
  kept = test::bytes_of(output);
  EXPECT_THAT(kept, AllOf(HasSubstr("translation"), HasSubstr("use leg"), Not(HasSubstr("seat"))));
  const test::Outcome unknown = grfconvert({input, "-o", output, "--only", "arm"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.err, HasSubstr("error: no mesh is called 'arm'"));
}

TEST(GrfconvertScene, StaysAsItIsWithoutOptions) {
  const TemporaryFolder folder;
  const std::string input = folder.add("in.obj", Triangle);
  EXPECT_EQ(grfconvert({input, "-o", folder.path("a.grf"), "-q"}).exit_code, 0);
  EXPECT_EQ(
      grfconvert({input, "-o", folder.path("b.grf"), "-q", "--up", "y", "--scale", "1", "--normals", "keep"})
          .exit_code,
      0);
  EXPECT_EQ(test::bytes_of(folder.path("a.grf")), test::bytes_of(folder.path("b.grf")));
}

}  // namespace
