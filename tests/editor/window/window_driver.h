// A main window on the test's screen, and helpers that use it as a user does.
#pragma once

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <ctime>
#include <stdexcept>
#include <string>
#include <utility>

#include "editor/document/document.h"
#include "editor/view/scene_view.h"
#include "editor/window/main_window.h"
#include "tests/support/temporary_folder.h"

namespace test {

/// Timeout for slow operations, milliseconds.
inline constexpr int Minute = 60'000;
/// A model of 70,000 faces of the package glmark2-data.
inline const QString BunnyFile = "/usr/share/glmark2/models/bunny.obj";

/// The visible widget of a type with this accessible name.
template <class Widget>
Widget& named(const QWidget& where, const QString& name) {
  for (Widget* each : where.findChildren<Widget*>()) {
    if (each->accessibleName() == name && each->isVisible()) return *each;
  }
  throw std::runtime_error("no visible control is called " + name.toStdString());
}

/// The action of a window with this text, without mnemonics.
inline QAction& action(const QWidget& window, const QString& text) {
  for (QAction* each : window.findChildren<QAction*>()) {
    if (each->text().remove('&') == text) return *each;
  }
  throw std::runtime_error("no action is called " + text.toStdString());
}

/// The position of a visible face in the view.
inline QPoint place_of(const editor::SceneView& view, editor::FaceId face) {
  const editor::SceneObjects& objects = view.objects();
  const grf::Mesh& mesh = *objects.meshes[face.mesh].mesh;
  grf::Vec3d centre(0);
  const auto corners = mesh.face(face.face);
  for (const auto corner : corners)
    centre += grf::Vec3d(mesh.geometry->positions[corner]) / static_cast<double>(corners.size());
  for (const editor::MeshInstance& instance : *objects.instances) {
    if (instance.mesh != face.mesh) continue;
    const auto place =
        view.camera().place_of(centre * instance.to_world, static_cast<double>(view.width()) / view.height());
    if (place) {
      return {static_cast<int>((place->x + 1) / 2 * view.width()),
              static_cast<int>((1 - place->y) / 2 * view.height())};
    }
  }
  throw std::runtime_error("the face is not in front of the eye");
}

inline void drag(QWidget& widget, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
  QTest::mousePress(&widget, Qt::LeftButton, modifiers, from);
  QTest::mouseMove(&widget, (from + to) / 2);
  QTest::mouseMove(&widget, to);
  QTest::mouseRelease(&widget, Qt::LeftButton, modifiers, to);
}

/// Types a file name into the next dialog, in place of the one that it proposes, and waits until it is
/// closed. An empty name accepts the proposal.
class FileTyping {
 public:
  explicit FileTyping(const QString& file) {
    timer_.callOnTimeout([file] {
      const auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      auto* name = dialog == nullptr ? nullptr : dialog->findChild<QLineEdit*>("fileNameEdit");
      if (name == nullptr) return;
      // The first Return may only close the list of names that fit.
      if (file.isEmpty() || name->text() == file) {
        QTest::keyClick(name, Qt::Key_Return);
      } else {
        name->selectAll();
        QTest::keyClicks(name, file);
      }
    });
    timer_.start(50);
  }

 private:
  QTimer timer_;
};

/// Time of the processor that this thread used, milliseconds.
inline double processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

/// Measures how long the window was blocked, at most: the longest time between two turns of its event loop,
/// and the most time of the processor that its thread used in between, which other programs hardly affect.
class Watchdog : public QObject {
 public:
  struct Block {
    qint64 milliseconds = 0;
    double processor_milliseconds = 0;
  };

  Watchdog() {
    timer_.callOnTimeout(this, [this] {
      longest_.milliseconds = std::max(longest_.milliseconds, since_.restart());
      const double used = processor_time();
      longest_.processor_milliseconds =
          std::max(longest_.processor_milliseconds, used - std::exchange(used_, used));
    });
    since_.start();
    timer_.start(1);
  }
  /// The longest since the last call, once the event queue is empty.
  Block longest() {
    QTest::qWait(20);
    since_.restart();
    used_ = processor_time();
    return std::exchange(longest_, {});
  }

 private:
  QTimer timer_;
  QElapsedTimer since_;
  double used_ = processor_time();
  Block longest_;
};

}  // namespace test
