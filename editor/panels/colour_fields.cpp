#include "editor/panels/colour_fields.h"

#include <QHBoxLayout>

#include "editor/controls/colour_button.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"

namespace editor {

ColourFields::ColourFields(const QString& name, const QString& help, double maximum, QWidget* parent)
    : QWidget(parent), button_(new ColourButton(this)) {
  auto* layout = tight_layout<QHBoxLayout>(this);
  button_->setAccessibleName(name);
  button_->setToolTip(tr("Choose a colour: %1").arg(help));
  layout->addWidget(button_);
  const std::array<QString, 3> names = {tr("red"), tr("green"), tr("blue")};
  for (int i = 0; i < 3; ++i) {
    const auto channel = static_cast<std::size_t>(i);
    channels_[channel] = number_box(
        {tr("%1, %2").arg(name, names[channel]), tr("%1: %2").arg(names[channel], help), 0, maximum}, this);
    layout->addWidget(channels_[channel], 1);
    connect_number(
        channels_[channel], this, [this, i](double number) { take(i, number); }, [this] { emit finished(); });
  }
  connect(button_, &ColourButton::changing, this, &ColourFields::take_colour);
  connect(button_, &ColourButton::edited, this, [this](const grf::Colour& colour) {
    take_colour(colour);
    emit finished();
  });
  show_blank({});
}

QWidget* ColourFields::field() const { return channels_.front(); }

void ColourFields::show_colour(const grf::Colour& colour) {
  colour_ = colour;
  button_->set_colour(colour);
  for (int i = 0; i < 3; ++i)
    channels_[static_cast<std::size_t>(i)]->set_value(static_cast<double>(colour[i]));
}

void ColourFields::show_blank(const QString& text) {
  colour_.reset();
  button_->set_colour(std::nullopt);
  for (NumberBox* channel : channels_) channel->set_blank(text);
}

// The first number typed into an empty colour is set for all channels.
void ColourFields::take(int channel, double number) {
  grf::Colour colour = colour_.value_or(grf::Colour(static_cast<float>(number)));
  colour[channel] = static_cast<float>(number);
  take_colour(colour);
}

void ColourFields::take_colour(const grf::Colour& colour) {
  show_colour(colour);
  emit edited(colour);
}

}  // namespace editor
