#pragma once

#include <QSettings>
#include <QSignalSpy>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "editor/window/file_actions.h"
#include "tests/editor/window/window_driver.h"

namespace editor {

/// A test fixture with an empty window on the screen, and a folder for its files.
class Authoring : public testing::Test {
 protected:
  Authoring() : window_(QString::fromStdString(folder_.path("sessions"))) {
    QSettings().clear();
    window_.show();
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
  }

  Document& document() { return window_.document(); }
  QString path(const std::string& name) const { return QString::fromStdString(folder_.path(name)); }

  void open(const QString& file) {
    QSignalSpy replaced(&document(), &Document::scene_replaced);
    window_.files().open(file);
    ASSERT_TRUE(!replaced.empty() || replaced.wait(test::Minute));
    ASSERT_TRUE(QTest::qWaitFor([this] { return window_.view().is_complete(); }, test::Minute));
  }

  bool are_jobs_done() {
    return QTest::qWaitFor([this] { return window_.jobs().jobs().empty(); }, test::Minute);
  }

  void select_two_faces() {
    const QPoint middle = window_.view().rect().center();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, middle);
    QTest::mouseClick(&window_.view(), Qt::LeftButton, Qt::ShiftModifier, middle + QPoint(12, 9));
  }

  std::size_t faces_where(const std::function<bool(const grf::Surface&)>& holds) {
    std::size_t count = 0;
    for (const MeshObject& object : document().objects().meshes) {
      for (std::size_t face = 0; face < object.mesh->face_count(); ++face) {
        if (holds(object.mesh->surface(face))) ++count;
      }
    }
    return count;
  }

  test::TemporaryFolder folder_;
  MainWindow window_;
};

}  // namespace editor
