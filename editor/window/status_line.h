#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace editor {

class Document;
class Job;
class JobList;

/// The status line: what is under the pointer, the outcome of the last action, the running job, and the size
/// of the selection.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  StatusLine(const Document& document, const JobList& jobs, QStatusBar& bar);

  void show_status(const QString& message);
  void show_hovered(const QString& text);
  QString message() const;

 private:
  void count();
  void show_job();

  const Document& document_;
  const JobList& jobs_;
  QLabel* message_;
  QLabel* work_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  QLabel* counts_;
  QString told_;
  QPointer<Job> job_;  ///< the displayed one
  QTimer show_delay_;  ///< delays the display of a job, so that short ones are not shown
};

}  // namespace editor
