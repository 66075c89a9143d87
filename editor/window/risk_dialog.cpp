#include "editor/window/risk_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <utility>

#include "editor/controls/counted.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"
#include "editor/document/document.h"
#include "editor/document/risk_repair.h"
#include "editor/window/mesh_actions.h"

namespace editor {

RiskDialog::RiskDialog(Document& document, MeshActions& meshes, grf::Catalogue catalogue, QWidget* parent)
    : QDialog(parent),
      document_(document),
      meshes_(meshes),
      catalogue_(std::move(catalogue)),
      summary_(new QLabel(this)),
      list_(new QTreeWidget(this)),
      advice_(new QLabel(this)),
      finding_(new QLabel(this)) {
  constexpr int PauseMilliseconds = 300;  // edits of a gesture follow each other faster
  setWindowTitle(tr("Check the scene"));
  resize(90 * Grid, 40 * Grid);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * Grid, 2 * Grid, 2 * Grid, 2 * Grid);
  layout->setSpacing(Grid);
  summary_->setWordWrap(true);
  layout->addWidget(summary_);
  list_->setHeaderHidden(true);
  list_->setRootIsDecorated(false);
  list_->setAccessibleName(tr("Risks of the scene"));
  list_->setToolTip(tr("Select a risk to select its faces or its object"));
  layout->addWidget(list_, 1);
  advice_->setWordWrap(true);
  advice_->setAccessibleName(tr("What to do"));
  layout->addWidget(advice_);
  finding_->setWordWrap(true);
  finding_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  finding_->setAccessibleName(tr("Result of the search for values that are not finite"));
  finding_->hide();
  layout->addWidget(finding_);
  add_buttons();
  pause_.setSingleShot(true);
  pause_.setInterval(PauseMilliseconds);
  connect(&pause_, &QTimer::timeout, this, &RiskDialog::check);
  connect(&document_, &Document::changed, this, &RiskDialog::check_soon);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &RiskDialog::choose);
}

RiskDialog::~RiskDialog() { search_stop_.request_stop(); }

void RiskDialog::add_buttons() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  repair_ = buttons->addButton(tr("&Repair"), QDialogButtonBox::ActionRole);
  repair_->setToolTip(tr("Repair the selected risk, as one undo step"));
  repair_->setEnabled(false);
  connect(repair_, &QPushButton::clicked, this, &RiskDialog::repair);
  search_ = buttons->addButton(tr("&Find values that are not finite"), QDialogButtonBox::ActionRole);
  search_->setToolTip(
      tr("Render the scene in the background with 64 samples per pixel, and explain the first "
         "sample that is infinite or NaN"));
  connect(search_, &QPushButton::clicked, this, &RiskDialog::search_non_finite);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  layout()->addWidget(buttons);
}

void RiskDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  check();
}

void RiskDialog::check_soon() {
  repair_->setEnabled(false);
  if (isVisible()) pause_.start();
}

void RiskDialog::check() {
  pause_.stop();
  summary_->setText(tr("Checking the scene..."));
  check_.start([scene = document_.scene(),
                catalogue = catalogue_](const StopFlag&) { return convert::risks_of(scene, catalogue); },
               [this](std::vector<convert::Risk> risks) { show_risks(std::move(risks)); });
}

void RiskDialog::show_risks(std::vector<convert::Risk> risks) {
  const QSignalBlocker blocker(list_);
  risks_ = std::move(risks);
  list_->clear();
  for (const convert::Risk& risk : risks_) {
    QString message = text_of(risk.message);
    message[0] = message[0].toUpper();
    auto* item = new QTreeWidgetItem(list_, {message});
    item->setToolTip(0, message);
  }
  summary_->setText(risks_.empty()
                        ? tr("Nothing was found that can make the image wrong or noisy.")
                        : counted(risks_.size(), tr("1 risk was found."),
                                  tr("%1 risks were found. Those that change the image most come first.")));
  repair_->setEnabled(false);
  advice_->clear();
}

const convert::Risk* RiskDialog::current() const {
  const QList<QTreeWidgetItem*> selected = list_->selectedItems();
  if (selected.isEmpty() || !is_up_to_date()) return nullptr;
  return &risks_[static_cast<std::size_t>(list_->indexOfTopLevelItem(selected.front()))];
}

void RiskDialog::choose() {
  const convert::Risk* risk = current();
  repair_->setEnabled(risk != nullptr && has_repair(risk->kind));
  if (risk == nullptr) return advice_->clear();
  advice_->setText(text_of(info_of(risk->kind).advice));
  FaceSelection faces = faces_of(*risk, document_.objects());
  if (!faces.empty()) document_.select(std::move(faces));
  emit chosen(risk->path);
}

void RiskDialog::repair() {
  const convert::Risk* risk = current();
  if (risk == nullptr) return;
  const std::shared_ptr<const SceneObjects> objects = document_.shared_objects();
  const QString title = tr("Repair: %1").arg(text_of(info_of(risk->kind).title));
  meshes_.start(title, faces_of(*risk, *objects), [risk = *risk](const SelectedFaces& faces) {
    return repaired(faces.scene, faces.objects, risk).value_or(faces.scene);
  });
}

void RiskDialog::search_non_finite() {
  search_->setEnabled(false);
  show_or_hide(finding_, tr("Rendering..."));
  job::PreviewRequest request;
  request.scene = document_.scene();
  request.path = document_.path().toStdString();
  request.options = document_.options().valid_options();
  search_job_.start(
      [request = std::move(request), stop = search_stop_.get_token()](const StopFlag&) {
        grf::Diagnostics diagnostics;
        Search search;
        search.found = job::search_non_finite(request, stop, diagnostics);
        search.problem = text_of(diagnostics);
        return search;
      },
      [this](const Search& search) { show_search(search); });
}

void RiskDialog::show_search(const Search& search) {
  search_->setEnabled(true);
  if (!search.found) return show_or_hide(finding_, search.problem);
  if (search.found->rejected == 0) {
    return show_or_hide(finding_, tr("All %L1 samples are finite.").arg(search.found->samples));
  }
  show_or_hide(finding_, tr("%L1 of %L2 samples are not finite: %3.")
                             .arg(search.found->rejected)
                             .arg(search.found->samples)
                             .arg(text_of(search.found->cause)));
}

}  // namespace editor
