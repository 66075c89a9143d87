#include "editor/window/status_line.h"

#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/counted.h"
#include "editor/document/document.h"

namespace editor {

StatusLine::StatusLine(const Document& document, QStatusBar& bar)
    : QObject(&bar),
      document_(document),
      message_(new QLabel(&bar)),
      work_(new QLabel(&bar)),
      progress_(new QProgressBar(&bar)),
      cancel_(new QToolButton(&bar)),
      counts_(new QLabel(&bar)) {
  message_->setAccessibleName(tr("Message"));
  message_->setContentsMargins(Grid, 0, 0, 0);
  // A long message is cut off, and does not widen the window.
  message_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  progress_->setFixedSize(12 * Grid, Grid);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Progress"));
  progress_->setToolTip(tr("How much of the work is done"));
  cancel_->setIcon(icon("stop"));
  cancel_->setText(tr("Stop"));
  cancel_->setAccessibleName(tr("Stop"));
  cancel_->setToolTip(tr("Gives this work up; the scene stays as it was"));
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
    if (cancelled_) cancelled_();
  });
  connect(&document_, &Document::selection_changed, this, &StatusLine::count);
  connect(&document_, &Document::changed, this, &StatusLine::count);
  end_work();
  count();
}

void StatusLine::count() {
  const SceneObjects& objects = document_.objects();
  counts_->setText(tr("%1 of %2 selected  ·  %3")
                       .arg(count_text(document_.selection().count()),
                            counted(objects.faces, tr("1 face"), tr("%1 faces")),
                            counted(objects.triangles, tr("1 triangle"), tr("%1 triangles"))));
}

void StatusLine::tell(const QString& message) {
  told_ = message;
  message_->setText(message);
  message_->setToolTip(message);
}

void StatusLine::show_hovered(const QString& text) { message_->setText(text.isEmpty() ? told_ : text); }

QString StatusLine::message() const { return told_; }

void StatusLine::begin_work(const QString& what, const std::function<void()>& cancel) {
  cancelled_ = cancel;
  work_->setText(what);
  show_done(-1);
  for (QWidget* part : work_parts()) part->show();
}

std::array<QWidget*, 3> StatusLine::work_parts() const { return {work_, progress_, cancel_}; }

void StatusLine::show_done(double done) {
  progress_->setRange(0, done < 0 ? 0 : 1000);  // without a range it moves to and fro
  if (done >= 0) progress_->setValue(static_cast<int>(1000 * done));
}

void StatusLine::end_work() {
  cancelled_ = {};
  for (QWidget* part : work_parts()) part->hide();
}

}  // namespace editor
