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
#include "editor/jobs/job_list.h"
#include "grf/read.h"
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
      : actions_(document_, jobs_, window_),
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

  /// Waits until no job is left.
  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return jobs_.jobs().empty(); }, 20000));
  }
  void open(const QString& file) {
    actions_.open(file);
    wait();
  }
  void save() {
    actions_.save();
    wait();
  }

  test::TemporaryFolder folder_;
  QMainWindow window_;
  Document document_;
  JobList jobs_;
  FileActions actions_;
  QSignalSpy done_;
  QSignalSpy failed_;
};

TEST_F(FileActionsTest, OpenScenesAndRememberThem) {
  const QString first = file("first.grf");
  const QString second = file("second.grf");
  open(first);
  open(second);
  open(first);
  EXPECT_EQ(done_.count(), 3);
  EXPECT_EQ(document_.path(), first);
  EXPECT_EQ(recent_files(), QStringList({first, second}));
  QMenu menu;
  actions_.fill(menu);
  QMenu* recent = menu.actions()[2]->menu();
  ASSERT_NE(recent, nullptr);
  EXPECT_EQ(recent->actions()[1]->text(), "second.grf");
  recent->actions()[1]->trigger();
  wait();
  EXPECT_EQ(document_.path(), second);
}

TEST_F(FileActionsTest, KeepTheSceneIfAnotherCannotBeOpened) {
  open(file("first.grf"));
  open(file("broken.grf", "begin mesh \"a\n"));
  EXPECT_EQ(document_.name(), "first.grf");
  ASSERT_EQ(failed_.count(), 1);
  EXPECT_THAT(failed_[0][0].toString().toStdString(), HasSubstr("broken.grf:1:"));
}

TEST_F(FileActionsTest, RevertToTheFileAfterAQuestion) {
  const QString first = file("first.grf");
  open(first);
  const grf::Scene saved = document_.scene();
  change();
  test::answer(QMessageBox::Cancel);
  actions_.revert();
  wait();
  EXPECT_TRUE(document_.is_modified());
  test::answer(QMessageBox::Discard);
  actions_.revert();
  wait();
  EXPECT_EQ(document_.scene(), saved);
  EXPECT_EQ(document_.path(), first);
  EXPECT_FALSE(document_.is_modified());
}

TEST_F(FileActionsTest, NeverReplaceUnaskedWhatAnotherProgramWrote) {
  for (const char* name : {"scene.grf", "part.grf", "scene.op"}) {
    file("part.grf");
    file("scene.op", "samples 7\n");
    open(file("scene.grf", "include \"part.grf\"\n"));
    change();
    const std::string theirs = std::string(name) == "scene.op" ? "samples 10000\n" : Triangle + Triangle;
    file(name, theirs);
    test::answer(QMessageBox::Cancel);
    save();
    EXPECT_TRUE(document_.is_modified()) << name;
    EXPECT_EQ(read(name), theirs);
    test::answer(QMessageBox::Save);
    save();
    EXPECT_FALSE(document_.is_modified()) << name;
  }
  EXPECT_NE(read("part.grf"), Triangle + Triangle) << "since the author said so";
}

TEST_F(FileActionsTest, TellWhatAnotherProgramWroteOnceItIsQuiet) {
  QSignalSpy found(&actions_.outside_changes(), &OutsideChanges::found);
  const QString scene = file("scene.grf");
  open(scene);
  change();
  save();  // is no other program
  EXPECT_FALSE(found.wait(500));
  file("scene.grf", Triangle + Triangle);
  ASSERT_TRUE(!found.empty() || found.wait(20'000));
  EXPECT_EQ(found[0][0].toStringList(), QStringList{scene});
  actions_.outside_changes().ignore();
  document_.undo_stack().undo();
  EXPECT_TRUE(document_.is_modified());
  save();  // without a question
  EXPECT_FALSE(document_.is_modified());
}

TEST_F(FileActionsTest, ImportModelsInAProcessOfTheirOwn) {
  actions_.open("/usr/share/glmark2/models/bunny.obj");
  EXPECT_TRUE(actions_.is_importing());
  EXPECT_EQ(jobs_.jobs().front()->title(), "Import bunny.obj");
  wait();
  EXPECT_GT(document_.objects().faces, 0U);
  EXPECT_TRUE(document_.is_modified());
  EXPECT_EQ(document_.name(), "Untitled");
}

TEST_F(FileActionsTest, LiveOnWhenAnImportFails) {
  open(file("first.grf"));
  done_.clear();
  open(file("broken.obj", "f 1 2 3\n"));
  wait();
  EXPECT_EQ(failed_.count(), 1);
  EXPECT_EQ(document_.name(), "first.grf");
}

TEST_F(FileActionsTest, MergeInAsOneStepOfUndo) {
  open(file("first.grf"));
  actions_.merge(file("second.grf"));
  wait();
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
  open(first);
  change();
  test::answer(QMessageBox::Cancel);
  open(second);
  EXPECT_EQ(document_.path(), first);
  test::answer(QMessageBox::Save);
  open(second);
  EXPECT_EQ(document_.path(), second);
  EXPECT_THAT(test::bytes_of(first.toStdString()), HasSubstr("rgb"));
  change();
  test::answer(QMessageBox::Discard);
  open(first);
  EXPECT_EQ(document_.path(), first);
  EXPECT_EQ(test::bytes_of(second.toStdString()), Triangle);
}

TEST_F(FileActionsTest, ExportThroughEveryWriter) {
  open(file("first.grf"));
  for (const char* name : {"out.obj", "out.ply", "out.gltf", "out.glb", "out.stl"}) {
    actions_.export_to(path(name));
    wait();
    EXPECT_EQ(failed_.count(), 0) << failed_.value(0).value(0).toString().toStdString();
    EXPECT_NE(test::bytes_of(folder_.path(name)), "");
  }
  EXPECT_FALSE(document_.is_modified());
  actions_.export_to(path("out.3ds"));
  EXPECT_EQ(failed_.count(), 1);
}

/// A mesh that is slow to write.
std::string large_mesh() {
  std::string text = "begin mesh \"a\"\n  begin vertexs\n";
  for (int i = 0; i < 100'000; ++i) text += "    (" + std::to_string(i) + ", 0.5, 0)\n";
  text += "  end vertexs\n  begin faces\n";
  for (int i = 0; i < 99'998; ++i) {
    text += "    (" + std::to_string(i) + ", " + std::to_string(i + 1) + ", " + std::to_string(i + 2) + ")\n";
  }
  return text + "  end faces\nend mesh\n";
}

TEST_F(FileActionsTest, SaveWhatWasThereAndNotWhatIsEditedMeanwhile) {
  open(file("scene.grf", large_mesh()));
  change();
  const grf::Scene asked_for = document_.scene();
  actions_.save();
  EXPECT_TRUE(actions_.is_saving()) << "the window goes on";
  document_.replace("Empty it", {});
  wait();
  EXPECT_TRUE(document_.is_modified()) << "what came later is not in the file";
  document_.undo_stack().undo();
  EXPECT_FALSE(document_.is_modified()) << "that is what was saved";
  grf::Diagnostics diagnostics;
  EXPECT_EQ(*grf::read(folder_.path("scene.grf"), diagnostics), asked_for);
}

TEST_F(FileActionsTest, SaveOneAfterAnother) {
  open(file("scene.grf", large_mesh()));
  change();
  actions_.save();
  document_.replace("Empty it", {});
  actions_.save_as(path("empty.grf"));
  wait();
  EXPECT_FALSE(document_.is_modified());
  EXPECT_EQ(document_.path(), path("empty.grf"));
  EXPECT_EQ(read("empty.grf"), "\n");
  EXPECT_THAT(read("scene.grf"), HasSubstr("rgb"));
}

TEST_F(FileActionsTest, OpenAnotherSceneOnceThisOneIsWritten) {
  const QString other = file("other.grf");
  open(file("scene.grf", large_mesh()));
  change();
  test::answer(QMessageBox::Save);
  actions_.open(other);
  actions_.merge(other);
  EXPECT_EQ(document_.name(), "scene.grf");
  ASSERT_TRUE(QTest::qWaitFor([this] { return document_.objects().meshes.size() == 2; }, 20000));
  EXPECT_EQ(document_.path(), other);
  EXPECT_THAT(read("scene.grf"), HasSubstr("rgb"));
}

TEST_F(FileActionsTest, AskWhereAnotherStateHasTheSameIndexOfUndo) {
  open(file("first.grf"));
  change();
  const QString second = file("second.grf");
  test::answer(QMessageBox::Discard);
  actions_.open(second);
  // During the read, one step is undone and another one made.
  document_.undo_stack().undo();
  document_.replace("Empty it", {});
  ASSERT_EQ(document_.undo_stack().index(), 1);
  test::answer(QMessageBox::Cancel);
  wait();
  EXPECT_EQ(document_.name(), "first.grf");
  EXPECT_TRUE(document_.scene().contents.blocks.empty());
}

TEST_F(FileActionsTest, NeverReplaceUnaskedFilesBesideAnotherName) {
  file("part.grf");
  open(file("scene.grf", "include \"part.grf\"\n"));
  change();
  file("part.grf", Triangle + Triangle);
  test::answer(QMessageBox::Cancel);
  actions_.save_as(path("other.grf"));
  wait();
  EXPECT_TRUE(document_.is_modified());
  EXPECT_EQ(read("part.grf"), Triangle + Triangle);
  EXPECT_FALSE(QFile::exists(path("other.grf")));
}

TEST_F(FileActionsTest, NeverReplaceUnaskedTheOptionsOfAnotherScene) {
  file("scene.op", "BPT_Samples 7\n");
  open(file("scene.grf"));
  const std::string theirs = "BPT_Samples 10000\n";
  file("other.op", theirs);
  test::answer(QMessageBox::Cancel);
  actions_.save_as(path("other.grf"));
  wait();
  EXPECT_EQ(read("other.op"), theirs);
  EXPECT_EQ(document_.name(), "scene.grf");
  test::answer(QMessageBox::Save);
  actions_.save_as(path("other.grf"));
  wait();
  EXPECT_EQ(document_.name(), "other.grf");
  EXPECT_THAT(read("other.op"), HasSubstr("BPT_Samples 7"));
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
