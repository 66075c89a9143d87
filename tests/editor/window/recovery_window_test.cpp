// Tests that the editor recovers unsaved work after it is killed and restarted.
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/notice_bar.h"
#include "editor/document/model_import.h"
#include "editor/document/reimport.h"
#include "editor/window/file_actions.h"
#include "tests/editor/window/window_driver.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

using test::BunnyFile;
using test::Minute;

/// The program with settings and data in a separate folder.
class Program {
 public:
  explicit Program(const QString& home) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"}) {
      environment.insert(name, home);
    }
    process_.setProcessEnvironment(environment);
    process_.setProcessChannelMode(QProcess::ForwardedChannels);
  }

  bool start(const QString& file) {
    process_.start(GRANADA_BIN_DIR "/wannabe", {file});
    return process_.waitForStarted(Minute);
  }
  bool is_running() const { return process_.state() == QProcess::Running; }
  /// Sends SIGKILL.
  bool kill() {
    process_.kill();
    return process_.waitForFinished(Minute) && process_.exitStatus() == QProcess::CrashExit;
  }

 private:
  QProcess process_;
};

/// The folder of sessions if the program's data are in this folder.
QString sessions_in(const QString& home) {
  const QString here = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
  return home + Recovery::default_folder().mid(here.size());
}

/// Whether a session has a complete autosave: the record is written last.
bool has_kept_work(const QString& sessions) {
  for (const QString& session : QDir(sessions).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    if (QFile::exists(sessions + "/" + session + "/work.json")) return true;
  }
  return false;
}

grf::Scene imported(const QString& file, const QString& folder) {
  Document document;
  ModelImport import(folder);
  QObject::connect(&import, &ModelImport::done,
                   [&](const std::shared_ptr<const ImportedModel>& model) { document.take_import(*model); });
  QSignalSpy done(&import, &ModelImport::done);
  import.start(file);
  if (done.empty()) done.wait(Minute);
  grf::Scene scene = document.scene();
  mark_imported(scene, file);
  return scene;
}

TEST(RecoveryOfTheProgram, GivesBackWhatWasUnsavedWhenItDied) {
  const test::TemporaryFolder folder;
  const QString home = QString::fromStdString(folder.path("home"));
  ASSERT_TRUE(QDir().mkpath(home));
  const QString sessions = sessions_in(home);
  Program program(home);
  ASSERT_TRUE(program.start(BunnyFile));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !program.is_running() || has_kept_work(sessions); }, 2 * Minute));
  ASSERT_TRUE(program.is_running());
  ASSERT_TRUE(program.kill());

  QSettings().clear();
  MainWindow window(sessions);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  window.offer_lost_work();
  ASSERT_TRUE(window.notice().isVisible());
  EXPECT_THAT(window.notice().text().toStdString(), testing::HasSubstr("never saved"));
  QPushButton* recover = nullptr;
  for (QPushButton* button : window.notice().findChildren<QPushButton*>()) {
    if (button->text() == "Recover") recover = button;
  }
  ASSERT_NE(recover, nullptr);
  QTest::mouseClick(recover, Qt::LeftButton);
  const auto settle = [&] { return QTest::qWaitFor([&] { return window.jobs().jobs().empty(); }, Minute); };
  ASSERT_TRUE(settle());
  EXPECT_EQ(window.document().objects().faces, 69666U);
  EXPECT_TRUE(window.document().is_modified());
  EXPECT_TRUE(window.document().scene() ==
              imported(BunnyFile, QString::fromStdString(folder.path("imports"))));

  window.files().save_as(QString::fromStdString(folder.path("bunny.grf")));
  ASSERT_TRUE(settle());
  EXPECT_FALSE(window.document().is_modified());
  // The autosave of the killed session is removed once this session has its own.
  EXPECT_TRUE(QTest::qWaitFor([&] { return !has_kept_work(sessions); }, Minute));
  window.notice().hide();
  window.offer_lost_work();
  EXPECT_FALSE(window.notice().isVisible());
}

}  // namespace
}  // namespace editor
