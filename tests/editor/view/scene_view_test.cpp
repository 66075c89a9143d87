// Tests of the gestures and keys of the view in a window.
#include "editor/view/scene_view.h"

#include <QImage>
#include <QSignalSpy>
#include <QWheelEvent>
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "editor/appearance/theme.h"
#include "editor/view/region_selection.h"
#include "tests/editor/programs/shell_program.h"
#include "tests/editor/view/shown_view.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

using grf::Vec3d;
using test::ShownView;

constexpr FaceId Front = {0, 0};
constexpr FaceId Back = {0, 1};
constexpr FaceId Right = {0, 2};
constexpr FaceId Top = {0, 4};

SceneObjects cube() { return test::objects_of_text(test::cube_text()); }

/// Two cubes side by side: the second mesh is four units to the right.
SceneObjects two_cubes() {
  return test::objects_of_text(test::cube_text() + "transform translation (4,0,0) begin " +
                               test::cube_text() + " end");
}

ViewCamera from_the_corner() {
  transport::View view;
  view.eye = Vec3d(4, 4, 6);
  view.field_of_view = 40;
  return ViewCamera(view);
}

void click(ShownView& shown, const Vec3d& point, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QTest::mouseClick(&shown.view, Qt::LeftButton, modifiers, shown.pixel_of(point));
}

TEST(SceneView, AClickSelectsTheFace) {
  ShownView shown(cube());
  ASSERT_TRUE(shown.is_shown);
  QSignalSpy spy(&shown.view, &SceneView::selection_made);
  click(shown, Vec3d(0.3, 0.2, 1));
  ASSERT_EQ(spy.count(), 1);
  const auto made = spy.takeFirst().front().value<FaceSelection>();
  EXPECT_EQ(made.count(), 1);
  EXPECT_TRUE(made.has(Front));
  EXPECT_EQ(shown.view.selection(), made);
}

TEST(SceneView, ShiftAddsAndControlRemoves) {
  ShownView shown(cube(), from_the_corner());
  click(shown, Vec3d(0, 0, 1));
  click(shown, Vec3d(1, 0, 0), Qt::ShiftModifier);
  click(shown, Vec3d(0, 1, 0), Qt::ShiftModifier);
  EXPECT_EQ(shown.view.selection().count(), 3);
  click(shown, Vec3d(0, 0, 1), Qt::ControlModifier);
  EXPECT_EQ(shown.view.selection().count(), 2);
  EXPECT_FALSE(shown.view.selection().has(Front));
  EXPECT_TRUE(shown.view.selection().has(Right) && shown.view.selection().has(Top));
  click(shown, Vec3d(0, 0, 1));
  EXPECT_EQ(shown.view.selection().count(), 1);
}

TEST(SceneView, AClickBesideAllClears) {
  ShownView shown(cube());
  click(shown, Vec3d(0, 0, 1));
  QTest::mouseClick(&shown.view, Qt::LeftButton, Qt::ShiftModifier, QPoint(5, 5));
  EXPECT_EQ(shown.view.selection().count(), 1);
  QTest::mouseClick(&shown.view, Qt::LeftButton, Qt::NoModifier, QPoint(5, 5));
  EXPECT_TRUE(shown.view.selection().empty());
}

TEST(SceneView, ABoxSelectsWhatIsSeenInIt) {
  ShownView shown(two_cubes());
  const QPoint from = shown.pixel_of(Vec3d(-0.5, 0.5, 1));
  const QPoint to = shown.pixel_of(Vec3d(0.5, -0.5, 1));
  shown.drag(Qt::LeftButton, Qt::NoModifier, {from, (from + to) / 2, to});
  EXPECT_EQ(shown.view.selection().count(), 1);
  EXPECT_TRUE(shown.view.selection().has(Front));
  shown.view.set_select_through(true);
  shown.drag(Qt::LeftButton, Qt::NoModifier, {from, (from + to) / 2, to});
  EXPECT_EQ(shown.view.selection().count(), 2);
  EXPECT_TRUE(shown.view.selection().has(Back));
}

TEST(SceneView, ABoxIsDrawnWhileItIsDragged) {
  ShownView shown(cube());
  const QPoint from = shown.pixel_of(Vec3d(-0.5, 0.5, 1));
  const QPoint to = shown.pixel_of(Vec3d(0.5, -0.5, 1));
  const QPoint on_edge(from.x(), (from.y() + to.y()) / 2);
  const auto accent_at = [&](const QPoint& pixel) {
    const QColor accent = colours_of(Theme::Dark).accent;
    const QColor colour = shown.view.grab().toImage().pixelColor(pixel);
    return std::abs(colour.redF() - accent.redF()) + std::abs(colour.blueF() - accent.blueF()) < 0.3F;
  };
  QTest::mousePress(&shown.view, Qt::LeftButton, Qt::NoModifier, from);
  shown.move((from + to) / 2, Qt::LeftButton, Qt::NoModifier);
  shown.move(to, Qt::LeftButton, Qt::NoModifier);
  EXPECT_TRUE(accent_at(on_edge));
  EXPECT_FALSE(accent_at(on_edge + QPoint(10, 0)));
  QTest::keyClick(&shown.view, Qt::Key_Escape);
  EXPECT_FALSE(accent_at(on_edge));
}

TEST(SceneView, ABoxSelectsWhatWasSeenWhereItWasMade) {
  ShownView shown(cube());
  const QPoint from = shown.pixel_of(Vec3d(-0.5, 0.5, 1));
  const QPoint to = shown.pixel_of(Vec3d(0.5, -0.5, 1));
  QTest::mousePress(&shown.view, Qt::LeftButton, Qt::NoModifier, from);
  for (const QPoint& point : {(from + to) / 2, to}) shown.move(point, Qt::LeftButton, Qt::NoModifier);
  // The thread renders another image when the box arrives, and the view changes before it is evaluated.
  shown.view.set_mode(DisplayMode::Brdf);
  QTest::qWait(1);
  QTest::mouseRelease(&shown.view, Qt::LeftButton, Qt::NoModifier, to);
  QTest::keyClick(&shown.view, Qt::Key_9);
  ASSERT_TRUE(shown.view.is_selecting());
  ASSERT_TRUE(shown.complete());
  EXPECT_EQ(shown.view.selection().count(), 1);
  EXPECT_TRUE(shown.view.selection().has(Front));
}

TEST(SceneView, ABoxInASceneThatIsAnotherByThenSelectsNothing) {
  ShownView shown(cube());
  QSignalSpy spy(&shown.view, &SceneView::selection_made);
  const QPoint from = shown.pixel_of(Vec3d(-0.5, 0.5, 1));
  const QPoint to = shown.pixel_of(Vec3d(0.5, -0.5, 1));
  QTest::mousePress(&shown.view, Qt::LeftButton, Qt::NoModifier, from);
  for (const QPoint& point : {(from + to) / 2, to}) shown.move(point, Qt::LeftButton, Qt::NoModifier);
  QTest::mouseRelease(&shown.view, Qt::LeftButton, Qt::NoModifier, to);
  ASSERT_TRUE(shown.view.is_selecting());
  shown.view.show(std::make_shared<const SceneObjects>(two_cubes()));
  ASSERT_TRUE(shown.complete());
  EXPECT_EQ(spy.count(), 0);
  EXPECT_TRUE(shown.view.selection().empty());
}

TEST(SceneView, ALassoSelectsWhatIsInsideAlone) {
  ShownView shown(two_cubes(), test::front_camera(20));
  const auto around = [&](double x) {
    std::vector<QPoint> way;
    for (int i = 0; i <= 32; ++i) {
      const double angle = i * std::numbers::pi / 16;
      way.push_back(shown.pixel_of(Vec3d(x + 0.4 * std::cos(angle), 0.4 * std::sin(angle), 1)));
    }
    return way;
  };
  shown.drag(Qt::LeftButton, Qt::AltModifier, around(0));
  EXPECT_EQ(shown.view.selection().count(), 1);
  EXPECT_TRUE(shown.view.selection().has(Front));
  shown.view.set_lasso(true);
  shown.drag(Qt::LeftButton, Qt::ShiftModifier, around(4));
  EXPECT_EQ(shown.view.selection().count(), 2);
  EXPECT_TRUE(shown.view.selection().has({1, 0}));
  shown.drag(Qt::LeftButton, Qt::ControlModifier, around(0));
  EXPECT_EQ(shown.view.selection().count(), 1);
}

TEST(SceneView, SelectedFacesAreInTheAccentColour) {
  for (const DisplayMode mode : {DisplayMode::Solid, DisplayMode::Wireframe, DisplayMode::Points}) {
    ShownView shown(cube());
    shown.view.set_mode(mode);
    ASSERT_TRUE(shown.complete());
    const QPoint inside = shown.pixel_of(Vec3d(0.3, 0.3, 1));
    const QColor before = shown.view.grab().toImage().pixelColor(inside);
    FaceSelection selection(shown.view.objects());
    selection.set(Front);
    shown.view.set_selection(selection);
    ASSERT_TRUE(shown.complete());
    const QColor after = shown.view.grab().toImage().pixelColor(inside);
    const QColor accent = colours_of(Theme::Dark).accent;
    const auto distance = [&](const QColor& c) {
      return std::abs(c.redF() - accent.redF()) + std::abs(c.blueF() - accent.blueF());
    };
    EXPECT_LT(distance(after), 0.7F * distance(before));
  }
}

TEST(SceneView, PickingIsExact) {
  const SceneObjects objects = test::objects_of_file(GRANADA_SOURCE_DIR "/samples/teapot/teapot.grf");
  ShownView shown(objects);
  shown.view.frame_all();
  std::mt19937 random(5);
  for (const double zoom : {1.0, 0.1, 0.01}) {
    ViewCamera camera = shown.view.camera();
    camera.zoom(zoom, grf::Vec2d(0.1, 0.1), 4.0 / 3);
    shown.view.set_camera(camera);
    ASSERT_TRUE(shown.complete());
    for (int i = 0; i < 50; ++i) {
      const QPoint pixel(int(random() % 800), int(random() % 600));
      shown.view.set_selection(FaceSelection(objects));
      QTest::mouseClick(&shown.view, Qt::LeftButton, Qt::NoModifier, pixel);
      // Each triangle separately, by the volumes that its edges span with the ray.
      const grf::Vec2d place(2 * pixel.x() / 800.0 - 1, 1 - 2 * pixel.y() / 600.0);
      const ViewRay ray = camera.ray(place, 800.0 / 600);
      std::optional<std::pair<double, FaceId>> nearest;
      for (const MeshInstance& instance : *objects.instances) {
        const MeshGeometry geometry(*objects.meshes[instance.mesh].mesh);
        for (std::size_t k = 0; k < geometry.arrays().triangles.size(); ++k) {
          const auto& [ia, ib, ic] = geometry.arrays().triangles[k];
          const Vec3d a = Vec3d(geometry.arrays().positions[ia]) * instance.to_world - ray.origin;
          const Vec3d b = Vec3d(geometry.arrays().positions[ib]) * instance.to_world - ray.origin;
          const Vec3d c = Vec3d(geometry.arrays().positions[ic]) * instance.to_world - ray.origin;
          const double wa = ray.direction.dot(b.cross(c));
          const double wb = ray.direction.dot(c.cross(a));
          const double wc = ray.direction.dot(a.cross(b));
          if (!((wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0)) || wa + wb + wc == 0)
            continue;
          const double distance = ray.direction.dot(a * wa + b * wb + c * wc) / (wa + wb + wc);
          if (distance > 0 && (!nearest || distance < nearest->first)) {
            nearest = {distance, FaceId{instance.mesh, geometry.arrays().face_of_triangle[k]}};
          }
        }
      }
      ASSERT_EQ(shown.view.selection().count(), nearest ? 1 : 0);
      if (nearest) {
        EXPECT_TRUE(shown.view.selection().has(nearest->second));
      }
    }
  }
}

TEST(SceneView, DragsFromEmptyGroundAndTheMiddleButtonOrbit) {
  ShownView shown(cube());
  QSignalSpy spy(&shown.view, &SceneView::camera_moved);
  const ViewCamera before = shown.view.camera();
  shown.drag(Qt::LeftButton, Qt::NoModifier, {{20, 20}, {60, 40}, {120, 60}});
  EXPECT_GT(spy.count(), 0);
  EXPECT_NE(shown.view.camera().forward(), before.forward());
  EXPECT_EQ(shown.view.camera().target(), before.target());
  EXPECT_TRUE(shown.view.selection().empty());
  const ViewCamera then = shown.view.camera();
  shown.drag(Qt::MiddleButton, Qt::NoModifier, {{400, 300}, {430, 310}, {460, 310}});
  EXPECT_NE(shown.view.camera().forward(), then.forward());
  shown.drag(Qt::MiddleButton, Qt::ShiftModifier, {{400, 300}, {430, 310}, {460, 310}});
  EXPECT_NE(shown.view.camera().target(), then.target());
}

TEST(SceneView, TheWheelZoomsAboutThePointer) {
  ShownView shown(cube());
  const Vec3d corner(1, 1, 0);
  const QPoint pixel = shown.pixel_of(corner);
  QWheelEvent event(pixel, shown.view.mapToGlobal(pixel), QPoint(), QPoint(0, 240), Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  const double before = shown.view.camera().distance();
  QApplication::sendEvent(&shown.view, &event);
  EXPECT_LT(shown.view.camera().distance(), before);
  EXPECT_LE((shown.pixel_of(corner) - pixel).manhattanLength(), 2);
}

TEST(SceneView, FliesWhileTheRightButtonIsHeld) {
  ShownView shown(cube());
  const Vec3d before = shown.view.camera().eye();
  QTest::mousePress(&shown.view, Qt::RightButton, Qt::NoModifier, {400, 300});
  QTest::keyPress(&shown.view, Qt::Key_W);
  EXPECT_TRUE(test::wait_for([&] { return (shown.view.camera().eye() - before).length() > 0.5; }));
  QTest::keyRelease(&shown.view, Qt::Key_W);
  QTest::mouseRelease(&shown.view, Qt::RightButton, Qt::NoModifier, {400, 300});
  EXPECT_LT(shown.view.camera().eye().z, before.z);
}

TEST(SceneView, KeysChooseViewsAndFrame) {
  ShownView shown(cube(), from_the_corner());
  QTest::keyClick(&shown.view, Qt::Key_1);
  EXPECT_LT((shown.view.camera().forward() - Vec3d(0, 0, -1)).length(), 1e-9);
  QTest::keyClick(&shown.view, Qt::Key_9);
  EXPECT_LT((shown.view.camera().forward() - Vec3d(0, 0, 1)).length(), 1e-9);
  QTest::keyClick(&shown.view, Qt::Key_3);
  EXPECT_LT((shown.view.camera().forward() - Vec3d(-1, 0, 0)).length(), 1e-9);
  QTest::keyClick(&shown.view, Qt::Key_7);
  EXPECT_LT((shown.view.camera().forward() - Vec3d(0, -1, 0)).length(), 1e-9);
  QTest::keyClick(&shown.view, Qt::Key_5);
  EXPECT_TRUE(shown.view.camera().is_orthographic());
  FaceSelection selection(shown.view.objects());
  selection.set(Top);
  shown.view.set_selection(selection);
  QTest::keyClick(&shown.view, Qt::Key_F);
  EXPECT_LT((shown.view.camera().target() - Vec3d(0, 1, 0)).length(), 1e-9);
  QTest::keyClick(&shown.view, Qt::Key_Home);
  EXPECT_LT(shown.view.camera().target().length(), 1e-9);
  const double yaw = shown.view.camera().right().x;
  QTest::keyClick(&shown.view, Qt::Key_Left);
  EXPECT_NE(shown.view.camera().right().x, yaw);
}

TEST(SceneView, SpaceTogglesTheFaceInTheMiddle) {
  ShownView shown(cube());
  QTest::keyClick(&shown.view, Qt::Key_Space);
  EXPECT_TRUE(shown.view.selection().has(Front));
  QTest::keyClick(&shown.view, Qt::Key_Space);
  EXPECT_TRUE(shown.view.selection().empty());
}

TEST(SceneView, TheMiddleIsMarkedForThoseWhoComeByKeyboard) {
  ShownView shown(cube());
  shown.view.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&shown.view) && shown.complete());
  const auto beside_the_middle = [&] {
    const QImage picture = shown.view.grab().toImage();
    return picture.pixelColor(picture.width() / 2 - 8, picture.height() / 2);
  };
  shown.view.setFocus(Qt::MouseFocusReason);
  const QColor bare = beside_the_middle();
  shown.view.clearFocus();
  shown.view.setFocus(Qt::TabFocusReason);
  EXPECT_NE(beside_the_middle(), bare);
  shown.view.clearFocus();
  EXPECT_EQ(beside_the_middle(), bare);
}

TEST(SceneView, ADoubleClickSetsTheCentreOfTheOrbit) {
  ShownView shown(cube());
  QTest::mouseDClick(&shown.view, Qt::LeftButton, Qt::NoModifier, shown.pixel_of(Vec3d(0.5, 0.5, 1)));
  EXPECT_LT((shown.view.camera().target() - Vec3d(0.5, 0.5, 1)).length(), 0.03);
}

TEST(SceneView, SaysWhatIsUnderThePointer) {
  ShownView shown(cube());
  QSignalSpy spy(&shown.view, &SceneView::hovered);
  shown.move(shown.pixel_of(Vec3d(0.3, 0.2, 1)), Qt::NoButton, Qt::NoModifier);
  ASSERT_TRUE(test::wait_for([&] { return spy.count() > 0; }));
  EXPECT_EQ(spy.last().front().toString(), "cube · face 0 · default diffuse");
}

TEST(SceneView, ALightIsDraggedInThePlaneOfTheView) {
  ShownView shown(
      test::objects_of_text(test::cube_text() +
                            "transform translation (0,2,0) begin light begin (-1,0,-1) (2,0,0) (0,0,2) "
                            "end end"));
  ASSERT_EQ(shown.view.handles().size(), 1);
  QSignalSpy moved(&shown.view, &SceneView::object_moved);
  const Vec3d grip = shown.view.handles().front().grip;
  const Vec3d corner = shown.view.handles().front().position;
  EXPECT_LT((corner - Vec3d(-1, 2, -1)).length(), 1e-6);
  const QPoint from = shown.pixel_of(grip);
  const QPoint to = shown.pixel_of(grip + Vec3d(1, 0.5, 0));
  shown.drag(Qt::LeftButton, Qt::NoModifier, {from, (from + to) / 2, to});
  ASSERT_EQ(moved.count(), 1);
  EXPECT_EQ(moved.front()[0].value<HandleId>().kind, HandleKind::Light);
  EXPECT_EQ(moved.front()[0].value<HandleId>().path, shown.view.objects().lights.front().path);
  const auto position = moved.front()[1].value<Vec3d>();
  EXPECT_LT((position - corner - Vec3d(1, 0.5, 0)).length(), 0.03);
  EXPECT_TRUE(shown.view.selection().empty());
}

TEST(SceneView, WithShiftADragStaysOnAnAxis) {
  ShownView shown(test::objects_of_text("params begin dependent view (0,1,0) end " + test::cube_text()));
  transport::View camera;
  camera.eye = Vec3d(0, -1.6, 1);
  camera.target = Vec3d(1.5, 1.5, 1);
  shown.view.set_render_camera(camera);
  EXPECT_EQ(shown.view.handles().size(), 3);
  QSignalSpy moved(&shown.view, &SceneView::object_moved);
  const QPoint from = shown.pixel_of(camera.target);
  shown.drag(Qt::LeftButton, Qt::ShiftModifier, {from, from + QPoint(20, 3), from + QPoint(60, 9)});
  ASSERT_EQ(moved.count(), 1);
  EXPECT_EQ(moved.front()[0].value<HandleId>().kind, HandleKind::CameraTarget);
  const Vec3d offset = moved.front()[1].value<Vec3d>() - camera.target;
  EXPECT_GT(offset.x, 0.1);
  EXPECT_EQ(offset.y, 0);
  EXPECT_EQ(offset.z, 0);
}

TEST(SceneView, AMissingTextureIsSaid) {
  const SceneObjects objects = test::objects_of_text(test::cube_text("texture \"nowhere.png\""));
  SceneView view;
  QSignalSpy spy(&view, &SceneView::message);
  view.show(std::make_shared<const SceneObjects>(objects));
  ASSERT_TRUE(test::wait_for([&] { return spy.count() > 0; }));
  EXPECT_TRUE(spy.front().front().toString().contains("nowhere.png"));
}

TEST(SceneView, FollowsATextureThatChangesOnDisk) {
  const test::TemporaryFolder folder;
  const QString file = QString::fromStdString(folder.path("paint.png"));
  const auto paint = [&file](QColor colour) {
    QImage image(8, 8, QImage::Format_RGB32);
    image.fill(colour);
    ASSERT_TRUE(image.save(file));
  };
  paint(Qt::red);
  ShownView shown(test::objects_of_text(test::cube_text("texture \"" + file.toStdString() + "\"")));
  shown.view.set_mode(DisplayMode::Textured);
  const auto shows = [&shown](auto is_wanted) {
    return test::wait_for([&] {
      const QImage picture = shown.view.grab().toImage();
      return shown.view.is_complete() &&
             is_wanted(picture.pixelColor(picture.width() / 2, picture.height() / 2));
    });
  };
  const auto is_red = [](const QColor& colour) { return colour.red() > 2 * colour.green(); };
  const auto is_green = [](const QColor& colour) { return colour.green() > 2 * colour.red(); };
  ASSERT_TRUE(shows(is_red));
  paint(Qt::green);
  EXPECT_TRUE(shows(is_green));
  ASSERT_TRUE(QFile::remove(file));  // as by a program that replaces files
  paint(Qt::red);
  EXPECT_TRUE(shows(is_red));
}

/// A texture whose decoder crashes is reported, and the rest is drawn.
TEST(SceneView, OutlivesADecoderOfTexturesThatCrashes) {
  const test::TemporaryFolder folder;
  const ImageProcess crashing(test::shell_program(folder, "kill -SEGV $$"));
  SceneView view(nullptr, {}, crashing);
  QSignalSpy spy(&view, &SceneView::message);
  view.resize(300, 200);
  view.set_mode(DisplayMode::Textured);
  view.set_camera(test::front_camera());
  view.show(std::make_shared<const SceneObjects>(
      test::objects_of_text(test::cube_text("texture \"" + folder.path("evil.png") + "\""))));
  view.show();
  EXPECT_TRUE(test::wait_for([&] { return view.is_complete(); }));
  ASSERT_EQ(spy.count(), 1);
  EXPECT_TRUE(
      spy.front().front().toString().contains("evil.png: cannot read the image: the file is corrupt (its"));
  EXPECT_EQ(view.face_at({150, 100}), Front);
}

TEST(SceneView, CanBeNamedToThoseWhoDoNotSee) {
  SceneView view;
  EXPECT_FALSE(view.accessibleName().isEmpty());
  EXPECT_TRUE(view.accessibleDescription().contains("Space"));
}

}  // namespace
}  // namespace editor
