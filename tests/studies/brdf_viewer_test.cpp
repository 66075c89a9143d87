#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "renderer/studies/brdf_viewer/tool.h"
#include "tests/studies/study_of_text.h"

namespace {

using testing::HasSubstr;

std::string state(const std::string& settings, const std::string& a, const std::string& b = "diffuse") {
  const bool has_samples = settings.find("samples=") != std::string::npos;
  return "tool brdfviewer " + settings + (has_samples ? "" : " samples=16") + "\nbrdf " + a + "\nbrdf " + b +
         "\n";
}

struct Row {
  int column = 0;
  double cosine = 0, r = 0, g = 0, b = 0;
};

/// The radiance along the middle of the picture.
std::vector<Row> rows_of(const std::string& text) {
  std::istringstream csv(test::study_of_text(text).csv);
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "column,cos_eye,r,g,b");
  std::vector<Row> rows;
  while (std::getline(csv, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    Row row;
    words >> row.column >> row.cosine >> row.r >> row.g >> row.b;
    rows.push_back(row);
  }
  return rows;
}

/// The row that faces the eye.
Row middle_of(const std::string& text) {
  const std::vector<Row> rows = rows_of(text);
  return *std::ranges::max_element(rows, {}, &Row::cosine);
}

/// A light at the eye, and no environment.
const std::string Headlight = "sky=black elevation=0 azimuth1=0 elevation1=0 ";

TEST(BrdfViewer, ReflectsALightAsItsFormulaSays) {
  const Row diffuse = middle_of(state(Headlight + "light1=(2, 1, 0.5)", "diffuse kd=(0.5, 0.4, 0.2)"));
  EXPECT_NEAR(diffuse.r, 1, 0.003);
  EXPECT_NEAR(diffuse.g, 0.4, 0.002);
  EXPECT_NEAR(diffuse.b, 0.1, 0.001);
  // Ward at normal incidence: f = kd/pi + ks/(4 pi s^2), and the light's irradiance is pi.
  EXPECT_NEAR(middle_of(state(Headlight, "ward sx=0.5 sy=0.5 kd=0.2 ks=0.3")).r, 0.2 + 0.3 / (4 * 0.25),
              0.004);
  // Lambert's law along the row: the eye is in the direction of the light, but for the perspective.
  for (const Row& row : rows_of(state(Headlight, "diffuse kd=1"))) {
    if (row.cosine > 0.95) {
      EXPECT_NEAR(row.r, row.cosine, 0.09);
    }
  }
}

TEST(BrdfViewer, ReflectsAConstantEnvironmentAsKdTimesItsRadiance) {
  for (const Row& row :
       rows_of(state("light1=0 sky=constant radiance=(2, 1, 0.5) samples=256", "diffuse kd=0.5"))) {
    if (row.cosine < 0.3) continue;  // also excludes pixels that the object covers in part
    EXPECT_NEAR(row.r, 1, 0.06);
    EXPECT_NEAR(row.b, 0.25, 0.015);
  }
}

TEST(BrdfViewer, ScalesDiffuseAndGlossyReflectionApart) {
  const std::string sky = "light1=0 sky=constant samples=256 ";
  const std::string brdf = "lewis n=30 kd=0.3 ks=0.4";
  const double both = middle_of(state(sky, brdf)).r;
  const double diffuse = middle_of(state(sky + "specularity=0", brdf)).r;
  EXPECT_NEAR(diffuse, 0.3, 0.01);
  EXPECT_NEAR(both, 0.7, 0.03);  // Lewis' lobe has the albedo ks at normal incidence
  EXPECT_NEAR(middle_of(state(sky + "diffuseness=0 specularity=2", brdf)).r, 2 * (both - diffuse), 0.01);
}

TEST(BrdfViewer, ShowsBOnTheRightOfTheSplit) {
  for (const Row& row :
       rows_of(state(Headlight + "split=0.5", "diffuse kd=(1, 0, 0)", "diffuse kd=(0, 0, 1)"))) {
    EXPECT_EQ(row.r > 0, row.column < 360 && row.r + row.b > 0);
    EXPECT_EQ(row.b > 0, row.column >= 360 && row.r + row.b > 0);
  }
}

TEST(BrdfViewer, HasSettingsThatAllChangeTheFigure) {
  const std::string before = "split=0.7 light2=0.3 light3=0.2 ";
  const auto figure = [&](const std::string& setting) {
    std::string settings = before;
    const std::string name = setting.substr(0, setting.find('=') + 1);
    if (const auto at = settings.find(name); at != std::string::npos)
      settings.erase(at, settings.find(' ', at) - at);
    return test::study_of_text(state(settings + setting, "phong", "ward")).figure.str();
  };
  const std::string first = figure("distance=1");
  for (const char* setting :
       {"shape=knot",    "azimuth=20",   "elevation=30",    "distance=2",      "split=0.3",
        "light1=0.5",    "azimuth1=-20", "elevation1=10",   "light2=0.6",      "azimuth2=10",
        "elevation2=50", "light3=0.6",   "azimuth3=60",     "elevation3=-20",  "sky=constant",
        "radiance=0.5",  "turned=60",    "diffuseness=0.5", "specularity=0.5", "backdrop=true",
        "exposure=1"})
    EXPECT_NE(figure(setting), first) << setting;
}

TEST(BrdfViewer, NamesItsBrdfsAndDescribesPixels) {
  const studies::Study study = test::study_of_text(state(Headlight + "split=0.5", "phong n=20", "oren"));
  const auto words = test::words_of(study);
  EXPECT_THAT(words, testing::IsSupersetOf({"BRDF A, on the left", "Phong (phong)", "n=20",
                                            "Oren-Nayar (oren)", "default parameters", "no environment"}));
  EXPECT_THAT(study.describe({370, 310}), HasSubstr("BRDF A: radiance ("));
  EXPECT_THAT(study.describe({390, 310}), HasSubstr("BRDF B: radiance ("));
  EXPECT_EQ(study.describe({25, 25}), "");
  EXPECT_EQ(study.describe({900, 310}), "");
}

TEST(BrdfViewer, SaysWhatIsWrong) {
  const auto messages = [](const std::string& text) { return test::outcome_of(text).messages; };
  EXPECT_THAT(messages(state("shape=model", "phong")), HasSubstr("no model is open"));
  EXPECT_THAT(messages(state("sky=map", "phong")), HasSubstr("no environment map is open"));
  EXPECT_THAT(messages(state("shape=model", "phong") + "file missing.grf\n"), HasSubstr("missing.grf"));
  EXPECT_THAT(messages(state("shape=model", "phong") + "file a.obj\n"), HasSubstr("grfconvert"));
  EXPECT_THAT(messages(state("sky=map", "phong") + "file missing.exr\n"), HasSubstr("missing.exr"));
  EXPECT_THAT(messages(state("", "phong") + "file a.obj\nfile b.ply\n"), HasSubstr("one model at a time"));
  EXPECT_THAT(messages(state("split=2", "phong")), HasSubstr("split"));
  EXPECT_THAT(messages(state("", "phong n=-1")), HasSubstr("'n'"));
}

TEST(BrdfViewer, ShowsAGrfScene) {
  const auto path = std::filesystem::temp_directory_path() / "brdf_viewer_test.grf";
  std::ofstream(path)
      << "begin mesh\nbegin vertexs\n(-1, -1, 0) (1, -1, 0) (1, 1, 0) (-1, 1, 0)\nend vertexs\n"
         "begin faces\n(0, 1, 2, 3)\nend faces\nend mesh\n";
  const std::string text =
      state(Headlight + "shape=model", "diffuse kd=0.6") + "file " + path.string() + "\n";
  // A square that faces the light.
  for (const Row& row : rows_of(text)) {
    if (row.column > 200 && row.column < 500) {
      EXPECT_NEAR(row.r, 0.6, 1e-4);
    }
  }
  std::filesystem::remove(path);
}

TEST(BrdfViewer, ShowsTheFilesThatWereOpenedLast) {
  const studies::StudyTool tool = studies::brdf_viewer_tool();
  studies::ToolState opened = tool.initial;
  opened.files = {{"a.obj", {}}, {"a.exr", {}}, {"b.ply", {}}};
  grf::Diagnostics diagnostics;
  tool.open(opened, diagnostics);
  ASSERT_EQ(opened.files.size(), 2U);
  EXPECT_EQ(opened.files[0].path, "b.ply");
  EXPECT_EQ(opened.files[1].path, "a.exr");
  EXPECT_THAT(to_text(opened), HasSubstr("shape=model sky=map"));
}

TEST(BrdfViewer, TurnsDirectionsIntoAnglesAndBack) {
  const studies::Heading heading = studies::heading_of(studies::direction_at(50, -20));
  EXPECT_NEAR(heading.azimuth, 50, 1e-4);
  EXPECT_NEAR(heading.elevation, -20, 1e-4);
  EXPECT_LT((studies::direction_at(90, 0) - reflectance::Vec3f(1, 0, 0)).length(), 1e-6F);
}

}  // namespace
