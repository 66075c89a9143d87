#pragma once

#include <QAbstractSpinBox>
#include <QTimer>
#include <optional>
#include <vector>

#include "editor/controls/expression.h"

namespace editor {

/// A box for a number, typed as arithmetic with units (`0.2*3`, `20deg`), or changed by arrow keys and wheel
/// in steps of one digit. What cannot be read stays in the box, marked, with a sentence that says why (in its
/// tool tip, and by `failed`), until it is mended or Escape brings the last number back. What was typed
/// counts from the return key on, or when the focus goes, or with a shortcut that is none of text editing.
///
/// The range limits steps alone: a number outside is taken, since the owner can say better what is wrong, but
/// of a box that is strict.
class NumberBox : public QAbstractSpinBox {
  Q_OBJECT
  Q_PROPERTY(double value READ value)

 public:
  explicit NumberBox(QWidget* parent = nullptr);

  void set_range(double minimum, double maximum);
  /// The unit of `value`, shown behind it and among those that can be typed.
  void set_unit(const QString& unit);
  /// What is typed and is outside of the range is no number for this box.
  void set_strict(bool is_strict) { is_strict_ = is_strict; }
  /// Each step changes the second digit, or adds a hundredth of the range.
  void set_logarithmic(bool is_logarithmic) { is_logarithmic_ = is_logarithmic; }
  /// Each step adds this.
  void set_step(double step) { step_ = step; }
  /// Whole numbers: steps of 1, and all digits are shown.
  void set_whole(bool is_whole);
  /// It may be left empty, which means this; if that is a number, steps begin there. See `cleared`.
  void set_default(const QString& text);
  /// What the control is for, perhaps as rich text; the box adds range and unit. Without it the tool tip is
  /// the owner's, but where something is wrong. See also set_message.
  void set_help(const QString& help);

  /// Without a value nothing is shown but the word, until somebody types. Without a signal.
  void set_blank(const QString& word);
  /// Likewise, of several things that differ.
  void set_mixed() { set_blank("mixed"); }
  bool has_value() const { return value_.has_value(); }
  /// Without a signal.
  void set_value(double value);
  double value() const { return value_.value_or(0); }
  /// A number as a file has it, say `1e3`, which stays as it is until it is edited; empty: none. Words that
  /// are no number are shown, too. Without a signal.
  void set_text(const QString& text);
  /// The number as a file should have it, with its unit: as it was given or typed, or with up to seven
  /// digits. A narrow box without the focus shows fewer.
  QString full_text() const { return full_text_; }
  /// Takes what was typed, as the return key does.
  void commit();

  /// Marks the box as wrong and says why; empty: it is right.
  void set_message(const QString& message);
  QString message() const { return message_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void changing(double value);         ///< while the person steps
  void edited(double value);           ///< once, when done
  void cleared();                      ///< left empty, where it may be
  void failed(const QString& reason);  ///< what was typed is no number

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
  QString unit_, help_, message_;
  QString full_text_;
  QString shown_;  // in the box, but for what is being typed
  std::vector<Unit> units_;
  QTimer settling_;  // steps that follow each other closely are one edit
};

}  // namespace editor
