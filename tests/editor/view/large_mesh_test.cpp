// A mesh of a million triangles stays interactive: the limits of the benchmark, with a margin for a shared
// machine.
#include <QElapsedTimer>
#include <QImage>
#include <algorithm>
#include <iostream>

#include <gtest/gtest.h>

#include "tests/editor/view/shown_view.h"
#include "tests/grf/height_field.h"
#include "tests/support/sanitizers.h"

namespace editor {
namespace {

using grf::Vec3d;

/// Factor for a slower, shared machine. Sanitizers cost several times as much again.
constexpr double Room = test::HasSanitizers ? 20 : 2;

double milliseconds(const QElapsedTimer& clock) { return double(clock.nsecsElapsed()) * 1e-6; }

/// Measures the longest turn of the event loop.
class Watchdog {
 public:
  Watchdog() {
    clock_.start();
    QObject::connect(&timer_, &QTimer::timeout, [this] {
      longest_ = std::max(longest_, milliseconds(clock_));
      clock_.restart();
    });
    timer_.start(1);
  }
  double longest() const { return longest_; }

 private:
  QTimer timer_;
  QElapsedTimer clock_;
  double longest_ = 0;
};

class LargeMesh : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    // 708 * 708 vertices make 999,698 triangles.
    objects_ = new SceneObjects(objects_of(grf::scene_of_mesh(grf::height_field(708)), {}));
  }
  static void TearDownTestSuite() { delete objects_; }

  static ViewCamera from_above() {
    transport::View view;
    view.eye = Vec3d(0.5, -0.6, 1.2);
    view.target = Vec3d(0.5, 0.5, 0);
    view.field_of_view = 40;
    return ViewCamera(view);
  }

  static void report(const char* what, double value, const char* unit) {
    std::cout << "  " << what << ": " << value << ' ' << unit << '\n';
  }

  static inline SceneObjects* objects_ = nullptr;  // NOLINT(readability-identifier-naming): a member
};

/// Counts the paint events of a widget.
class Paints : public QObject {
 public:
  explicit Paints(QWidget& widget) { widget.installEventFilter(this); }
  int count() const { return count_; }
  bool eventFilter(QObject* /*widget*/, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++count_;
    return false;
  }

 private:
  int count_ = 0;
};

TEST_F(LargeMesh, TurnsAndComesToRestInTime) {
  test::ShownView shown(*objects_, from_above());
  ASSERT_TRUE(shown.is_shown);
  const Watchdog watchdog;
  constexpr int Frames = 30;
  QElapsedTimer clock;
  clock.start();
  QTest::mousePress(&shown.view, Qt::MiddleButton, Qt::NoModifier, {400, 300});
  shown.move({380, 280}, Qt::MiddleButton, Qt::NoModifier);  // no longer a click
  for (int i = 0; i < Frames; ++i) {
    const Paints paints(shown.view);
    shown.move({400 + 4 * i, 300 + i}, Qt::MiddleButton, Qt::NoModifier);
    ASSERT_TRUE(test::wait_for([&] { return paints.count() > 0; }));
  }
  const double per_second = 1000 * Frames / milliseconds(clock);
  EXPECT_FALSE(shown.view.is_full());
  clock.restart();
  ASSERT_TRUE(test::wait_for([&] { return shown.view.is_full(); }));
  const double rest = milliseconds(clock);
  report("frames while turning", per_second, "a second");
  report("full detail after rest", rest, "ms");
  report("longest block of the event loop", watchdog.longest(), "ms");
  EXPECT_GE(per_second, 15 / Room);
  EXPECT_LE(rest, 500 * Room);
  EXPECT_LE(watchdog.longest(), 100 * Room);
}

TEST_F(LargeMesh, AnswersClicksAndLassosInTime) {
  test::ShownView shown(*objects_, from_above());
  ASSERT_TRUE(shown.is_shown);
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(&shown.view, Qt::LeftButton, Qt::NoModifier, shown.pixel_of(Vec3d(0.5, 0.5, 0)));
  const double click = milliseconds(clock);
  EXPECT_EQ(shown.view.selection().count(), 1);
  const auto corner = [&](double x, double y) { return shown.pixel_of(Vec3d(x, y, 0.1)); };
  const std::vector<QPoint> way = {corner(0.1, 0.1), corner(0.9, 0.1), corner(0.9, 0.9), corner(0.1, 0.9),
                                   corner(0.1, 0.15)};
  QTest::mousePress(&shown.view, Qt::LeftButton, Qt::AltModifier, way.front());
  for (const QPoint& point : way) shown.move(point, Qt::LeftButton, Qt::AltModifier);
  clock.restart();
  QTest::mouseRelease(&shown.view, Qt::LeftButton, Qt::AltModifier, way.back());
  ASSERT_TRUE(test::wait_for([&] { return !shown.view.is_selecting(); }));
  const double lasso = milliseconds(clock);
  report("click", click, "ms");
  report("lasso", lasso, "ms");
  report("faces in the lasso", double(shown.view.selection().count()), "");
  EXPECT_GE(shown.view.selection().count(), 500'000);
  EXPECT_LE(click, 50 * Room);
  EXPECT_LE(lasso, 300 * Room);
}

TEST_F(LargeMesh, KeepsItsGeometryWhileSurfacesChange) {
  test::ShownView shown(*objects_, from_above());
  ASSERT_TRUE(shown.is_shown);
  SceneObjects edited = *objects_;
  edited.meshes[0].mesh.edit().surfaces[0].colour = grf::Colour(1, 0, 0);
  edited.meshes[0].flat_surfaces[0].colour = grf::Colour(1, 0, 0);
  QElapsedTimer clock;
  clock.start();
  shown.view.show(std::make_shared<const SceneObjects>(edited));
  report("showing other surfaces", milliseconds(clock), "ms");
  EXPECT_LE(milliseconds(clock), 100 * Room);
  // The former image stays until there is a new one.
  ASSERT_TRUE(test::wait_for([&] { return shown.view.is_full(); }));
  EXPECT_TRUE(shown.complete());
}

}  // namespace
}  // namespace editor
