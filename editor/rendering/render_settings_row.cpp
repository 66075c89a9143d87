#include "editor/rendering/render_settings_row.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <cmath>
#include <limits>

#include "editor/appearance/theme.h"
#include "editor/controls/number_box.h"
#include "editor/controls/text.h"

namespace editor {
namespace {

using options::OptionInfo;
using options::RenderOptions;

QString help_of(const OptionInfo& option) {
  QString help = text_of(option.meaning);
  help[0] = help[0].toUpper();
  return RenderSettingsRow::tr("<p>%1.</p><p>Default: %2. In OP files: %3</p>")
      .arg(help.toHtmlEscaped(), text_of(option.default_value).toHtmlEscaped(), text_of(option.key));
}

/// The limit of the wheel, below that of the table: scrolling must not lead to gigapixels.
constexpr int LargestSide = 16384;

/// Shows a value, or a word for none. Text that is being typed is kept if the value is unchanged.
void put(NumberBox& box, std::optional<double> value, const QString& word) {
  if (value) {
    box.set_value(*value);
  } else if (box.has_value()) {
    box.set_blank(word);
  }
}

/// Empty if the option is not set.
std::optional<int> whole(double value) {
  return value > 0 ? std::optional(static_cast<int>(std::lround(value))) : std::nullopt;
}

std::optional<float> given(double value) {
  return value > 0 ? std::optional(static_cast<float>(value)) : std::nullopt;
}

void set_help(QWidget& control, const QString& help) { control.setToolTip(help); }

// The help includes the range.
void set_help(NumberBox& box, const QString& help) { box.set_help(help); }

}  // namespace

template <class Control>
Control* RenderSettingsRow::add(const QString& name, std::string_view key, int row, int column, int columns,
                                const QString& more) {
  const OptionInfo* option = options::find_option(key);
  Q_ASSERT(option != nullptr);
  auto* control = new Control(this);
  control->setAccessibleName(name);
  const QString help = help_of(*option) + more;
  set_help(*control, help);
  auto* label = new QLabel(name, this);
  label->setBuddy(control);
  label->setToolTip(help);
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
  width_ = add_number(tr("Width"), "BPT_Image_Resolution", 0, 0);
  height_ = add_number(tr("Height"), "BPT_Image_Resolution", 0, 1);
  samples_ = add_number(
      tr("Samples"), "BPT_Samples", 0, 2,
      tr("<p>auto: no sample limit if there is a target error or a time limit, otherwise the default.</p>"));
  depth_ = add_number(tr("Depth"), "BPT_Depth", 0, 3);
  scheme_ = add<QComboBox>(tr("Sampling scheme"), "BPT_Pdf_Name", 1, 0, 2);
  scheme_->addItem(tr("as in the scene"), QString());
  const auto& words = std::get<options::WordOption>(options::find_option("BPT_Pdf_Name")->value).words;
  for (const std::string_view word : words) scheme_->addItem(text_of(word), text_of(word));
  target_error_ = add_number(tr("Target error"), "BPT_TargetError", 1, 2);
  seconds_ = add_number(tr("Time limit"), "BPT_MaxTime", 1, 3);
  set_ranges();
  set_options({});
  connect_controls();
}

NumberBox* RenderSettingsRow::add_number(const QString& name, std::string_view key, int row, int column,
                                         const QString& more) {
  auto* box = add<NumberBox>(name, key, row, column, 1, more);
  box->set_strict(true);
  box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  return box;
}

std::vector<NumberBox*> RenderSettingsRow::numbers() const {
  return {width_, height_, samples_, depth_, target_error_, seconds_};
}

void RenderSettingsRow::set_ranges() {
  for (NumberBox* side : {width_, height_}) {
    side->set_range(1, LargestSide);
    side->set_unit(tr("px"));
  }
  for (NumberBox* count : {samples_, depth_}) count->set_range(0, std::numeric_limits<int>::max());
  for (NumberBox* box : {width_, height_, samples_, depth_}) box->set_whole(true);
  samples_->set_default(tr("auto"));
  target_error_->set_range(0, 100);
  target_error_->set_step(0.5);
  target_error_->set_unit("%");
  seconds_->set_range(0, 1e6);
  seconds_->set_step(1);
  seconds_->set_unit("s");
  for (NumberBox* limit : {target_error_, seconds_}) limit->set_default(tr("none"));
}

void RenderSettingsRow::connect_controls() {
  for (NumberBox* box : numbers()) {
    connect(box, &NumberBox::edited, this, &RenderSettingsRow::take);
    connect(box, &NumberBox::cleared, this, &RenderSettingsRow::take);
  }
  connect(scheme_, &QComboBox::currentIndexChanged, this, &RenderSettingsRow::take);
}

void RenderSettingsRow::commit() {
  for (NumberBox* box : numbers()) box->commit();
}

void RenderSettingsRow::set_options(const RenderOptions& render_options) {
  options_ = render_options;
  show_options();
}

void RenderSettingsRow::show_options() {
  is_showing_ = true;
  width_->set_value(options_.size.width);
  height_->set_value(options_.size.height);
  put(*samples_, options_.samples, tr("auto"));
  depth_->set_value(options_.depth);
  scheme_->setCurrentIndex(std::max(
      0, scheme_->findData(QString::fromStdString(options_.scheme), Qt::UserRole, Qt::MatchFixedString)));
  std::optional<double> target_error = options_.target_error;
  if (target_error) *target_error *= 100;
  put(*target_error_, target_error, tr("none"));
  put(*seconds_, options_.max_seconds, tr("none"));
  is_showing_ = false;
}

void RenderSettingsRow::take() {
  if (is_showing_) return;
  options_.size = {whole(width_->value()).value_or(1), whole(height_->value()).value_or(1)};
  options_.samples = whole(samples_->value());
  options_.depth = static_cast<int>(std::lround(depth_->value()));
  options_.scheme = scheme_->currentData().toString().toStdString();
  options_.target_error = given(target_error_->value() / 100);
  options_.max_seconds = given(seconds_->value());
  show_options();
  emit edited();
}

}  // namespace editor
