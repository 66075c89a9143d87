#include "renderer/options/op_file.h"

#include <filesystem>

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

  /// Returns the error messages of an invalid text, without the path.
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
  EXPECT_EQ(read_options->eye, grf::Vec3f(1, 2, -3.5F));
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
            "OP:6:16: error: BPT_Background: found '-1', expected three numbers, each 0 or more\n"
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
            "BPT_RIS: found '4 8', expected two whole numbers from 1 to 65536, the second no greater than "
            "the first\n"
            "BPT_Pdf_CDF_Res: found '0 8', expected two whole numbers from 1 to 4096\n"
            "BPT_QT_avgnmax: found '1', expected a number between 1 and 100\n");
}

TEST_F(OpFile, ReportsAKeyGivenTwice) {
  EXPECT_EQ(errors_of("BPT_Scene a.grf\nBPT_Depth 1\nBPT Depth 2\n"),
            "OP:3:1: error: BPT_Depth is given twice, first on line 2\n"
            "  BPT Depth 2\n"
            "  ^\n");
}

TEST_F(OpFile, AsksForAScene) {
  EXPECT_EQ(errors_of("BPT_Depth 1\n"),
            "OP: error: no scene is given, expected a line 'BPT_Scene' with the path of a GRF file\n");
  EXPECT_EQ(errors_of(""), "OP: error: the file is empty, expected options, one per line\n");
}

TEST_F(OpFile, TakesTheOpFileOfTheThesis) {
  // Table 6.1 of the thesis, whose keys lost their underscores in print.
  const auto read_options = read(
      "BPT Scene escena.grf\nBPT Image Resolution 500 400\nBPT Output Image buzon.exr\n"
      "BPT Viewer 0.5 0.5 1\nBPT VLook 0.5 0.1 0\nBPT Pixel Radial false\nBPT Pixel Random true\n"
      "BPT Background 1 1 1\nBPT Pixel SampleRes 1 2\nBPT RE NSecRaysRoot 100\nBPT Depth 5\n"
      "BPT Pdf Name Disk\nBPT Pdf LobeExponent 30\nBPT Pdf AnisoNu 25\nBPT Pdf AnisoNv 25\n"
      "BPT Pdf memstat true\nBPT QT Precomputed 90\nBPT QT Anisotropic 1\nBPT QT ImgRes 800\n"
      "BPT QT avgnmax 1.7\nBPT RayCasting false\nBPT DisplayWindow false\nBPT Chrono Sampling true\n"
      "BPT Chrono Rendering false\nBPT Chrono Prebuild false\n");
  ASSERT_TRUE(read_options) << diagnostics_.to_text();
  EXPECT_EQ(read_options->pixel_samples, (options::IntegerPair{1, 2}));
  EXPECT_EQ(read_options->secondary_rays_root, 100);
  EXPECT_EQ(read_options->samples_per_pixel(), 20000) << "about what it cost then";
  EXPECT_FALSE(read_options->pixel_radial || read_options->ray_casting || read_options->shows_window);
  EXPECT_TRUE(read_options->pixel_random);
}

TEST_F(OpFile, SetsHowARenderGoesOn) {
  const auto read_options = read(
      "Scene a.grf\nIntegrator NAIVE\nPixel_Radial true\nPixel_Random false\nRayCasting true\n"
      "BPT_DisplayWindow true\nDisplayServer [::1]:14158\nTargetError 0.02\nMaxTime 1.5\n"
      "Checkpoint keep/it.bin\nExposure -2.5\nIrradiance true\nLayers Variance,albedo\n");
  ASSERT_TRUE(read_options) << diagnostics_.to_text();
  EXPECT_EQ(read_options->integrator, "naive");
  EXPECT_TRUE(read_options->pixel_radial && !read_options->pixel_random && read_options->ray_casting);
  EXPECT_TRUE(read_options->shows_window && read_options->uses_irradiance);
  EXPECT_EQ(read_options->display_server, "[::1]:14158");
  EXPECT_EQ(read_options->target_error, 0.02F);
  EXPECT_EQ(read_options->max_seconds, 1.5F);
  EXPECT_EQ(read_options->checkpoint, folder_.path("keep/it.bin"));
  EXPECT_EQ(read_options->exposure, -2.5F);
  EXPECT_EQ(read_options->layers, (std::vector<std::string>{"albedo", "variance"}));
  EXPECT_EQ(read("Scene a.grf\nLayers all\n")->layers.size(), 6U);
  EXPECT_TRUE(read("Scene a.grf\nLayers none\n")->layers.empty());
}

TEST_F(OpFile, TakesQuotesAndCommentsAsTheyStand) {
  const auto read_options = read(
      "\xEF\xBB\xBF//a comment\n#another\n\t BPT_Scene \"my # scene.grf\" // a third\n"
      "BPT_Output_Image a#b//c.png\t#fourth\n\n   \nBPT_EM_Background \"/maps/sky.exr\"\n"
      "BPT_Checkpoint ../keep.bin");
  ASSERT_TRUE(read_options) << diagnostics_.to_text();
  EXPECT_EQ(read_options->scene, folder_.path("my # scene.grf"));
  EXPECT_EQ(read_options->output, folder_.path("a#b/c.png"));
  EXPECT_EQ(read_options->environment, "/maps/sky.exr");
  EXPECT_EQ(read_options->checkpoint, std::filesystem::path(folder_.path()).parent_path() / "keep.bin");
}

TEST_F(OpFile, ReportsQuotesThatAreNotClosed) {
  EXPECT_EQ(errors_of("BPT_Scene \"a.grf\n"),
            "OP:1:11: error: unclosed quote, expected another one on this line\n"
            "  BPT_Scene \"a.grf\n"
            "            ^\n");
}

TEST_F(OpFile, CountsColumnsInCharacters) {
  EXPECT_EQ(errors_of("BPT_Scene \"\xC3\xA9\xC3\xA9.grf\" b\n"),
            "OP:1:11: error: BPT_Scene: found 2 values, expected 1 (path)\n"
            "  BPT_Scene \"\xC3\xA9\xC3\xA9.grf\" b\n"
            "            ^\n");
  read("\xC3\xA9\xC3\xA9 1\nBPT_Scene a.grf\nBPT_Depth \xC3\xA9 \"\n");
  EXPECT_EQ(diagnostics_.entries().back().location.column, 13U);
}

TEST_F(OpFile, ReportsUnknownKeysHoweverTheyAreWritten) {
  EXPECT_FALSE(read("BPT Pixel SampelRes 1 2\nfrobnicate 5\n"));
  ASSERT_EQ(diagnostics_.entries().size(), 2U) << diagnostics_.to_text();
  EXPECT_EQ(diagnostics_.entries()[0].message,
            "unknown option 'BPT_Pixel_SampelRes': did you mean 'BPT_Pixel_SampleRes'?");
  const std::string& unlike = diagnostics_.entries()[1].message;
  EXPECT_TRUE(unlike.starts_with("unknown option 'frobnicate', expected one of BPT_Scene, ")) << unlike;
  for (const options::OptionInfo& option : options::option_table()) {
    EXPECT_NE(unlike.find(option.key), std::string::npos) << option.key;
  }
}

TEST_F(OpFile, ReportsValuesOfTheNewKinds) {
  EXPECT_FALSE(
      read("BPT_Scene a.grf\nBPT_Layers albedo,nromal\nBPT_DisplayServer 14158\nBPT_TargetError 0\n"
           "BPT_Exposure 101\nBPT_Pixel_SampleRes 1\nBPT_MaxTime -1\nBPT_Depth\n"));
  std::string messages;
  for (const grf::Diagnostic& entry : diagnostics_.entries()) messages += entry.message + "\n";
  EXPECT_EQ(messages,
            "BPT_Layers: found 'nromal', expected one of albedo, normal, depth, variance, error, samples, "
            "all, none: "
            "did you mean 'normal'?\n"
            "BPT_DisplayServer: found '14158', expected HOST:PORT, such as 127.0.0.1:14158, the path of a "
            "socket, or none\n"
            "BPT_TargetError: found '0', expected a number between 0 and 1000\n"
            "BPT_Exposure: found '101', expected a number from -100 to 100\n"
            "BPT_Pixel_SampleRes: found 1 value, expected 2 (int int)\n"
            "BPT_MaxTime: found '-1', expected a number between 0 and 1000000000\n"
            "BPT_Depth: found 0 values, expected 1 (int)\n");
}

}  // namespace
