#pragma once

#include <QWidget>
#include <map>

class QLabel;
class QVBoxLayout;

namespace editor {

class Job;
class JobList;
class JobRow;

/// Lists the running and queued jobs, each with its progress and a cancel button.
class JobPanel : public QWidget {
  Q_OBJECT

 public:
  /// The jobs outlive the panel.
  explicit JobPanel(const JobList& jobs, QWidget* parent = nullptr);

 private:
  void show_jobs();

  const JobList& jobs_;
  std::map<const Job*, JobRow*> rows_;
  QVBoxLayout* column_;
  QLabel* hint_;
};

}  // namespace editor
