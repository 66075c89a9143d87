#include "editor/window/status_line.h"

#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>
#include <algorithm>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/counted.h"
#include "editor/document/document.h"
#include "editor/jobs/job_list.h"

namespace editor {

StatusLine::StatusLine(const Document& document, const JobList& jobs, QStatusBar& bar)
    : QObject(&bar),
      document_(document),
      jobs_(jobs),
      message_(new QLabel(&bar)),
      work_(new QLabel(&bar)),
      progress_(new QProgressBar(&bar)),
      cancel_(new QToolButton(&bar)),
      counts_(new QLabel(&bar)) {
  message_->setAccessibleName(tr("Message"));
  message_->setContentsMargins(Grid, 0, 0, 0);
  // A long message is cut off instead of widening the window.
  message_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  progress_->setFixedSize(12 * Grid, Grid);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Progress"));
  progress_->setToolTip(tr("Progress of the job"));
  cancel_->setIcon(icon("stop"));
  cancel_->setText(tr("Cancel"));
  cancel_->setAccessibleName(tr("Cancel"));
  cancel_->setAutoRaise(true);
  counts_->setAccessibleName(tr("Counts"));
  counts_->setToolTip(tr("Selected faces, and triangles of the whole scene with all instances"));
  bar.setSizeGripEnabled(false);
  bar.addWidget(message_, 1);
  bar.addPermanentWidget(work_);
  bar.addPermanentWidget(progress_);
  bar.addPermanentWidget(cancel_);
  bar.addPermanentWidget(counts_);
  connect(cancel_, &QToolButton::clicked, this, [this] {
    if (job_) job_->cancel();
  });
  show_delay_.setSingleShot(true);
  show_delay_.setInterval(200);
  connect(&show_delay_, &QTimer::timeout, this, &StatusLine::show_job);
  connect(&jobs_, &JobList::changed, this, [this] {
    const bool is_idle = jobs_.jobs().empty();
    if (job_ || is_idle) return show_job();
    if (!show_delay_.isActive()) show_delay_.start();
  });
  connect(&document_, &Document::selection_changed, this, &StatusLine::count);
  connect(&document_, &Document::changed, this, &StatusLine::count);
  show_job();
  count();
}

void StatusLine::count() {
  const SceneObjects& objects = document_.objects();
  counts_->setText(tr("%1 of %2 selected  ·  %3")
                       .arg(count_text(document_.selection().count()),
                            counted(objects.faces, tr("1 face"), tr("%1 faces")),
                            counted(objects.triangles, tr("1 triangle"), tr("%1 triangles"))));
}

void StatusLine::show_status(const QString& message) {
  told_ = message;
  message_->setText(message);
  message_->setToolTip(message);
}

void StatusLine::show_hovered(const QString& text) { message_->setText(text.isEmpty() ? told_ : text); }

QString StatusLine::message() const { return told_; }

/// Shows the first running job, and the number of others.
void StatusLine::show_job() {
  const std::vector<Job*>& jobs = jobs_.jobs();
  const auto first =
      std::ranges::find_if(jobs, [](const Job* job) { return job->state() == Job::State::Running; });
  job_ = first == jobs.end() ? nullptr : *first;
  for (QWidget* part : std::initializer_list<QWidget*>{work_, progress_}) part->setVisible(job_ != nullptr);
  cancel_->setVisible(job_ && !job_->cancel_tip().isEmpty());
  if (!job_) return;
  work_->setText(jobs.size() == 1 ? job_->title() : tr("%1 (+%2)").arg(job_->title()).arg(jobs.size() - 1));
  cancel_->setToolTip(job_->cancel_tip());
  progress_->setRange(0, job_->done() < 0 ? 0 : 1000);  // without a range it is indeterminate
  if (job_->done() >= 0) progress_->setValue(static_cast<int>(1000 * job_->done()));
}

}  // namespace editor
