#include "editor/brdf/parameter_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QScopedValueRollback>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "editor/appearance/theme.h"
#include "editor/brdf/map_button.h"
#include "editor/controls/colour_button.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/controls/scaled_slider.h"
#include "editor/controls/text.h"
#include "editor/document/image_files.h"

namespace editor {
namespace {

using grf::ParameterKind;
using grf::Value;

bool are_equal(const std::vector<Value>& values) {
  return std::ranges::all_of(values, [&](const Value& one) { return one == values.front(); });
}

bool is_unbounded(const grf::ParameterInfo& parameter) { return parameter.minimum < -1e30F; }

/// The ends of the slider of a parameter, which may be unbounded.
double slider_end(const grf::ParameterInfo& parameter) {
  if (is_unbounded(parameter)) return 10 * std::max(1.0F, std::abs(parameter.default_value));
  return parameter.maximum < 1e30F ? parameter.maximum : 100 * std::max(1.0F, parameter.default_value);
}
double slider_start(const grf::ParameterInfo& parameter) {
  return is_unbounded(parameter) ? -slider_end(parameter) : parameter.minimum;
}

grf::Colour colour_of(const Value& value) {
  const auto* number = std::get_if<float>(&value);
  if (number != nullptr) return grf::Colour(*number);
  const auto* rgb = std::get_if<grf::Colour>(&value);
  return rgb != nullptr ? *rgb : grf::Colour(0);
}

constexpr std::array<const char*, 3> ChannelNames = {"red", "green", "blue"};

}  // namespace

ParameterRow::ParameterRow(const grf::ParameterInfo& parameter, bool takes_maps, QWidget* parent)
    : QWidget(parent), parameter_(parameter) {
  auto* row = tight_layout<QHBoxLayout>(this);
  name_ = new QLabel(text_of(parameter.name), this);
  name_->setToolTip(help_of(parameter));
  row->addWidget(name_);
  const bool is_number =
      parameter.kind == ParameterKind::Number || parameter.kind == ParameterKind::Reflectance;
  if (is_number) {
    add_number();
    if (parameter.kind == ParameterKind::Reflectance) add_colour();
  } else {
    add_choice();
  }
  if (is_number && takes_maps && !parameter.is_whole) add_map();
  add_reset();
}

NumberBox* ParameterRow::new_box(const QString& name) {
  auto* box = new NumberBox(this);
  box->set_range(slider_start(parameter_), slider_end(parameter_));
  box->set_logarithmic(parameter_.scale == grf::ParameterScale::Logarithmic);
  if (parameter_.is_whole) box->set_whole(true);
  box->set_unit(text_of(parameter_.unit));
  box->set_help(text_of(parameter_.help));
  box->setAccessibleName(name);
  layout()->addWidget(box);
  return box;
}

void ParameterRow::add_number() {
  const QString name = text_of(parameter_.name);
  slider_ = new ScaledSlider(this);
  slider_->set_range(
      slider_start(parameter_), slider_end(parameter_),
      parameter_.scale == grf::ParameterScale::Logarithmic ? SliderScale::Logarithmic : SliderScale::Linear);
  slider_->set_whole(parameter_.is_whole);
  slider_->setToolTip(help_of(parameter_));
  slider_->setAccessibleName(name);
  slider_->setMinimumWidth(3 * Grid);
  static_cast<QHBoxLayout*>(layout())->addWidget(slider_, 1);
  box_ = new_box(name);
  box_->setFixedWidth(10 * Grid);
  name_->setBuddy(box_);
  const auto as_value = [](double number) { return Value(static_cast<float>(number)); };
  for (const auto& [signal, done] :
       {std::pair(&ScaledSlider::changing, false), {&ScaledSlider::edited, true}}) {
    connect(slider_, signal, this, [this, as_value, is_done = done](double number) {
      box_->set_value(number);
      emit is_done ? edited(as_value(number)) : changing(as_value(number));
    });
  }
  for (const auto& [signal, done] : {std::pair(&NumberBox::changing, false), {&NumberBox::edited, true}}) {
    connect(box_, signal, this, [this, as_value, is_done = done](double number) {
      slider_->set_number(number);
      emit is_done ? edited(as_value(number)) : changing(as_value(number));
    });
  }
}

void ParameterRow::add_colour() {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    channels_[i] = new_box(text_of(parameter_.name) + ", " + ChannelNames[i]);
    channels_[i]->hide();
    channels_[i]->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(channels_[i], &NumberBox::changing, this,
            [this, i](double number) { report_channel(i, number, false); });
    connect(channels_[i], &NumberBox::edited, this,
            [this, i](double number) { report_channel(i, number, true); });
  }
  split_ = new QToolButton(this);
  split_->setText("RGB");
  split_->setCheckable(true);
  split_->setAutoRaise(true);
  split_->setToolTip(tr("One number for all channels, or one for each of red, green and blue (linear)"));
  split_->setAccessibleName(tr("%1 as RGB").arg(text_of(parameter_.name)));
  layout()->addWidget(split_);
  connect(split_, &QToolButton::clicked, this, &ParameterRow::split_channels);
  if (parameter_.minimum < 0 || parameter_.maximum > 1) return;
  colour_ = new ColourButton(this);
  colour_->setToolTip(tr("Choose a colour: the numbers are its linear red, green and blue"));
  colour_->setAccessibleName(tr("%1, colour").arg(text_of(parameter_.name)));
  layout()->addWidget(colour_);
  for (const auto& [signal, done] :
       {std::pair(&ColourButton::changing, false), {&ColourButton::edited, true}}) {
    connect(colour_, signal, this, [this, is_done = done](const grf::Colour& colour) {
      emit is_done ? edited(colour) : changing(colour);
    });
  }
}

void ParameterRow::add_choice() {
  const QString name = text_of(parameter_.name);
  if (parameter_.kind == ParameterKind::Boolean) {
    check_ = new QCheckBox(this);
    check_->setToolTip(help_of(parameter_));
    check_->setAccessibleName(name);
    static_cast<QHBoxLayout*>(layout())->addWidget(check_, 1);
    name_->setBuddy(check_);
    connect(check_, &QCheckBox::clicked, this, [this] {
      check_->setTristate(false);
      emit edited(check_->isChecked());
    });
    return;
  }
  words_ = new QComboBox(this);
  for (const std::string_view choice : parameter_.choices) words_->addItem(text_of(choice));
  words_->setPlaceholderText(tr("mixed"));
  words_->setToolTip(help_of(parameter_));
  words_->setAccessibleName(name);
  static_cast<QHBoxLayout*>(layout())->addWidget(words_, 1);
  name_->setBuddy(words_);
  connect(words_, &QComboBox::activated, this,
          [this] { emit edited(grf::Word{words_->currentText().toStdString()}); });
}

void ParameterRow::add_map() {
  map_ = new MapButton(parameter_, this);
  layout()->addWidget(map_);
  connect(map_, &MapButton::edited, this, &ParameterRow::map_edited);
  setAcceptDrops(true);
}

void ParameterRow::show_maps(const std::vector<std::optional<grf::ParameterMap>>& maps) {
  if (map_ != nullptr) map_->show_maps(maps);
}

void ParameterRow::dragEnterEvent(QDragEnterEvent* event) {
  const QStringList files = local_files(*event->mimeData());
  if (files.size() == 1 && is_image(files.front())) event->acceptProposedAction();
}

void ParameterRow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  map_->take(local_files(*event->mimeData()).front());
}

void ParameterRow::add_reset() {
  reset_ = tool_button(
      "reset", tr("%1, reset to default").arg(text_of(parameter_.name)), {}, [this] { emit reset(); }, this);
  layout()->addWidget(reset_);
}

void ParameterRow::show_values(const std::vector<Value>& values, bool is_default) {
  const QScopedValueRollback updating(is_updating_, true);
  enable(reset_, tr("Reset to the default"), is_default ? tr("Already at its default") : QString());
  if (check_ != nullptr) {
    const auto* flag = std::get_if<bool>(&values.front());
    check_->setTristate(!are_equal(values));
    check_->setCheckState(!are_equal(values)         ? Qt::PartiallyChecked
                          : flag != nullptr && *flag ? Qt::Checked
                                                     : Qt::Unchecked);
    check_->setText(are_equal(values) ? "" : tr("mixed"));
  } else if (words_ != nullptr) {
    words_->setCurrentIndex(
        are_equal(values) ? words_->findText(text_of(values.front()), Qt::MatchFixedString) : -1);
  } else if (parameter_.kind == ParameterKind::Reflectance) {
    show_colour(values);
  } else {
    show_number(values);
  }
}

void ParameterRow::show_number(const std::vector<Value>& values) {
  const auto* number = std::get_if<float>(&values.front());
  if (number == nullptr) return box_->set_mixed();
  // The range of a number without bounds grows with it.
  const double largest = 2.0 * std::abs(*number);
  if (is_unbounded(parameter_) && largest > slider_end(parameter_)) {
    slider_->set_range(-largest, largest, SliderScale::Linear);
    box_->set_range(-largest, largest);
  }
  slider_->set_number(*number);
  if (are_equal(values)) {
    box_->set_value(*number);
  } else {
    box_->set_mixed();
  }
}

void ParameterRow::show_colour(const std::vector<Value>& values) {
  const bool is_rgb =
      std::ranges::any_of(values, [](const Value& one) { return std::holds_alternative<grf::Colour>(one); });
  show_channels(is_rgb);
  rgb_ = colour_of(values.front());
  if (colour_ != nullptr) colour_->set_colour(are_equal(values) ? std::optional(rgb_) : std::nullopt);
  if (!is_rgb) return show_number(values);
  for (int i = 0; i < 3; ++i) {
    const bool is_same =
        std::ranges::all_of(values, [&](const Value& one) { return colour_of(one)[i] == rgb_[i]; });
    NumberBox* box = channels_[static_cast<std::size_t>(i)];
    if (is_same) {
      box->set_value(rgb_[i]);
    } else {
      box->set_mixed();
    }
  }
}

void ParameterRow::show_channels(bool are_shown) {
  split_->setChecked(are_shown);
  slider_->setVisible(!are_shown);
  box_->setVisible(!are_shown);
  for (NumberBox* box : channels_) box->setVisible(are_shown);
  name_->setBuddy(are_shown ? channels_[0] : box_);
}

void ParameterRow::split_channels(bool into_three) {
  if (into_three) {
    emit edited(rgb_);
  } else {
    emit edited((rgb_.x + rgb_.y + rgb_.z) / 3);
  }
}

void ParameterRow::report_channel(std::size_t channel, double number, bool is_done) {
  if (is_updating_) return;
  rgb_[static_cast<int>(channel)] = static_cast<float>(number);
  emit is_done ? edited(rgb_) : changing(rgb_);
}

void ParameterRow::set_message(const QString& message) {
  if (box_ != nullptr) box_->set_message(message);
  for (NumberBox* box : channels_) {
    if (box != nullptr) box->set_message(message);
  }
}

void ParameterRow::set_name_width(int width) { name_->setFixedWidth(width); }
int ParameterRow::name_width() const { return name_->sizeHint().width(); }

}  // namespace editor
