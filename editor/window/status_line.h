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

/// The line under the window: what is under the pointer, what the last action did, the job that runs, and how
/// much is selected.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  StatusLine(const Document& document, const JobList& jobs, QStatusBar& bar);

  void tell(const QString& message);
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
  QPointer<Job> job_;  ///< is shown
  QTimer patience_;    ///< what is done at once is not shown
};

}  // namespace editor
