// Uses the scene's list, and hides and locks faces, through the whole window, by pointer and keyboard.
#include <QCheckBox>
#include <QDropEvent>
#include <QInputDialog>
#include <QMimeData>
#include <QSignalSpy>
#include <QTreeView>
#include <algorithm>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/panels/scene_model.h"
#include "editor/panels/scene_tree.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/screen_geometry.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two unit squares side by side that face +z, from this x on.
std::string two_squares(const std::string& name, int x) {
  const auto at = [x](int i, int j) {
    return "(" + std::to_string(x + i) + ", " + std::to_string(j) + ", 0) ";
  };
  return "begin mesh \"" + name + "\"\n  begin vertexs\n" + at(0, 0) + at(1, 0) + at(2, 0) + at(0, 1) +
         at(1, 1) + at(2, 1) +
         "\n  end vertexs\n  begin faces\n (0, 1, 4, 3) (1, 2, 5, 4)\n  end faces\nend mesh\n";
}

/// The faces 0 and 1 of the mesh "left" are at x = 0 and 1, those of "right" at x = 5 and 6.
class SceneList : public Authoring {
 protected:
  SceneList() {
    std::ofstream(folder_.path("scene.grf")) << two_squares("left", 0) << two_squares("right", 5);
    open_scene();
  }

  void open_scene() {
    open(path("scene.grf"));
    view().set_grid(false);
    view().press(Qt::Key_1);
    view().press(Qt::Key_5);
    is_at_rest();
    view().setFocus();
  }

  SceneView& view() { return window_.view(); }
  QTreeView& list() { return *window_.scene_tree().view(); }

  bool is_at_rest() {
    return QTest::qWaitFor([this] { return view().is_complete() && !view().is_selecting(); }, test::Minute);
  }
  QPoint pixel(double x, double y) {
    const auto at = pixel_of({x, y, 0}, view().camera(), view().window_size());
    return {qRound(at->x), qRound(at->y)};
  }
  void click(double x, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(&view(), Qt::LeftButton, modifiers, pixel(x, 0.5));
    is_at_rest();
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    view().setFocus();
    QTest::keyClick(&view(), key, modifiers);
    is_at_rest();
  }

  /// A set of faces as x of their left sides.
  static std::vector<int> places(const FaceSelection& faces) {
    std::vector<int> result;
    for (std::uint32_t mesh = 0; mesh < faces.mesh_count(); ++mesh)
      faces.for_each_face(mesh, [&](std::size_t face) { result.push_back(int(5 * mesh + face)); });
    return result;
  }
  std::vector<int> selected() { return places(document().selection()); }
  std::vector<int> hidden() { return places(document().editor_state().hidden); }
  std::vector<int> locked() { return places(document().editor_state().locked); }

  /// Whether nothing but the background, which varies vertically only, is drawn around a face.
  bool is_background(int x) {
    document().select_objects({});  // a gizmo
    is_at_rest();
    const QImage image = view().grab().toImage();
    const QRect around = QRect(pixel(x, 1), pixel(x + 1, 0)).adjusted(3, 3, -3, -3);
    for (int row = around.top(); row <= around.bottom(); ++row) {
      for (int column = around.left(); column <= around.right(); ++column) {
        if (image.pixel(column, row) != image.pixel(around.left(), row)) return false;
        if (image.pixel(column, row) != image.pixel(2, row)) return false;
      }
    }
    return true;
  }

  QModelIndex item(const QString& name) {
    const QAbstractItemModel& model = *list().model();
    const QModelIndexList found =
        model.match(model.index(0, 0), Qt::DisplayRole, name, 1, Qt::MatchExactly | Qt::MatchRecursive);
    EXPECT_FALSE(found.isEmpty()) << name.toStdString();
    return found.isEmpty() ? QModelIndex() : found.front();
  }
  void click_item(const QString& name, int column = 0, Qt::KeyboardModifiers modifiers = {}) {
    list().expandAll();
    const QModelIndex index = item(name).siblingAtColumn(column);
    list().scrollTo(index);
    QTest::mouseClick(list().viewport(), Qt::LeftButton, modifiers, list().visualRect(index).center());
    is_at_rest();
  }
  std::string spoken(const QString& name, int column) {
    return item(name).siblingAtColumn(column).data(Qt::AccessibleTextRole).toString().toStdString();
  }
};

TEST_F(SceneList, HidesTheSelectedFaces) {
  click(0.5);
  ASSERT_THAT(selected(), ElementsAre(0));
  ASSERT_FALSE(is_background(0));
  press(Qt::Key_H);
  EXPECT_THAT(hidden(), ElementsAre(0));
  EXPECT_THAT(selected(), IsEmpty());
  EXPECT_TRUE(is_background(0));
  EXPECT_FALSE(is_background(1)) << "the other face of the mesh";
  click(0.5);
  EXPECT_THAT(selected(), IsEmpty()) << "it is not picked";
  test::action(window_, "All").trigger();
  EXPECT_THAT(selected(), ElementsAre(1, 5, 6));
  press(Qt::Key_H, Qt::AltModifier);
  EXPECT_THAT(hidden(), IsEmpty());
  EXPECT_FALSE(is_background(0));
}

TEST_F(SceneList, OrdersObjectsAndGroupsByKeys) {
  const auto names = [this] {
    std::vector<std::string> result;
    for (const MeshObject& object : document().objects().meshes) result.push_back(object.name);
    return result;
  };
  const auto depth = [this] { return document().selected_objects().at(0).size(); };
  click_item("right");
  const auto key = [this](Qt::Key arrow) {
    list().setFocus();
    QTest::keyClick(&list(), arrow, Qt::AltModifier);
    is_at_rest();
  };
  key(Qt::Key_Up);
  EXPECT_THAT(names(), ElementsAre("right", "left"));
  ASSERT_EQ(document().selected_objects().size(), 1U) << "it stays selected";
  EXPECT_EQ(list().currentIndex().data().toString(), "right");
  key(Qt::Key_Up);
  EXPECT_EQ(document().undo_stack().count(), 1) << "it is the first one already";
  key(Qt::Key_Down);
  EXPECT_THAT(names(), ElementsAre("left", "right"));
  click_item("left", 0, Qt::ControlModifier);
  QTest::keyClick(&window_, Qt::Key_G, Qt::ControlModifier);
  window_.scene_tree().view()->expandAll();
  click_item("right");
  const std::size_t inside = depth();
  key(Qt::Key_Left);
  EXPECT_LT(document().selected_objects().at(0).size(), inside);
  key(Qt::Key_Down);
  EXPECT_EQ(document().undo_stack().count(), 4) << "out of the group, it is the last one";
  document().undo_stack().undo();
  EXPECT_EQ(depth(), inside);
}

TEST_F(SceneList, HidesFacesInAllDisplayModes) {
  click(5.5);
  press(Qt::Key_H);
  const std::vector<DisplayMode> modes = {DisplayMode::Points, DisplayMode::Wireframe,
                                          DisplayMode::SolidEdges, DisplayMode::Brdf};
  view().set_vertex_normals(true);
  view().set_face_normals(true);
  for (const DisplayMode mode : modes) {
    view().set_mode(mode);
    EXPECT_TRUE(is_background(5)) << static_cast<int>(mode);
  }
  view().set_mode(DisplayMode::Solid);
  EXPECT_FALSE(is_background(6));
}

TEST_F(SceneList, RegionsLeaveOutHiddenAndLockedFaces) {
  click(1.5);
  press(Qt::Key_H);
  click(5.5);
  test::action(window_, "Lock selected").trigger();
  EXPECT_THAT(locked(), ElementsAre(5));
  EXPECT_FALSE(is_background(5)) << "it is drawn";
  for (const bool is_through : {false, true}) {
    if (is_through) test::action(window_, "Select through").trigger();
    test::action(window_, "None").trigger();
    test::drag(view(), pixel(0.2, 0.2), pixel(6.8, 0.9));
    is_at_rest();
    EXPECT_THAT(selected(), ElementsAre(0, 6)) << is_through;
  }
  click(5.5);
  EXPECT_THAT(selected(), IsEmpty());
  EXPECT_THAT(document().selected_objects(), IsEmpty());
  test::action(window_, "Unlock all").trigger();
  click(5.5);
  EXPECT_THAT(selected(), ElementsAre(5));
}

TEST_F(SceneList, IsolatesAndComesBack) {
  click(6.5);
  press(Qt::Key_H);
  click(5.5);
  press(Qt::Key_Slash);
  EXPECT_THAT(hidden(), ElementsAre(0, 1, 6)) << "what was hidden before stays so";
  EXPECT_THAT(selected(), ElementsAre(5));
  EXPECT_TRUE(is_background(0));
  press(Qt::Key_Slash);
  EXPECT_THAT(hidden(), ElementsAre(6));
  press(Qt::Key_H, Qt::ShiftModifier);
  EXPECT_THAT(hidden(), ElementsAre(0, 1, 6)) << "all but the selected face";
}

TEST_F(SceneList, HasAnEyeAndALockPerObject) {
  EXPECT_EQ(spoken("right", SceneModel::VisibleColumn), "visible");
  click_item("right", SceneModel::VisibleColumn);
  EXPECT_THAT(hidden(), ElementsAre(5, 6));
  EXPECT_EQ(spoken("right", SceneModel::VisibleColumn), "hidden");
  EXPECT_EQ(spoken("left", SceneModel::VisibleColumn), "visible");
  EXPECT_THAT(selected(), IsEmpty()) << "the click selects nothing";
  click_item("right", SceneModel::LockedColumn);
  EXPECT_THAT(locked(), ElementsAre(5, 6));
  EXPECT_EQ(spoken("right", SceneModel::LockedColumn), "locked");
  click_item("right", SceneModel::VisibleColumn);
  EXPECT_THAT(hidden(), IsEmpty());
  click_item("Objects", SceneModel::VisibleColumn);
  EXPECT_THAT(hidden(), ElementsAre(0, 1, 5, 6)) << "those of all objects inside";
  click_item("left");
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_H, Qt::ControlModifier);
  EXPECT_THAT(hidden(), ElementsAre(5, 6));
}

TEST_F(SceneList, KeepsNamedSets) {
  click(0.5);
  click(6.5, Qt::ShiftModifier);
  test::action(window_, "Save selection as...").trigger();
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowActive(dialog));
  QTest::keyClicks(dialog->findChild<QLineEdit*>(), "corners & more");
  QTest::keyClick(dialog, Qt::Key_Return);
  ASSERT_EQ(document().editor_state().face_sets.count("corners & more"), 1U);
  test::action(window_, "None").trigger();
  test::action(window_, "Select").trigger();
  EXPECT_THAT(selected(), ElementsAre(0, 6));
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(document().save(path("scene.grf"), diagnostics)) << diagnostics.to_text();
  document().clear();
  open_scene();
  test::action(window_, "Select").trigger();
  EXPECT_THAT(selected(), ElementsAre(0, 6)) << "kept beside the scene";
  test::action(window_, "Remove").trigger();
  EXPECT_THAT(document().editor_state().face_sets, IsEmpty());
}

TEST_F(SceneList, PreviewsWithoutHiddenFacesOnRequest) {
  test::action(window_, "Align camera to view").trigger();
  options::RenderOptions small = document().options().valid_options();
  small.size = {48, 32};
  small.samples = 4;
  document().options().set_options("Small", small);
  click_item("left", SceneModel::VisibleColumn);
  Preview& preview = window_.render_panel().preview();
  const auto pixels_with_faces = [&preview] {
    const auto& pixels = preview.image()->pixels;
    return std::ranges::count_if(pixels, [&](const auto& pixel) { return pixel != pixels.front(); });
  };
  const auto is_done_after = [&](const std::function<void()>& act) {
    const QSignalSpy states(&preview, &Preview::state_changed);
    act();
    return QTest::qWaitFor(
        [&] {
          return !states.empty() && states.back()[0].value<job::PreviewState>() == job::PreviewState::Done;
        },
        test::Minute);
  };
  ASSERT_TRUE(is_done_after([this] { test::action(window_, "Preview").trigger(); }));
  const auto all = pixels_with_faces();  // previews have all faces by default
  QCheckBox* without = nullptr;
  for (QCheckBox* box : window_.render_panel().findChildren<QCheckBox*>()) {
    if (box->text().remove('&') == "Without hidden faces") without = box;
  }
  ASSERT_NE(without, nullptr);
  ASSERT_TRUE(is_done_after([without] { without->click(); }));
  EXPECT_GT(pixels_with_faces(), 0);
  EXPECT_LT(pixels_with_faces(), 0.7 * static_cast<double>(all));
  ASSERT_TRUE(is_done_after([this] { click_item("left", SceneModel::VisibleColumn); }));
  EXPECT_EQ(pixels_with_faces(), all) << "it follows";
}

/// Three objects, and a definition that one of them uses.
class SceneListOrder : public SceneList {
 protected:
  SceneListOrder() {
    std::ofstream(folder_.path("scene.grf")) << "def tile = " << two_squares("", 0) << "begin\n"
                                             << two_squares("a", 0) << two_squares("b", 3)
                                             << "transform translation (6, 0, 0) begin\nuse tile\nend\nend\n";
    open_scene();
    list().expandAll();
  }

  /// The names of the items in the item called `Objects`, those of groups in brackets.
  std::string order(const QModelIndex& parent) {
    std::string text;
    for (int row = 0; row < list().model()->rowCount(parent); ++row) {
      const QModelIndex child = list().model()->index(row, 0, parent);
      text += (row > 0 ? " " : "") + child.data().toString().toStdString();
      if (list().model()->hasChildren(child)) text += "[" + order(child) + "]";
    }
    return text;
  }
  std::string order() { return order(item("Objects")); }

  /// Drops the selected items on another one, or above it.
  void drop_selection(QWidget& on, const QPoint& at) {
    const std::unique_ptr<QMimeData> data(
        list().model()->mimeData(list().selectionModel()->selectedIndexes()));
    ASSERT_NE(data, nullptr);
    QDragEnterEvent enter(at, Qt::MoveAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &enter);
    QDragMoveEvent move(at, Qt::MoveAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &move);
    QDropEvent drop(at, Qt::MoveAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &drop);
    list().expandAll();
    is_at_rest();
  }
  void drop_above(const QString& name) {
    drop_selection(*list().viewport(), list().visualRect(item(name)).topLeft() + QPoint(8, 1));
  }
  void drop_on(const QString& name) {
    drop_selection(*list().viewport(), list().visualRect(item(name)).center());
  }
  void press_in_list(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    list().setFocus();
    QTest::keyClick(&list(), key, modifiers);
    list().expandAll();
    is_at_rest();
  }
};

TEST_F(SceneListOrder, ReordersByDragging) {
  ASSERT_EQ(order(), "a b tile");
  click_item("tile");
  drop_above("a");
  EXPECT_EQ(order(), "tile a b");
  click_item("a");
  click_item("b", 0, Qt::ControlModifier);
  EXPECT_EQ(document().selected_objects().size(), 2U);
  drop_above("tile");
  EXPECT_EQ(order(), "a b tile");
  EXPECT_EQ(document().selected_objects().size(), 2U);
  click_item("a");
  drop_on("Objects");
  EXPECT_EQ(order(), "b tile a") << "at the end";
  EXPECT_EQ(document().undo_stack().count(), 3);
  document().undo_stack().undo();
  EXPECT_EQ(order(), "a b tile");
}

TEST_F(SceneListOrder, GroupsAndReparents) {
  click_item("a");
  click_item("b", 0, Qt::ShiftModifier);
  press_in_list(Qt::Key_G, Qt::ControlModifier);
  EXPECT_EQ(order(), "transform[a b] tile");
  EXPECT_EQ(item("transform").siblingAtColumn(1).data().toString(), "2 objects, 4 faces");
  click_item("b", SceneModel::LockedColumn);
  EXPECT_THAT(selected(), ElementsAre(5, 6)) << "of the second mesh, a";
  EXPECT_EQ(list().currentIndex(), item("transform")) << "it still has selected faces";
  click_item("a");
  EXPECT_EQ(document().selected_objects().back().size(), 3U) << "the child of the group, which is in a scope";
  click_item("tile");
  drop_on("transform");
  EXPECT_EQ(order(), "transform[a b tile]");
  const auto bounds = document().objects().bounds;
  EXPECT_EQ(bounds.max, grf::Vec3d(8, 1, 0)) << "where it was";
  click_item("transform");
  drop_above("b");
  EXPECT_EQ(order(), "transform[a b tile]") << "not into itself";
  click_item("transform");
  press_in_list(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(order(), "a b tile");
  EXPECT_EQ(document().objects().bounds.max, grf::Vec3d(8, 1, 0));
}

TEST_F(SceneListOrder, RenamesOnTheSpot) {
  const auto type_name = [this](const char* name) {
    QLineEdit* editor = nullptr;
    ASSERT_TRUE(QTest::qWaitFor(
        [&editor] {
          editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
          return editor != nullptr;
        },
        5000));
    editor->selectAll();
    QTest::keyClicks(editor, name);
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([this] { return list().hasFocus(); }, 5000));
  };
  click_item("a");
  press_in_list(Qt::Key_F2);
  type_name("first");
  EXPECT_EQ(order(), "first b tile");
  click_item("b");  // QTest's double click is only the second press
  QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(item("b")).center());
  type_name("second");
  EXPECT_EQ(order(), "first second tile");
}

TEST_F(SceneListOrder, AddsInstancesByDragging) {
  const auto choose_definition = [this] {
    list().setCurrentIndex(list().model()->index(0, 0, item("Mesh definitions")));
  };
  choose_definition();
  drop_above("b");
  EXPECT_EQ(order(), "a tile b tile");
  choose_definition();
  drop_selection(view(), pixel(1, 0.5));
  EXPECT_EQ(order(), "a tile b tile tile");
  ASSERT_EQ(document().selected_objects().size(), 1U);
  const grf::Box3d placed = object_bounds(document().objects(), document().selected_objects().front());
  EXPECT_NEAR(placed.center().x, 1, 0.02) << "on the surface under the pointer";
  EXPECT_NEAR(placed.min.y, 0.5, 0.02);
  test::action(window_, "Make single").trigger();
  EXPECT_EQ(document().objects().meshes.size(), 4U);
  test::action(window_, "Make instance").trigger();
  EXPECT_EQ(list().model()->rowCount(item("Mesh definitions")), 2);
}

}  // namespace
}  // namespace editor
