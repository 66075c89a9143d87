// Chooses faces through the whole window, by pointer and keyboard.
#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/panels/face_query_dialog.h"
#include "editor/view/screen_geometry.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Squares of 10 x 10 at this z that face +z, row by row from the origin; those from y = 5 up are phong.
std::string square_grid(double z) {
  std::string text = "begin mesh\n  begin vertexs\n";
  for (int i = 0; i < 121; ++i)
    text += "(" + std::to_string(i % 11) + ", " + std::to_string(i / 11) + ", " + std::to_string(z) + ") ";
  text += "\n  end vertexs\n  begin faces\n";
  for (int i = 0; i < 100; ++i) {
    if (i == 50) text += "brdf phong\n";
    const int first = i / 10 * 11 + i % 10;
    text += "(" + std::to_string(first) + ", " + std::to_string(first + 1) + ", " +
            std::to_string(first + 12) + ", " + std::to_string(first + 11) + ") ";
  }
  return text + "\n  end faces\nend mesh\n";
}

class ChoosingFaces : public Authoring {
 protected:
  ChoosingFaces() {
    std::ofstream(folder_.path("scene.grf")) << square_grid(0) << square_grid(-1);
    open(path("scene.grf"));
    // Seen from the front, without perspective: a face has the same size everywhere.
    view().press(Qt::Key_1);
    view().press(Qt::Key_5);
    is_at_rest();
    view().setFocus();
  }

  SceneView& view() { return window_.view(); }

  bool is_at_rest() {
    return QTest::qWaitFor([this] { return view().is_complete() && !view().is_selecting(); }, test::Minute);
  }

  QPoint pixel(double x, double y) {
    const auto at = pixel_of({x, y, 0}, view().camera(), view().window_size());
    return {qRound(at->x), qRound(at->y)};
  }
  double pixels_per_face() { return pixel(10, 0).x() / 10.0 - pixel(0, 0).x() / 10.0; }

  void click(double x, double y, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(&view(), Qt::LeftButton, modifiers, pixel(x, y));
  }

  /// The selected faces of a mesh once the view is at rest: 0 is in front, 1 behind.
  std::vector<std::size_t> selected(std::uint32_t mesh = 0) {
    EXPECT_TRUE(is_at_rest());
    std::vector<std::size_t> faces;
    document().selection().for_each_face(mesh, [&](std::size_t face) { faces.push_back(face); });
    return faces;
  }

  /// Makes the brush as large as possible below so many faces.
  void set_radius(double faces) {
    for (int i = 0; i < 40; ++i) QTest::keyClick(&view(), Qt::Key_BracketLeft);
    double radius = 2;
    for (; radius * 1.2 < faces * pixels_per_face(); radius *= 1.2)
      QTest::keyClick(&view(), Qt::Key_BracketRight);
  }
};

TEST_F(ChoosingFaces, BrushPaintsAndTakesAway) {
  QTest::keyClick(&view(), Qt::Key_C);
  ASSERT_TRUE(test::action(window_, "Brush").isChecked());
  set_radius(0.4);
  const ViewCamera camera = view().camera();
  test::drag(view(), pixel(0.5, 5.5), pixel(9.5, 5.5));
  EXPECT_THAT(selected(), ElementsAre(50, 51, 52, 53, 54, 55, 56, 57, 58, 59));
  EXPECT_THAT(selected(1), IsEmpty()) << "behind";
  test::drag(view(), pixel(2.5, 5.5), pixel(4.5, 5.5), Qt::ControlModifier);
  EXPECT_THAT(selected(), ElementsAre(50, 51, 55, 56, 57, 58, 59));
  click(0.5, 0.5);
  EXPECT_THAT(selected(), ElementsAre(0, 50, 51, 55, 56, 57, 58, 59)) << "adds without Shift";
  test::drag(view(), pixel(-0.8, 3), pixel(-0.8, 4));
  EXPECT_EQ(view().camera(), camera) << "the background is painted, too, and no orbit begins";
  ASSERT_EQ(document().selected_objects().size(), 1U);
  const QPoint arrow = pixel(5, 5) + QPoint(60, 0);  // of the gizmo that is there without the brush
  test::drag(view(), arrow, arrow + QPoint(40, 0));
  EXPECT_GT(selected().size(), 8U);
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_FALSE(test::action(window_, "Brush").isChecked());
  click(3.5, 3.5);
  EXPECT_THAT(selected(), ElementsAre(33)) << "a click as ever";
  EXPECT_EQ(document().undo_stack().count(), 0) << "no gizmo was in the way";
}

TEST_F(ChoosingFaces, BrushHasARadius) {
  QTest::keyClick(&view(), Qt::Key_C);
  for (const double radius : {0.45, 0.65, 1.3}) {
    test::action(window_, "None").trigger();
    set_radius(radius);
    click(5.5, 4.5);
    // The brush is between radius / 1.2 and radius; no square is that far from the centre.
    std::vector<std::size_t> expected;
    for (int face = 0; face < 100; ++face) {
      const double x = std::max(std::abs(face % 10 - 5) - 0.5, 0.0);
      const double y = std::max(std::abs(face / 10 - 4) - 0.5, 0.0);
      if (std::hypot(x, y) < radius / 1.2) expected.push_back(static_cast<std::size_t>(face));
    }
    EXPECT_EQ(selected(), expected) << radius;
  }
  const double before = pixels_per_face();
  test::action(window_, "None").trigger();
  set_radius(0.45);
  for (int i = 0; i < 6; ++i) {
    QWheelEvent event(QPointF(pixel(5.5, 4.5)), view().mapToGlobal(QPointF(pixel(5.5, 4.5))), {}, {0, 120},
                      {}, Qt::ShiftModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view(), &event);
  }
  click(5.5, 4.5);
  EXPECT_GT(selected().size(), 4U) << "1.2^6 is nearly 3";
  EXPECT_EQ(pixels_per_face(), before) << "no zoom";
}

TEST_F(ChoosingFaces, BrushSelectsThrough) {
  test::action(window_, "Select through").trigger();
  QTest::keyClick(&view(), Qt::Key_C);
  // Through, a face is selected by its centre.
  set_radius(0.4);
  test::drag(view(), pixel(1.5, 2.5), pixel(3.5, 2.5));
  EXPECT_THAT(selected(0), ElementsAre(21, 22, 23));
  EXPECT_THAT(selected(1), ElementsAre(21, 22, 23));
}

TEST_F(ChoosingFaces, LoopsFollowTheEdgeUnderThePointer) {
  click(5.5, 3.1, Qt::AltModifier);
  EXPECT_THAT(selected(), ElementsAre(5, 15, 25, 35, 45, 55, 65, 75, 85, 95)) << "across the lower edge";
  click(5.1, 3.5, Qt::AltModifier);
  EXPECT_THAT(selected(), ElementsAre(30, 31, 32, 33, 34, 35, 36, 37, 38, 39)) << "across the left edge";
  click(5.1, 3.5, Qt::AltModifier | Qt::ControlModifier);
  EXPECT_THAT(selected(), ElementsAre(5, 15, 25, 35, 45, 55, 65, 75, 85, 95)) << "the other way";
  click(8.5, 8.9, Qt::AltModifier | Qt::ShiftModifier);
  EXPECT_EQ(selected().size(), 20U);
  EXPECT_TRUE(document().selection().has({0, 8}));
  EXPECT_THAT(selected(1), IsEmpty());
}

TEST_F(ChoosingFaces, PolygonSelectsInside) {
  test::action(window_, "Polygon").trigger();
  const auto click_corners = [this](std::initializer_list<std::pair<double, double>> corners) {
    for (const auto& [x, y] : corners) click(x, y);
  };
  // An L of three faces, with a wrong corner that is undone.
  click_corners({{2.1, 2.1}, {3.9, 2.1}, {3.9, 2.9}, {9, 9}});
  EXPECT_THAT(selected(), IsEmpty()) << "until it is closed";
  QTest::keyClick(&view(), Qt::Key_Backspace);
  click_corners({{2.9, 2.9}, {2.9, 3.9}, {2.1, 3.9}});
  QTest::keyClick(&view(), Qt::Key_Return);
  EXPECT_THAT(selected(), ElementsAre(22, 23, 32));
  EXPECT_THAT(selected(1), IsEmpty());
  // A triangle closed by a double click; Shift adds.
  click(6.1, 6.1, Qt::ShiftModifier);
  click(6.9, 6.1, Qt::ShiftModifier);
  QTest::mouseClick(&view(), Qt::LeftButton, Qt::ShiftModifier, pixel(6.5, 6.9));
  QTest::mouseDClick(&view(), Qt::LeftButton, Qt::ShiftModifier, pixel(6.5, 6.9));
  EXPECT_THAT(selected(), ElementsAre(22, 23, 32, 66));
  click_corners({{0.1, 0.1}, {9.9, 0.1}, {9.9, 9.9}});
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_FALSE(test::action(window_, "Polygon").isChecked());
  QTest::keyClick(&view(), Qt::Key_Return);
  EXPECT_THAT(selected(), ElementsAre(22, 23, 32, 66)) << "Escape discards the corners";
}

TEST_F(ChoosingFaces, OneToolEndsTheOther) {
  test::action(window_, "Brush").trigger();
  test::action(window_, "Polygon").trigger();
  EXPECT_FALSE(test::action(window_, "Brush").isChecked());
  click(2.5, 2.5);
  EXPECT_THAT(selected(), IsEmpty()) << "a corner of the polygon";
  test::action(window_, "Lasso").trigger();
  EXPECT_FALSE(test::action(window_, "Polygon").isChecked());
  click(2.5, 2.5);
  EXPECT_THAT(selected(), ElementsAre(22));
}

class SelectingByDialog : public ChoosingFaces {
 protected:
  SelectingByDialog() {
    test::action(window_, "Select faces by...").trigger();
    dialog_ = window_.findChild<FaceQueryDialog*>();
    EXPECT_TRUE(QTest::qWaitFor([this] { return dialog_->isActiveWindow(); }, 10'000));
  }

  void type(const QString& field, const QString& text) {
    auto& box = test::named<NumberBox>(*dialog_, field);
    box.setFocus();
    box.selectAll();
    QTest::keyClick(&box, Qt::Key_Delete);
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Tab);
  }
  void press(const QString& button) {
    QTest::mouseClick(&test::named<QPushButton>(*dialog_, button), Qt::LeftButton);
  }
  bool is_count(const QString& text) {
    return QTest::qWaitFor(
        [&] {
          return std::ranges::any_of(dialog_->findChildren<QLabel*>(),
                                     [&](const QLabel* label) { return label->text() == text; });
        },
        10'000);
  }

  FaceQueryDialog* dialog_ = nullptr;
};

TEST_F(ChoosingFaces, TheDialogIsFoundBySearch) {
  test::action(window_, "Find action").trigger();
  auto* search = window_.findChild<QDialog*>("shortcuts")->findChild<QLineEdit*>();
  QTest::keyClicks(search, "material similarities");
  QTest::keyClick(search, Qt::Key_Return);
  const auto* dialog = window_.findChild<FaceQueryDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->isVisible());
}

TEST_F(SelectingByDialog, CountsWhileItIsEdited) {
  ASSERT_NE(dialog_, nullptr);
  EXPECT_FALSE(dialog_->isModal());
  EXPECT_TRUE(is_count("200 faces"));
  type("Lowest y", "3");
  EXPECT_TRUE(is_count("140 faces"));
  type("Highest y", "4");
  EXPECT_TRUE(is_count("20 faces"));
  QTest::keyClicks(&test::named<QLineEdit>(*dialog_, "Material"), "ph*");
  EXPECT_TRUE(is_count("0 faces"));
  type("Highest y", "6");
  EXPECT_TRUE(is_count("20 faces"));
  EXPECT_TRUE(document().selection().empty()) << "until a button is pressed";
}

TEST_F(SelectingByDialog, CombinesWithTheSelection) {
  type("Highest y", "1");
  press("Replace");
  EXPECT_EQ(document().selection().count(), 20U);
  type("Highest y", "");
  type("Lowest y", "9");
  press("Add");
  EXPECT_EQ(document().selection().count(), 40U);
  type("Highest y", "10");
  press("Subtract");
  EXPECT_EQ(document().selection().count(), 20U);
  EXPECT_TRUE(document().selection().has({1, 9}));
  type("Lowest y", "");
  press("Intersect");
  EXPECT_EQ(document().selection().count(), 20U);
  type("Lowest y", "1");
  press("Intersect");
  EXPECT_EQ(document().selection().count(), 0U);
}

TEST_F(SelectingByDialog, ComparesWithTheSelection) {
  QTest::mouseClick(&test::named<QCheckBox>(*dialog_, "Same BRDF"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_TRUE(is_count("No face is selected to compare with"));
  FaceSelection one(document().objects());
  one.set({0, 77});
  document().select(one);
  EXPECT_TRUE(is_count("100 faces"));
  QTest::mouseClick(&test::named<QCheckBox>(*dialog_, "Same object"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_TRUE(is_count("50 faces"));
  press("Replace");
  EXPECT_EQ(document().selection().count(), 50U);
  EXPECT_FALSE(document().selection().has({0, 49}));
}

}  // namespace
}  // namespace editor
