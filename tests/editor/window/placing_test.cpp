// Places objects through the whole window, by pointer and keyboard.
#include <QAbstractButton>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLabel>
#include <QStatusBar>
#include <QTreeView>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/notice_bar.h"
#include "editor/controls/number_box.h"
#include "editor/document/object_placement.h"
#include "editor/panels/scene_tree.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/screen_geometry.h"
#include "editor/window/docks.h"
#include "grf/write.h"
#include "tests/editor/pointer.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using grf::Vec3d;
using test::Minute;
using testing::HasSubstr;

/// A cube of side 1 with this lowest corner.
std::string cube(const std::string& name, double x, double y, double z) {
  std::string text = "begin mesh \"" + name + "\"\n  begin vertexs\n";
  for (int corner = 0; corner < 8; ++corner) {
    text += "    (" + std::to_string(x + (corner & 1)) + ", " + std::to_string(y + (corner >> 1 & 1)) + ", " +
            std::to_string(z + (corner >> 2 & 1)) + ")\n";
  }
  return text +
         "  end vertexs\n  begin faces\n    (0, 2, 3, 1)\n    (4, 5, 7, 6)\n    (0, 1, 5, 4)\n    (2, 6, 7, "
         "3)\n"
         "    (0, 4, 6, 2)\n    (1, 3, 7, 5)\n  end faces\nend mesh\n";
}

grf::ColourAttribute edit_colour() { return grf::Colour(0.25F, 0.5F, 0.75F); }

class Placing : public Authoring {
 protected:
  void open_text(const std::string& text) {
    std::ofstream(folder_.path("scene.grf")) << text;
    open(path("scene.grf"));
    window_.view().press(Qt::Key_1);
    ASSERT_TRUE(is_drawn());
  }

  bool is_drawn() {
    return QTest::qWaitFor([this] { return window_.view().is_complete(); }, Minute);
  }

  QPoint pixel(const Vec3d& point) {
    const auto at = pixel_of(point, window_.view().camera(), window_.view().window_size());
    return {qRound(at->x), qRound(at->y)};
  }

  void click(const Vec3d& point, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(&window_.view(), Qt::LeftButton, modifiers, pixel(point));
  }

  /// Presses keys in the view, then Return.
  void type(const QString& keys) {
    window_.view().setFocus();
    QTest::keyClicks(&window_.view(), keys);
    QTest::keyClick(&window_.view(), Qt::Key_Return);
  }

  grf::Box3d bounds(std::size_t selected = 0) {
    return object_bounds(document().objects(), document().selected_objects().at(selected));
  }

  std::string text() { return grf::to_text(document().scene()); }

  double world_per_pixel(const Vec3d& point) {
    return 2 * window_.view().camera().half_height_at(point) / window_.view().window_size().y;
  }
};

TEST_F(Placing, MovesByATenthTenTimesAndBackToTheSameBytes) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  const std::string before = text();
  click({0.5, 0.5, 1});
  ASSERT_EQ(document().selected_objects().size(), 1U);
  for (int i = 0; i < 10; ++i) type("gx.1");
  EXPECT_EQ(bounds().min, Vec3d(1, 0, 0));
  EXPECT_THAT(text(), HasSubstr("transform translation (1, 0, 0)"));
  for (int i = 0; i < 10; ++i) type("gx-.1");
  EXPECT_EQ(text(), before);
  EXPECT_EQ(document().undo_stack().count(), 20);
  document().undo_stack().undo();
  EXPECT_EQ(bounds().min.x, 0.1F) << "the object stays selected";
}

TEST_F(Placing, RotatesByFourQuarterTurnsToTheSameBytes) {
  open_text(cube("left", 0.3, 0, 0) + cube("right", 3, 0, 0));
  const std::string before = text();
  click({0.8, 0.5, 1});
  for (const char* const keys : {"rx90", "ry90", "rz90"}) {
    for (int i = 0; i < 4; ++i) type(keys);
    EXPECT_EQ(text(), before) << keys;
  }
  type("ry45");
  EXPECT_NEAR(bounds().size().x, std::sqrt(2), 1e-6) << "a cube turned by 45 degrees";
  EXPECT_LT((bounds().center() - Vec3d(0.8, 0.5, 0.5)).length(), 1e-6) << "about its centre";
}

TEST_F(Placing, LightsTheFirstPreviewOfAModelByAStudio) {
  std::ofstream(folder_.path("cube.obj")) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  open(path("cube.obj"));
  ASSERT_TRUE(document().has_plain_sky());
  QTest::keyClick(&window_, Qt::Key_F5);
  EXPECT_EQ(document().objects().lights.size(), 2U);
  EXPECT_EQ(document().objects().meshes.size(), 2U) << "with a floor";
  EXPECT_FALSE(document().has_plain_sky());
  auto& notice = *window_.findChild<NoticeBar*>();
  EXPECT_TRUE(notice.isVisible());
  QTest::keyClick(&window_, Qt::Key_F5);  // pauses
  QTest::keyClick(&window_, Qt::Key_F5);
  EXPECT_EQ(document().objects().lights.size(), 2U) << "one studio";
  for (auto* choice : notice.findChildren<QAbstractButton*>()) {
    if (choice->text() == "Without the studio") QTest::mouseClick(choice, Qt::LeftButton);
  }
  EXPECT_TRUE(document().objects().lights.empty());
  EXPECT_TRUE(document().has_plain_sky());
  EXPECT_FALSE(notice.isVisible());
  window_.render_panel().stop_action()->trigger();
  QTest::keyClick(&window_, Qt::Key_F5);
  EXPECT_TRUE(document().objects().lights.empty()) << "it was refused";
}

/// Types a number into a field.
void enter(QWidget& field, const QString& number) {
  field.setFocus();
  QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(&field, number);
  QTest::keyClick(&field, Qt::Key_Return);
}

TEST_F(Placing, ChangesTheParametersOfANewShape) {
  open_text(cube("left", 0, 0, 0));
  test::action(window_, "Add a sphere").trigger();
  ASSERT_EQ(document().undo_stack().count(), 1);
  auto& radius = test::named<NumberBox>(window_, "Radius of the new shape");
  auto& segments = test::named<NumberBox>(window_, "Segments of the new shape");
  EXPECT_THROW(test::named<NumberBox>(window_, "Tube radius of the new shape"), std::runtime_error);
  enter(radius, "3");
  EXPECT_NEAR(bounds().size().y, 6, 1e-5) << "it stands on the floor, poles above each other";
  EXPECT_NEAR(bounds().min.y, 0, 1e-5);
  enter(segments, "8");
  const auto faces = [this] { return document().objects().meshes.at(1).mesh->face_count(); };
  EXPECT_EQ(faces(), 8U * 4U) << "half as many rows";
  EXPECT_TRUE(radius.isVisible());
  QTest::keyClick(&segments, Qt::Key_Up);
  EXPECT_EQ(faces(), 9U * 4U) << "at once";
  EXPECT_EQ(document().undo_stack().count(), 1) << "with the addition it is one step";
  EXPECT_EQ(document().objects().meshes.at(1).name, "sphere");
  document().undo_stack().undo();
  EXPECT_EQ(document().objects().meshes.size(), 1U);
  EXPECT_FALSE(radius.isVisible());
  document().undo_stack().redo();
  EXPECT_EQ(faces(), 9U * 4U);
  EXPECT_NEAR(bounds().size().y, 6, 1e-5);
  EXPECT_FALSE(radius.isVisible()) << "after other steps they are fixed";
}

TEST_F(Placing, FixesANewShapeByTheNextEdit) {
  open_text(cube("left", 0, 0, 0));
  test::action(window_, "Add a torus").trigger();
  auto& tube = test::named<NumberBox>(window_, "Tube radius of the new shape");
  test::action(window_, "Drop to floor").trigger();
  EXPECT_TRUE(tube.isVisible()) << "it stands there already: no edit";
  click({0.5, 0.5, 1});
  EXPECT_FALSE(tube.isVisible()) << "another object is selected";
  test::action(window_, "Add a box").trigger();
  auto& width = test::named<NumberBox>(window_, "Width of the new shape");
  enter(test::named<NumberBox>(window_, "Height of the new shape"), "2");
  EXPECT_NEAR(bounds().size().y, 2, 1e-6);
  type("gx1");
  EXPECT_FALSE(width.isVisible());
  EXPECT_EQ(document().undo_stack().count(), 3);
  test::action(window_, "Add a disc").trigger();
  auto& radius = test::named<NumberBox>(window_, "Radius of the new shape");
  EXPECT_TRUE(radius.isVisible());
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(document().save(document().path(), diagnostics));
  EXPECT_FALSE(radius.isVisible()) << "it was saved";
}

TEST_F(Placing, LeavesScenesOfTheirOwnWithoutAStudio) {
  open_text(cube("left", 0, 0, 0));
  ASSERT_TRUE(document().has_plain_sky());
  QTest::keyClick(&window_, Qt::Key_F5);
  EXPECT_TRUE(document().objects().lights.empty());
}

TEST_F(Placing, StandsOnTheSurfaceThatIsClicked) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  click({0.5, 0.5, 1});
  QTest::keyClick(&window_, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  window_.view().press(Qt::Key_7);  // from above
  click({3.5, 1, 0.5});             // the top of the other one
  EXPECT_NEAR(bounds().min.y, 1, 1e-6);
  EXPECT_NEAR(bounds().center().x, 3.5, 0.05);
  EXPECT_EQ(document().undo_stack().undoText(), "Place on surface");
}

TEST_F(Placing, ScalesByATypedFactorAlongAnAxis) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  click({0.5, 0.5, 1});
  type("sy3");
  EXPECT_EQ(bounds().min, Vec3d(0, -1, 0));
  EXPECT_EQ(bounds().max, Vec3d(1, 2, 1));
  type("s.5");
  EXPECT_EQ(bounds().size(), Vec3d(0.5, 1.5, 0.5));
}

TEST_F(Placing, DragsAnArrowOfTheGizmoAlongItsAxis) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  click({0.5, 0.5, 1});
  const Vec3d pivot(0.5);
  const double unit = world_per_pixel(pivot);
  const QPoint arrow = pixel(pivot + Vec3d(60 * unit, 0, 0));
  test::drag(window_.view(), arrow, arrow + QPoint(80, 35));
  ASSERT_EQ(document().undo_stack().count(), 1);
  EXPECT_EQ(document().undo_stack().undoText(), "Move");
  EXPECT_NEAR(bounds().min.x, 80 * unit, 2 * unit);
  EXPECT_EQ(bounds().min.y, 0);
  EXPECT_EQ(bounds().min.z, 0);
}

TEST_F(Placing, DragsTheRingsAndHandlesOfTheOtherGizmos) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  click({0.5, 0.5, 1});
  window_.view().press(Qt::Key_5);  // orthographic: a pixel is as long everywhere
  const QPoint pivot = pixel(Vec3d(0.5));
  test::action(window_, "Rotate gizmo").trigger();
  // Along the ring about z, which faces the eye, counter-clockwise.
  test::drag(window_.view(), pivot + QPoint(64, -64), pivot + QPoint(-64, -64));
  EXPECT_EQ(document().undo_stack().undoText(), "Rotate");
  EXPECT_THAT(text(), HasSubstr("rotation (0, 0, 1.57"));
  document().undo_stack().undo();
  test::action(window_, "Scale gizmo").trigger();
  test::drag(window_.view(), pivot + QPoint(80, 0), pivot + QPoint(160, 30));
  EXPECT_EQ(document().undo_stack().undoText(), "Scale");
  EXPECT_NEAR(bounds().size().x, 2, 0.02);
  EXPECT_EQ(bounds().size().y, 1);
  EXPECT_NEAR(bounds().center().x, 0.5, 1e-6);
}

TEST_F(Placing, ClicksGoThroughTheGizmo) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  click({0.5, 0.5, 1});
  ASSERT_EQ(document().selection().count(), 1U);
  document().select(FaceSelection(document().objects()));
  click({0.5, 0.5, 0.5});
  EXPECT_EQ(document().selection().count(), 1U) << "of the face behind the gizmo's middle";
  EXPECT_EQ(document().undo_stack().count(), 0);
}

TEST_F(Placing, SnapsToTheGridWithCtrl) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  click({0.5, 0.5, 1});
  const double unit = world_per_pixel(Vec3d(0.5));
  const QPoint arrow = pixel(Vec3d(0.5 + 60 * unit, 0.5, 0.5));
  test::drag(window_.view(), arrow, arrow + QPoint(83, 0), Qt::ControlModifier);
  // The grid of a scene of this size has steps of a fifth or a whole.
  const double centre = bounds().center().x;
  EXPECT_GT(centre, 0.6);
  EXPECT_NEAR(centre * 5, std::round(centre * 5), 1e-5);
}

TEST_F(Placing, FollowsThePointerUntilEscape) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  const std::string before = text();
  click({0.5, 0.5, 1});
  const ViewCamera camera = window_.view().camera();
  QTest::keyClicks(&window_.view(), "g");
  test::move_pointer(window_.view(), pixel({2, 1, 0}));
  QTest::keyClicks(&window_.view(), "7");
  EXPECT_EQ(window_.view().camera(), camera) << "digits are the distance";
  QTest::keyClick(&window_.view(), Qt::Key_Escape);
  EXPECT_EQ(text(), before);
  EXPECT_EQ(document().undo_stack().count(), 0);
  QTest::keyClicks(&window_.view(), "g");
  test::move_pointer(window_.view(), pixel({2, 1, 0}));
  QTest::mouseClick(&window_.view(), Qt::RightButton, {}, pixel({2, 1, 0}));
  EXPECT_EQ(document().undo_stack().count(), 0);
  QTest::keyClicks(&window_.view(), "7");
  EXPECT_FALSE(window_.view().camera() == camera) << "the key is that of the view again";
}

TEST_F(Placing, MovesSeveralObjectsAndUndoesThatAtOnce) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  const std::string before = text();
  click({0.5, 0.5, 1});
  click({3.5, 0.5, 1}, Qt::ShiftModifier);
  ASSERT_EQ(document().selected_objects().size(), 2U);
  type("gz2");
  EXPECT_EQ(bounds(0).min, Vec3d(0, 0, 2));
  EXPECT_EQ(bounds(1).min, Vec3d(3, 0, 2));
  document().undo_stack().undo();
  EXPECT_EQ(text(), before);
  EXPECT_EQ(document().selected_objects().size(), 2U);
  document().undo_stack().redo();
  EXPECT_EQ(bounds(1).min, Vec3d(3, 0, 2));
}

TEST_F(Placing, AlignsDistributesMirrorsAndDrops) {
  open_text(cube("a", 0, 5, 0) + cube("b", 2, 3, 0) + cube("c", 9, 1, 0));
  for (const double x : {0.5, 2.5, 9.5}) {
    const double y = x == 0.5 ? 5.5 : x == 2.5 ? 3.5 : 1.5;
    click({x, y, 1}, x == 0.5 ? Qt::NoModifier : Qt::ShiftModifier);
  }
  ASSERT_EQ(document().selected_objects().size(), 3U);
  test::action(window_, "Distribute along X").trigger();
  EXPECT_EQ(bounds(1).min.x, 4.5);
  test::action(window_, "Align Y maximum").trigger();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(bounds(i).max.y, 2);
  test::action(window_, "Drop to floor").trigger();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(bounds(i).min.y, 0);
  test::action(window_, "Along X").trigger();
  EXPECT_EQ(bounds(0).min.x, 9);
  EXPECT_EQ(bounds(2).min.x, 0);
  test::action(window_, "Reset transform").trigger();
  EXPECT_EQ(bounds(1).min, Vec3d(2, 3, 0));
}

TEST_F(Placing, EditsNumbersInTheObjectDock) {
  open_text(cube("left", 0, 0, 0) + cube("right", 3, 0, 0));
  window_.scene_tree().choose(document().objects().instances->at(1).path);
  ASSERT_EQ(document().selected_objects().size(), 1U);
  Docks::show(window_.findChild<QDockWidget*>("object"));
  const auto enter = [this](const QString& name, const QString& number) {
    auto& box = test::named<NumberBox>(window_, name);
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, number);
    QTest::keyClick(&box, Qt::Key_Return);
  };
  enter("Position, y", "1.5");
  EXPECT_EQ(bounds().min, Vec3d(3, 1.5, 0));
  enter("Rotation, z", "90");
  // A quarter turn about the origin of the transform takes x to y.
  EXPECT_LT((bounds().min - Vec3d(-1, 4.5, 0)).length(), 1e-5);
  EXPECT_THAT(text(), HasSubstr("rotation (0, 0, 1.5707964) translation (0, 1.5, 0)"));
  enter("Scale, x", "0");
  EXPECT_THAT(text(), HasSubstr("transform rotation (0, 0, 1.5707964) translation (0, 1.5, 0)"));
  document().undo_stack().undo();
  document().undo_stack().undo();
  EXPECT_EQ(bounds().min, Vec3d(3, 0, 0));
  EXPECT_EQ(test::named<NumberBox>(window_, "Position, y").value(), 0);
}

TEST_F(Placing, MovesAnObjectOfAnIncludedFileByItsPlace) {
  std::ofstream(folder_.path("part.grf")) << cube("part", 0, 0, 0);
  open_text("include \"part.grf\"\ntransform translation (3, 0, 0) begin\ninclude \"part.grf\"\nend\n");
  click({0.5, 0.5, 1});
  ASSERT_EQ(document().selected_objects().size(), 1U);
  type("gy2");
  EXPECT_EQ(document().objects().instances->at(0).to_world.translation(), Vec3d(0, 2, 0));
  EXPECT_EQ(document().objects().instances->at(1).to_world.translation(), Vec3d(3, 0, 0));
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(document().save(path("scene.grf"), diagnostics)) << diagnostics.to_text();
  std::ifstream part(folder_.path("part.grf"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(part), {}), cube("part", 0, 0, 0));
}

TEST_F(Placing, SendsAMaterialAsTextAndBack) {
  open_text("def\n  metal = brdf ward sx=0.1\n  both = brdf combine 0.5 metal\nbegin\n" +
            cube("left", 0, 0, 0) + cube("right", 3, 0, 0) + "end\n");
  click({0.5, 0.5, 1});
  SurfaceEdit edit;
  edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(grf::Reference{"both", {}});
  edit.colour = AttributeEdit<grf::ColourAttribute>::set(edit_colour());
  document().edit_surfaces("Surface", edit);
  test::action(window_, "Copy material").trigger();
  const QString mail = QGuiApplication::clipboard()->text();
  EXPECT_THAT(mail.toStdString(), HasSubstr("metal = brdf ward"));
  document().undo_stack().undo();  // closing asks nothing

  open_text(cube("other", 0, 0, 0));
  const std::string before = text();
  click({0.5, 0.5, 1});
  QGuiApplication::clipboard()->setText("Hello");
  test::action(window_, "Paste material").trigger();
  EXPECT_EQ(text(), before);
  EXPECT_TRUE(window_.notice().isVisible());
  QGuiApplication::clipboard()->setText(mail);
  test::action(window_, "Paste material").trigger();
  EXPECT_EQ(document().undo_stack().count(), 1);
  EXPECT_THAT(text(), HasSubstr("combine 0.5 metal"));
  EXPECT_EQ(faces_where([](const grf::Surface& surface) {
              const auto* brdf = surface.brdf ? std::get_if<grf::Reference>(&*surface.brdf) : nullptr;
              return brdf != nullptr && brdf->name == "both" && surface.colour == edit_colour();
            }),
            1U);
  // The same text again finds its definitions there.
  const std::string once = text();
  test::action(window_, "Paste material").trigger();
  EXPECT_EQ(text(), once);
  document().undo_stack().undo();
  EXPECT_EQ(text(), before);
}

TEST_F(Placing, TurnsAboutThePivotThatIsChosen) {
  open_text(cube("left", 1, 0, 0) + cube("right", 3, 0, 0));
  click({1.5, 0.5, 1});
  test::action(window_, "World origin").trigger();
  type("rz90");
  EXPECT_LT((bounds().min - Vec3d(-1, 1, 0)).length(), 1e-6);
  test::action(window_, "Local axes").trigger();
  type("gx1");
  EXPECT_LT((bounds().min - Vec3d(-1, 2, 0)).length(), 1e-6) << "the object's own x points up";
}

}  // namespace
}  // namespace editor
