#include "editor/window/job_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/jobs/job_list.h"
#include "editor/rendering/render_report.h"

namespace editor {
namespace {

QString state_text(const Job& job) {
  if (job.state() == Job::State::Waiting) return JobPanel::tr("Waiting");
  if (job.done() < 0) return JobPanel::tr("Running");
  const QString percent = JobPanel::tr("%1 %").arg(100 * job.done(), 0, 'f', 0);
  return job.seconds_left() ? JobPanel::tr("%1 · %2 left").arg(percent, duration_text(*job.seconds_left()))
                            : percent;
}

}  // namespace

/// The row of one job.
class JobRow : public QWidget {
 public:
  JobRow(Job* job, QWidget* parent) : QWidget(parent), job_(job) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(Grid, 0, Grid, 0);
    row->setSpacing(Grid);
    title_->setText(job->title());
    title_->setToolTip(job->title());
    title_->setFixedWidth(40 * Grid);
    progress_->setFixedSize(20 * Grid, Grid);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(JobPanel::tr("Progress of %1").arg(job->title()));
    state_->setFixedWidth(20 * Grid);
    const auto cancel = [this] {
      if (job_) job_->cancel();
    };
    cancel_ = tool_button("stop", JobPanel::tr("Cancel"), {}, cancel, this);
    cancel_->setAccessibleName(JobPanel::tr("Cancel %1").arg(job->title()));
    for (QWidget* part : std::initializer_list<QWidget*>{title_, progress_, state_, cancel_}) {
      row->addWidget(part);
    }
    row->addStretch();
    show_job();
  }

  void show_job() {
    const bool is_known = job_->state() == Job::State::Waiting || job_->done() >= 0;
    progress_->setRange(0, is_known ? 1000 : 0);  // without a range it is indeterminate
    if (is_known) progress_->setValue(static_cast<int>(1000 * std::max(0.0, job_->done())));
    state_->setText(state_text(*job_));
    cancel_->setToolTip(job_->cancel_tip());
    cancel_->setEnabled(!job_->cancel_tip().isEmpty());
  }

 private:
  QPointer<Job> job_;
  QLabel* title_ = new QLabel(this);
  QProgressBar* progress_ = new QProgressBar(this);
  QLabel* state_ = new QLabel(this);
  QToolButton* cancel_;
};

JobPanel::JobPanel(const JobList& jobs, QWidget* parent)
    : QWidget(parent), jobs_(jobs), hint_(new QLabel(this)) {
  auto* list = new QWidget(this);
  column_ = new QVBoxLayout(list);
  column_->setContentsMargins(0, Grid, 0, Grid);
  column_->setSpacing(Grid / 2);
  hint_->setText(tr("No jobs are running. Imports, saves, renders and other long tasks appear here"));
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  column_->addWidget(hint_, 1);
  column_->addStretch();
  auto* area = new QScrollArea(this);
  area->setMinimumHeight(13 * Grid);
  area->setFrameStyle(QFrame::NoFrame);
  area->setAccessibleName(tr("Jobs"));
  area->setToolTip(tr("Running and queued jobs"));
  area->setWidgetResizable(true);
  area->setWidget(list);
  tight_layout<QVBoxLayout>(this)->addWidget(area);
  connect(&jobs_, &JobList::changed, this, &JobPanel::show_jobs);
  show_jobs();
}

void JobPanel::show_jobs() {
  const std::vector<Job*>& jobs = jobs_.jobs();
  std::erase_if(rows_, [&jobs](const auto& entry) {
    const bool is_gone = std::ranges::find(jobs, entry.first) == jobs.end();
    if (is_gone) entry.second->deleteLater();
    return is_gone;
  });
  for (Job* job : jobs) {
    JobRow*& row = rows_[job];
    if (row == nullptr) {
      row = new JobRow(job, this);
      column_->insertWidget(column_->count() - 1, row);
    }
    row->show_job();
  }
  hint_->setVisible(jobs.empty());
}

}  // namespace editor
