// Tests of images that several runs of `bpt render` make in parts.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "renderer/image/image_file.h"
#include "tests/cli/bpt.h"

namespace {

using nlohmann::json;
using test::Outcome;
using test::Quad;
using testing::HasSubstr;

class BptParts : public test::Bpt {
 protected:
  const std::string scene_ = write("scene.grf", Quad);

  Outcome render(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", scene_, "--size", "40x30"});
    return bpt(arguments);
  }

  std::string part(const std::string& number, std::vector<std::string> arguments) const {
    std::string file = number + ".part";
    std::ranges::replace(file, '/', '_');
    arguments.insert(arguments.end(), {"--part", number, "-o", path(file)});
    const Outcome outcome = render(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return path(file);
  }

  std::string bytes(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    EXPECT_TRUE(file) << name;
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

// The layers of an EXR image, too, are those of one process: albedo and the like come from the scene.
TEST_F(BptParts, AddUpToTheImageOfOneProcess) {
  const std::string op =
      write("scene.op",
            "BPT_Scene scene.grf\nBPT_Image_Resolution 40 30\nBPT_Samples 8\nBPT_Exposure 1\n"
            "BPT_Layers all\n");
  ASSERT_EQ(bpt({op, "-o", path("whole.exr"), "-o", path("whole.png")}).exit_code, 0);
  std::vector<std::string> merge = {"merge"};
  for (const char* number : {"3/3", "1/3", "2/3"}) {
    merge.push_back(path(std::string(number).substr(0, 1) + ".part"));
    ASSERT_EQ(bpt({"render", op, "--part", number, "-o", merge.back()}).exit_code, 0);
  }
  merge.insert(merge.end(), {"-o", path("merged.exr"), "-o", path("merged.png"), "--json"});
  const Outcome outcome = bpt(merge);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["samples"], 8);
  EXPECT_EQ(bytes("merged.png"), bytes("whole.png"));
  grf::Diagnostics diagnostics;
  const auto whole = image::read_image_file(path("whole.exr"), diagnostics);
  const auto merged = image::read_image_file(path("merged.exr"), diagnostics);
  ASSERT_TRUE(whole && merged);
  EXPECT_EQ(merged->image.pixels, whole->image.pixels);
  ASSERT_EQ(merged->layers.size(), 6U);
  for (std::size_t i = 0; i < merged->layers.size(); ++i) {
    EXPECT_EQ(merged->layers[i].name, whole->layers[i].name);
    EXPECT_EQ(merged->layers[i].values, whole->layers[i].values) << whole->layers[i].name;
  }
}

// Rendering what `--missing` prints makes the image whole, word by word.
TEST_F(BptParts, ThatLackArePrintedAsFlags) {
  ASSERT_EQ(render({"--samples", "10", "-o", path("whole.pfm")}).exit_code, 0);
  std::vector<std::string> parts = {part("2/4", {"--samples", "10"}), part("4/4", {"--samples", "10"})};
  const Outcome missing = bpt({"merge", parts[0], parts[1], "--missing"});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(missing.out, "--part 1/4\n--part 3/4\n");
  const Outcome incomplete = bpt({"merge", parts[0], parts[1], "-o", path("merged.pfm")});
  EXPECT_EQ(incomplete.exit_code, 1);
  EXPECT_THAT(incomplete.err, HasSubstr("merged.pfm: error: samples of the image lack"));
  EXPECT_FALSE(std::filesystem::exists(path("merged.pfm")));
  std::istringstream lines(missing.out);
  for (std::string flag, value; lines >> flag >> value;) {
    parts.push_back(path("rest" + std::to_string(parts.size()) + ".part"));
    ASSERT_EQ(render({"--samples", "10", flag, value, "-o", parts.back()}).exit_code, 0);
  }
  std::vector<std::string> merge = {"merge", "-o", path("merged.pfm")};
  merge.insert(merge.end(), parts.begin(), parts.end());
  EXPECT_EQ(bpt(merge).exit_code, 0);
  EXPECT_EQ(bytes("merged.pfm"), bytes("whole.pfm"));
  parts.insert(parts.begin(), "merge");
  parts.push_back("--missing");
  const Outcome none = bpt(parts);
  EXPECT_EQ(none.exit_code, 0);
  EXPECT_EQ(none.out, "");
}

TEST_F(BptParts, AreOfRangesOfSamplesAndTiles) {
  const std::string op =
      write("scene.op", "BPT_Scene scene.grf\nBPT_Image_Resolution 40 30\nBPT_Samples 6\n");
  ASSERT_EQ(bpt({op, "-o", path("whole.pfm")}).exit_code, 0);
  const std::vector<std::vector<std::string>> ranges = {{"--samples", "0..2"},
                                                        {"--samples", "3..5", "--tiles", "0..1"},
                                                        {"--samples", "3..5", "--tiles", "2..5"}};
  std::vector<std::string> merge = {"merge", "-o", path("merged.pfm")};
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    merge.push_back(path(std::to_string(i) + ".part"));
    std::vector<std::string> arguments = {"render", op, "-o", merge.back()};
    arguments.insert(arguments.end(), ranges[i].begin(), ranges[i].end());
    ASSERT_EQ(bpt(arguments).exit_code, 0);
  }
  EXPECT_EQ(bpt(merge).exit_code, 0);
  EXPECT_EQ(bytes("merged.pfm"), bytes("whole.pfm"));
}

TEST_F(BptParts, OfAdaptiveImagesBeginWithThePilot) {
  const std::vector<std::string> adaptive = {"--adaptive", "--samples", "48"};
  auto whole = adaptive;
  whole.insert(whole.end(), {"-o", path("whole.pfm")});
  ASSERT_EQ(render(whole).exit_code, 0);
  const std::string first = part("1/2", adaptive);
  const std::string second = part("2/2", adaptive);
  ASSERT_EQ(bpt({"merge", first, second, "-o", path("pilot.part")}).exit_code, 0);
  auto with_half_pilot = adaptive;
  with_half_pilot.insert(with_half_pilot.end(), {"--pilot", first, "--part", "1/3", "-o", path("x.part")});
  EXPECT_THAT(render(with_half_pilot).err, HasSubstr("the pilot has not all tiles: merge all of its parts"));
  auto with_pilot = adaptive;
  with_pilot.insert(with_pilot.end(), {"--pilot", path("pilot.part")});
  const std::vector<std::string> rest = {part("1/3", with_pilot), part("2/3", with_pilot),
                                         part("3/3", with_pilot)};
  const Outcome merged =
      bpt({"merge", rest[2], path("pilot.part"), rest[0], rest[1], "-o", path("merged.pfm"), "--json"});
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(bytes("merged.pfm"), bytes("whole.pfm"));
}

TEST_F(BptParts, ResumeFromACheckpoint) {
  const std::string whole = part("2/3", {"--samples", "3000"});
  const std::string expected = bytes("2_3.part");
  const std::vector<std::string> command = {GRANADA_BIN_DIR "/bpt",
                                            "render",
                                            scene_,
                                            "--size",
                                            "40x30",
                                            "--samples",
                                            "3000",
                                            "--part",
                                            "2/3",
                                            "-o",
                                            path("p.part"),
                                            "--checkpoint",
                                            path("state")};
  // On a loaded machine the first signal may come before there is a sample.
  for (int delay = 100; !std::filesystem::exists(path("state")); delay *= 2) {
    ASSERT_LT(delay, 60'000);
    const Outcome stopped = test::run(command, {}, {{SIGINT, std::chrono::milliseconds(delay)}});
    if (stopped.exit_code == 0) continue;
    EXPECT_FALSE(std::filesystem::exists(path("p.part"))) << "a part has all of its samples";
  }
  const Outcome other =
      render({"--samples", "3000", "--part", "3/3", "-o", path("q.part"), "--checkpoint", path("state")});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err, HasSubstr("it belongs to a render with other options"));
  ASSERT_EQ(test::run(command).exit_code, 0);
  const Outcome same = bpt({"merge", whole, path("p.part"), "-o", path("both.part")});
  EXPECT_EQ(same.exit_code, 0) << "it has the same samples and values: " << same.err;
}

TEST_F(BptParts, OfAnotherTextureAreRefused) {
  const auto texture = [&](float value) {
    std::string bytes = "PF\n1 1\n-1.0\n";
    for (int i = 0; i < 3; ++i) bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    write("texture.pfm", bytes);
  };
  write("scene.grf",
        "begin mesh brdf diffuse kd=0.5 texture \"texture.pfm\"\nbegin vertexs uv (0,0) (0,0,0) uv (1,0) "
        "(1,0,0) "
        "uv (1,1) (1,1,0) end vertexs\nbegin faces (0,1,2) end faces end mesh\n");
  texture(0.5F);
  const std::string first = part("1/2", {"--samples", "4"});
  texture(0.6F);
  const std::string second = part("2/2", {"--samples", "4"});
  const Outcome outcome = bpt({"merge", first, second, "-o", path("merged.pfm")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the scene has other contents"));
}

// The scene is in several folders, with names of each kind: relative, up, absolute.
TEST_F(BptParts, AreOfJobFilesToo) {
  std::filesystem::create_directories(path("scenes/parts"));
  std::filesystem::create_directories(path("textures"));
  const auto image = [](int side) {
    std::string bytes = "PF\n" + std::to_string(side) + " " + std::to_string(side) + "\n-1.0\n";
    for (int i = 0; i < 3 * side * side; ++i) {
      const float value = 0.1F + static_cast<float>(i % 7) / 10;
      bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    return bytes;
  };
  write("textures/up.pfm", image(4));
  write("textures/absolute.pfm", image(5));
  write("textures/sky.pfm", image(8));
  const auto square = [](const std::string& texture, int x) {
    const std::string from = std::to_string(x);
    const std::string to = std::to_string(x + 1);
    return "begin mesh brdf diffuse kd=0.5 texture \"" + texture + "\"\nbegin vertexs uv (0,0) (" + from +
           ",0,0) uv (1,0) (" + to + ",0,0) uv (1,1) (" + to + ",1,0) uv (0,1) (" + from +
           ",1,0) end vertexs\nbegin faces (0,1,2,3) end faces end mesh\n";
  };
  write("scenes/scene.grf", square("../textures/up.pfm", 0) + "include \"parts/part.grf\"\n");
  write("scenes/parts/part.grf", square(path("textures/absolute.pfm"), 1));
  const std::string op = write("scenes/scene.op",
                               "BPT_Scene scene.grf\nBPT_Image_Resolution 40 30\nBPT_Samples 4\n"
                               "BPT_EM_Background ../textures/sky.pfm\nBPT_Output_Image elsewhere.png\n");
  ASSERT_EQ(bpt({op, "-o", path("whole.pfm")}).exit_code, 0);
  const Outcome packed = bpt({"pack", op, "-o", path("a.grfjob"), "--json"});
  ASSERT_EQ(packed.exit_code, 0) << packed.err;
  ASSERT_EQ(bpt({"pack", op, "-o", path("b.grfjob")}).exit_code, 0);
  EXPECT_EQ(bytes("a.grfjob"), bytes("b.grfjob"));
  std::filesystem::remove_all(path("scenes"));
  std::filesystem::remove_all(path("textures"));
  std::vector<std::string> merge = {"merge", "-o", path("merged.pfm")};
  for (const char* number : {"1", "2"}) {
    merge.push_back(path(std::string(number) + ".part"));
    const Outcome outcome = bpt({"render", path(std::string(*number == '1' ? "a" : "b") + ".grfjob"),
                                 "--part", std::string(number) + "/2", "-o", merge.back()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  EXPECT_EQ(bpt(merge).exit_code, 0);
  EXPECT_EQ(bytes("merged.pfm"), bytes("whole.pfm"));
  ASSERT_EQ(bpt({"render", path("a.grfjob"), "--samples", "2"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("a.exr")))
      << "beside the job file, and not where the OP file says";
}

TEST_F(BptParts, OfAPackedSceneTakeItsFlags) {
  ASSERT_EQ(render({"--samples", "3", "--depth", "1", "-o", path("whole.pfm")}).exit_code, 0);
  ASSERT_EQ(bpt({"pack", scene_, "--samples", "3", "--depth", "1", "--size", "40x30", "-o", path("a.grfjob")})
                .exit_code,
            0);
  ASSERT_EQ(bpt({"render", path("a.grfjob"), "-o", path("job.pfm")}).exit_code, 0);
  EXPECT_EQ(bytes("job.pfm"), bytes("whole.pfm"));
  EXPECT_EQ(bpt({"pack", scene_, "-o", path("a.tar")}).exit_code, 2);
}

TEST_F(BptParts, AreRefusedWhereTheirFlagsAreWrong) {
  const std::string file = path("x.part");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--part", "0/3", "-o", file},
       "--part: expected a number from 1 and the number of parts, such as 3/40"},
      {{"--part", "4/3", "-o", file}, "--part: expected"},
      {{"--part", "1", "-o", file}, "--part: expected"},
      {{"--part", "1/3x", "-o", file}, "--part: expected"},
      {{"--samples", "5..2", "-o", file},
       "--samples: expected the first and the last sample, such as 128..255"},
      {{"--tiles", "1-2", "-o", file}, "--tiles: expected the first and the last tile, such as 0..99"},
      {{"--part", "1/3", "-o", path("x.png")}, "written to one file, whose name ends in .part"},
      {{"-o", file}, "written to one file, whose name ends in .part"}};
  for (const auto& [arguments, message] : cases) {
    const Outcome outcome = render(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(file));
  }
  const Outcome until_error = render({"--part", "1/3", "--target-error", "0.1", "-o", file});
  EXPECT_EQ(until_error.exit_code, 1);
  EXPECT_THAT(until_error.err, HasSubstr("a part of an image has a number of samples and no target error"));
  const Outcome no_pilot = render({"--part", "1/3", "--pilot", "p.part", "-o", file});
  EXPECT_THAT(no_pilot.err, HasSubstr("p.part: error: only parts of an adaptive image have a pilot"));
  EXPECT_EQ(bpt({"merge", file}).exit_code, 2) << "neither --missing nor an output";
  const Outcome absent = bpt({"merge", file, "-o", path("x.png")});
  EXPECT_EQ(absent.exit_code, 1);
  EXPECT_THAT(absent.err, HasSubstr("x.part: error: cannot read the file"));
}

}  // namespace
