#include "editor/document/recovery.h"

#include <QDir>
#include <QProcess>
#include <QSignalSpy>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "editor/document/import_folder.h"
#include "grf/read.h"
#include "grf/scene_path.h"
#include "grf/write.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::HasSubstr;

const std::string TriangleLists = R"(begin vertexs
    (0, 0, 0) (1, 0, 0) (0, 1, 0)
  end vertexs
  begin faces
    (0, 1, 2)
  end faces
)";

/// A scene with a texture, and an include with another texture in another folder.
class RecoveryTest : public testing::Test {
 protected:
  RecoveryTest() {
    folder_.add("scene/main.grf", "include \"../parts/part.grf\"\nbegin mesh \"a\"\n  texture \"a.png\"\n  " +
                                      TriangleLists + "end mesh\n");
    part_ = folder_.add("parts/part.grf",
                        "begin mesh \"b\"\n  texture \"b.png\"\n  " + TriangleLists + "end mesh\n");
    grf::Diagnostics diagnostics;
    const std::string path = folder_.path("scene/main.grf");
    auto scene = grf::read(path, diagnostics);
    if (!scene) throw std::runtime_error(diagnostics.to_text());
    document_.take(std::move(*scene), QString::fromStdString(path), diagnostics);
  }

  void rename(std::uint32_t mesh, const std::string& name) {
    grf::Scene scene = document_.scene();
    grf::find_mesh(scene, document_.objects().meshes[mesh].path)->edit().name = name;
    document_.replace("Rename", scene);
  }

  QString sessions() const { return QString::fromStdString(folder_.path("sessions")); }
  QString imports() const { return QString::fromStdString(folder_.path("imports")); }

  test::TemporaryFolder folder_;
  std::string part_;
  Document document_;
};

/// Timeout for a busy machine, milliseconds.
constexpr int Timeout = 30000;

const QString TexturedBox = "/usr/share/assimp/models/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb";

void wait_for(QSignalSpy& spy) { ASSERT_TRUE(spy.count() > 0 || spy.wait(Timeout)); }

TEST_F(RecoveryTest, KeepsNothingWhereNothingIsUnsaved) {
  const Recovery recovery(document_, sessions(), 0);
  EXPECT_FALSE(QDir(sessions()).exists());
  EXPECT_TRUE(recovery.lost_work().empty());
}

TEST_F(RecoveryTest, GivesBackWorkAfterTheProcessDied) {
  // A separate program: a fork would lack the threads of this one, and Qt would wait for them.
  QProcess session;
  session.start(GRANADA_BIN_DIR "/editing_session",
                {document_.path(), sessions(), imports(), "changed inside"});
  ASSERT_TRUE(session.waitForReadyRead(Timeout)) << session.readAllStandardError().toStdString();
  EXPECT_EQ(session.readAll().toStdString(), "kept\n");
  Document next;
  const Recovery recovery(next, sessions(), 0);
  EXPECT_TRUE(recovery.lost_work().empty()) << "its process still lives";
  session.kill();
  ASSERT_TRUE(session.waitForFinished(Timeout));
  rename(0, "changed inside");

  const auto lost = recovery.lost_work();
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].path, document_.path());
  EXPECT_LT(lost[0].saved.secsTo(QDateTime::currentDateTimeUtc()), 60);
  grf::Diagnostics diagnostics;
  const auto scene = Recovery::read(lost[0], diagnostics);
  ASSERT_TRUE(scene.has_value()) << diagnostics.to_text();
  EXPECT_EQ(*scene, document_.scene());
  EXPECT_THAT(test::bytes_of(part_), HasSubstr("\"b\"")) << "an included file was written";

  next.take(*scene, lost[0].path, {}, {}, true);
  EXPECT_TRUE(next.is_modified());
  ASSERT_TRUE(next.save(next.path(), diagnostics)) << diagnostics.to_text();
  EXPECT_THAT(test::bytes_of(part_), HasSubstr("changed inside"));
  Recovery::discard(lost[0]);
  EXPECT_TRUE(recovery.lost_work().empty());
}

TEST_F(RecoveryTest, GivesBackImagesThatStoodInsideAModel) {
  QProcess session;
  session.start(GRANADA_BIN_DIR "/editing_session", {TexturedBox, sessions(), imports(), "box"});
  ASSERT_TRUE(session.waitForReadyRead(Timeout)) << session.readAllStandardError().toStdString();
  const auto folders = [this] { return QDir(imports()).entryList(QDir::Dirs | QDir::NoDotAndDotDot); };
  ASSERT_EQ(folders().size(), 1);
  ImportFolder::remove_abandoned(imports(), {});
  EXPECT_EQ(folders().size(), 1) << "of a session that lives";
  session.kill();
  ASSERT_TRUE(session.waitForFinished(Timeout));
  Document next;
  const Recovery recovery(next, sessions(), 0);
  const auto lost = recovery.lost_work();
  ASSERT_EQ(lost.size(), 1U);
  ImportFolder::remove_abandoned(imports(), lost[0].imports);
  ASSERT_EQ(folders().size(), 1) << "since its work can be recovered";

  grf::Diagnostics diagnostics;
  auto scene = Recovery::read(lost[0], diagnostics);
  ASSERT_TRUE(scene.has_value()) << diagnostics.to_text();
  next.take(std::move(*scene), lost[0].path, {}, {}, true);
  for (const QString& folder : lost[0].imports) next.add_import(ImportFolder::adopt(folder));
  ImportFolder::remove_abandoned(imports(), {});
  ASSERT_EQ(folders().size(), 1) << "of this session now";
  const std::string image = next.objects().meshes[0].flat_surfaces.front().texture;
  const std::string bytes = test::bytes_of(image);
  EXPECT_GT(bytes.size(), 1000U);
  folder_.add("saved/other", "");
  ASSERT_TRUE(next.save(QString::fromStdString(folder_.path("saved/box.grf")), diagnostics));
  const std::string copy = next.objects().meshes[0].flat_surfaces.front().texture;
  EXPECT_THAT(copy, HasSubstr("/saved/"));
  EXPECT_EQ(test::bytes_of(copy), bytes);
  EXPECT_TRUE(QDir(imports()).isEmpty()) << "once the image is copied, nobody needs it there";
}

TEST_F(RecoveryTest, LeavesNoImportsOfSessionsThatKeptNothing) {
  folder_.add("imports/one/image.png", "");
  folder_.add("imports/one.lock", "");
  folder_.add("imports/two/image.png", "");
  ImportFolder::remove_abandoned(imports(), {imports() + "/two"});
  EXPECT_EQ(QDir(imports()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList("two"));
}

TEST_F(RecoveryTest, WritesNoIncludedFileAgainThatIsAsItWas) {
  Recovery recovery(document_, sessions(), 0);
  QSignalSpy kept(&recovery, &Recovery::kept);
  rename(1, "changed");
  wait_for(kept);
  const QString session = QDir(sessions()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).value(0);
  grf::Diagnostics diagnostics;
  const auto scene = Recovery::read({sessions() + "/" + session, document_.path(), {}, {}}, diagnostics);
  ASSERT_TRUE(scene.has_value());
  ASSERT_TRUE(grf::write(*scene, document_.path().toStdString(), diagnostics));
  EXPECT_EQ(diagnostics.to_text(), "") << "no note that an included file was written";
}

TEST_F(RecoveryTest, GivesBackHiddenAndNamedFaces) {
  Recovery recovery(document_, sessions(), 0);
  QSignalSpy kept(&recovery, &Recovery::kept);
  EditorState state = document_.editor_state();
  state.hidden.set({1, 0});
  state.face_sets.emplace("part", FaceSelection(document_.objects()));
  state.face_sets.at("part").set({0, 0});
  document_.set_editor_state(state);
  wait_for(kept);
  kept.clear();
  state.locked.set({0, 0});
  document_.set_editor_state(state);
  wait_for(kept);
  const QString session = QDir(sessions()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).value(0);
  const LostWork work = {sessions() + "/" + session, document_.path(), {}, {}};
  grf::Diagnostics diagnostics;
  const auto scene = Recovery::read(work, diagnostics);
  ASSERT_TRUE(scene.has_value());
  const SceneObjects objects = objects_of(*scene, document_.path().toStdString());
  const EditorState read = Recovery::read_state(work, objects, diagnostics);
  EXPECT_EQ(diagnostics.to_text(), "");
  EXPECT_EQ(read, state) << "also what was locked while the work was unsaved already";
  EXPECT_FALSE(QFile::exists(document_.path() + ".editor.json"))
      << "the file beside the scene is not written";
}

TEST_F(RecoveryTest, TakesNoWorkFromASessionThatLives) {
  Recovery recovery(document_, sessions(), 0);
  QSignalSpy kept(&recovery, &Recovery::kept);
  rename(1, "changed");
  wait_for(kept);
  Document other;
  EXPECT_TRUE(Recovery(other, sessions(), 0).lost_work().empty());
}

TEST_F(RecoveryTest, GivesBackWorkWhoseProcessIdIsUsedAgain) {
  // The lock of a crashed session, which names a live process: this one.
  QLockFile lock(QString::fromStdString(folder_.path("lock")));
  ASSERT_TRUE(lock.tryLock());
  const std::string words = test::bytes_of(lock.fileName().toStdString());
  ASSERT_NE(words, "");
  for (const std::string& left : {words, std::string()}) {
    folder_.add("sessions/one/lock", left);
    folder_.add("sessions/one/work.json", R"({"path": "a.grf"})");
    EXPECT_EQ(Recovery(document_, sessions(), 0).lost_work().size(), 1U) << "its lock says: " << left;
  }
}

TEST_F(RecoveryTest, LeavesNothingOnceAllIsSaved) {
  Recovery recovery(document_, sessions(), 0);
  QSignalSpy kept(&recovery, &Recovery::kept);
  rename(1, "changed");
  wait_for(kept);
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(document_.save(document_.path(), diagnostics));
  EXPECT_TRUE(QDir(sessions()).isEmpty());
}

TEST_F(RecoveryTest, SaysWhereWorkCannotBeKept) {
  folder_.add("file", "");
  Recovery recovery(document_, QString::fromStdString(folder_.path("file")), 0);
  QSignalSpy failed(&recovery, &Recovery::failed);
  rename(1, "changed");
  wait_for(failed);
}

}  // namespace
}  // namespace editor
