// Edits texture coordinates through the whole window, by pointer and keyboard.
#include <QDialog>
#include <QDockWidget>
#include <QImage>
#include <QWheelEvent>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/document/texture_coordinates.h"
#include "editor/panels/uv_view.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using grf::Vec2f;
using test::Minute;

class TextureCoordinatesInTheWindow : public Authoring {
 protected:
  /// Opens a square of side 1 with the corners of its image, or squares in a row.
  void open_squares(int count = 1) {
    QImage image(8, 8, QImage::Format_RGB32);
    image.fill(Qt::red);
    image.save(path("paper.png"));
    std::ofstream file(folder_.path("scene.grf"));
    file << "begin mesh\ntexture \"paper.png\"\nbegin vertexs\n";
    for (int i = 0; i <= count; ++i)
      file << "uv (" << i << ",0) (" << i << ",0,0)\nuv (" << i << ",1) (" << i << ",1,0)\n";
    file << "end vertexs\nbegin faces\n";
    for (int i = 0; i < count; ++i)
      file << "(" << 2 * i << "," << 2 * i + 2 << "," << 2 * i + 3 << "," << 2 * i + 1 << ")\n";
    file << "end faces\nend mesh\n";
    file.close();
    open(path("scene.grf"));
  }
  UvView& show_uvs() {
    QTest::keyClick(&window_, Qt::Key_U, Qt::ControlModifier | Qt::AltModifier);
    auto* view = window_.findChild<UvView*>();
    EXPECT_TRUE(QTest::qWaitFor([view] { return view->isVisible() && !view->image().image().isNull(); }));
    return *view;
  }
  Vec2f uv(std::size_t corner) {
    const grf::Mesh& mesh = *document().objects().meshes[0].mesh;
    return mesh.geometry->uvs[mesh.face(0)[corner]];
  }
  void type(const QString& field, const QString& number) {
    auto& box = test::named<NumberBox>(window_, field);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, number);
    QTest::keyClick(&box, Qt::Key_Return);
  }
  double number(const QString& field) { return test::named<NumberBox>(window_, field).value(); }
  int steps() { return document().undo_stack().count(); }
};

TEST_F(TextureCoordinatesInTheWindow, AreProjectedByTheListOfActions) {
  open_squares();
  test::action(window_, "All").trigger();
  QTest::keyClick(&window_, Qt::Key_F3);
  auto* dialog = window_.findChild<QDialog*>("shortcuts");
  auto* search = dialog->findChild<QLineEdit*>();
  QTest::keyClicks(search, "unwrap flip horizontally");
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(steps(), 1);
  EXPECT_EQ(uv(0), Vec2f(1, 0));
  test::action(window_, "Project along x").trigger();
  EXPECT_EQ(uv(0), Vec2f(0, 0));
  EXPECT_EQ(uv(1), Vec2f(0, 0)) << "seen from the side";
  test::action(window_, "Project along the normal").trigger();
  EXPECT_EQ(uv(1), Vec2f(1, 0));
  test::action(window_, "Rotate by 90°").trigger();
  EXPECT_EQ(uv(1), Vec2f(1, 1));
  EXPECT_EQ(document().undo_stack().undoText(), "Rotate by 90°");
  EXPECT_EQ(steps(), 4);
  for (int i = 0; i < 4; ++i) document().undo_stack().undo();
  EXPECT_EQ(uv(1), Vec2f(1, 0));
}

TEST_F(TextureCoordinatesInTheWindow, MoveWithADragInOneStep) {
  open_squares();
  test::action(window_, "All").trigger();
  UvView& view = show_uvs();
  const QPoint from = view.place_of({0.5, 0.5}).toPoint();
  const QPoint to = view.place_of({0.75, 0.625}).toPoint();
  const QPointF offset = view.uv_at(to) - view.uv_at(from);
  test::drag(view, from, to);
  EXPECT_EQ(steps(), 1);
  EXPECT_NEAR(uv(0).x, offset.x(), 1e-6);
  EXPECT_NEAR(uv(2).y, 1 + offset.y(), 1e-6);
  EXPECT_NEAR(number("UV centre, u"), 0.5 + offset.x(), 1e-6);
  test::drag(view, from, to);
  EXPECT_EQ(steps(), 2) << "each drag is a step";
  EXPECT_NEAR(uv(0).x, 2 * offset.x(), 1e-6);
  document().undo_stack().undo();
  document().undo_stack().undo();
  EXPECT_EQ(uv(0), Vec2f(0, 0));
  EXPECT_EQ(number("UV centre, u"), 0.5);
}

TEST_F(TextureCoordinatesInTheWindow, FollowTheNumbers) {
  open_squares();
  test::action(window_, "All").trigger();
  show_uvs();
  type("UV centre, u", "2");
  EXPECT_EQ(uv(0), Vec2f(1.5F, 0));
  type("UV size, v", "4");
  EXPECT_EQ(uv(0), Vec2f(1.5F, -1.5F));
  EXPECT_EQ(uv(2), Vec2f(2.5F, 2.5F));
  type("UV rotation", "90");
  EXPECT_EQ(uv(0), Vec2f(4, 0)) << "about (2, 0.5): left below becomes right below";
  EXPECT_EQ(number("UV size, u"), 4);
  EXPECT_EQ(number("UV rotation"), 0) << "the next one is relative, too";
  EXPECT_EQ(steps(), 3);
  auto& box = test::named<NumberBox>(window_, "UV rotation");
  QTest::keyClick(&box, Qt::Key_Up);
  QTest::keyClick(&box, Qt::Key_Up);
  EXPECT_NE(uv(0), Vec2f(4, 0)) << "at once";
  EXPECT_TRUE(QTest::qWaitFor([this] { return number("UV rotation") == 0; }));
  EXPECT_EQ(steps(), 4) << "steps that follow each other are one";
}

TEST_F(TextureCoordinatesInTheWindow, MoveWithTheArrows) {
  open_squares();
  test::action(window_, "All").trigger();
  UvView& view = show_uvs();
  view.setFocus();
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_LT((uv(0) - Vec2f(0.02F, -0.1F)).length(), 1e-6F);
  EXPECT_EQ(steps(), 1);
}

TEST_F(TextureCoordinatesInTheWindow, AreSeenOverTheRepeatedImage) {
  open_squares();
  test::action(window_, "All").trigger();
  UvView& view = show_uvs();
  const auto colour = [&view](const QPointF& uv) {
    return view.grab().toImage().pixelColor(view.place_of(uv).toPoint());
  };
  const QPoint pointer = view.place_of({0.75, 0.5}).toPoint();
  const QPointF under = view.uv_at(pointer);
  QWheelEvent wheel(pointer, view.mapToGlobal(pointer), {}, {0, -360}, {}, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view, &wheel);
  EXPECT_NEAR(view.uv_at(pointer).x(), under.x(), 1e-9) << "zooms about the pointer";
  EXPECT_EQ(colour({0.5, 0.5}), QColor(Qt::red));
  const QColor outside = colour({1.2, 0.5});
  EXPECT_GT(outside.red(), outside.green() + 20) << "the image, faint";
  EXPECT_LT(outside.red(), 200);
  const QPointF before = view.place_of({0, 0});
  QTest::mousePress(&view, Qt::MiddleButton, {}, pointer);
  QTest::mouseMove(&view, pointer + QPoint(20, -10));
  QTest::mouseRelease(&view, Qt::MiddleButton, {}, pointer + QPoint(20, -10));
  EXPECT_EQ((view.place_of({0, 0}) - before).toPoint(), QPoint(20, -10));
  EXPECT_EQ(steps(), 0);
  // The image is read again when it changes.
  QImage image(8, 8, QImage::Format_RGB32);
  image.fill(Qt::blue);
  image.save(path("paper.png"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return colour({0.5, 0.5}) == QColor(Qt::blue); }, Minute));
}

TEST_F(TextureCoordinatesInTheWindow, OfManyFacesMoveAtTheEndOfADrag) {
  open_squares(static_cast<int>(FewFaces));
  test::action(window_, "All").trigger();
  UvView& view = show_uvs();
  EXPECT_LE(view.outlines().size(), 4000);
  QTest::keyClick(&view, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_EQ(steps(), 0);
  ASSERT_TRUE(QTest::qWaitFor([this] { return steps() == 1; }, Minute));
  EXPECT_LT((uv(0) - Vec2f(0, 0.1F)).length(), 1e-6F);
  EXPECT_NEAR(number("UV centre, v"), 0.6, 1e-6);
}

}  // namespace
}  // namespace editor
