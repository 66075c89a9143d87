#include "editor/panels/message_panel.h"

#include <QLabel>
#include <QListView>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/controls/counted.h"
#include "editor/controls/form_widgets.h"
#include "editor/document/definitions.h"
#include "editor/document/scene_places.h"
#include "editor/panels/message_list.h"

namespace editor {
namespace {

bool is_same(const grf::Diagnostic& a, const grf::Diagnostic& b) {
  const auto path = [](const grf::Diagnostic& each) {
    return each.location.file ? each.location.file->path : std::string();
  };
  return a.message == b.message && a.location.line == b.location.line &&
         a.location.column == b.location.column && path(a) == path(b);
}

}  // namespace

MessagePanel::MessagePanel(Document& document, grf::Catalogue catalogue, QWidget* parent)
    : QWidget(parent),
      document_(document),
      check_(document, std::move(catalogue)),
      of_file_(document.diagnostics()),
      model_(new MessageModel(this)),
      summary_(new QLabel(this)),
      pages_(new QStackedWidget(this)),
      view_(new QListView(pages_)) {
  setAccessibleName(tr("Messages"));
  view_->setModel(model_);
  view_->setItemDelegate(new MessageDelegate(view_));
  view_->setAccessibleName(tr("Messages about the scene"));
  view_->setFrameShape(QFrame::NoFrame);
  view_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view_->setResizeMode(QListView::Adjust);
  pages_->addWidget(hint_label(
      tr("The scene has no errors or warnings.\n\nProblems are listed here while you edit."), pages_));
  pages_->addWidget(view_);
  auto* layout = tight_layout<QVBoxLayout>(this, 0);
  summary_->setContentsMargins(Grid, Grid / 2, Grid, Grid / 2);
  layout->addWidget(summary_);
  layout->addWidget(pages_, 1);
  connect(&check_, &SceneCheck::checked, this, &MessagePanel::show_all);
  connect(&document_, &Document::path_changed, this, [this] { show_diagnostics(document_.diagnostics()); });
  connect(&document_, &Document::scene_replaced, this, [this] {
    of_display_ = {};
    show_all();
  });
  connect(view_, &QListView::activated, this, &MessagePanel::go_to);
  show_all();
}

void MessagePanel::show_diagnostics(const grf::Diagnostics& diagnostics) {
  of_file_ = diagnostics;
  show_all();
}

void MessagePanel::add_warning(const QString& message) {
  of_display_.warning({}, message.toStdString());
  show_all();
}

QSize MessagePanel::sizeHint() const { return {640, 200}; }

// The height of wrapped lines depends on the width.
void MessagePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  view_->doItemsLayout();
}

void MessagePanel::show_all() {
  std::vector<grf::Diagnostic> messages = of_file_.entries();
  const auto add = [&messages](const grf::Diagnostic& found) {
    const bool is_known = std::ranges::any_of(
        messages, [&found](const grf::Diagnostic& known) { return is_same(known, found); });
    if (!is_known) messages.push_back(found);
  };
  for (const grf::Diagnostic& found : check_.diagnostics().entries()) add(found);
  for (const grf::Diagnostic& found : of_display_.entries()) add(found);
  std::ranges::stable_sort(
      messages, [](const grf::Diagnostic& a, const grf::Diagnostic& b) { return a.severity > b.severity; });
  const auto count = [&messages](grf::Severity severity) {
    return static_cast<std::size_t>(std::ranges::count_if(
        messages, [severity](const grf::Diagnostic& each) { return each.severity == severity; }));
  };
  errors_ = count(grf::Severity::Error);
  warnings_ = count(grf::Severity::Warning);
  summary_->setText(QString("%1, %2").arg(counted(errors_, tr("1 error"), tr("%1 errors")),
                                          counted(warnings_, tr("1 warning"), tr("%1 warnings"))));
  summary_->setVisible(!messages.empty());
  pages_->setCurrentIndex(messages.empty() ? 0 : 1);
  model_->show_messages(std::move(messages));
  emit messages_changed();
}

void MessagePanel::go_to(const QModelIndex& index) {
  const grf::SourceLocation location = model_->message(index.row()).location;
  if (!location.file) return;
  if (const auto path = written_at(document_.scene(), location)) {
    FaceSelection faces = faces_with(document_.scene(), document_.objects(), *path);
    if (!faces.empty()) document_.select(std::move(faces));
    emit chosen(*path);
  }
  emit place_requested(location);
}

}  // namespace editor
