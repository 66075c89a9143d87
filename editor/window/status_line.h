#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <functional>

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;
class QWidget;

namespace editor {

class Document;

/// The line under the window: what is under the pointer, what the last action did, long work that can be
/// given up, and how much is selected.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  StatusLine(const Document& document, QStatusBar& bar);

  void tell(const QString& message);
  void show_hovered(const QString& text);
  /// Work that takes its time, 0..1 of it done or below 0 if that is not known, and how it is given up.
  void begin_work(const QString& what, const std::function<void()>& cancel);
  void show_done(double done);
  void end_work();
  QString message() const;

 private:
  void count();
  std::array<QWidget*, 3> work_parts() const;

  const Document& document_;
  QLabel* message_;
  QLabel* work_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  QLabel* counts_;
  QString told_;
  std::function<void()> cancelled_;
};

}  // namespace editor
