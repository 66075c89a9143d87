#include "renderer/options/op_file.h"

#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace {

using options::RenderOptions;

class OpFile : public testing::Test {
 protected:
  std::optional<RenderOptions> read(const std::string& text) {
    diagnostics_ = {};
    return options::read_op_file(folder_.add("test.op", text), diagnostics_);
  }

  /// What is said of a text that is wrong, without the path.
  std::string errors_of(const std::string& text) {
    EXPECT_FALSE(read(text));
    std::string errors = diagnostics_.to_text();
    for (std::size_t at = 0; (at = errors.find(path_)) != std::string::npos;)
      errors.replace(at, path_.size(), "OP");
    return errors;
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.path("test.op");
  grf::Diagnostics diagnostics_;
};

TEST_F(OpFile, SetsEveryOption) {
  const auto read_options = read(
      "# a comment\n"
      "BPT_Scene scene.grf // another\n"
      "\n"
      "bpt_image_resolution 640 480\r\n"
      "BPT Output Image \"my image.png\"\n"
      "Viewer 1 2 -3.5\n"
      "VLook 0 +1 1e-3\n"
      "BPT_Up 0 0 1\n"
      "BPT_FieldOfView 60\n"
      "BPT_Background 0.5 0 2\n"
      "BPT_Depth 0\n"
      "BPT_Samples 7\n"
      "BPT_Seed 4294967295\n"
      "BPT_EM_Background maps/sky.exr\n"
      "BPT_EM_Projection BackPlate\n"
      "BPT_RIS 64 4\n"
      "BPT_Pdf_memstat true\n"
      "BPT_Chrono_Sampling true\n"
      "BPT_Chrono_Rendering True\n"
      "BPT_Chrono_Prebuild true\n"
      "BPT_Threads 3");
  ASSERT_TRUE(read_options) << diagnostics_.to_text();
  EXPECT_EQ(read_options->scene, folder_.path("scene.grf"));
  EXPECT_EQ(read_options->output, folder_.path("my image.png"));
  EXPECT_EQ(read_options->size, (options::ImageSize{640, 480}));
  EXPECT_EQ(read_options->viewer, grf::Vec3f(1, 2, -3.5F));
  EXPECT_EQ(read_options->target, grf::Vec3f(0, 1, 1e-3F));
  EXPECT_EQ(read_options->up, grf::Vec3f(0, 0, 1));
  EXPECT_EQ(read_options->field_of_view, 60);
  EXPECT_EQ(read_options->background, grf::Vec3f(0.5F, 0, 2));
  EXPECT_EQ(read_options->depth, 0);
  EXPECT_EQ(read_options->samples, 7);
  EXPECT_EQ(read_options->seed, 4294967295U);
  EXPECT_EQ(read_options->threads, 3);
  EXPECT_EQ(read_options->environment, folder_.path("maps/sky.exr"));
  EXPECT_EQ(read_options->projection, "backplate");
  EXPECT_EQ(read_options->resampling, (options::IntegerPair{64, 4}));
  EXPECT_TRUE(read_options->writes_memory && read_options->writes_sampling_time &&
              read_options->writes_rendering_time && read_options->writes_prebuild_time);
  EXPECT_EQ(read_options->locations.of("BPT_Viewer").line, 6U);
  EXPECT_FALSE(read_options->locations.of("BPT_Pdf_Name").file);
}

TEST_F(OpFile, HasDefaultsForTheRest) {
  const auto read_options = read("BPT_Scene /scenes/scene.grf");
  ASSERT_TRUE(read_options);
  RenderOptions expected;
  expected.scene = "/scenes/scene.grf";
  EXPECT_EQ(*read_options, expected);
}

TEST_F(OpFile, ReportsAnUnknownKeyWithTheNearestOne) {
  EXPECT_EQ(errors_of("BPT_Scene a.grf\n  BPT_Dept 5\n"),
            "OP:2:3: error: unknown option 'BPT_Dept': did you mean 'BPT_Depth'?\n"
            "    BPT_Dept 5\n"
            "    ^\n");
}

TEST_F(OpFile, ReportsEveryWrongValueAtItsPlace) {
  EXPECT_EQ(errors_of("BPT_Scene a.grf\n"
                      "BPT_Depth -1\n"
                      "BPT_Image_Resolution 640\n"
                      "BPT_FieldOfView 180\n"
                      "BPT_Viewer 1 2 x\n"
                      "BPT_Background 1 1 -1\n"
                      "BPT_Samples 1.5\n"
                      "BPT_Seed 1 2\n"),
            "OP:2:11: error: BPT_Depth: found '-1', expected a whole number from 0 to 2147483647\n"
            "  BPT_Depth -1\n"
            "            ^\n"
            "OP:3:22: error: BPT_Image_Resolution: found 1 value, expected 2 (int int)\n"
            "  BPT_Image_Resolution 640\n"
            "                       ^\n"
            "OP:4:17: error: BPT_FieldOfView: found '180', expected a number between 0 and 180\n"
            "  BPT_FieldOfView 180\n"
            "                  ^\n"
            "OP:5:12: error: BPT_Viewer: found 'x', expected three numbers\n"
            "  BPT_Viewer 1 2 x\n"
            "             ^\n"
            "OP:6:16: error: BPT_Background: found '-1', expected three numbers of 0 or more\n"
            "  BPT_Background 1 1 -1\n"
            "                 ^\n"
            "OP:7:13: error: BPT_Samples: found '1.5', expected a whole number from 1 to 2147483647\n"
            "  BPT_Samples 1.5\n"
            "              ^\n"
            "OP:8:10: error: BPT_Seed: found 2 values, expected 1 (int)\n"
            "  BPT_Seed 1 2\n"
            "           ^\n");
}

TEST_F(OpFile, ReportsWordsBooleansAndPairsThatAreNone) {
  EXPECT_FALSE(
      read("BPT_Scene a.grf\nBPT_Pdf_Name Dsik\nBPT_EM_Projection flat\nBPT_Pdf_memstat 1\n"
           "BPT_RIS 4 8\nBPT_Pdf_CDF_Res 0 8\nBPT_QT_avgnmax 1\n"));
  std::string messages;
  for (const grf::Diagnostic& entry : diagnostics_.entries()) messages += entry.message + "\n";
  EXPECT_EQ(messages,
            "BPT_Pdf_Name: found 'Dsik', expected one of Diffuse, Specular, Hemisphere, Sphere, Anisotropic, "
            "Disk, Adaptive, Factored, CascadeCDF, Reject, Own, Auto: did you mean 'Disk'?\n"
            "BPT_EM_Projection: found 'flat', expected one of latlong, backplate\n"
            "BPT_Pdf_memstat: found '1', expected true or false\n"
            "BPT_RIS: found '4 8', expected two whole numbers from 1 to 65536, the second at most the first\n"
            "BPT_Pdf_CDF_Res: found '0 8', expected two whole numbers from 1 to 65536\n"
            "BPT_QT_avgnmax: found '1', expected a number between 1 and 1000000\n");
}

TEST_F(OpFile, ReportsAKeyGivenTwice) {
  EXPECT_EQ(errors_of("BPT_Scene a.grf\nBPT_Depth 1\nBPT Depth 2\n"),
            "OP:3:1: error: BPT_Depth is given twice, first in line 2\n"
            "  BPT Depth 2\n"
            "  ^\n");
}

TEST_F(OpFile, AsksForAScene) {
  EXPECT_EQ(errors_of("BPT_Depth 1\n"),
            "OP: error: no scene is named, expected a line 'BPT_Scene' and the path of a GRF file\n");
  EXPECT_EQ(errors_of(""), "OP: error: the file is empty, expected options, one a line\n");
}

TEST(OptionTable, KeysAndFlagsAreDistinctAndExplained) {
  for (const options::OptionInfo& option : options::option_table()) {
    EXPECT_EQ(options::find_option(option.key), &option);
    EXPECT_FALSE(option.meaning.empty());
    for (const options::OptionInfo& other : options::option_table()) {
      EXPECT_TRUE(&other == &option || option.flag.empty() || other.flag != option.flag) << option.flag;
    }
  }
}

// The words of the table say what the struct has.
TEST(OptionTable, DefaultsAreThoseOfTheStruct) {
  for (const char* key : {"BPT_Image_Resolution", "BPT_Up", "BPT_FieldOfView", "BPT_Background", "BPT_Depth",
                          "BPT_Samples", "BPT_Seed", "BPT_Threads", "BPT_EM_Background", "BPT_EM_Projection",
                          "BPT_Pdf_memstat", "BPT_Checkpoint", "BPT_DisplayWindow", "BPT_Pdf_Factors_File",
                          "BPT_Chrono_Sampling", "BPT_Chrono_Rendering", "BPT_Chrono_Prebuild"}) {
    const options::OptionInfo& option = *options::find_option(key);
    std::istringstream stream{std::string(option.default_value)};
    const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    RenderOptions render_options;
    EXPECT_EQ(options::set_option(render_options, option, words), std::nullopt) << key;
    EXPECT_EQ(render_options, RenderOptions()) << key;
  }
}

}  // namespace
