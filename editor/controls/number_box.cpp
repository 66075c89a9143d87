#include "editor/controls/number_box.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QStyleOptionSpinBox>
#include <QTextDocument>
#include <QTextDocumentFragment>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/appearance/theme.h"
#include "editor/controls/gesture.h"

namespace editor {
namespace {

constexpr double Endless = std::numeric_limits<float>::max();

/// Whether two numbers are equal up to float rounding.
bool are_alike(double a, double b) { return std::abs(a - b) <= 5e-7 * std::max(std::abs(a), std::abs(b)); }

/// The unit as it follows a number.
QString suffix_of(const QString& unit) {
  if (unit.isEmpty()) return {};
  return unit == "deg" ? QString(QChar(0xb0)) : " " + unit;
}

/// Whether a key may be a shortcut of the window; modifiers by themselves are not.
bool may_be_shortcut(const QKeyEvent& event) {
  const int key = event.key();
  if (key >= Qt::Key_F1 && key <= Qt::Key_F35) return true;
  if (key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_AltGr ||
      key == Qt::Key_Meta) {
    return false;
  }
  return (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
}

}  // namespace

NumberBox::NumberBox(QWidget* parent)
    : QAbstractSpinBox(parent), value_(0), minimum_(-Endless), maximum_(Endless) {
  setButtonSymbols(NoButtons);
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
  settling_.setSingleShot(true);
  settling_.setInterval(SettlingMilliseconds);
  connect(&settling_, &QTimer::timeout, this, &NumberBox::finish_steps);
  connect(lineEdit(), &QLineEdit::returnPressed, this, &NumberBox::commit);
  show_value();
}

void NumberBox::set_range(double minimum, double maximum) {
  minimum_ = std::abs(minimum) < Endless ? minimum / factor_ : minimum;
  maximum_ = std::abs(maximum) < Endless ? maximum / factor_ : maximum;
  show_state();
}

void NumberBox::set_unit(const QString& unit) {
  is_length_ = unit == "m";
  show_unit(unit);
}

void NumberBox::show_lengths_in(const QString& unit) {
  if (!is_length_ || unit == unit_) return;
  finish_steps();
  const double ratio = length_unit(unit) / length_unit(unit_);
  if (value_) value_ = *value_ / ratio;
  for (double* const end : {&minimum_, &maximum_}) {
    if (std::abs(*end) < Endless) *end /= ratio;
  }
  step_ /= ratio;
  factor_ = length_unit(unit);
  show_unit(unit);
}

void NumberBox::show_unit(const QString& unit) {
  unit_ = unit;
  units_ = units_like(unit);
  show_value();
}

void NumberBox::set_help(const QString& help) {
  help_ = help;
  show_state();
}

void NumberBox::set_whole(bool is_whole) {
  is_whole_ = is_whole;
  step_ = is_whole ? 1 : 0;
}

void NumberBox::set_default(const QString& text) {
  may_be_empty_ = true;
  lineEdit()->setPlaceholderText(text);
}

void NumberBox::set_blank(const QString& word) {
  settling_.stop();
  value_.reset();
  lineEdit()->setPlaceholderText(word);
  show_value();
}

void NumberBox::set_value(double number) {
  const double value = number / factor_;
  // Typed text and unfinished steps are kept when the same number is set again.
  if (value_ && are_alike(*value_, value)) {
    value_ = value;
    return;
  }
  settling_.stop();
  value_ = value;
  show_value();
}

void NumberBox::set_text(const QString& text) {
  if (text == full_text_) return;
  settling_.stop();
  value_ = value_of(text, units_).value;
  show_text(text);
}

void NumberBox::set_message(const QString& message) {
  if (message == message_) return;
  message_ = message;
  show_state();
}

QString NumberBox::text_of(double value) const {
  constexpr double AllDigits = 1e15;
  if (is_whole_ && value == std::round(value) && std::abs(value) < AllDigits)
    return QString::number(value, 'f', 0) + suffix_of(unit_);
  return number_text(value) + suffix_of(unit_);
}

void NumberBox::show_value() { show_text(value_ ? text_of(*value_) : QString()); }

void NumberBox::show_text(const QString& text) {
  full_text_ = text;
  shown_ = fitting_text();
  lineEdit()->setText(shown_);
  lineEdit()->setCursorPosition(0);
  message_.clear();
  show_state();
}

QString NumberBox::fitting_text() const {
  if (!value_ || is_whole_ || hasFocus()) return full_text_;
  constexpr int Margins = 2 * 2;  // of a line edit's text
  constexpr int Fewest = 3;
  const int room = lineEdit()->width() - Margins;
  QString text = full_text_;
  for (int digits = 6; digits >= Fewest && fontMetrics().horizontalAdvance(text) > room; --digits) {
    text = QString::number(*value_, 'g', digits) + suffix_of(unit_);
  }
  return text;
}

void NumberBox::fit() {
  if (lineEdit()->text() != shown_) return;
  shown_ = fitting_text();
  if (lineEdit()->text() == shown_) return;
  lineEdit()->setText(shown_);
  lineEdit()->setCursorPosition(0);
}

void NumberBox::show_state() {
  const ThemeColours colours = colours_of(theme_of(palette()));
  QPalette look = lineEdit()->palette();
  const QColor text = message_.isEmpty() ? colours.text : colours.error;
  if (look.color(QPalette::Text) != text) {
    look.setColor(QPalette::Text, text);
    lineEdit()->setPalette(look);
  }
  const QString tip = tip_text();
  setToolTip(tip);
  setAccessibleDescription(Qt::mightBeRichText(tip) ? QTextDocumentFragment::fromHtml(tip).toPlainText()
                                                    : tip);
}

QString NumberBox::tip_text() const {
  const bool is_rich = Qt::mightBeRichText(help_);
  QStringList parts;
  const auto add = [&](const QString& text) {
    if (!text.isEmpty()) parts.append(is_rich ? "<p>" + text.toHtmlEscaped() + "</p>" : text);
  };
  add(message_);
  if (!help_.isEmpty()) parts.append(help_);
  if (!help_.isEmpty() && (minimum_ > -Endless || maximum_ < Endless)) add(range_text());
  return parts.join(is_rich ? "" : "\n");
}

QString NumberBox::range_text() const {
  const auto end = [this](double number) { return std::abs(number) < Endless ? text_of(number) : tr("any"); };
  return tr("Range: %1 to %2").arg(end(minimum_), end(maximum_));
}

void NumberBox::commit() {
  if (lineEdit()->text() == shown_) return finish_steps();
  settling_.stop();
  if (may_be_empty_ && lineEdit()->text().trimmed().isEmpty()) {
    value_.reset();
    show_value();
    emit cleared();
  } else {
    take_typed();
  }
}

void NumberBox::take_typed() {
  const QString text = lineEdit()->text().trimmed();
  const Typed typed = value_of(text, units_);
  if (!typed.value) return refuse(typed.error);
  if (is_strict_ && (*typed.value < minimum_ || *typed.value > maximum_)) return refuse(range_text() + ".");
  const bool is_new = typed.value != value_;
  value_ = typed.value;
  bool is_literal = false;
  text.toDouble(&is_literal);
  // Digits beyond float precision are kept for the reader.
  show_text(is_literal && unit_.isEmpty() ? text : text_of(*value_));
  if (is_new) emit edited(value());
}

void NumberBox::refuse(const QString& reason) {
  set_message(reason);
  emit failed(reason);
}

void NumberBox::finish_steps() {
  if (!settling_.isActive() && sender() != &settling_) return;
  settling_.stop();
  if (value_) emit edited(value());
}

double NumberBox::step_from(double start) const {
  if (step_ > 0) return step_;
  const double range = maximum_ - minimum_;
  if (!is_logarithmic_ && range < 1e4) return std::pow(10, std::floor(std::log10(range) + 1e-9)) / 100;
  const double size = start == 0 ? 1e-3 : std::max(std::abs(start), 1e-6);
  return 0.1 * std::pow(10, std::floor(std::log10(size) + 1e-9));
}

void NumberBox::stepBy(int steps) {
  bool is_number = false;
  const double default_value = lineEdit()->placeholderText().toDouble(&is_number);
  const double start = value_.value_or(std::clamp(is_number ? default_value : 0.0, minimum_, maximum_));
  const double step = step_from(start);
  // Multiples of the step have few digits.
  const double next = std::round(start / step + steps) * step;
  value_ = std::clamp(next, minimum_, maximum_);
  show_value();
  emit changing(value());
  settling_.start();
}

QAbstractSpinBox::StepEnabled NumberBox::stepEnabled() const {
  return isReadOnly() ? StepNone : StepEnabled(StepUpEnabled | StepDownEnabled);
}

// A shortcut such as Save does not take the focus, but typed text has to be committed first. Keys that edit
// text are accepted by the line edit.
bool NumberBox::event(QEvent* event) {
  const bool is_known = QAbstractSpinBox::event(event);
  if (event->type() == QEvent::ShortcutOverride && !event->isAccepted() &&
      may_be_shortcut(static_cast<QKeyEvent&>(*event))) {
    commit();
  }
  return is_known;
}

void NumberBox::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && lineEdit()->text() != shown_) return show_text(full_text_);
  QAbstractSpinBox::keyPressEvent(event);
}

void NumberBox::focusOutEvent(QFocusEvent* event) {
  if (event->reason() != Qt::PopupFocusReason) commit();
  QAbstractSpinBox::focusOutEvent(event);
  fit();
}

// Shows all digits before the base class selects them.
void NumberBox::focusInEvent(QFocusEvent* event) {
  fit();
  QAbstractSpinBox::focusInEvent(event);
}

void NumberBox::resizeEvent(QResizeEvent* event) {
  QAbstractSpinBox::resizeEvent(event);
  fit();
}

void NumberBox::wheelEvent(QWheelEvent* event) {
  // Scrolling a form under the pointer must not change values.
  if (!hasFocus()) return event->ignore();
  QAbstractSpinBox::wheelEvent(event);
}

void NumberBox::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) show_state();
  QAbstractSpinBox::changeEvent(event);
}

QSize NumberBox::sizeHint() const {
  ensurePolished();
  QStyleOptionSpinBox option;
  initStyleOption(&option);
  const int width = fontMetrics().horizontalAdvance("0.00000000") + 2 * Grid;
  const QSize contents(width, lineEdit()->sizeHint().height());
  return style()->sizeFromContents(QStyle::CT_SpinBox, &option, contents, this);
}

QSize NumberBox::minimumSizeHint() const {
  return {fontMetrics().horizontalAdvance("0.0000") + 2 * Grid, sizeHint().height()};
}

}  // namespace editor
