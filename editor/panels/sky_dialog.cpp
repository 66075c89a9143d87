#include "editor/panels/sky_dialog.h"

#include <QDateEdit>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTimeEdit>
#include <cmath>
#include <utility>

#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "grf/srgb.h"
#include "renderer/image/image_file.h"
#include "renderer/sky/daylight.h"

namespace editor {
namespace {

/// Texels of the picture and of the map.
constexpr int PictureWidth = 320;
constexpr int MapWidth = 1024;

/// The map as a picture in which a white horizontal surface would be bright, but not white.
QImage picture_of(const sky::SkyMap& map) {
  QImage picture(map.image.width, map.image.height, QImage::Format_RGB32);
  const auto gain = static_cast<float>(1.5 * map.brightness());
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const grf::Colour& radiance = map.image.at(x, y);
      const auto byte = [&](float value) {
        return static_cast<int>(std::lround(255 * grf::srgb_encoded(1 - std::exp(-gain * value))));
      };
      picture.setPixel(x, y, qRgb(byte(radiance.x), byte(radiance.y), byte(radiance.z)));
    }
  }
  return picture;
}

/// A field for a date or a time that Tab leaves at once: arrow keys go through its parts.
template <class Edit>
class OneStop : public Edit {
 public:
  using Edit::Edit;

 protected:
  bool focusNextPrevChild(bool is_next) override {
    // NOLINTNEXTLINE(bugprone-parent-virtual-call): the edit's own one goes through its parts.
    return QWidget::focusNextPrevChild(is_next);
  }
};

}  // namespace

SkyDialog::SkyDialog(QWidget* parent)
    : QDialog(parent), picture_(new QLabel(this)), summary_(new QLabel(this)) {
  setWindowTitle(tr("Sky by place and time"));
  auto* form = new QFormLayout(this);
  form->setContentsMargins(2 * Grid, 2 * Grid, 2 * Grid, 2 * Grid);
  form->setVerticalSpacing(Grid);
  picture_->setAccessibleName(tr("Picture of the sky"));
  picture_->setToolTip(tr("The environment map: its middle is toward -z, its right half toward +x"));
  picture_->setFixedSize(PictureWidth, PictureWidth / 2);
  form->addRow(picture_);
  latitude_ =
      add_number(*form, tr("Latitude"),
                 {tr("Latitude"), tr("Latitude of the place; north is positive"), -90, 90, 1, "deg"}, 37.18);
  longitude_ = add_number(
      *form, tr("Longitude"),
      {tr("Longitude"), tr("Longitude of the place; east is positive"), -180, 180, 1, "deg"}, -3.6);
  add_time(*form);
  utc_offset_ = add_number(
      *form, tr("Offset from UTC"),
      {tr("Offset from UTC"),
       tr("Hours that the local time is ahead of UTC; with daylight saving time one more"), -14, 14, 1},
      2);
  turbidity_ = add_number(*form, tr("Turbidity"),
                          {tr("Turbidity"), tr("Turbidity of the air, from clear, 2, to hazy, 6"),
                           sky::LeastTurbidity, sky::LargestTurbidity, 0.5},
                          3);
  north_ =
      add_number(*form, tr("Direction of north"),
                 {tr("Direction of north"),
                  tr("Direction of north from -z, counter-clockwise seen from above; with 0, east is +x"),
                  -360, 360, 5, "deg"},
                 0);
  summary_->setAccessibleName(tr("The sun and its light"));
  summary_->setWordWrap(true);
  summary_->setFixedWidth(PictureWidth);
  summary_->setMinimumHeight(summary_->fontMetrics().lineSpacing() * 4);  // translations are longer
  summary_->setAlignment(Qt::AlignTop);
  form->addRow(summary_);
  add_buttons(*form);
  load_place();
  update_picture();
}

NumberBox* SkyDialog::add_number(QFormLayout& form, const QString& label, const NumberInfo& info,
                                 double value) {
  NumberBox* box = number_box(info, this);
  box->set_value(value);
  form.addRow(label, box);
  connect(box, &NumberBox::changing, this, &SkyDialog::update_picture);
  connect(box, &NumberBox::edited, this, &SkyDialog::update_picture);
  return box;
}

/// Adds date and time after the place: Tab visits fields in the order in which they are made.
void SkyDialog::add_time(QFormLayout& form) {
  date_ = new OneStop<QDateEdit>(this);
  time_ = new OneStop<QTimeEdit>(this);
  date_->setDisplayFormat("yyyy-MM-dd");
  date_->setDateRange({1950, 1, 1}, {2050, 12, 31});
  date_->setDate({QDate::currentDate().year(), 6, 21});
  date_->setAccessibleName(tr("Date"));
  date_->setToolTip(tr("The day: year, month and day, from 1950 to 2050"));
  form.addRow(tr("Date"), date_);
  time_->setDisplayFormat("HH:mm");
  time_->setTime({12, 0});
  time_->setAccessibleName(tr("Local time"));
  time_->setToolTip(tr("The local time of the day"));
  form.addRow(tr("Local time"), time_);
  connect(date_, &QDateEdit::dateChanged, this, &SkyDialog::update_picture);
  connect(time_, &QTimeEdit::timeChanged, this, &SkyDialog::update_picture);
}

void SkyDialog::add_buttons(QFormLayout& form) {
  auto* buttons = new QDialogButtonBox(this);
  accept_ = buttons->addButton(tr("Set environment"), QDialogButtonBox::AcceptRole);
  accept_->setToolTip(tr("Write the map as OpenEXR, and light the scene by it"));
  QPushButton* cancel = buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  cancel->setToolTip(tr("Close without a map"));
  form.addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &SkyDialog::write);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

/// The last place and its time zone are likely to be wanted again.
void SkyDialog::load_place() {
  const QSettings stored;
  for (const auto& [key, box] : {std::pair("sky/latitude", latitude_), std::pair("sky/longitude", longitude_),
                                 std::pair("sky/utc_offset", utc_offset_)}) {
    if (stored.contains(key)) box->set_value(stored.value(key).toDouble());
  }
}

void SkyDialog::save_place() const {
  QSettings stored;
  stored.setValue("sky/latitude", latitude_->value());
  stored.setValue("sky/longitude", longitude_->value());
  stored.setValue("sky/utc_offset", utc_offset_->value());
}

sky::SkySettings SkyDialog::settings() const {
  sky::SkySettings settings;
  const QDate date = date_->date();
  settings.at = {latitude_->value(),  longitude_->value(), date.year(),
                 date.month(),        date.day(),          time_->time().msecsSinceStartOfDay() / 3.6e6,
                 utc_offset_->value()};
  settings.turbidity = turbidity_->value();
  settings.north = north_->value();
  settings.width = MapWidth;
  return settings;
}

void SkyDialog::update_picture() {
  sky::SkySettings small = settings();
  small.width = PictureWidth;
  previewing_.start(
      [small](const StopFlag&) {
        Preview preview = {{}, sky::problem_of(small)};
        if (preview.problem.empty()) preview.map = sky::sky_map(small);
        preview.map.sun = sky::sun_position(small.at);
        return preview;
      },
      [this](const Preview& preview) { show_preview(preview); });
}

void SkyDialog::show_preview(const Preview& preview) {
  accept_->setEnabled(preview.problem.empty());
  if (preview.map.sun.elevation <= 0) {
    picture_->clear();
    return summary_->setText(tr("The sun is %1° below the horizon: the model is one of the day.")
                                 .arg(-preview.map.sun.elevation, 0, 'f', 1));
  }
  if (!preview.problem.empty()) {
    picture_->clear();
    return summary_->setText(QString::fromStdString(preview.problem));
  }
  picture_->setPixmap(QPixmap::fromImage(picture_of(preview.map)));
  summary_->setText(
      tr("Sun: azimuth %1° from north over east, elevation %2°. Horizontal illuminance: %3 klux by the "
         "sun, %4 klux by the sky.")
          .arg(preview.map.sun.azimuth, 0, 'f', 1)
          .arg(preview.map.sun.elevation, 0, 'f', 1)
          .arg(preview.map.sun_illuminance, 0, 'f', 1)
          .arg(preview.map.sky_illuminance, 0, 'f', 1));
}

void SkyDialog::write() {
  const sky::SkySettings wanted = settings();
  if (!sky::problem_of(wanted).empty() || writing_.is_busy()) return;
  emit file_wanted();
  if (file_.isEmpty()) return;
  accept_->setEnabled(false);
  const auto work = [wanted, file = file_.toStdString()](const StopFlag&) {
    const sky::SkyMap map = sky::sky_map(wanted);
    grf::Diagnostics diagnostics;
    if (image::write_image({map.image}, file, diagnostics)) return Written{map.brightness(), {}};
    return Written{1, diagnostics.entries().front().message};
  };
  writing_.start(work, [this](const Written& written) {
    accept_->setEnabled(true);
    if (!written.problem.empty()) return summary_->setText(QString::fromStdString(written.problem));
    save_place();
    emit made(file_, written.brightness);
    accept();
  });
}

}  // namespace editor
