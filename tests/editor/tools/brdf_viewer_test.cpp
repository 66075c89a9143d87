#include <QApplication>
#include <QLabel>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <QPlainTextEdit>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <cstdio>
#include <fstream>

#include <gmock/gmock.h>

#include "editor/brdf/compiled_brdf.h"
#include "editor/controls/notice_bar.h"
#include "editor/tools/brdf_drawing.h"
#include "editor/tools/brdf_view.h"
#include "editor/tools/brdf_viewer_window.h"
#include "editor/tools/shader_text_view.h"
#include "editor/tools/study_form.h"
#include "renderer/reflectance/presets.h"
#include "renderer/studies/brdf_viewer/tool.h"
#include "tests/editor/pointer.h"
#include "tests/editor/scene_of.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

using reflectance::Rgb;
using reflectance::Vec3f;
using testing::HasSubstr;

constexpr int Timeout = 60000;

std::string brdfs(const std::string& a, const std::string& b = "diffuse") {
  return "\nbrdf " + a + "\nbrdf " + b + "\n";
}

/// The window with a state, once its image is done.
class ShownViewer {
 public:
  explicit ShownViewer(const std::string& text, const GraphicsDriver& driver = {}) : window(driver) {
    window.resize(1000, 640);
    EXPECT_TRUE(window.read(QString::fromStdString(text), "test.study"))
        << window.notice().text().toStdString();
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    settle();
  }
  void settle() {
    EXPECT_TRUE(QTest::qWaitFor([this] { return !window.is_busy(); }, Timeout))
        << window.notice().text().toStdString();
  }
  /// The light of a pixel, by the GPU and by the CPU.
  PixelProbe probe(const QPoint& at) {
    QSignalSpy probed(&window.view(), &BrdfView::probed);
    test::move_pointer(window.view(), at);
    PixelProbe last;
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          if (probed.isEmpty()) return false;
          last = probed.last()[0].value<PixelProbe>();
          return last.pixel == at;
        },
        Timeout));
    return last;
  }
  QPoint middle() { return window.view().rect().center(); }
  float setting(std::string_view name) {
    const studies::StudyTool tool = studies::brdf_viewer_tool();
    const grf::Argument* argument = grf::find_argument(window.state().settings, *tool.settings.find(name));
    return argument != nullptr ? std::get<float>(argument->value) : tool.settings.find(name)->default_value;
  }

  BrdfViewerWindow window;
};

QPoint brightest(const QImage& image, const QRect& place) {
  QPoint at;
  int most = -1;
  for (int y = place.top(); y <= place.bottom(); ++y) {
    for (int x = place.left(); x <= place.right(); ++x) {
      const QColor colour = image.pixelColor(x, y);
      const int sum = colour.red() + colour.green() + colour.blue();
      if (sum > most) {
        most = sum;
        at = {x, y};
      }
    }
  }
  return at;
}

/// A scene of 96 x 80 pixels for drawing without a window.
BrdfScene small_scene(const std::string& brdf, studies::Environment::Kind sky) {
  static const auto object =
      viewed_object(objects_of(studies::scene_of_shape(studies::BrdfViewerSettings::Knot), {}));
  BrdfScene scene;
  scene.object = object;
  const CompiledBrdf compiled = compile_brdf(brdf_model(brdf), {});
  scene.brdfs[0] = std::make_shared<const studies::LitBrdf>(studies::lit_brdf(*compiled.brdf, 0.7F, 1.3F));
  scene.brdfs[1] = scene.brdfs[0];
  scene.lighting.lights = {{studies::direction_at(30, 40), Rgb(3, 2, 1)},
                           {studies::direction_at(-70, 10), Rgb(0, 0.5F, 1)}};
  scene.lighting.samples = 16;
  scene.lighting.environment.kind = sky;
  scene.view = studies::BrdfViewerSettings().view(object->bounds, 1.2);
  scene.size = {96, 80};
  return scene;
}

/// OpenGL without a window.
class Offscreen {
 public:
  Offscreen() {
    QOpenGLContext* const current = context_.make_current();
    if (current == nullptr) return;
    gl_ = QOpenGLVersionFunctionsFactory::get<Gl>(current);
    if (gl_ != nullptr) gl_->initializeOpenGLFunctions();
  }
  Gl* gl() { return gl_; }

 private:
  OffscreenContext context_;
  Gl* gl_ = nullptr;
};

/// The pixels that differ by more than 1 %, of those that show the object.
std::pair<int, int> differing(BrdfDrawing& drawing, const BrdfScene& scene) {
  drawing.show(scene);
  EXPECT_TRUE(drawing.is_by_glsl());
  int different = 0;
  int all = 0;
  for (int y = 2; y < scene.size.height(); y += 7) {
    for (int x = 2; x < scene.size.width(); x += 7) {
      const PixelProbe probe = drawing.probe({x, y});
      if (!probe.is_object) continue;
      ++all;
      if (!((probe.by_gpu - probe.by_cpu).length() <= 0.01F * probe.by_cpu.length() + 1e-4F)) ++different;
    }
  }
  return {different, all};
}

std::vector<std::string> all_models() {
  std::vector<std::string> models;
  for (const reflectance::Preset& preset : reflectance::thesis_models().presets)
    models.emplace_back(preset.brdf);
  for (const char* more : {"specular ks=0.8", "ward sx=0.05 sy=0.4 kd=(0.1, 0.2, 0.9)", "neumann", "granier"})
    models.emplace_back(more);
  for (const grf::ModelInfo& info : reflectance::brdf_infos()) {
    if (info.argument_kind == grf::ModelInfo::ArgumentKind::Parameters) models.emplace_back(info.keyword);
  }
  return models;
}

TEST(BrdfDrawing, IsWhatTheCpuEvaluatesForEveryModel) {
  Offscreen offscreen;
  ASSERT_NE(offscreen.gl(), nullptr);
  BrdfDrawing drawing(*offscreen.gl(), {});
  for (const std::string& model : all_models()) {
    for (const auto sky : {studies::Environment::Kind::None, studies::Environment::Kind::Studio}) {
      const auto [different, all] = differing(drawing, small_scene(model, sky));
      EXPECT_GT(all, 30) << model;
      // The rim of a narrow lobe may differ.
      EXPECT_LE(different, 2) << model << (sky == studies::Environment::Kind::None ? "" : " in the studio");
    }
  }
}

TEST(BrdfDrawing, IsWhatTheCpuEvaluatesUnderAMap) {
  Offscreen offscreen;
  ASSERT_NE(offscreen.gl(), nullptr);
  BrdfDrawing drawing(*offscreen.gl(), {});
  BrdfScene scene = small_scene("ashikhmin", studies::Environment::Kind::Map);
  image::Image image = {8, 4, std::vector<Rgb>(32, Rgb(0.2F, 0.3F, 0.5F))};
  image.pixels[11] = Rgb(90, 80, 60);
  scene.lighting.environment.set_map(std::make_shared<const transport::EnvironmentMap>(image));
  scene.lighting.environment.turned = 0.8F;
  scene.lighting.environment.scale = Rgb(1, 0.5F, 2);
  const auto [different, all] = differing(drawing, scene);
  EXPECT_GT(all, 30);
  // Directions at the border of a texel may fall to either side.
  EXPECT_LE(different, 4);
}

TEST(BrdfDrawing, RefinesToWhatTheProbeSays) {
  Offscreen offscreen;
  ASSERT_NE(offscreen.gl(), nullptr);
  BrdfDrawing drawing(*offscreen.gl(), {});
  BrdfScene scene = small_scene("diffuse kd=0.5", studies::Environment::Kind::Constant);
  scene.lighting.lights.clear();
  scene.brdfs[0] = std::make_shared<const studies::LitBrdf>(
      studies::lit_brdf(*compile_brdf(brdf_model("diffuse kd=0.5"), {}).brdf, 1, 1));
  scene.lighting.samples = 1024;
  drawing.show(scene);
  while (drawing.passes() < drawing.all_passes()) drawing.refine([] { return false; });
  // kd L = 0.5, sRGB-encoded 188.
  const QImage image = drawing.image();
  int inside = 0;
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 96; ++x) {
      if (image.pixelColor(x, y).red() > 180) ++inside;
      EXPECT_LE(image.pixelColor(x, y).red(), 194);
    }
  }
  EXPECT_GT(inside, 1500);
}

TEST(BrdfDrawing, GoesOnWhereTheNormalsAloneTakeASliceOfTime) {
  Offscreen offscreen;
  ASSERT_NE(offscreen.gl(), nullptr);
  BrdfDrawing drawing(*offscreen.gl(), {});
  const BrdfScene scene = small_scene("ward sx=0.2 sy=0.3", studies::Environment::Kind::Studio);
  drawing.show(scene);
  ASSERT_GT(drawing.all_passes(), 0);
  const int most_calls = scene.size.height() * drawing.all_passes();  // one for each row
  for (int i = 0; i < most_calls; ++i) drawing.refine([] { return true; });
  EXPECT_EQ(drawing.passes(), drawing.all_passes());
}

TEST(BrdfDrawing, ShadesOnTheCpuWhereTheDriverRefuses) {
  Offscreen offscreen;
  ASSERT_NE(offscreen.gl(), nullptr);
  GraphicsDriver driver;
  driver.compile = [](const ShaderTexts& texts) -> CompiledProgram {
    if (texts.fragment.contains("vec3 ward(")) return {nullptr, "0:1(1): error: no such thing\nmore"};
    return compile_program(texts);
  };
  const BrdfScene scene = small_scene("ward sx=0.2 sy=0.3", studies::Environment::Kind::Studio);
  const auto image_of = [&](const GraphicsDriver& of_driver) {
    BrdfDrawing drawing(*offscreen.gl(), of_driver);
    drawing.show(scene);
    while (drawing.passes() < drawing.all_passes()) drawing.refine([] { return false; });
    return std::pair(drawing.image(), drawing.limitations());
  };
  const auto [by_gpu, no_limitations] = image_of({});
  const auto [by_cpu, limitations] = image_of(driver);
  EXPECT_TRUE(no_limitations.isEmpty());
  ASSERT_EQ(limitations.size(), 1);
  EXPECT_THAT(limitations[0].toStdString(), testing::EndsWith("slowly: 0:1(1): error: no such thing"));
  int different = 0;
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 96; ++x) {
      if (std::abs(by_gpu.pixelColor(x, y).green() - by_cpu.pixelColor(x, y).green()) > 2) ++different;
    }
  }
  EXPECT_LE(different, 20);
}

TEST(BrdfViewerWindow, ShowsAConstantEnvironmentAsKdTimesItsRadiance) {
  ShownViewer viewer("tool brdfviewer light1=0 sky=constant radiance=(2, 1, 0.5) samples=512" +
                     brdfs("diffuse kd=(0.5, 0.4, 0.2)"));
  const PixelProbe probe = viewer.probe(viewer.middle());
  ASSERT_TRUE(probe.is_object);
  for (const Rgb& radiance : {probe.by_gpu, probe.by_cpu}) {
    EXPECT_NEAR(radiance.x, 1.0, 0.02);
    EXPECT_NEAR(radiance.y, 0.4, 0.008);
    EXPECT_NEAR(radiance.z, 0.1, 0.002);
  }
  EXPECT_THAT(viewer.window.pointed_text().toStdString(), HasSubstr("BRDF A"));
  EXPECT_THAT(viewer.window.pointed_text().toStdString(), HasSubstr("difference"));
}

TEST(BrdfViewerWindow, ScalesDiffuseAndGlossyReflectionOfTheEnvironment) {
  const auto radiance = [](const std::string& settings) {
    ShownViewer viewer("tool brdfviewer light1=0 sky=constant samples=512 " + settings +
                       brdfs("lewis kd=0.3 ks=0.5 n=50"));
    return viewer.probe(viewer.middle()).by_gpu.x;
  };
  const float both = radiance("");
  const float diffuse = radiance("specularity=0");
  EXPECT_NEAR(diffuse, 0.3, 0.006);  // kd times the radiance 1
  EXPECT_NEAR(radiance("diffuseness=0"), both - diffuse, 0.01);
  EXPECT_NEAR(radiance("diffuseness=2 specularity=0"), 2 * diffuse, 0.01);
}

TEST(BrdfViewerWindow, ShowsBOnTheRightOfTheSplit) {
  ShownViewer viewer("tool brdfviewer sky=constant light1=0 split=0.5" +
                     brdfs("diffuse kd=(0.8, 0, 0)", "diffuse kd=(0, 0, 0.8)"));
  const QImage image = viewer.window.view().image().image;
  const QPoint middle = viewer.middle();
  const QColor left = image.pixelColor(middle - QPoint(60, 0));
  const QColor right = image.pixelColor(middle + QPoint(60, 0));
  EXPECT_GT(left.red(), 200);
  EXPECT_EQ(left.blue(), 0);
  EXPECT_EQ(right.red(), 0);
  EXPECT_GT(right.blue(), 200);
  EXPECT_FALSE(viewer.probe(middle + QPoint(60, 0)).is_first);
  // The split is dragged.
  BrdfView* view = &viewer.window.view();
  QTest::mousePress(view, Qt::LeftButton, {}, middle);
  test::move_pointer(*view, middle + QPoint(100, 0), Qt::LeftButton);
  QTest::mouseRelease(view, Qt::LeftButton, {}, middle + QPoint(100, 0));
  viewer.settle();
  EXPECT_NEAR(viewer.setting("split"), 0.5 + 100.0 / view->width(), 0.01);
  EXPECT_EQ(view->image().image.pixelColor(middle + QPoint(60, 0)).blue(), 0);
}

TEST(BrdfViewerWindow, MovesTheHighlightUnderThePointer) {
  ShownViewer viewer("tool brdfviewer sky=black elevation=0 exposure=-5" + brdfs("lewis n=200 kd=0 ks=0.2"));
  BrdfView* view = &viewer.window.view();
  view->set_tool(BrdfView::Tool::Light);
  for (const QPoint& by : {QPoint(70, -40), QPoint(-60, 50)}) {
    const QPoint at = viewer.middle() + by;
    QTest::mousePress(view, Qt::LeftButton, {}, viewer.middle());
    test::move_pointer(*view, at, Qt::LeftButton);
    viewer.settle();
    const QPoint dragged = brightest(view->image().image, view->rect());
    EXPECT_NEAR(dragged.x(), at.x(), 6);
    EXPECT_NEAR(dragged.y(), at.y(), 6);
    QTest::mouseRelease(view, Qt::LeftButton, {}, at);
    viewer.settle();
    const QPoint shown = brightest(view->image().image, view->rect());
    EXPECT_NEAR(shown.x(), at.x(), 6);
    EXPECT_NEAR(shown.y(), at.y(), 6);
  }
  // Each drag is one step of undo.
  EXPECT_NE(viewer.setting("azimuth1"), 30);
}

TEST(BrdfViewerWindow, FollowsThePointerAndTheKeys) {
  ShownViewer viewer("tool brdfviewer shape=teapot" + brdfs("phong"));
  BrdfView* view = &viewer.window.view();
  QTest::mousePress(view, Qt::LeftButton, {}, viewer.middle());
  test::move_pointer(*view, viewer.middle() + QPoint(50, 0), Qt::LeftButton);
  QTest::mouseRelease(view, Qt::LeftButton, {}, viewer.middle() + QPoint(50, 0));
  EXPECT_LT(viewer.setting("azimuth"), -20);
  const float elevation = viewer.setting("elevation");
  view->setFocus();
  QTest::keyClick(view, Qt::Key_Up);
  EXPECT_NE(viewer.setting("elevation"), elevation);
  const float azimuth = viewer.setting("azimuth1");
  QTest::keyClick(view, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(viewer.setting("azimuth1"), azimuth + 5, 1e-3);
  QTest::keyClick(view, Qt::Key_Plus);
  EXPECT_FLOAT_EQ(viewer.setting("exposure"), 0.5F);
  QTest::keyClick(view, Qt::Key_PageUp);
  EXPECT_FLOAT_EQ(viewer.setting("distance"), 0.9F);
  viewer.settle();
  EXPECT_TRUE(view->image().is_by_glsl);
}

TEST(BrdfViewerWindow, SaysWhatIsWrongWithFiles) {
  QTemporaryDir folder;
  const std::string path = folder.path().toStdString();
  std::ofstream(path + "/broken.grf") << "mesh { vertices oops";
  std::ofstream(path + "/broken.obj") << "f 1 2 99\n";
  std::ofstream(path + "/broken.exr") << "no image";
  const auto message = [&](const std::string& settings, const std::string& file) {
    ShownViewer viewer("tool brdfviewer " + settings + brdfs("phong") +
                       (file.empty() ? "" : "file " + path + file));
    EXPECT_TRUE(viewer.window.notice().isVisible()) << file;
    return viewer.window.notice().text().toStdString();
  };
  EXPECT_THAT(message("shape=model", "/missing.grf"), HasSubstr("missing.grf"));
  EXPECT_THAT(message("shape=model", "/broken.grf"), HasSubstr("broken.grf"));
  EXPECT_THAT(message("shape=model", "/broken.obj"), HasSubstr("broken.obj"));
  EXPECT_THAT(message("sky=map", "/broken.exr"), HasSubstr("broken.exr"));
  EXPECT_THAT(message("sky=map", "/missing.exr"), HasSubstr("missing.exr"));
  EXPECT_THAT(message("sky=map", ""), HasSubstr("No environment map is open"));
  EXPECT_THAT(message("", "/a.obj\nfile " + path + "/b.obj"), HasSubstr("one model at a time"));
}

TEST(BrdfViewerWindow, ShowsModelsOfOtherFormats) {
  QTemporaryDir folder;
  const QString file = folder.filePath("teapot.obj");
  ASSERT_EQ(QProcess::execute(GRANADA_BIN_DIR "/make_teapot", {"4", file}), 0);
  ShownViewer viewer("tool brdfviewer shape=model" + brdfs("phong") + "file " + file.toStdString() + "\n");
  EXPECT_FALSE(viewer.window.notice().isVisible()) << viewer.window.notice().text().toStdString();
  EXPECT_TRUE(viewer.probe(viewer.middle()).is_object);
  EXPECT_EQ(viewer.window.view().scene().object->triangles, 992U);
}

TEST(BrdfViewerWindow, ShowsTheShaderWithTheDriversErrors) {
  GraphicsDriver driver;
  driver.compile = [](const ShaderTexts& texts) -> CompiledProgram {
    if (texts.fragment.contains("vec3 ward(")) return {nullptr, "0:7(1): error: no such thing"};
    return compile_program(texts);
  };
  ShownViewer viewer("tool brdfviewer" + brdfs("phong"), driver);
  ShaderTextView& text = viewer.window.shader_text();
  EXPECT_TRUE(text.text().isReadOnly());
  EXPECT_THAT(text.text().toPlainText().toStdString(), HasSubstr("vec3 phong("));
  EXPECT_EQ(text.message(), "");
  EXPECT_TRUE(viewer.window.read(QString::fromStdString("tool brdfviewer" + brdfs("ward")), "test"));
  viewer.settle();
  EXPECT_THAT(text.text().toPlainText().toStdString(), HasSubstr("vec3 ward("));
  EXPECT_EQ(text.message(), "0:7(1): error: no such thing");
  EXPECT_THAT(viewer.window.notice().text().toStdString(), HasSubstr("on the CPU"));
  EXPECT_FALSE(viewer.window.view().image().is_by_glsl);
}

TEST(BrdfViewerWindow, KeepsItsStateAsText) {
  ShownViewer viewer("tool brdfviewer shape=knot split=0.25 light2=(1, 0.5, 0) sky=black" +
                     brdfs("phong n=7", "ward sx=0.3"));
  const std::string text = to_text(viewer.window.state());
  grf::Diagnostics diagnostics;
  const auto state = studies::read_state(text, "again.study", diagnostics);
  ASSERT_TRUE(state) << diagnostics.to_text();
  EXPECT_EQ(*state, viewer.window.state());
  EXPECT_FALSE(viewer.window.read("tool brdfviewer split=3" + QString::fromStdString(brdfs("phong")), "bad"));
  EXPECT_THAT(viewer.window.notice().text().toStdString(), HasSubstr("split"));
  EXPECT_EQ(to_text(viewer.window.state()), text);
}

}  // namespace
}  // namespace editor
