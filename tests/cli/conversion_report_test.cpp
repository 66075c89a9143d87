// grfconvert --report: a page with pictures of a scene and of what comes back.
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/image/image_file.h"
#include "tests/cli/grfconvert.h"
#include "tests/support/temporary_folder.h"

namespace {

using testing::HasSubstr;

class ConversionReport : public testing::Test {
 protected:
  test::TemporaryFolder folder_;

  /// Converts a room with a lamp and a floor of this BRDF, and returns the page.
  std::string page(const std::string& brdf, const std::string& output, const std::string& name) {
    const std::string scene =
        folder_.add("room.grf",
                    "light begin (-0.5, 2, -0.5) (1, 0, 0) (0, 0, 1) rgb (9, 9, 9) end\n"
                    "begin mesh brdf " +
                        brdf +
                        "\nbegin vertexs (-1, 0, 1) (1, 0, 1) (1, 0, -1) (-1, 0, -1) end\n"
                        "begin faces (0, 1, 2, 3) end end\n");
    const test::Outcome run =
        test::grfconvert({scene, "-o", folder_.path(output), "--report", folder_.path(name)});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    for (const char* what : {"original", "returned", "difference"}) {
      grf::Diagnostics diagnostics;
      const std::string picture = name.substr(0, name.rfind('.')) + "_" + what + ".png";
      EXPECT_TRUE(image::read_image(folder_.path(picture), diagnostics)) << diagnostics.to_text();
    }
    return test::bytes_of(folder_.path(name));
  }
  /// Returns the percentage in the last cell of a row of a Markdown page.
  static double percentage(const std::string& page, const std::string& row) {
    std::smatch match;
    EXPECT_TRUE(std::regex_search(page, match, std::regex("\\| " + row + "[^\\n]* ([0-9.e+-]+) % \\|\\n")))
        << page;
    return match.empty() ? -1 : std::stod(match[1]);
  }
};

TEST_F(ConversionReport, OfABrdfThatIsKeptShowsNoise) {
  const std::string page = this->page("diffuse kd=0.8", "room.glb", "page.md");
  EXPECT_LE(percentage(page, "difference, sqrt"), percentage(page, "of noise alone"));
  EXPECT_THAT(page, HasSubstr("| diffuse kd=0.8 | 1 | the same | 0.800, 0.800 |"));
  EXPECT_THAT(page, HasSubstr("(page_original.png)"));
}

// Lambert's BRDF of 0.8 becomes that of 0.5, and no lamp comes back.
TEST_F(ConversionReport, OfABrdfThatIsLostHasTheDifferenceOfAlbedos) {
  const std::string page = this->page("diffuse kd=0.8", "room.stl", "page.md");
  EXPECT_THAT(page,
              HasSubstr("0.800, 0.500 | 0.800, 0.500 | 0.800, 0.500 | 0.800, 0.500 | 0.300 | 37.5 % |"));
  EXPECT_GT(percentage(page, "difference, sqrt"), 10);
  EXPECT_THAT(page, HasSubstr("lost of this scene"));
}

TEST_F(ConversionReport, OfAFormatThatIsNotReadIsOfTheMappedBrdfs) {
  const std::string page = this->page("ward sx=0.3 sy=0.3 ks=0.3 kd=0.3", "room.pbrt", "page.html");
  EXPECT_THAT(page, HasSubstr("the original scene with the BRDFs that the format has"));
  EXPECT_THAT(page, HasSubstr("<img src=\"page_returned.png\""));
  EXPECT_THAT(page, HasSubstr("rgl "));
}

// The conversion is confined to the folders of what it reads and writes, and lists what it has written.
TEST_F(ConversionReport, IsWrittenIntoAFolderOfItsOwn) {
  std::filesystem::create_directory(folder_.path("pages"));
  std::filesystem::create_directory(folder_.path("models"));
  const std::string scene = folder_.add(
      "a.grf", "begin mesh begin vertexs (0,0,0) (1,0,0) (0,1,0) end begin faces (0,1,2) end end");
  const std::string page = folder_.path("pages/page.md");
  const test::Outcome run =
      test::grfconvert({scene, "-o", folder_.path("models/a.glb"), "--report", page, "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto files = nlohmann::json::parse(run.out)["files"].get<std::vector<std::string>>();
  EXPECT_THAT(files, testing::ElementsAre(page, folder_.path("pages/page_original.png"),
                                          folder_.path("pages/page_returned.png"),
                                          folder_.path("pages/page_difference.png")));
  EXPECT_TRUE(std::filesystem::exists(folder_.path("models/a.glb")));
  for (const std::string& file : files) EXPECT_TRUE(std::filesystem::exists(file)) << file;
}

TEST_F(ConversionReport, SaysWhatIsWrong) {
  const std::string scene = folder_.add(
      "a.grf", "begin mesh begin vertexs (0,0,0) (1,0,0) (0,1,0) end begin faces (0,1,2) end end");
  const auto expect = [&](std::vector<std::string> more, const std::string& message) {
    std::vector<std::string> arguments = {scene, "-o", folder_.path("a.stl")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const test::Outcome run = test::grfconvert(arguments);
    EXPECT_EQ(run.exit_code, 2) << message;
    EXPECT_THAT(run.err, HasSubstr(message));
  };
  expect({"--report", "page.doc"}, "the name of a page ends in .html or .md");
  expect({"--report", "page.md", "--dry-run"}, "--dry-run writes none");
  expect({scene, "--report", "page.md"}, "--report is for one input file");
}

}  // namespace
