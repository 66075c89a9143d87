#include "editor/panels/lamp_form.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <limits>

#include "editor/appearance/icons.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/document/blackbody.h"
#include "editor/document/light_edits.h"
#include "editor/panels/colour_fields.h"

namespace editor {
namespace {

constexpr double LargestLampNumber = std::numeric_limits<float>::max();
constexpr double SmallestLampSize = 1e-6;

enum LampRow {
  PositionRow,
  DirectionRow,
  SizeRow,
  RadiusRow,
  RadianceRow,
  PowerRow,
  TemperatureRow,
  ButtonRow,
  EndRow
};

}  // namespace

struct LampForm::Field {
  NumberInfo info;
  double (*read)(const Lamp& lamp);
  void (*write)(Lamp& lamp, double number);
};

LampForm::LampForm(QWidget* parent) : QWidget(parent), layout_(tight_layout<QGridLayout>(this)) {
  layout_->setVerticalSpacing(Grid);
  add_placement();
  add_output();
  add_buttons();
  layout_->setRowStretch(EndRow, 1);
}

void LampForm::add_row(int row, const QString& label, const std::vector<Field>& fields) {
  layout_->addWidget(new QLabel(label, this), row, 0);
  int column = 1;
  for (const Field& field : fields) {
    NumberBox* box = number_box(field.info, this);
    layout_->addWidget(box, row, column++);
    boxes_.emplace_back(box, field.read);
    connect_number(
        box, this,
        [this, field](double number) {
          Lamp lamp = lamp_;
          field.write(lamp, number);
          change(lamp, tr("Set light: %1").arg(field.info.name), field.info.name);
        },
        [this] { emit finished(); });
  }
}

void LampForm::add_placement() {
  const double largest = LargestLampNumber;
  const QString centre = tr("centre of the light in world space");
  add_row(PositionRow, tr("Position"),
          {{{tr("Position, x"), tr("x: %1").arg(centre), -largest, largest, 0.1, "m"},
            [](const Lamp& lamp) { return lamp.centre.x; },
            [](Lamp& lamp, double number) { lamp.centre.x = number; }},
           {{tr("Position, y"), tr("y, upwards: %1").arg(centre), -largest, largest, 0.1, "m"},
            [](const Lamp& lamp) { return lamp.centre.y; },
            [](Lamp& lamp, double number) { lamp.centre.y = number; }},
           {{tr("Position, z"), tr("z: %1").arg(centre), -largest, largest, 0.1, "m"},
            [](const Lamp& lamp) { return lamp.centre.z; },
            [](Lamp& lamp, double number) { lamp.centre.z = number; }}});
  add_row(DirectionRow, tr("Direction"),
          {{{tr("Yaw"),
             tr("Yaw of the direction of emission about +y, counter-clockwise seen from above: 0 is toward "
                "-z, 90 toward -x"),
             -360, 360, 5, "deg"},
            [](const Lamp& lamp) { return lamp.yaw; },
            [](Lamp& lamp, double number) { lamp.yaw = number; }},
           {{tr("Elevation"),
             tr("Elevation of the direction of emission above the horizon: -90 is straight down, 90 straight "
                "up"),
             -90, 90, 5, "deg"},
            [](const Lamp& lamp) { return lamp.elevation; },
            [](Lamp& lamp, double number) { lamp.elevation = number; }},
           {{tr("Roll"), tr("Roll about the direction of emission; at 0 the width is horizontal"), -360, 360,
             5, "deg"},
            [](const Lamp& lamp) { return lamp.roll; },
            [](Lamp& lamp, double number) { lamp.roll = number; }}});
  add_row(SizeRow, tr("Size"),
          {{{tr("Width"), tr("Width of the rectangle, edge 1 of the area light"), SmallestLampSize, largest,
             0.1, "m"},
            [](const Lamp& lamp) { return lamp.width; },
            [](Lamp& lamp, double number) { lamp.width = number; }},
           {{tr("Height"), tr("Height of the rectangle, edge 2 of the area light"), SmallestLampSize, largest,
             0.1, "m"},
            [](const Lamp& lamp) { return lamp.height; },
            [](Lamp& lamp, double number) { lamp.height = number; }}});
  add_row(RadiusRow, tr("Radius"),
          {{{tr("Radius"), tr("Radius of disc or sphere"), SmallestLampSize, largest, 0.1, "m"},
            [](const Lamp& lamp) { return lamp.radius; },
            [](Lamp& lamp, double number) { lamp.radius = number; }}});
}

void LampForm::add_output() {
  radiance_ = new ColourFields(tr("Radiance"), tr("emitted radiance, W/(sr m²)"), LargestLampNumber, this);
  layout_->addWidget(new QLabel(tr("Radiance"), this), RadianceRow, 0);
  layout_->addWidget(radiance_, RadianceRow, 1, 1, 3);
  power_ = number_box({tr("Power"), tr("Emitted power: π × area × mean of the radiance's RGB values"), 0,
                       LargestLampNumber, 10, tr("W")},
                      this);
  temperature_ =
      number_box({tr("Colour temperature"),
                  tr("Colour temperature: sets the radiance to the colour of a black body, with the same "
                     "power. Candles have 1900 K, halogen lamps 3000 K, daylight 6500 K"),
                  LeastTemperature, LargestTemperature, 100, tr("K")},
                 this);
  layout_->addWidget(new QLabel(tr("Power"), this), PowerRow, 0);
  layout_->addWidget(power_, PowerRow, 1, 1, 3);
  layout_->addWidget(new QLabel(tr("Temperature"), this), TemperatureRow, 0);
  layout_->addWidget(temperature_, TemperatureRow, 1, 1, 3);
  connect(radiance_, &ColourFields::edited, this, [this](const grf::Colour& radiance) {
    Lamp lamp = lamp_;
    lamp.radiance = radiance;
    change(lamp, tr("Set light radiance"), "radiance");
  });
  connect(radiance_, &ColourFields::finished, this, &LampForm::finished);
  const auto finish = [this] { emit finished(); };
  const auto set_power = [this](double power) {
    Lamp lamp = lamp_;
    lamp.radiance = radiance_of(power, area_, lamp_.radiance);
    change(lamp, tr("Set light power"), "power");
  };
  connect_number(power_, this, set_power, finish);
  const auto set_temperature = [this](double kelvin) {
    Lamp lamp = lamp_;
    const double power = power_of(lamp_.radiance, area_);
    lamp.radiance = radiance_of(power, area_, grf::Colour(blackbody_colour(kelvin)));
    change(lamp, tr("Set light colour temperature"), "temperature");
  };
  connect_number(temperature_, this, set_temperature, finish);
}

void LampForm::add_buttons() {
  const auto button = [this](const QString& icon_name, const QString& text, const QString& tip) {
    auto* made = new QPushButton(icon(icon_name), text, this);
    made->setAccessibleName(text);
    made->setToolTip(tip);
    return made;
  };
  aim_ = button("pick", tr("Aim"),
                tr("Turn the light toward the point that is clicked next in the 3D view; Escape cancels"));
  highlight_ = button("light", tr("Highlight"),
                      tr("Place the light, at its distance, so that its reflection is where you click or "
                         "drag in the 3D view; Escape cancels"));
  layout_->addWidget(aim_, ButtonRow, 1);
  layout_->addWidget(highlight_, ButtonRow, 2, 1, 2);
  connect(aim_, &QPushButton::clicked, this, &LampForm::aim_requested);
  connect(highlight_, &QPushButton::clicked, this, &LampForm::highlight_requested);
}

void LampForm::show_lamp(const Lamp& lamp, double area) {
  lamp_ = lamp;
  area_ = area;
  for (const auto& [box, read] : boxes_) box->set_value(read(lamp));
  const bool is_rectangle = lamp.shape == LampShape::Rectangle;
  show_row(*layout_, PositionRow, true);
  show_row(*layout_, DirectionRow, lamp.shape != LampShape::Sphere);
  layout_->itemAtPosition(DirectionRow, 3)->widget()->setVisible(is_rectangle);
  show_row(*layout_, SizeRow, is_rectangle);
  show_row(*layout_, RadiusRow, !is_rectangle);
  show_row(*layout_, ButtonRow, true);
  aim_->setVisible(lamp.shape != LampShape::Sphere);
  show_radiance();
}

void LampForm::show_output(const grf::Colour& radiance, double area) {
  lamp_.radiance = radiance;
  area_ = area;
  for (const int row : {PositionRow, DirectionRow, SizeRow, RadiusRow, ButtonRow})
    show_row(*layout_, row, false);
  show_radiance();
}

void LampForm::show_radiance() {
  radiance_->show_colour(lamp_.radiance);
  power_->set_value(power_of(lamp_.radiance, area_));
  if (const auto kelvin = temperature_of(lamp_.radiance)) {
    temperature_->set_value(*kelvin);
  } else {
    temperature_->set_blank(tr("none"));  // no black body has this colour
  }
}

void LampForm::change(const Lamp& lamp, const QString& title, const QString& key) {
  emit edited(lamp, title, "light " + key);
}

}  // namespace editor
