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
#include <utility>

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

std::vector<std::size_t> checked_rows(const QListWidget& list) {
  std::vector<std::size_t> rows;
  for (int row = 0; row < list.count(); ++row) {
    if (list.item(row)->checkState() == Qt::Checked) rows.push_back(static_cast<std::size_t>(row));
  }
  return rows;
}

/// The texts of a dialog with a list whose checked rows are rendered.
struct ListTexts {
  QString title;
  QString name;  ///< accessible name of the list
  QString tip;
  QString accept_tip;
  QString none_checked;
};

/// Asks which rows of a list to render; at first all are checked. Returns nothing if it is cancelled.
std::optional<std::vector<std::size_t>> ask_for_rows(const ListTexts& texts,
                                                     const std::vector<std::pair<QString, QString>>& rows,
                                                     QWidget* parent) {
  FormDialog dialog(texts.title, parent);
  auto* list = new QListWidget(&dialog);
  list->setAccessibleName(texts.name);
  list->setToolTip(texts.tip);
  for (const auto& [text, tip] : rows) {
    auto* item = new QListWidgetItem(text, list);
    item->setToolTip(tip);
    item->setCheckState(Qt::Checked);
  }
  list->setCurrentRow(0);
  dialog.form().addRow(list);
  QObject::connect(list, &QListWidget::itemChanged, &dialog, [&] {
    enable(dialog.ok(), texts.accept_tip, checked_rows(*list).empty() ? texts.none_checked : QString());
  });
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  return checked_rows(*list);
}

}  // namespace

std::optional<std::vector<std::string>> ask_for_cameras(const RenderOptions& render_options,
                                                        QWidget* parent) {
  std::vector<std::pair<QString, QString>> rows = {{RenderPanel::tr("Render camera"), {}}};
  for (const options::NamedCamera& camera : render_options.cameras) {
    rows.emplace_back(QString::fromStdString(camera.name), QString());
  }
  const auto checked =
      ask_for_rows({RenderPanel::tr("Render cameras"), RenderPanel::tr("Cameras to render"),
                    RenderPanel::tr("Each checked camera becomes a job; Space checks one"),
                    RenderPanel::tr("Queue a render per camera"), RenderPanel::tr("No camera is checked")},
                   rows, parent);
  if (!checked) return std::nullopt;
  std::vector<std::string> names;
  for (const std::size_t row : *checked)
    names.push_back(row == 0 ? "" : render_options.cameras[row - 1].name);
  return names;
}

std::optional<std::vector<EffectRender>> ask_for_effects(const std::vector<EffectRender>& effects,
                                                         QWidget* parent) {
  std::vector<std::pair<QString, QString>> rows;
  for (const EffectRender& effect : effects) {
    rows.emplace_back(QString::fromStdString(effect.name), QString::fromStdString(effect.why));
  }
  const auto checked =
      ask_for_rows({RenderPanel::tr("Render effects separately"), RenderPanel::tr("Effects to render"),
                    RenderPanel::tr("Each checked effect becomes a job; Space checks one"),
                    RenderPanel::tr("Queue a render per effect"), RenderPanel::tr("No effect is checked")},
                   rows, parent);
  if (!checked) return std::nullopt;
  std::vector<EffectRender> chosen;
  for (const std::size_t row : *checked) chosen.push_back(effects[row]);
  return chosen;
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
