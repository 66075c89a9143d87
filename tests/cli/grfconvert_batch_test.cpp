// Tests of `grfconvert` with many files, as pipelines and the editor run it.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/grfconvert.h"
#include "tests/support/temporary_folder.h"

namespace {

using nlohmann::json;
using test::Bunny;
using test::CubeWithMaterials;
using test::Faces;
using test::grfconvert;
using test::Malformed;
using test::TemporaryFolder;
using test::Triangle;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(GrfconvertBatch, WritesEachFileIntoTheFolder) {
  const TemporaryFolder folder;
  const std::string a = folder.add("in/a.obj", Triangle);
  const std::string b = folder.add("in/b.c.obj", Triangle + "f 3 2 1\n");
  const std::string c = folder.add("in/c.igrf", "begin mesh brdf ward" + Faces);
  const test::Outcome outcome = grfconvert({a, b, c, "-o", folder.path("out"), "--brdf", "ward"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_EQ(outcome.out, folder.path("out/a.grf") + ": 1 mesh, 1 face\n" + folder.path("out/b.c.grf") +
                             ": 1 mesh, 2 faces\n" + folder.path("out/c.igrf") +
                             ": 1 mesh, 1 face\n3 of 3 files converted\n");
  for (const std::string name : {"out/a.grf", "out/b.c.grf", "out/c.igrf"}) {
    EXPECT_EQ(grfconvert({"check", "-q", folder.path(name)}).exit_code, 0) << name;
  }
}

TEST(GrfconvertBatch, WritesOneFileIntoAFolderThatThereIsOrIsToBe) {
  const TemporaryFolder folder;
  const std::string a = folder.add("in/a.obj", Triangle);
  EXPECT_EQ(grfconvert({a, "-o", folder.path("in"), "-q"}).exit_code, 0);
  EXPECT_EQ(grfconvert({a, "-o", folder.path("new/folder/"), "-q"}).exit_code, 0);
  EXPECT_EQ(test::bytes_of(folder.path("in/a.grf")), test::bytes_of(folder.path("new/folder/a.grf")));
}

TEST(GrfconvertBatch, GoesOnAfterABadFileAndSaysSo) {
  const TemporaryFolder folder;
  const std::string good = folder.add("good.obj", Triangle);
  const std::string missing = folder.path("missing.obj");
  const std::string output = folder.path("out");
  const test::Outcome outcome = grfconvert({Malformed, missing, good, "-o", output});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(Malformed + ":28:3: error: "),
                                 HasSubstr(missing + ": error: cannot read the file")));
  EXPECT_THAT(outcome.out,
              HasSubstr("1 of 3 files converted; failed: '" + Malformed + "', '" + missing + "'\n"));
  EXPECT_TRUE(std::filesystem::exists(output + "/good.grf"));
  EXPECT_FALSE(std::filesystem::exists(output + "/malformed.grf"));
}

TEST(GrfconvertBatch, GivesTheSameFilesWithManyJobs) {
  const TemporaryFolder folder;
  std::vector<std::string> inputs;
  for (int i = 0; i < 12; ++i) {
    const std::string number = std::to_string(i);
    inputs.push_back(
        folder.add("in/" + number + ".obj", "v " + number + " 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n"));
  }
  inputs.push_back(Bunny);
  for (const std::string jobs : {"1", "0", "5"}) {
    auto arguments = inputs;
    arguments.insert(arguments.end(), {"-o", folder.path(jobs), "--jobs", jobs, "-q"});
    EXPECT_EQ(grfconvert(arguments).exit_code, 0);
  }
  for (const std::string name : {"0.grf", "11.grf", "bunny.grf"}) {
    EXPECT_FALSE(test::bytes_of(folder.path("1/" + name)).empty());
    EXPECT_EQ(test::bytes_of(folder.path("1/" + name)), test::bytes_of(folder.path("0/" + name)));
    EXPECT_EQ(test::bytes_of(folder.path("1/" + name)), test::bytes_of(folder.path("5/" + name)));
  }
}

TEST(GrfconvertBatch, DoesNotMixWhatFilesSay) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments;
  for (int i = 0; i < 8; ++i) {
    std::string text = Triangle;
    for (int k = 0; k < 5; ++k) text += "usemtl m" + std::to_string(k) + "\nf 1 2 3\n";
    arguments.push_back(folder.add("in/" + std::to_string(i) + ".obj", text));
  }
  arguments.insert(arguments.end(), {"-o", folder.path("out"), "--jobs", "4"});
  const std::string err = grfconvert(arguments).err;
  std::string last;
  std::vector<std::string> order;
  for (std::size_t at = 0; (at = err.find(folder.path("in/"), at)) != std::string::npos; ++at) {
    const std::string name = err.substr(at, err.find(':', at) - at);
    if (name != last) order.push_back(name);
    last = name;
  }
  EXPECT_EQ(order.size(), 8U) << "each file's lines stand together: " << err;
}

TEST(GrfconvertBatch, ShowsProgressAsLinesWhereThereIsNoTerminal) {
  const TemporaryFolder folder;
  const std::string good = folder.add("good.obj", Triangle);
  const std::string bad = folder.add("bad.obj", "f 1 2 3\n");
  const test::Outcome outcome =
      grfconvert({good, bad, "-o", folder.path("out"), "--progress", "--brdf", "ward"});
  EXPECT_THAT(outcome.err, HasSubstr("[1/2] " + good + ": converted\n"));
  EXPECT_THAT(outcome.err, HasSubstr("[2/2] " + bad + ": failed\n"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("\r")));
}

TEST(GrfconvertBatch, QuietSaysOnlyWhatWentWrong) {
  const TemporaryFolder folder;
  const std::string good = folder.add("good.obj", Triangle);
  const test::Outcome outcome =
      grfconvert({good, folder.path("missing.obj"), "-o", folder.path("out"), "--progress", "-q"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_EQ(outcome.err,
            folder.path("missing.obj") + ": error: cannot read the file: No such file or directory\n");
}

TEST(GrfconvertBatch, ReportsAllAsOneJsonObject) {
  const TemporaryFolder folder;
  const std::string good = folder.add("good.obj", Triangle);
  const std::string missing = folder.path("missing.obj");
  const test::Outcome outcome =
      grfconvert({missing, good, CubeWithMaterials, "-o", folder.path("out"), "--json", "--jobs", "2"});
  EXPECT_EQ(outcome.exit_code, 1);
  const json report = json::parse(outcome.out);
  ASSERT_EQ(report["conversions"].size(), 2U);
  EXPECT_EQ(report["conversions"][0]["input"], good);
  EXPECT_EQ(report["conversions"][1]["output"], folder.path("out/cube_usemtl.grf"));
  EXPECT_EQ(report["failed"], json::array({missing}));
}

TEST(GrfconvertJson, HasWhatTheEditorAsksFor) {
  const TemporaryFolder folder;
  const std::string output = folder.path("out.grf");
  const std::string input = folder.add(
      "in.obj", "mtllib in.mtl\n" + Triangle + "usemtl glass\nf 1 2 3\nf 3 2 1\nusemtl gone\nf 1 2 3\n");
  folder.add("in.mtl", "newmtl glass\nKd 1 1 1\nillum 6\n");
  const test::Outcome outcome = grfconvert({input, "-o", output, "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["input"], input);
  EXPECT_EQ(report["output"], output);
  EXPECT_EQ(report["format"], "grf");
  EXPECT_EQ(report["meshes"], 1);
  EXPECT_EQ(report["faces"], 4);
  EXPECT_GT(report["warnings"].get<int>(), 1);
  EXPECT_EQ(report["losses"], json::array({"2 faces lost their transparency: it is read as opaque"}));
  EXPECT_EQ(report["files"], json::array());
  const test::Outcome failed = grfconvert({Malformed, "-o", output, "--json"});
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.out, IsEmpty());
}

TEST(GrfconvertDryRun, WritesNothing) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.obj", Triangle);
  const std::string b = folder.add("b.obj", Triangle);
  const test::Outcome one = grfconvert({a, "-o", folder.path("a.grf"), "--dry-run"});
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_EQ(one.out, folder.path("a.grf") + ": 1 mesh, 1 face (not written: --dry-run)\n");
  EXPECT_THAT(one.err, HasSubstr("warning: "));
  EXPECT_EQ(grfconvert({a, b, "-o", folder.path("out"), "--dry-run"}).exit_code, 0);
  EXPECT_TRUE(json::parse(grfconvert({a, "-o", folder.path("a.grf"), "--dry-run", "--json"}).out)["output"]
                  .is_null());
  EXPECT_EQ(grfconvert({Malformed, "-o", folder.path("a.grf"), "--dry-run"}).exit_code, 1);
  EXPECT_THAT(folder.names(), ElementsAre("a.obj", "b.obj"));
}

TEST(GrfconvertLimits, EndWhatTakesTooLong) {
  const TemporaryFolder folder;
  const std::string output = folder.path("out.grf");
  const test::Outcome outcome = grfconvert({Bunny, "-o", output, "--max-time", "0.01"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, Bunny + ": error: exceeded the time limit of 0.01 s\n");
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(folder.names(), IsEmpty());
  EXPECT_EQ(grfconvert({"info", Bunny, "--max-time", "0.01"}).exit_code, 1);
  const test::Outcome check = grfconvert({"check", "--json", Bunny, "--max-time", "0.01"});
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_EQ(json::parse(check.out)["files"][0]["errors"], 1);
}

TEST(GrfconvertLimits, EndWhatWantsTooMuchMemory) {
  if (!test::LimitsMemory) GTEST_SKIP();
  const TemporaryFolder folder;
  const std::string good = folder.add("good.obj", Triangle);
  const test::Outcome outcome =
      grfconvert({Bunny, good, "-o", folder.path("out"), "--brdf", "ward", "--max-memory", "25MB"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("1 of 2 files converted; failed: '" + Bunny + "'\n"));
  EXPECT_THAT(std::filesystem::exists(folder.path("out/good.grf")), true);
  EXPECT_THAT(std::filesystem::exists(folder.path("out/bunny.grf")), false);
}

}  // namespace
