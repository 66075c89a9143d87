// Widgets that several parts of the window are put together from.
#pragma once

#include <QLabel>
#include <functional>
#include <limits>

#include "editor/appearance/theme.h"

class QComboBox;
class QMimeData;
class QObject;
class QToolButton;
class QWidget;

namespace editor {

class NumberBox;

/// A layout of all of a widget, without a margin.
template <class Layout>
Layout* tight_layout(QWidget* widget, int spacing = Grid / 2) {
  auto* layout = new Layout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  return layout;
}

/// A small button with a drawing alone; its text is for assistive technology.
QToolButton* tool_button(const QString& icon, const QString& text, const QString& tool_tip,
                         const std::function<void()>& pressed, QWidget* parent);

/// Enables a widget, or says in its tool tip why not; an empty reason enables it.
void enable(QWidget* widget, const QString& tool_tip, const QString& why_not);

/// A list of choices that is as narrow as its place wants, and at least so many letters wide.
QComboBox* narrow_list(const QString& name, const QString& tool_tip, int letters, QWidget* parent);

/// A label of some lines, in a colour of the theme that the palette has no role for.
class ThemedLabel : public QLabel {
 public:
  ThemedLabel(QColor ThemeColours::*colour, QWidget* parent);
  void set_colour(QColor ThemeColours::*colour);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QColor ThemeColours::*colour_;
};

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

/// The files of this machine that are dragged.
QStringList local_files(const QMimeData& data);

/// Words for an empty widget: what to do next.
QLabel* hint_label(const QString& text, QWidget* parent);

}  // namespace editor
