// Helpers that build common form widgets.
#pragma once

#include <QLabel>
#include <functional>
#include <limits>

#include "editor/appearance/theme.h"

class QComboBox;
class QGridLayout;
class QMimeData;
class QObject;
class QToolButton;
class QWidget;

namespace editor {

class NumberBox;

/// Adds a layout without margins to a widget.
template <class Layout>
Layout* tight_layout(QWidget* widget, int spacing = Grid / 2) {
  auto* layout = new Layout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  return layout;
}

/// Shows or hides the widgets in a row of a grid.
void show_row(const QGridLayout& grid, int row, bool is_shown);

/// A small button with an icon; its text is for assistive technology.
QToolButton* tool_button(const QString& icon, const QString& text, const QString& tool_tip,
                         const std::function<void()>& pressed, QWidget* parent);

/// Enables a widget, or disables it with the reason in its tool tip; an empty reason enables it.
void enable(QWidget* widget, const QString& tool_tip, const QString& why_not);

/// A combo box that can shrink with its form, to no fewer than so many letters.
QComboBox* narrow_list(const QString& name, const QString& tool_tip, int letters, QWidget* parent);

/// A multi-line label in a colour of the theme that the palette has no role for.
class ThemedLabel : public QLabel {
 public:
  ThemedLabel(QColor ThemeColours::*colour, QWidget* parent);
  void set_colour(QColor ThemeColours::*colour);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QColor ThemeColours::*colour_;
};

/// A label in the error colour that is hidden while it is empty.
QLabel* problem_label(QWidget* parent);
/// Shows a text in a label, which is hidden while it has none.
void show_or_hide(QLabel* label, const QString& text);

/// Name, help, range and unit of a number field.
struct NumberInfo {
  QString name;  ///< accessible name
  QString help;  ///< meaning; the box adds range and unit
  double minimum = 0;
  double maximum = std::numeric_limits<float>::max();
  double step = 0.1;
  QString unit = {};  ///< empty for none
};

/// A strict number box that is as narrow as possible.
NumberBox* number_box(const NumberInfo& info, QWidget* parent);
/// Shows the lengths of all number boxes in a widget in a unit; see NumberBox::show_lengths_in.
void show_lengths_in(const QString& unit, const QWidget& form);
/// Calls `take` with each new number, and then `done` unless more steps of the same edit may follow.
void connect_number(NumberBox* box, QObject* context, const std::function<void(double)>& take,
                    const std::function<void()>& done);

/// The local files among dragged data.
QStringList local_files(const QMimeData& data);

/// A label for an empty widget that says what to do next.
QLabel* hint_label(const QString& text, QWidget* parent);

}  // namespace editor
