#include "editor/rendering/render_settings_row.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSpinBox>
#include <string>

#include "editor/appearance/theme.h"

namespace editor {
namespace {

using options::OptionInfo;
using options::RenderOptions;

QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString help_of(const OptionInfo& option) {
  QString help = text_of(option.meaning);
  help[0] = help[0].toUpper();
  return RenderSettingsRow::tr("<p>%1.</p><p>Default: %2. In OP files: %3</p>")
      .arg(help.toHtmlEscaped(), text_of(option.default_value).toHtmlEscaped(), text_of(option.key));
}

/// Most of a screen, not what the table allows: a wheel must not lead to gigapixels.
constexpr int LargestSide = 16384;

void set_up(QSpinBox& box) {
  box.setKeyboardTracking(false);
  box.setAccelerated(true);
}

void set_up(QDoubleSpinBox& box) {
  box.setKeyboardTracking(false);
  box.setSpecialValueText(RenderSettingsRow::tr("none"));
}

void set_up(QComboBox&) {}

}  // namespace

template <class Control>
Control* RenderSettingsRow::add(const QString& name, std::string_view key, int row, int column, int columns,
                                const QString& more) {
  const OptionInfo* option = options::find_option(key);
  Q_ASSERT(option != nullptr);
  auto* control = new Control(this);
  set_up(*control);
  control->setAccessibleName(name);
  control->setToolTip(help_of(*option) + more);
  auto* label = new QLabel(name, this);
  label->setBuddy(control);
  label->setToolTip(control->toolTip());
  // A label is nearer to its own control than to that above it.
  const int first = 3 * row;
  if (row > 0) layout_->setRowMinimumHeight(first - 1, Grid / 2);
  layout_->addWidget(label, first, column, 1, columns);
  layout_->addWidget(control, first + 1, column, 1, columns);
  return control;
}

RenderSettingsRow::RenderSettingsRow(QWidget* parent) : QWidget(parent), layout_(new QGridLayout(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setHorizontalSpacing(Grid);
  layout_->setVerticalSpacing(2);
  width_ = add<QSpinBox>(tr("Width"), "BPT_Image_Resolution", 0, 0);
  height_ = add<QSpinBox>(tr("Height"), "BPT_Image_Resolution", 0, 1);
  for (QSpinBox* side : {width_, height_}) {
    side->setRange(1, LargestSide);
    side->setSuffix(tr(" px"));
  }
  samples_ = add<QSpinBox>(tr("Samples"), "BPT_Samples", 0, 2, 1,
                           tr("<p>auto: as many as target error or time ask for, else the default.</p>"));
  samples_->setRange(0, std::numeric_limits<int>::max());
  samples_->setSpecialValueText(tr("auto"));
  depth_ = add<QSpinBox>(tr("Depth"), "BPT_Depth", 0, 3);
  depth_->setRange(0, std::numeric_limits<int>::max());
  scheme_ = add<QComboBox>(tr("Sampling scheme"), "BPT_Pdf_Name", 1, 0, 2);
  scheme_->addItem(tr("as in the scene"), QString());
  const auto& words = std::get<options::WordOption>(options::find_option("BPT_Pdf_Name")->value).words;
  for (const std::string_view word : words) scheme_->addItem(text_of(word), text_of(word));
  target_error_ = add<QDoubleSpinBox>(tr("Target error"), "BPT_TargetError", 1, 2);
  target_error_->setRange(0, 100);
  target_error_->setDecimals(2);
  target_error_->setSingleStep(0.5);
  target_error_->setSuffix(tr(" %"));
  seconds_ = add<QDoubleSpinBox>(tr("Time limit"), "BPT_MaxTime", 1, 3);
  seconds_->setRange(0, 1e6);
  seconds_->setDecimals(0);
  seconds_->setSuffix(tr(" s"));
  set_options({});
  connect_controls();
}

void RenderSettingsRow::connect_controls() {
  for (QSpinBox* box : {width_, height_, samples_, depth_}) {
    connect(box, &QSpinBox::valueChanged, this, &RenderSettingsRow::take);
  }
  for (QDoubleSpinBox* box : {target_error_, seconds_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, &RenderSettingsRow::take);
  }
  connect(scheme_, &QComboBox::currentIndexChanged, this, &RenderSettingsRow::take);
}

void RenderSettingsRow::set_options(const RenderOptions& render_options) {
  is_showing_ = true;
  options_ = render_options;
  width_->setValue(options_.size.width);
  height_->setValue(options_.size.height);
  samples_->setValue(options_.samples.value_or(0));
  depth_->setValue(options_.depth);
  scheme_->setCurrentIndex(std::max(
      0, scheme_->findData(QString::fromStdString(options_.name), Qt::UserRole, Qt::MatchFixedString)));
  target_error_->setValue(100 * static_cast<double>(options_.target_error.value_or(0)));
  seconds_->setValue(static_cast<double>(options_.max_seconds.value_or(0)));
  is_showing_ = false;
}

void RenderSettingsRow::take() {
  if (is_showing_) return;
  const auto given = [](double value) {
    return value > 0 ? std::optional(static_cast<float>(value)) : std::nullopt;
  };
  options_.size = {width_->value(), height_->value()};
  options_.samples = samples_->value() > 0 ? std::optional(samples_->value()) : std::nullopt;
  options_.depth = depth_->value();
  options_.name = scheme_->currentData().toString().toStdString();
  options_.target_error = given(target_error_->value() / 100);
  options_.max_seconds = given(seconds_->value());
  emit edited();
}

}  // namespace editor
