#include "editor/programs/bundled_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace editor {
namespace {

/// A folder that comes first in PATH.
class BundledProgram : public testing::Test {
 protected:
  void SetUp() override {
    path_ = qgetenv("PATH");
    qputenv("PATH", QFile::encodeName(folder_.path()) + ":" + path_);
  }
  void TearDown() override { qputenv("PATH", path_); }

  QString make_program(const QString& name, QFile::Permissions permissions) const {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QFile::WriteOnly));
    EXPECT_TRUE(file.setPermissions(permissions));
    return file.fileName();
  }

 private:
  QTemporaryDir folder_;
  QByteArray path_;
};

constexpr auto Executable = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;

TEST_F(BundledProgram, BesideThisOneComesFirst) {
  make_program("bpt", Executable);
  EXPECT_EQ(bundled_program("bpt"), QDir(QCoreApplication::applicationDirPath()).filePath("bpt"));
}

TEST_F(BundledProgram, IsElseInPath) {
  const QString made = make_program("made_for_this_test", Executable);
  EXPECT_EQ(bundled_program("made_for_this_test"), made);
}

TEST_F(BundledProgram, IsNoFileThatCannotBeRun) {
  make_program("made_for_this_test", QFile::ReadOwner | QFile::WriteOwner);
  EXPECT_EQ(bundled_program("made_for_this_test"), QString());
}

}  // namespace
}  // namespace editor
