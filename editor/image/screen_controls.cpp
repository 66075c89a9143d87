#include "editor/image/screen_controls.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "editor/appearance/theme.h"
#include "editor/controls/number_box.h"

namespace editor {
namespace {

constexpr int MostStops = 16;
constexpr int StepsAStop = 10;
constexpr int FalseColourView = 5;  ///< behind those of the channels

void explain(QWidget* control, const QString& name, const QString& help) {
  control->setAccessibleName(name);
  control->setToolTip(help);
}

}  // namespace

ScreenControls::ScreenControls(QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal, this)),
      stops_(new NumberBox(this)),
      curve_(new QComboBox(this)),
      view_(new QComboBox(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(Grid / 2, 0, Grid / 2, 0);
  row->setSpacing(Grid);
  add_exposure();
  add_curve();
  add_view();
  // The controls stay together in a wide window.
  row->setStretchFactor(slider_, 3);
  row->addStretch(1);
}

template <class Edit>
void ScreenControls::change(const Edit& edit) {
  const ScreenSettings before = settings_;
  edit(settings_);
  if (settings_ == before) return;
  show_exposure();
  emit edited(settings_);
}

void ScreenControls::show_exposure() {
  const QSignalBlocker block_slider(slider_);
  slider_->setValue(static_cast<int>(std::lround(settings_.exposure * StepsAStop)));
  stops_->set_value(static_cast<double>(settings_.exposure));
}

void ScreenControls::set_settings(const ScreenSettings& settings) {
  settings_ = settings;
  show_exposure();
  const QSignalBlocker block_curve(curve_);
  const QSignalBlocker block_view(view_);
  curve_->setCurrentIndex(static_cast<int>(settings.curve));
  view_->setCurrentIndex(settings.colouring == Colouring::FalseColour ? FalseColourView
                                                                      : static_cast<int>(settings.channel));
}

void ScreenControls::add_exposure() {
  const QString help = tr("Exposure in stops: +1 doubles the brightness. Keys E and Shift+E.");
  slider_->setRange(-MostStops * StepsAStop, MostStops * StepsAStop);
  slider_->setPageStep(StepsAStop);
  slider_->setMinimumWidth(6 * Grid);
  slider_->setMaximumWidth(32 * Grid);
  stops_->set_range(-MostStops, MostStops);
  stops_->set_strict(true);
  stops_->set_step(0.5);
  stops_->set_value(0);
  stops_->set_help(help);
  stops_->setAccessibleName(tr("Exposure in stops"));
  stops_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  explain(slider_, tr("Exposure"), help);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int value) { set_exposure(static_cast<float>(value) / StepsAStop); });
  for (const auto signal : {&NumberBox::changing, &NumberBox::edited}) {
    connect(stops_, signal, this, [this](double value) { set_exposure(static_cast<float>(value)); });
  }
  auto* label = new QLabel(tr("Exposure"), this);
  label->setBuddy(stops_);
  layout()->addWidget(label);
  layout()->addWidget(slider_);
  layout()->addWidget(stops_);
}

void ScreenControls::add_curve() {
  curve_->addItems({tr("sRGB"), tr("Filmic"), tr("Reinhard")});
  explain(curve_, tr("Tone curve"),
          tr("Tone mapping of radiance for the screen. sRGB: as in 8-bit files, clipped at 1. Filmic: "
             "highlights roll off as on film. Reinhard: x / (1 + x), without clipping."));
  connect(curve_, &QComboBox::currentIndexChanged, this, [this](int index) {
    change([index](ScreenSettings& settings) { settings.curve = static_cast<ToneCurve>(index); });
  });
  layout()->addWidget(curve_);
}

void ScreenControls::add_view() {
  view_->addItems({tr("Colour"), tr("Red"), tr("Green"), tr("Blue"), tr("Luminance"), tr("False colour")});
  explain(view_, tr("Channels shown"),
          tr("Channels that are shown: all, one of them, the luminance in grey, or the luminance in false "
             "colours with a scale. Keys C, R, G, B, Y and P."));
  connect(view_, &QComboBox::currentIndexChanged, this, [this](int index) {
    const bool is_false = index == FalseColourView;
    change([is_false, index](ScreenSettings& settings) {
      settings.colouring = is_false ? Colouring::FalseColour : Colouring::Natural;
      settings.channel = is_false ? ImageChannel::Colour : static_cast<ImageChannel>(index);
    });
  });
  layout()->addWidget(view_);
}

void ScreenControls::set_exposure(float stops) {
  change([stops](ScreenSettings& settings) {
    settings.exposure = std::clamp(stops, float(-MostStops), float(MostStops));
  });
}

void ScreenControls::set_channel(ImageChannel channel) { view_->setCurrentIndex(static_cast<int>(channel)); }

void ScreenControls::set_false_colour(bool is_on) { view_->setCurrentIndex(is_on ? FalseColourView : 0); }

}  // namespace editor
