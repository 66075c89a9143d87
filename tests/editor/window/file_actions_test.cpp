#include "editor/window/file_actions.h"

#include <QFile>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "tests/editor/answer.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::HasSubstr;

const std::string Triangle =
    "begin mesh \"a\"\n  begin vertexs\n    (0, 0, 0)\n    (1, 0, 0)\n    (0, 1, 0)\n  end vertexs\n"
    "  begin faces\n    (0, 1, 2)\n  end faces\nend mesh\n";

class FileActionsTest : public testing::Test {
 protected:
  FileActionsTest()
      : actions_(document_, window_),
        done_(&actions_, &FileActions::done),
        failed_(&actions_, &FileActions::failed) {
    QSettings().clear();
  }

  QString file(const std::string& name, const std::string& bytes = Triangle) {
    return QString::fromStdString(folder_.add(name, bytes));
  }
  QString path(const std::string& name) const { return QString::fromStdString(folder_.path(name)); }

  std::string read(const std::string& name) const {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QFile::ReadOnly));
    return file.readAll().toStdString();
  }

  void change() {
    FaceSelection all(document_.objects());
    all.select_all();
    document_.select(all);
    SurfaceEdit edit;
    edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(0.5F));
    document_.edit_surfaces("Colour", edit);
  }

  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return done_.count() + failed_.count() > 0; }, 20000));
  }

  test::TemporaryFolder folder_;
  QMainWindow window_;
  Document document_;
  FileActions actions_;
  QSignalSpy done_;
  QSignalSpy failed_;
};

TEST_F(FileActionsTest, OpenScenesAndRememberThem) {
  const QString first = file("first.grf");
  const QString second = file("second.grf");
  actions_.open(first);
  actions_.open(second);
  actions_.open(first);
  EXPECT_EQ(done_.count(), 3);
  EXPECT_EQ(document_.path(), first);
  EXPECT_EQ(recent_files(), QStringList({first, second}));
  QMenu menu;
  actions_.fill(menu);
  QMenu* recent = menu.actions()[2]->menu();
  ASSERT_NE(recent, nullptr);
  EXPECT_EQ(recent->actions()[1]->text(), "second.grf");
  recent->actions()[1]->trigger();
  EXPECT_EQ(document_.path(), second);
}

TEST_F(FileActionsTest, KeepTheSceneIfAnotherCannotBeOpened) {
  actions_.open(file("first.grf"));
  actions_.open(file("broken.grf", "begin mesh \"a\n"));
  EXPECT_EQ(document_.name(), "first.grf");
  ASSERT_EQ(failed_.count(), 1);
  EXPECT_THAT(failed_[0][0].toString().toStdString(), HasSubstr("broken.grf:1:"));
}

TEST_F(FileActionsTest, RevertToTheFileAfterAQuestion) {
  const QString first = file("first.grf");
  actions_.open(first);
  const grf::Scene saved = document_.scene();
  change();
  test::answer(QMessageBox::Cancel);
  actions_.revert();
  EXPECT_TRUE(document_.is_modified());
  test::answer(QMessageBox::Discard);
  actions_.revert();
  EXPECT_EQ(document_.scene(), saved);
  EXPECT_EQ(document_.path(), first);
  EXPECT_FALSE(document_.is_modified());
}

TEST_F(FileActionsTest, NeverReplaceUnaskedWhatAnotherProgramWrote) {
  for (const char* name : {"scene.grf", "part.grf", "scene.op"}) {
    file("part.grf");
    file("scene.op", "samples 7\n");
    actions_.open(file("scene.grf", "include \"part.grf\"\n"));
    change();
    const std::string theirs = std::string(name) == "scene.op" ? "samples 10000\n" : Triangle + Triangle;
    file(name, theirs);
    test::answer(QMessageBox::Cancel);
    actions_.save();
    EXPECT_TRUE(document_.is_modified()) << name;
    EXPECT_EQ(read(name), theirs);
    test::answer(QMessageBox::Save);
    actions_.save();
    EXPECT_FALSE(document_.is_modified()) << name;
  }
  EXPECT_NE(read("part.grf"), Triangle + Triangle) << "since the author said so";
}

TEST_F(FileActionsTest, TellWhatAnotherProgramWroteOnceItIsQuiet) {
  QSignalSpy found(&actions_.outside_changes(), &OutsideChanges::found);
  const QString scene = file("scene.grf");
  actions_.open(scene);
  change();
  actions_.save();  // is no other program
  EXPECT_FALSE(found.wait(500));
  file("scene.grf", Triangle + Triangle);
  ASSERT_TRUE(!found.empty() || found.wait(20'000));
  EXPECT_EQ(found[0][0].toStringList(), QStringList{scene});
  actions_.outside_changes().ignore();
  document_.undo_stack().undo();
  EXPECT_TRUE(document_.is_modified());
  actions_.save();  // without a question
  EXPECT_FALSE(document_.is_modified());
}

TEST_F(FileActionsTest, ImportModelsInAProcessOfTheirOwn) {
  actions_.open("/usr/share/glmark2/models/bunny.obj");
  EXPECT_TRUE(actions_.is_importing());
  wait();
  EXPECT_GT(document_.objects().faces, 0U);
  EXPECT_TRUE(document_.is_modified());
  EXPECT_EQ(document_.name(), "Untitled");
}

TEST_F(FileActionsTest, LiveOnWhenAnImportFails) {
  actions_.open(file("first.grf"));
  done_.clear();
  actions_.open(file("broken.obj", "f 1 2 3\n"));
  wait();
  EXPECT_EQ(failed_.count(), 1);
  EXPECT_EQ(document_.name(), "first.grf");
}

TEST_F(FileActionsTest, MergeInAsOneStepOfUndo) {
  actions_.open(file("first.grf"));
  actions_.merge(file("second.grf"));
  EXPECT_EQ(document_.objects().meshes.size(), 2U);
  done_.clear();
  actions_.merge("/usr/share/glmark2/models/bunny.obj");
  wait();
  EXPECT_EQ(document_.objects().meshes.size(), 3U);
  document_.undo_stack().undo();
  document_.undo_stack().undo();
  EXPECT_EQ(document_.objects().meshes.size(), 1U);
  EXPECT_FALSE(document_.is_modified());
}

TEST_F(FileActionsTest, AskBeforeWorkIsLost) {
  const QString first = file("first.grf");
  const QString second = file("second.grf");
  actions_.open(first);
  change();
  test::answer(QMessageBox::Cancel);
  actions_.open(second);
  EXPECT_EQ(document_.path(), first);
  test::answer(QMessageBox::Save);
  actions_.open(second);
  EXPECT_EQ(document_.path(), second);
  EXPECT_THAT(test::bytes_of(first.toStdString()), HasSubstr("rgb"));
  change();
  test::answer(QMessageBox::Discard);
  actions_.open(first);
  EXPECT_EQ(document_.path(), first);
  EXPECT_EQ(test::bytes_of(second.toStdString()), Triangle);
}

TEST_F(FileActionsTest, ExportThroughEveryWriter) {
  actions_.open(file("first.grf"));
  for (const char* name : {"out.obj", "out.ply", "out.gltf", "out.glb", "out.stl"}) {
    actions_.export_to(path(name));
    EXPECT_EQ(failed_.count(), 0) << failed_.value(0).value(0).toString().toStdString();
    EXPECT_NE(test::bytes_of(folder_.path(name)), "");
  }
  EXPECT_FALSE(document_.is_modified());
  actions_.export_to(path("out.3ds"));
  EXPECT_EQ(failed_.count(), 1);
}

TEST_F(FileActionsTest, HaveShortcutsAndTips) {
  QMenu menu;
  actions_.fill(menu);
  for (const QAction* action : menu.actions()) {
    if (action->isSeparator() || action->menu() != nullptr) continue;
    EXPECT_FALSE(action->shortcut().isEmpty()) << action->text().toStdString();
    EXPECT_NE(action->toolTip(), action->text());
  }
}

}  // namespace
}  // namespace editor
