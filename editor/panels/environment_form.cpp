#include "editor/panels/environment_form.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <cmath>
#include <limits>

#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/controls/scaled_slider.h"
#include "editor/document/document.h"
#include "editor/document/op_document.h"
#include "editor/panels/colour_fields.h"
#include "editor/panels/sky_dialog.h"
#include "renderer/image/image_file.h"

namespace editor {
namespace {

constexpr double MostEnvironmentRadiance = std::numeric_limits<float>::max();

enum EnvironmentRow { MapRow, SkyRow, RotationRow, BrightnessRow, BackgroundRow };

}  // namespace

QStringList bundled_environments() {
  const QDir folder(QCoreApplication::applicationDirPath() + "/../share/granada/environments");
  QStringList paths;
  for (const QFileInfo& file : folder.entryInfoList({"*.exr"}, QDir::Files, QDir::Name)) {
    paths.append(QDir::cleanPath(file.absoluteFilePath()));
  }
  return paths;
}

void set_environment(OpDocument& render_options, const QString& path, std::optional<double> brightness) {
  options::RenderOptions wanted = render_options.valid_options();
  wanted.environment = path.toStdString();
  wanted.projection = options::RenderOptions().projection;
  if (brightness) {
    wanted.environment_scale = static_cast<float>(*brightness);
    wanted.environment_rotation = 0;
  }
  render_options.set_options(
      path.isEmpty() ? EnvironmentForm::tr("Remove environment") : EnvironmentForm::tr("Set environment"),
      wanted);
}

EnvironmentForm::EnvironmentForm(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      render_options_(document.options()),
      maps_(narrow_list(tr("Environment map"),
                        tr("The image whose radiance surrounds the scene and lights it"), 8, this)),
      background_(new ColourFields(tr("Background"), tr("constant background radiance, W/(sr m²)"),
                                   MostEnvironmentRadiance, this)) {
  auto* layout = tight_layout<QGridLayout>(this);
  layout->setColumnStretch(1, 1);
  layout->addWidget(new QLabel(tr("Environment"), this), MapRow, 0);
  layout->addWidget(maps_, MapRow, 1, 1, 2);
  add_sky();
  add_rotation();
  add_brightness();
  layout->addWidget(new QLabel(tr("Background"), this), BackgroundRow, 0);
  layout->addWidget(background_, BackgroundRow, 1, 1, 2);
  connect(maps_, &QComboBox::activated, this, &EnvironmentForm::choose);
  connect(background_, &ColourFields::edited, this, [this](const grf::Colour& colour) {
    change(tr("Set background"), "background", [&](auto& wanted) { wanted.background = colour; });
  });
  connect(background_, &ColourFields::finished, &render_options_, &OpDocument::finish_step);
  connect(&render_options_, &OpDocument::changed, this, &EnvironmentForm::show_options);
  show_options();
}

void EnvironmentForm::add_rotation() {
  const QString name = tr("Rotation of the environment");
  const QString help =
      tr("Rotates the environment map about the vertical axis, counter-clockwise seen from above");
  rotation_ = number_box({name, help, -360, 360, 5, "deg"}, this);
  rotation_slider_ = new ScaledSlider(this);
  rotation_slider_->set_range(-180, 180, SliderScale::Linear);
  rotation_slider_->setAccessibleName(tr("Rotation of the environment, slider"));
  rotation_slider_->setToolTip(help);
  auto* layout = static_cast<QGridLayout*>(this->layout());
  layout->addWidget(new QLabel(tr("Rotation"), this), RotationRow, 0);
  layout->addWidget(rotation_slider_, RotationRow, 1);
  layout->addWidget(rotation_, RotationRow, 2);
  const auto rotate = [this](double degrees) {
    change(tr("Rotate environment"), "rotation",
           [&](auto& wanted) { wanted.environment_rotation = static_cast<float>(degrees); });
  };
  // A slider has no use for more digits than pixels.
  const auto rotate_roughly = [rotate](double degrees) { rotate(std::round(degrees)); };
  const auto finish = [this] { render_options_.finish_step(); };
  connect_number(rotation_, this, rotate, finish);
  connect(rotation_slider_, &ScaledSlider::changing, this, rotate_roughly);
  connect(rotation_slider_, &ScaledSlider::edited, this, [rotate_roughly, finish](double degrees) {
    rotate_roughly(degrees);
    finish();
  });
}

void EnvironmentForm::add_brightness() {
  brightness_ = number_box(
      {tr("Brightness of the environment"),
       tr("A factor of the radiance of the environment map or backplate"), 0, MostEnvironmentRadiance},
      this);
  brightness_->set_logarithmic(true);
  auto* layout = static_cast<QGridLayout*>(this->layout());
  layout->addWidget(new QLabel(tr("Brightness"), this), BrightnessRow, 0);
  layout->addWidget(brightness_, BrightnessRow, 2);
  connect_number(
      brightness_, this,
      [this](double factor) {
        change(tr("Set brightness of environment"), "brightness",
               [&](auto& wanted) { wanted.environment_scale = static_cast<float>(factor); });
      },
      [this] { render_options_.finish_step(); });
}

void EnvironmentForm::change(const QString& title, const QString& key, const Edit& edit) {
  options::RenderOptions wanted = render_options_.valid_options();
  edit(wanted);
  render_options_.set_options(title, wanted, key);
}

void EnvironmentForm::choose(int index) {
  const QVariant path = maps_->itemData(index);
  if (path.isValid()) return set_environment(render_options_, path.toString());
  show_options();
  QTimer::singleShot(0, this, &EnvironmentForm::choose_file);  // once the list is closed
}

void EnvironmentForm::choose_file() {
  const QString current = QString::fromStdString(render_options_.valid_options().environment);
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Choose an environment map"), current,
      tr("Images (%1);;All files (*)").arg(QString::fromStdString(image::readable_name_patterns())));
  if (!path.isEmpty()) set_environment(render_options_, path);
}

void EnvironmentForm::add_sky() {
  auto* button = new QPushButton(tr("Sky by place and time…"), this);
  button->setToolTip(tr("Make an environment map of the clear sky and the sun at a place and a time"));
  button->setAccessibleName(tr("Sky by place and time"));
  static_cast<QGridLayout*>(layout())->addWidget(button, SkyRow, 1, 1, 2);
  setTabOrder(maps_, button);  // before the background, which was made earlier
  connect(button, &QPushButton::clicked, this, &EnvironmentForm::make_sky);
}

void EnvironmentForm::make_sky() {
  if (!sky_) {
    sky_ = new SkyDialog(this);
    sky_->setAttribute(Qt::WA_DeleteOnClose);
    connect(sky_, &SkyDialog::file_wanted, this, [this] { sky_->set_file(sky_file()); });
    connect(sky_, &SkyDialog::made, this, [this](const QString& file, double brightness) {
      set_environment(render_options_, file, brightness);
    });
  }
  sky_->show();
  sky_->raise();
  sky_->activateWindow();
}

/// Returns a new file beside the scene, since undo goes back to the former one; asks where if the scene has
/// no file.
QString EnvironmentForm::sky_file() {
  const QFileInfo scene(document_.path());
  if (document_.path().isEmpty()) {
    return QFileDialog::getSaveFileName(sky_, tr("Save the sky"), "sky.exr", tr("OpenEXR (*.exr)"));
  }
  const QString base = scene.absoluteDir().filePath(scene.completeBaseName() + "-sky");
  QString file = base + ".exr";
  for (int number = 2; QFileInfo::exists(file); ++number) file = QString("%1-%2.exr").arg(base).arg(number);
  return file;
}

void EnvironmentForm::show_options() {
  const options::RenderOptions& shown = render_options_.valid_options();
  const QString current = QString::fromStdString(shown.environment);
  QStringList paths = bundled_;
  if (!current.isEmpty() && !paths.contains(current)) paths.append(current);
  const QSignalBlocker blocker(maps_);
  maps_->clear();
  maps_->addItem(tr("None: a constant background"), QString());
  for (const QString& path : paths) maps_->addItem(QFileInfo(path).completeBaseName(), path);
  maps_->addItem(tr("Choose a file…"));
  maps_->setCurrentIndex(current.isEmpty() ? 0 : maps_->findData(current));
  maps_->setToolTip(current.isEmpty() ? tr("The image whose radiance surrounds the scene and lights it")
                                      : current);
  const bool is_map = !current.isEmpty() && shown.projection != "backplate";
  auto& rows = *static_cast<QGridLayout*>(layout());
  show_row(rows, RotationRow, is_map);
  show_row(rows, BrightnessRow, !current.isEmpty());
  show_row(rows, BackgroundRow, current.isEmpty());
  rotation_->set_value(double(shown.environment_rotation));
  rotation_slider_->set_number(std::remainder(double(shown.environment_rotation), 360.0));
  brightness_->set_value(double(shown.environment_scale));
  background_->show_colour(shown.background);
}

}  // namespace editor
