#pragma once

#include <QAbstractSpinBox>
#include <QTimer>
#include <optional>
#include <vector>

#include "editor/controls/expression.h"

namespace editor {

/// A spin box for numbers, typed as arithmetic with units (`0.2*3`, `20deg`), or changed by arrow keys and
/// wheel in steps of one digit. Invalid text stays in the box, marked, with the reason in its tool tip and by
/// `failed`, until it is corrected or Escape restores the last number. Typed text is committed by Return,
/// loss of focus, or a shortcut that does not edit text.
///
/// The range limits only steps: a number outside is accepted, since the owner can report it better, unless
/// the box is strict.
class NumberBox : public QAbstractSpinBox {
  Q_OBJECT
  Q_PROPERTY(double value READ value)

 public:
  explicit NumberBox(QWidget* parent = nullptr);

  void set_range(double minimum, double maximum);
  /// Sets the unit of `value`, shown as a suffix and accepted in typed text.
  void set_unit(const QString& unit);
  /// Shows a box whose unit is the metre in another unit of length; its values stay in metres. Other boxes
  /// stay as they are.
  void show_lengths_in(const QString& unit);
  /// Makes typed numbers outside of the range invalid.
  void set_strict(bool is_strict) { is_strict_ = is_strict; }
  /// Makes each step change the second significant digit, instead of a hundredth of the range.
  void set_logarithmic(bool is_logarithmic) { is_logarithmic_ = is_logarithmic; }
  /// Sets the increment of a step.
  void set_step(double step) { step_ = step; }
  /// Makes the numbers integers: steps of 1, and all digits are shown.
  void set_whole(bool is_whole);
  /// Allows an empty box, which means this default; if that is a number, steps begin there. See `cleared`.
  void set_default(const QString& text);
  /// Sets the help text, perhaps rich text, to which the box adds range and unit. Without it the owner sets
  /// the tool tip, except for errors. See also set_message.
  void set_help(const QString& help);

  /// Shows a word in place of a value, until the user types. Without a signal.
  void set_blank(const QString& word);
  /// Shows that several values differ.
  void set_mixed() { set_blank(tr("mixed")); }
  bool has_value() const { return value_.has_value(); }
  /// Sets the value, without a signal.
  void set_value(double number);
  double value() const { return value_.value_or(0) * factor_; }
  /// Sets a number as text, such as `1e3`, which is kept until it is edited; empty for none. Invalid text is
  /// shown, too. Without a signal.
  void set_text(const QString& text);
  /// The number as text with its unit: as it was set or typed, or with up to seven digits. A narrow box
  /// without the focus shows fewer digits.
  QString full_text() const { return full_text_; }
  /// Commits typed text, as the Return key does.
  void commit();

  /// Marks the box as invalid with a reason; empty clears the mark.
  void set_message(const QString& message);
  QString message() const { return message_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void changing(double value);         ///< while stepping
  void edited(double value);           ///< once, when editing is finished
  void cleared();                      ///< emptied, if it has a default
  void failed(const QString& reason);  ///< typed text is invalid

 protected:
  bool event(QEvent* event) override;
  void stepBy(int steps) override;
  StepEnabled stepEnabled() const override;
  QValidator::State validate(QString&, int&) const override { return QValidator::Acceptable; }
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void show_unit(const QString& unit);
  void take_typed();
  void refuse(const QString& reason);
  void finish_steps();
  double step_from(double start) const;
  QString text_of(double value) const;
  QString range_text() const;
  QString tip_text() const;
  void show_value();
  void show_text(const QString& text);
  QString fitting_text() const;
  void fit();
  void show_state();

  std::optional<double> value_;
  double minimum_;
  double maximum_;
  double step_ = 0;  // 0: by the range
  bool is_logarithmic_ = false;
  bool is_strict_ = false;
  bool is_whole_ = false;
  bool may_be_empty_ = false;
  bool is_length_ = false;
  double factor_ = 1;  // of values to what is shown
  QString unit_, help_, message_;
  QString full_text_;
  QString shown_;  // in the box, but for what is being typed
  std::vector<Unit> units_;
  QTimer settling_;  // steps that follow each other closely are one edit
};

}  // namespace editor
