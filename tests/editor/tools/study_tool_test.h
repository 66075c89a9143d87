// A fixture for tests of a study tool in its window.
#pragma once

#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include "editor/controls/notice_bar.h"
#include "editor/controls/number_box.h"
#include "editor/tools/figure_view.h"
#include "editor/tools/study_window.h"
#include "tests/editor/pointer.h"
#include "tests/editor/window/window_driver.h"
#include "tests/support/temporary_folder.h"

namespace editor {

/// The window of a tool on the screen.
class StudyToolTest : public testing::Test {
 protected:
  explicit StudyToolTest(std::string_view tool) : window_(studies::study_tool(tool).value()) {
    window_.resize(1200, 720);
    window_.show();
  }
  void SetUp() override { ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_)); }

  bool is_done() {
    return QTest::qWaitFor([this] { return !window_.is_busy(); }, test::Minute);
  }
  void open(const QStringList& files) {
    window_.open(files);
    ASSERT_TRUE(is_done());
  }
  /// Replaces the state by that of a text.
  void set(const std::string& text) {
    ASSERT_TRUE(window_.read(QString::fromStdString(text), "a.study")) << notice();
    ASSERT_TRUE(is_done());
  }
  /// Types a number into the box of a setting.
  void type(const QString& setting, const QString& number) {
    auto& box = test::named<NumberBox>(window_, setting);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, number);
    QTest::keyClick(&box, Qt::Key_Return);
  }
  std::string notice() { return window_.notice().isVisible() ? window_.notice().text().toStdString() : ""; }
  double number(const QString& name) { return test::named<NumberBox>(window_, name).value(); }
  QString pointed() { return test::named<QLabel>(window_, "What is under the pointer").text(); }
  /// Moves the pointer to a position of the figure, in its own units, and returns the text of the status
  /// line.
  std::string pointed_at(const QPointF& at) {
    test::move_pointer(window_.figure(), window_.figure().in_widget(at));
    return pointed().toStdString();
  }
  std::string summary() { return window_.figure().accessibleDescription().toStdString(); }
  QString path(const std::string& name) const { return QString::fromStdString(folder_.path(name)); }
  /// Waits until a file is written, and returns the error message.
  QString message_of(const std::function<void()>& write) {
    QSignalSpy written(&window_, &StudyWindow::written);
    write();
    if (written.empty() && !written.wait(test::Minute)) return "nothing was written";
    return written.front().at(1).toString();
  }

  test::TemporaryFolder folder_;
  StudyWindow window_;
};

}  // namespace editor
