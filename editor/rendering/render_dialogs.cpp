#include "editor/rendering/render_dialogs.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/rendering/render_panel.h"

namespace editor {
namespace {

using options::RenderOptions;

constexpr double MostFrames = 100'000;

/// A dialog with a form and buttons below it, of which the first one says "Render".
class FormDialog : public QDialog {
 public:
  FormDialog(const QString& title, QWidget* parent)
      : QDialog(parent),
        form_(new QFormLayout),
        buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setWindowTitle(title);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(2 * Grid, 2 * Grid, 2 * Grid, 2 * Grid);
    rows->setSpacing(2 * Grid);
    rows->addLayout(form_);
    rows->addWidget(buttons_);
    ok()->setText(RenderPanel::tr("&Render"));
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  }

  QFormLayout& form() { return *form_; }
  QPushButton* ok() { return buttons_->button(QDialogButtonBox::Ok); }

 private:
  QFormLayout* form_;
  QDialogButtonBox* buttons_;
};

std::vector<std::string> checked_names(const QListWidget& list, const RenderOptions& render_options) {
  std::vector<std::string> names;
  for (int row = 0; row < list.count(); ++row) {
    if (list.item(row)->checkState() != Qt::Checked) continue;
    names.push_back(row == 0 ? "" : render_options.cameras[static_cast<std::size_t>(row - 1)].name);
  }
  return names;
}

}  // namespace

std::optional<std::vector<std::string>> ask_for_cameras(const RenderOptions& render_options,
                                                        QWidget* parent) {
  FormDialog dialog(RenderPanel::tr("Render cameras"), parent);
  auto* list = new QListWidget(&dialog);
  list->setAccessibleName(RenderPanel::tr("Cameras to render"));
  list->setToolTip(RenderPanel::tr("Each checked camera becomes a job; Space checks one"));
  list->addItem(RenderPanel::tr("Render camera"));
  for (const options::NamedCamera& camera : render_options.cameras) {
    list->addItem(QString::fromStdString(camera.name));
  }
  for (int row = 0; row < list->count(); ++row) list->item(row)->setCheckState(Qt::Checked);
  list->setCurrentRow(0);
  dialog.form().addRow(list);
  QObject::connect(list, &QListWidget::itemChanged, &dialog, [&] {
    enable(
        dialog.ok(), RenderPanel::tr("Queue a render per camera"),
        checked_names(*list, render_options).empty() ? RenderPanel::tr("No camera is checked") : QString());
  });
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  return checked_names(*list, render_options);
}

std::optional<RenderOptions> ask_for_animation(const RenderOptions& render_options, QWidget* parent) {
  FormDialog dialog(RenderPanel::tr("Render animation"), parent);
  NumberBox* frames = number_box(
      {RenderPanel::tr("Frames"), RenderPanel::tr("Number of images of the animation"), 2, MostFrames, 1, {}},
      &dialog);
  frames->set_whole(true);
  frames->set_value(std::max(2, render_options.frames));
  QComboBox* path = narrow_list(RenderPanel::tr("Camera path"),
                                RenderPanel::tr("How the camera moves from frame to frame"), 30, &dialog);
  path->addItem(RenderPanel::tr("Turntable about the look-at point"), "turntable");
  // A path leads from a named camera to another one.
  if (render_options.cameras.size() > 1) {
    path->addItem(RenderPanel::tr("Linear through the named cameras"), "linear");
    path->addItem(RenderPanel::tr("Smooth through the named cameras"), "smooth");
  }
  path->setCurrentIndex(std::max(0, path->findData(QString::fromStdString(render_options.camera_path))));
  dialog.form().addRow(RenderPanel::tr("&Frames"), frames);
  dialog.form().addRow(RenderPanel::tr("Camera &path"), path);
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  RenderOptions animation = render_options;
  animation.frames = static_cast<int>(std::lround(frames->value()));
  animation.frame = 0;
  animation.camera_path = path->currentData().toString().toStdString();
  return animation;
}

}  // namespace editor
