#include <QApplication>
#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "editor/brdf/compiled_brdf.h"
#include "editor/graphics/graphics_thread.h"
#include "editor/tools/brdf_drawing.h"
#include "editor/tools/brdf_view.h"
#include "editor/tools/brdf_viewer_window.h"
#include "grf/read.h"
#include "renderer/studies/brdf_viewer/tool.h"
#include "tests/editor/pointer.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

/// Frames per second that have to be reached while an object of 100,000 triangles is turned.
constexpr double Target = 15;
constexpr int WarmUp = 6;
constexpr int Frames = 30;

std::shared_ptr<const ViewedObject> knot(int triangles) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("knot.grf");
  if (QProcess::execute(GRANADA_BIN_DIR "/make_shape", {"knot", QString::number(triangles), file}) != 0)
    return nullptr;
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(file.toStdString(), diagnostics);
  return scene ? viewed_object(objects_of(*scene, {})) : nullptr;
}

struct Speed {
  double frames = 0;  ///< per second, the median
  int scale = 1;      ///< of the drafts
};

Speed speed_of(BrdfDrawing& drawing, BrdfScene scene) {
  std::vector<double> seconds;
  studies::BrdfViewerSettings settings;
  for (int frame = 0; frame < WarmUp + Frames; ++frame) {
    settings.azimuth = static_cast<float>(3 * frame);
    scene.view = settings.view(scene.object->bounds, 800.0 / 600);
    QElapsedTimer clock;
    clock.start();
    drawing.show(scene);
    EXPECT_FALSE(drawing.image().isNull());
    if (frame >= WarmUp) seconds.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-9);
  }
  std::nth_element(seconds.begin(), seconds.begin() + Frames / 2, seconds.end());
  return {1 / seconds[Frames / 2], drawing.scale()};
}

TEST(BrdfDrawing, TurnsALargeObjectInRealTimeWithEveryModel) {
  OffscreenContext context;
  QOpenGLContext* const current = context.make_current();
  ASSERT_NE(current, nullptr);
  Gl* gl = QOpenGLVersionFunctionsFactory::get<Gl>(current);
  ASSERT_NE(gl, nullptr);
  gl->initializeOpenGLFunctions();
  BrdfScene scene;
  scene.object = knot(100'000);
  ASSERT_TRUE(scene.object);
  scene.size = {800, 600};
  scene.lighting.lights = {{studies::direction_at(30, 40), reflectance::Rgb(3)}};
  std::printf("%-14s %21s %21s\n", "model", "one light", "light and studio");
  for (const grf::ModelInfo& info : reflectance::brdf_infos()) {
    if (info.argument_kind != grf::ModelInfo::ArgumentKind::Parameters) continue;
    grf::BrdfModel model;
    model.keyword = info.keyword;
    const CompiledBrdf compiled = compile_brdf(model, {});
    ASSERT_TRUE(compiled.brdf) << info.keyword;
    scene.brdfs[0] = std::make_shared<const studies::LitBrdf>(studies::lit_brdf(*compiled.brdf, 1, 1));
    scene.brdfs[1] = scene.brdfs[0];
    // A drawing of its own, since the resolution is adapted to the speed.
    BrdfDrawing drawing(*gl, {});
    scene.lighting.environment.kind = studies::Environment::Kind::None;
    const Speed with_light = speed_of(drawing, scene);
    scene.lighting.environment.kind = studies::Environment::Kind::Studio;
    const Speed with_studio = speed_of(drawing, scene);
    std::printf("%-14s %5.0f frames/s at 1/%d %5.0f frames/s at 1/%d\n", std::string(info.keyword).c_str(),
                with_light.frames, with_light.scale, with_studio.frames, with_studio.scale);
    EXPECT_GE(with_light.frames, Target) << info.keyword;
    EXPECT_GE(with_studio.frames, Target) << info.keyword;
  }
}

/// The longest time for which the window's thread did not get to its events while the object is turned.
TEST(BrdfViewerWindow, IsNeverBlocked) {
  BrdfViewerWindow window;
  window.resize(1000, 700);
  ASSERT_TRUE(window.read("tool brdfviewer shape=knot\nbrdf he\nbrdf diffuse\n", "test"));
  window.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.is_busy(); }, 60000));
  QElapsedTimer clock;
  qint64 last = 0;
  std::vector<qint64> gaps;
  QTimer beat;
  QObject::connect(&beat, &QTimer::timeout, [&] {
    gaps.push_back(clock.nsecsElapsed() - last);
    last = clock.nsecsElapsed();
  });
  const QPoint middle = window.view().rect().center();
  QTest::mousePress(&window.view(), Qt::LeftButton, {}, middle);
  clock.start();
  beat.start(0);
  int drafts = 0;
  QObject::connect(&window.view(), &BrdfView::drawn,
                   [&] { drafts += window.view().image().passes == 0 ? 1 : 0; });
  for (int i = 1; i <= 60; ++i) {
    test::move_pointer(window.view(), middle + QPoint(3 * i, i), Qt::LeftButton);
    QTest::qWait(10);
  }
  beat.stop();
  QTest::mouseRelease(&window.view(), Qt::LeftButton, {}, middle + QPoint(180, 60));
  std::sort(gaps.begin(), gaps.end());
  const double seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
  std::printf("longest gap between events: %.1f ms; %.1f frames/s\n", static_cast<double>(gaps.back()) * 1e-6,
              drafts / seconds);
  EXPECT_GT(drafts / seconds, 5);
  EXPECT_LT(static_cast<double>(gaps.back()) * 1e-6, 50);
}

}  // namespace
}  // namespace editor
