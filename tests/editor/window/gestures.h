// A user of a window works by pointer and keyboard; gestures are counted.
#pragma once

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <functional>
#include <stdexcept>

#include "editor/jobs/job_list.h"
#include "editor/view/screen_geometry.h"
#include "editor/window/import_dialog.h"
#include "tests/editor/window/window_driver.h"

namespace test {

/// A user of a window. A click, a double click, a drop, a key or chord, or a typed word is one gesture.
class Gestures {
 public:
  /// The window outlives the user.
  explicit Gestures(editor::MainWindow& window) : user_window_(window) {}

  int gestures() const { return gestures_; }

  void click(QWidget& widget, QPoint at, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(&widget, Qt::LeftButton, modifiers, at);
    ++gestures_;
  }
  void click(QWidget& widget) { click(widget, widget.rect().center()); }
  /// Clicks a point of the scene in the view.
  void click_view(const grf::Vec3d& point, Qt::KeyboardModifiers modifiers = {}) {
    click(user_window_.view(), pixel(point), modifiers);
  }
  void double_click(QWidget& widget, QPoint at) {
    QTest::mouseClick(&widget, Qt::LeftButton, {}, at);
    QTest::mouseDClick(&widget, Qt::LeftButton, {}, at);
    ++gestures_;
  }
  void press(QWidget& widget, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&widget, key, modifiers);
    ++gestures_;
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { press(user_window_, key, modifiers); }
  void type(QWidget& field, const QString& text) {
    QTest::keyClicks(&field, text);
    ++gestures_;
  }
  void drop(QWidget& widget, const QStringList& files, QPoint at, Qt::KeyboardModifiers modifiers = {}) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) urls.append(QUrl::fromLocalFile(file));
    data.setUrls(urls);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, modifiers);
    QApplication::sendEvent(&widget, &enter);
    QDropEvent event(QPointF(at), Qt::CopyAction, &data, Qt::LeftButton, modifiers);
    QApplication::sendEvent(&widget, &event);
    ++gestures_;
  }
  /// Drops models on the window, uses the dialog of their options and accepts it.
  void import(const QStringList& files, Qt::KeyboardModifiers modifiers = {},
              const std::function<void(editor::ImportDialog&)>& use = {}) {
    QTimer timer;
    bool is_used = false;
    timer.callOnTimeout([&] {
      auto* dialog = qobject_cast<editor::ImportDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || is_used) return;
      is_used = true;
      if (use) use(*dialog);
      press(*dialog, Qt::Key_Return);
    });
    timer.start(20);
    drop(user_window_, files, {9, 9}, modifiers);
    const bool is_closed =
        QTest::qWaitFor([&] { return is_used && QApplication::activeModalWidget() == nullptr; }, Minute);
    // The focus may be lost some time after the dialog where there is no window manager.
    QTest::qWait(200);
    const bool is_done =
        QTest::qWaitFor([this] { return user_window_.jobs().jobs().empty(); }, Minute) && is_drawn();
    user_window_.activateWindow();
    const bool is_active = QTest::qWaitForWindowActive(&user_window_);
    if (!is_closed || !is_done || !is_active) throw std::runtime_error("the model was not imported");
  }

  // Not gestures.

  bool is_drawn() {
    return QTest::qWaitFor([this] { return user_window_.view().is_complete(); }, Minute);
  }
  /// The pixel of the view at which a point of the scene is.
  QPoint pixel(const grf::Vec3d& point) {
    const auto at = editor::pixel_of(point, user_window_.view().camera(), user_window_.view().window_size());
    if (!at) throw std::runtime_error("a point is not in front of the eye");
    return {qRound(at->x), qRound(at->y)};
  }

 private:
  editor::MainWindow& user_window_;
  int gestures_ = 0;
};

}  // namespace test
