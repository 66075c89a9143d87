// What the docks' widgets are put together from.
#pragma once

#include <QString>
#include <functional>
#include <limits>

class QLabel;
class QObject;
class QToolButton;
class QWidget;

namespace editor {

class NumberBox;

/// A small button with a drawing alone; its text is for assistive technology.
QToolButton* tool_button(const QString& icon, const QString& text, const QString& tool_tip,
                         const std::function<void()>& pressed, QWidget* parent);

/// Enables a widget, or says in its tool tip why not; an empty reason enables it.
void enable(QWidget* widget, const QString& tool_tip, const QString& why_not);

/// A line that is hidden until it has something to say, in the colour of errors.
QLabel* problem_label(QWidget* parent);
void show_problem(QLabel* label, const QString& problem);

/// What a number means and may be.
struct NumberInfo {
  QString name;  ///< for assistive technology
  QString help;  ///< meaning; the box adds range and unit
  double minimum = 0;
  double maximum = std::numeric_limits<float>::max();
  double step = 0.1;
  QString unit = {};  ///< empty: none
};

/// A box that takes numbers of the range alone, and is as narrow as it must be.
NumberBox* number_box(const NumberInfo& info, QWidget* parent);
/// Calls `take` with each new number, and then `done` where it is more than a step on the way.
void connect_number(NumberBox* box, QObject* context, const std::function<void(double)>& take,
                    const std::function<void()>& done);

/// Words for an empty widget: what to do next.
QLabel* hint_label(const QString& text, QWidget* parent);

}  // namespace editor
