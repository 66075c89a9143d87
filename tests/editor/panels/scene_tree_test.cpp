#include "editor/panels/scene_tree.h"

#include <QAction>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTreeView>
#include <QtTest>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/brdf_mime.h"
#include "grf/read.h"
#include "grf/write.h"
#include "tests/editor/panels/panel_scene.h"
#include "tests/editor/scene_of.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::HasSubstr;

class SceneTrees : public testing::Test {
 protected:
  SceneTrees() : tree_(document_) {
    document_.take(scene_of(PanelScene), "/nowhere/scene.grf", {});
    tree_.resize(280, 560);
    tree_.show();
    tree_.activateWindow();  // shortcuts are those of the active window
    EXPECT_TRUE(QTest::qWaitForWindowActive(&tree_));
    view()->setFocus();
    view()->expandAll();
  }

  QTreeView* view() const { return tree_.view(); }
  /// The item of that name, under the group or item of that other name.
  QModelIndex line(const QString& parent, const QString& name) const {
    const QAbstractItemModel& model = *view()->model();
    const QModelIndexList parents =
        model.match(model.index(0, 0), Qt::DisplayRole, parent, 1, Qt::MatchExactly | Qt::MatchRecursive);
    if (parents.isEmpty()) return {};
    for (int row = 0; row < model.rowCount(parents.front()); ++row) {
      const QModelIndex index = model.index(row, 0, parents.front());
      if (index.data().toString() == name) return index;
    }
    return {};
  }
  void click(const QModelIndex& index) {
    ASSERT_TRUE(index.isValid());
    view()->scrollTo(index);
    QTest::mouseClick(view()->viewport(), Qt::LeftButton, {}, view()->visualRect(index).center());
  }
  void trigger(const QString& text) {
    for (QAction* action : view()->actions()) {
      if (action->text() == text) action->trigger();
    }
  }
  QString problem() const {
    for (const QLabel* label : tree_.findChildren<QLabel*>()) {
      if (label->isVisible() && label->parent() == &tree_) return label->text();
    }
    return {};
  }

  Document document_;
  SceneTree tree_;
};

TEST_F(SceneTrees, CountTheUsesOfDefinitionsAfterAnEditOfFaces) {
  const auto uses = [this](const QString& kind, const QString& name) {
    return line(kind, name).siblingAtColumn(1).data().toString().toStdString();
  };
  FaceSelection face(document_.objects());
  face.set({1, 0});
  document_.select(face);
  SurfaceEdit edit;
  edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Reference{"red", {}});
  edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(grf::Reference{"gold", {}});
  document_.edit_surfaces("Assign", edit);
  EXPECT_EQ(uses("Colours", "red"), "1 use");
  EXPECT_EQ(uses("BRDFs", "gold"), "2 uses");
  edit.colour = AttributeEdit<grf::ColourAttribute>::remove();
  document_.edit_surfaces("Take away", edit);
  EXPECT_EQ(uses("Colours", "red"), "unused");
  document_.undo_stack().undo();
  document_.undo_stack().undo();
  EXPECT_EQ(uses("Colours", "red"), "unused");
  EXPECT_EQ(uses("BRDFs", "gold"), "1 use");
}

TEST_F(SceneTrees, ListWhatThereIs) {
  EXPECT_EQ(line("Objects", "tile").siblingAtColumn(1).data(), "(0, 0, 0)");
  EXPECT_EQ(line("Objects", "sides").siblingAtColumn(1).data(), "2 faces");
  EXPECT_TRUE(line("Objects", "light").isValid());
  EXPECT_EQ(line("BRDFs", "gold").siblingAtColumn(1).data(), "1 use");
  EXPECT_EQ(line("Colours", "red").siblingAtColumn(1).data(), "unused");
  EXPECT_EQ(line("Mesh definitions", "tile").siblingAtColumn(1).data(), "2 uses");
}

TEST_F(SceneTrees, SelectFacesAndShowWhereTheyAre) {
  QSignalSpy chosen(&tree_, &SceneTree::chosen);
  click(line("Objects", "sides"));
  EXPECT_EQ(document_.selection().count(), 2U);
  EXPECT_TRUE(document_.selection().has({1, 0}));
  EXPECT_EQ(chosen.back().front().value<grf::ScenePath>(), document_.objects().meshes[1].path);
  click(line("BRDFs", "gold"));
  EXPECT_EQ(document_.selection().count(), 1U);
  EXPECT_TRUE(document_.selection().has({1, 1}));
  FaceSelection faces(document_.objects());
  faces.set({0, 0});
  document_.select(faces);
  EXPECT_EQ(view()->currentIndex().data(), "tile");
  EXPECT_TRUE(view()->currentIndex().data(Qt::FontRole).value<QFont>().bold());
  EXPECT_EQ(document_.selection().count(), 1U);
}

TEST_F(SceneTrees, RenameInPlace) {
  click(line("BRDFs", "gold"));
  trigger("Rename");
  auto* editor = view()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(editor, "brass");
  QTest::keyClick(editor, Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([this] { return line("BRDFs", "brass").isValid(); }));
  EXPECT_THAT(grf::to_text(document_.scene()), HasSubstr("brdf brass"));
  EXPECT_FALSE(view()->model()->setData(line("BRDFs", "brass"), "dull"));
  EXPECT_EQ(problem(), "'dull' is the name of another definition");
  document_.undo_stack().undo();
  EXPECT_TRUE(line("BRDFs", "gold").isValid());
}

TEST_F(SceneTrees, RenameAMeshAndWhatShowsItsName) {
  const test::TemporaryFolder folder;
  folder.add("part.grf", R"(begin mesh "box" begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs
    begin faces (0, 1, 2) end faces end mesh)");
  grf::Diagnostics diagnostics;
  auto scene = grf::read_text("transform scale (2, 2, 2) begin include \"part.grf\" end",
                              folder.path("scene.grf"), diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  document_.take(std::move(*scene), QString::fromStdString(folder.path("scene.grf")), {});
  const auto detail = [this] { return line("Objects", "transform").siblingAtColumn(1).data().toString(); };
  ASSERT_EQ(detail(), "box");
  const QPersistentModelIndex mesh = line("part.grf", "box");
  ASSERT_TRUE(view()->model()->setData(mesh, "crate"));
  EXPECT_EQ(mesh.data(), "crate");
  EXPECT_EQ(detail(), "crate");
  document_.undo_stack().undo();
  EXPECT_EQ(mesh.data(), "box");
  EXPECT_EQ(detail(), "box");
}

TEST_F(SceneTrees, KeepWhatIsExpandedAndCurrent) {
  const QPersistentModelIndex objects = line("Objects", "sides").parent();
  view()->collapse(line("BRDFs", "gold").parent());
  click(line("Objects", "light"));
  const QPersistentModelIndex light = line("Objects", "light");
  click(line("Objects", "sides"));
  QTest::keyClick(view(), Qt::Key_D, Qt::ControlModifier);
  EXPECT_EQ(document_.objects().instances->size(), 4U);
  EXPECT_TRUE(light.isValid());
  EXPECT_TRUE(view()->isExpanded(objects));
  EXPECT_FALSE(view()->isExpanded(line("BRDFs", "gold").parent()));
  document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(PanelScene));
  EXPECT_TRUE(light.isValid());
}

TEST_F(SceneTrees, DeleteWhatIsNotUsed) {
  click(line("BRDFs", "gold"));
  QTest::keyClick(view(), Qt::Key_Delete);
  EXPECT_EQ(problem(), "'gold' is used once");
  click(line("Objects", "sides"));
  QTest::keyClick(view(), Qt::Key_Delete);
  EXPECT_FALSE(line("Objects", "sides").isValid());
  trigger("Delete unused definitions");
  EXPECT_FALSE(line("BRDFs", "gold").isValid());
  EXPECT_TRUE(line("BRDFs", "dull").isValid());
  while (document_.undo_stack().canUndo()) document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(PanelScene));
}

TEST_F(SceneTrees, SearchForNames) {
  auto* search = tree_.findChild<QLineEdit*>();
  QTest::keyClicks(search, "GOL");
  EXPECT_TRUE(line("BRDFs", "gold").isValid());
  EXPECT_FALSE(line("Objects", "sides").isValid());
  search->clear();
  EXPECT_TRUE(line("Objects", "sides").isValid());
}

TEST_F(SceneTrees, GiveBrdfsToDrags) {
  const QModelIndex gold = line("BRDFs", "gold");
  EXPECT_TRUE(view()->model()->flags(gold).testFlag(Qt::ItemIsDragEnabled));
  const std::unique_ptr<QMimeData> data(view()->model()->mimeData({gold}));
  EXPECT_EQ(data->data(BrdfMimeType), "ward sx=0.2");
  EXPECT_EQ(data->data(BrdfNameMimeType), "gold");
  EXPECT_FALSE(view()->model()->flags(line("Colours", "red")).testFlag(Qt::ItemIsDragEnabled));
}

TEST_F(SceneTrees, AreQuickWithManyInstances) {
  std::string text = PanelScene.substr(0, PanelScene.rfind("end"));
  constexpr int Instances = 10000;
  for (int i = 0; i < Instances; ++i) {
    text += "transform translation (" + std::to_string(i) + ", 0, 0) begin use tile end\n";
  }
  document_.take(scene_of(text + "end\n"), {}, {});
  FaceSelection faces(document_.objects());
  faces.set({1, 0});
  document_.select(faces);
  QElapsedTimer timer;
  timer.start();
  SurfaceEdit edit;
  edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(0.5F));
  document_.edit_surfaces("Colour", edit);
  // A tenth of this is usual; the limit allows for slow machines and sanitizers.
  EXPECT_LT(timer.elapsed(), 1000);
  RecordProperty("milliseconds", static_cast<int>(timer.elapsed()));
}

}  // namespace
}  // namespace editor
