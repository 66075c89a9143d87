#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/summary.h"
#include "grf/text_file.h"
#include "renderer/image/image.h"
#include "renderer/job/preview_scene.h"
#include "renderer/job/render_job.h"
#include "renderer/options/op_file.h"
#include "renderer/reflectance/geometry.h"
#include "tests/studies/study_of_text.h"
#include "tests/support/temporary_folder.h"

namespace {

using image::Image;
using testing::Contains;
using testing::HasSubstr;

// A plane that fills the image, under a background of radiance 1: a diffuse BRDF shows its kd.
constexpr const char* Plane =
    "begin mesh \"plane\" brdf diffuse kd=0.8 begin vertexs (-50,0,50) (50,0,50) (50,0,-50) (-50,0,-50) end\n"
    "begin faces (0,1,2,3) end end\n";
constexpr const char* Options =
    "BPT_Scene plane.grf\nBPT_Image_Resolution 40 20\nBPT_Viewer 1 5 2\nBPT_VLook 1 0 1.5\nBPT_Background 1 "
    "1 1\n"
    "BPT_Depth 3\n";

class MiniRender : public testing::Test {
 protected:
  MiniRender() {
    folder_.add("plane.grf", Plane);
    folder_.add("plane.op", Options);
  }

  test::StudyOutcome outcome(const std::string& settings,
                             const std::string& files = "file plane.grf\nfile plane.op\n",
                             const std::string& brdfs = "brdf diffuse kd=0.3\nbrdf diffuse kd=0.6\n",
                             const std::string& pdfs = "pdf auto\npdf diffuse\n") {
    return test::outcome_of("tool minibpt " + settings + "\n" + brdfs + pdfs + files,
                            folder_.path("a.study"));
  }
  studies::Study study(const std::string& settings) {
    test::StudyOutcome made = outcome(settings);
    if (!made.study) throw std::runtime_error(made.messages);
    return std::move(*made.study);
  }
  /// The image of a study, as it is written and read.
  Image image_of(const studies::Study& study, const std::string& name = "a.exr") {
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(write_data(study, folder_.path(name), diagnostics)) << diagnostics.to_text();
    return image::read_image(folder_.path(name), diagnostics).value();
  }
  static double mean(const Image& image) {
    double sum = 0;
    for (const grf::Colour& pixel : image.pixels) sum += reflectance::mean(pixel);
    return sum / static_cast<double>(image.pixels.size());
  }

  test::TemporaryFolder folder_;
};

const std::string Above = "viewer_x=0 viewer_y=3 viewer_z=0.5 vlook_x=0 vlook_y=0 vlook_z=0 width=40 ";

TEST_F(MiniRender, RendersTheSceneWithItsOwnBrdfs) {
  const auto made = study(Above + "samples=16");
  const Image image = image_of(made);
  EXPECT_EQ(image.width, 40);
  EXPECT_EQ(image.height, 20) << "the aspect ratio of the options";
  EXPECT_NEAR(mean(image), 0.8, 0.01);
  EXPECT_THAT(test::words_of(made), Contains("plane.grf"));
  EXPECT_THAT(made.summary, HasSubstr("16 samples per pixel"));
}

TEST_F(MiniRender, ReplacesTheBrdfsOfTheScene) {
  EXPECT_NEAR(mean(image_of(study(Above + "samples=16 replace=true"))), 0.3, 0.005);
}

TEST_F(MiniRender, RendersSums) {
  const auto made = outcome(Above + "samples=16 replace=true", "file plane.grf\nfile plane.op\n",
                            "def a = brdf diffuse kd=0.2\nbrdf combine 2 a 1 a\nbrdf diffuse\n");
  ASSERT_TRUE(made.study) << made.messages;
  EXPECT_NEAR(mean(image_of(*made.study)), 0.6, 0.01);
  EXPECT_THAT(outcome("replace=true", "file plane.grf\n", "brdf combine 1 gone\nbrdf diffuse\n").messages,
              HasSubstr("gone"));
}

TEST_F(MiniRender, ComparesInEqualTime) {
  const auto made = study(Above + "samples=512 replace=true compare=brdfs");
  EXPECT_THAT(
      made.csv,
      HasSubstr("image,brdf,scheme,samples,seconds,estimated_error\nA,\"diffuse kd=0.3\",\"auto\",512,"));
  EXPECT_THAT(made.csv, HasSubstr("\nB,\"diffuse kd=0.6\",\"auto\","));
  double seconds[2] = {};
  const std::string csv = made.csv;
  std::size_t line = csv.find('\n') + 1;
  for (double& each : seconds) {
    std::size_t field = line;
    for (int i = 0; i < 4; ++i) field = csv.find(',', field) + 1;
    each = std::stod(csv.substr(field));
    line = csv.find('\n', line) + 1;
  }
  EXPECT_GT(seconds[0], 0);
  EXPECT_NEAR(seconds[1], seconds[0], 0.05 + 0.2 * seconds[0]);
  EXPECT_THAT(study(Above + "samples=4 replace=true compare=schemes").csv,
              HasSubstr("\nB,\"diffuse kd=0.3\",\"diffuse\","));
}

// Four samples of a highlight that the scheme seldom finds.
TEST_F(MiniRender, SaysLargeErrorsInWholePercent) {
  const auto made = outcome("samples=4 width=64", "", "brdf ward sx=0.02 ks=0.9 kd=0.05\nbrdf diffuse\n",
                            "pdf diffuse\npdf diffuse\n");
  ASSERT_TRUE(made.study) << made.messages;
  EXPECT_THAT(made.study->summary, testing::ContainsRegex("estimated error [1-9][0-9][0-9] %"));
}

TEST_F(MiniRender, IsWrittenInAllFormatsOfImages) {
  const auto made = study(Above + "samples=4");
  for (const char* name : {"a.exr", "a.raw", "a.pfm", "a.hdr"})
    EXPECT_NEAR(mean(image_of(made, name)), 0.8, 0.02) << name;
  // 8 bits: read as linear values again.
  for (const char* name : {"a.png", "a.tga", "a.jpg"})
    EXPECT_NEAR(mean(image_of(made, name)), 0.8, 0.02) << name;
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(write_data(made, folder_.path("a.gif"), diagnostics));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("can be written as .csv, .exr"));
}

// `bpt` renders the exported scene and options.
TEST_F(MiniRender, IsExportedAsSceneAndOptions) {
  const auto made = study(Above + "samples=8 replace=true depth=2 seed=7");
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(write_data(made, folder_.path("out.grf"), diagnostics)) << diagnostics.to_text();
  ASSERT_TRUE(write_data(made, folder_.path("out.op"), diagnostics)) << diagnostics.to_text();
  const auto options = options::read_op_file(folder_.path("out.op"), diagnostics);
  ASSERT_TRUE(options) << diagnostics.to_text();
  EXPECT_EQ(options->depth, 2);
  EXPECT_EQ(options->seed, 7U);
  EXPECT_EQ(options->samples, 8);
  EXPECT_EQ(options->eye, grf::Vec3f(0, 3, 0.5F));
  EXPECT_EQ(options->target, grf::Vec3f(0));
  EXPECT_EQ(options->background, grf::Vec3f(1));
  const auto job = job::render_job(*options, diagnostics);
  ASSERT_TRUE(job) << diagnostics.to_text();
  transport::Render render(job->scene, job->settings);
  render.run();
  const Image rendered = render.film().mean();
  EXPECT_EQ(rendered.height, 20);
  EXPECT_NEAR(mean(rendered), mean(image_of(made)), 0.005) << "0.3 for the BRDF that replaced the scene's";
}

TEST_F(MiniRender, ShowsEachShapeOnAFloor) {
  std::vector<double> means;
  for (const char* shape : {"sphere", "plane", "jug", "dragon", "knot"}) {
    const auto made = outcome(fmt::format("shape={} samples=4 width=64", shape), "");
    ASSERT_TRUE(made.study) << made.messages;
    EXPECT_EQ(made.messages, "");
    means.push_back(mean(image_of(*made.study)));
    EXPECT_THAT(test::words_of(*made.study), Contains(fmt::format("A {} on a floor", shape)));
  }
  std::ranges::sort(means);
  EXPECT_EQ(std::ranges::adjacent_find(means), means.end()) << "two shapes look the same";
}

// The box is 10 wide, and stands on the floor with a longest side of 2.
TEST_F(MiniRender, StandsAModelOnTheFloor) {
  studies::StudyContext context;
  context.read_scene = [](const std::string& path, grf::Diagnostics& diagnostics) {
    EXPECT_EQ(grf::file_name(path), "box.obj");
    return grf::read_text(
        "begin mesh brdf specular light rgb (9, 9, 9) begin vertexs (5,3,5) (15,3,5) (15,7,5) (5,7,5) "
        "end begin faces (0,1,2,3) end end\n",
        "box.grf", diagnostics);
  };
  grf::Diagnostics diagnostics;
  const auto state = studies::read_state(
      "tool minibpt shape=model samples=1 width=64\nbrdf diffuse kd=0.3\nbrdf diffuse\npdf auto\npdf "
      "auto\nfile "
      "box.obj\n",
      folder_.path("a.study"), diagnostics);
  const auto made = studies::study_of(*state, context, diagnostics);
  ASSERT_TRUE(made) << diagnostics.to_text();
  EXPECT_THAT(test::words_of(*made), Contains("box.obj on a floor"));
  ASSERT_TRUE(write_data(*made, folder_.path("a.grf"), diagnostics)) << diagnostics.to_text();
  auto scene = grf::read(folder_.path("a.grf"), diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  scene->contents.blocks.erase(scene->contents.blocks.begin());  // the floor
  scene->contents.blocks.pop_back();                             // the light
  const grf::Summary summary = grf::summarize(*scene);
  EXPECT_TRUE(summary.bounds.min.equalWithAbsError({-1, 0, 0}, 1e-5F));
  EXPECT_TRUE(summary.bounds.max.equalWithAbsError({1, 0.8F, 0}, 1e-5F));
  EXPECT_EQ(summary.lights, 0U) << "the model's materials are left out";
  EXPECT_EQ(summary.brdfs, 1U);
}

TEST_F(MiniRender, ShowsTheFilesThatWereOpenedLast) {
  const studies::StudyTool tool = studies::study_tool("minibpt").value();
  studies::ToolState state = tool.initial;
  grf::Diagnostics diagnostics;
  const auto open = [&](const std::vector<std::string>& paths) {
    open_files(tool, paths, state, diagnostics);
    std::vector<std::string> names;
    for (const auto& file : state.files) names.push_back(grf::file_name(file.path));
    return names;
  };
  using testing::ElementsAre;
  EXPECT_THAT(open({folder_.path("plane.grf")}), ElementsAre("plane.grf", "plane.op"));
  EXPECT_THAT(open({"sky.hdr"}), ElementsAre("plane.grf", "plane.op", "sky.hdr"));
  EXPECT_EQ(tool.model(state), nullptr);
  EXPECT_THAT(open({"a.obj"}), ElementsAre("sky.hdr", "a.obj"));
  ASSERT_NE(tool.model(state), nullptr);
  EXPECT_EQ(tool.model(state)->path, "a.obj");
  EXPECT_THAT(open({"studio.exr", "b.glb"}), ElementsAre("studio.exr", "b.glb"));
  EXPECT_THAT(to_text(state), HasSubstr("shape=model"));
  EXPECT_THAT(open({folder_.path("plane.grf")}), ElementsAre("studio.exr", "plane.grf", "plane.op"));
  EXPECT_EQ(diagnostics.to_text(), "");
}

// Only what a change touches is compiled anew.
TEST_F(MiniRender, CompilesAWindowsSceneOnce) {
  studies::StudyContext context;
  context.cache = std::make_shared<studies::StudyCache>();
  const auto compilations = [&](const std::string& settings, const std::string& brdf) {
    grf::Diagnostics diagnostics;
    const auto state = studies::read_state("tool minibpt samples=1 width=32 " + settings + "\nbrdf " + brdf +
                                               "\nbrdf diffuse\npdf auto\npdf auto\n",
                                           "a.study", diagnostics);
    EXPECT_TRUE(studies::study_of(*state, context, diagnostics)) << diagnostics.to_text();
    return context.cache->find<job::PreviewScene>("minibpt A")->compilations();
  };
  EXPECT_EQ(compilations("", "diffuse"), 1);
  EXPECT_EQ(compilations("viewer_x=1 depth=2", "diffuse"), 1);
  EXPECT_EQ(compilations("viewer_x=1", "phong"), 2);
  EXPECT_EQ(compilations("viewer_x=1 shape=knot", "phong"), 3);
}

TEST_F(MiniRender, TakesTheViewOfTheOptions) {
  studies::ToolState state;
  state.settings.keyword = "minibpt";
  state.files = {{folder_.path("plane.grf"), {}}};
  grf::Diagnostics diagnostics;
  studies::study_tool("minibpt")->open(state, diagnostics);
  EXPECT_EQ(diagnostics.to_text(), "");
  ASSERT_EQ(state.files.size(), 2U) << "the options beside the scene";
  EXPECT_EQ(state.files[1].path, folder_.path("plane.op"));
  EXPECT_EQ(to_text(state).substr(0, to_text(state).find('\n')),
            "tool minibpt width=40 depth=3 viewer_x=1 viewer_y=5 viewer_z=2 vlook_x=1 vlook_y=0 vlook_z=1.5");
}

TEST_F(MiniRender, TurnsTheEyeAboutThePointLookedAt) {
  grf::Diagnostics diagnostics;
  auto state = studies::read_state(
      "tool minibpt viewer_x=1 viewer_y=0 viewer_z=6 vlook_x=1 vlook_y=0 vlook_z=1\n", "a", diagnostics);
  studies::study_tool("minibpt")->turn(*state, 90, 0);
  const auto value = [&](std::size_t i) { return std::get<float>(state->settings.arguments[i].value); };
  EXPECT_NEAR(value(0), 6, 1e-5);
  EXPECT_NEAR(value(1), 0, 1e-5);
  EXPECT_NEAR(value(2), 1, 1e-5);
}

TEST_F(MiniRender, RefinesAndIsStopped) {
  grf::Diagnostics diagnostics;
  const auto state = studies::read_state(
      "tool minibpt samples=60000 width=64\nbrdf diffuse\nbrdf diffuse\npdf auto\npdf auto\n", "a.study",
      diagnostics);
  ASSERT_TRUE(state);
  int refined = 0;
  studies::StudyContext context;
  context.refined = [&](const studies::Study& study) {
    ++refined;
    EXPECT_GT(study.figure.str().size(), 1000U);
  };
  context.is_stopped = [&] { return refined >= 3; };
  EXPECT_FALSE(studies::study_of(*state, context, diagnostics));
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.to_text();
  EXPECT_GE(refined, 3);
  EXPECT_LE(refined, 4);
}

TEST_F(MiniRender, SaysWhatIsWrong) {
  EXPECT_THAT(outcome("compare=brdfs").messages, HasSubstr("set 'replace' to compare them"));
  EXPECT_THAT(outcome("", "file gone.grf\n").messages, HasSubstr("gone.grf"));
  EXPECT_THAT(outcome("", "file plane.grf\nfile plane.grf\n").messages,
              HasSubstr("found a second file of this kind"));
  EXPECT_THAT(outcome("", "file gone.hdr\n").messages, HasSubstr("gone.hdr"));
  EXPECT_THAT(outcome("shape=model", "").messages, HasSubstr("no model is open"));
  EXPECT_THAT(outcome("shape=model", "file a.obj\n").messages, HasSubstr("convert it with grfconvert"));
  EXPECT_THAT(outcome("", "", "brdf diffuse\nbrdf diffuse\n", "pdf specular\npdf auto\n").messages,
              HasSubstr("specular"));
  EXPECT_THAT(outcome("viewer_x=0 viewer_y=0 viewer_z=0 vlook_x=0 vlook_y=0 vlook_z=0").messages,
              HasSubstr("error"));
  folder_.add("zeros.hdr", std::string(500'000, '\0'));
  EXPECT_THAT(outcome("", "file zeros.hdr\n").messages, HasSubstr("zeros.hdr"));
}

}  // namespace
