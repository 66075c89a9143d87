#include "editor/controls/form_widgets.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QMimeData>
#include <QToolButton>
#include <QUrl>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/number_box.h"

namespace editor {
ThemedLabel::ThemedLabel(QColor ThemeColours::*colour, QWidget* parent) : QLabel(parent), colour_(colour) {
  setWordWrap(true);
  set_colour(colour);
}

void ThemedLabel::set_colour(QColor ThemeColours::*colour) {
  colour_ = colour;
  const QColor wanted = colours_of(theme_of(palette())).*colour_;
  if (palette().color(QPalette::WindowText) == wanted) return;
  QPalette own;
  own.setColor(QPalette::WindowText, wanted);
  setPalette(own);
}

void ThemedLabel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) set_colour(colour_);
  QLabel::changeEvent(event);
}

QComboBox* narrow_list(const QString& name, const QString& tool_tip, int letters, QWidget* parent) {
  auto* list = new QComboBox(parent);
  list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list->setMinimumContentsLength(letters);
  list->setAccessibleName(name);
  list->setToolTip(tool_tip);
  return list;
}

void show_row(const QGridLayout& grid, int row, bool is_shown) {
  for (int column = 0; column < grid.columnCount(); ++column) {
    const QLayoutItem* item = grid.itemAtPosition(row, column);
    if (item != nullptr && item->widget() != nullptr) item->widget()->setVisible(is_shown);
  }
}

QToolButton* tool_button(const QString& icon_name, const QString& text, const QString& tool_tip,
                         const std::function<void()>& pressed, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon(icon_name));
  button->setText(text);
  button->setAccessibleName(text);
  button->setToolTip(tool_tip);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  QObject::connect(button, &QToolButton::clicked, button, pressed);
  return button;
}

void enable(QWidget* widget, const QString& tool_tip, const QString& why_not) {
  widget->setEnabled(why_not.isEmpty());
  widget->setToolTip(why_not.isEmpty() ? tool_tip : why_not);
}

QLabel* problem_label(QWidget* parent) {
  auto* label = new ThemedLabel(&ThemeColours::error, parent);
  label->hide();
  return label;
}

void show_or_hide(QLabel* label, const QString& text) {
  label->setText(text);
  label->setVisible(!text.isEmpty());
}

NumberBox* number_box(const NumberInfo& info, QWidget* parent) {
  auto* box = new NumberBox(parent);
  box->set_range(info.minimum, info.maximum);
  box->set_strict(true);
  box->set_step(info.step);
  box->set_unit(info.unit);
  box->set_help(info.help);
  box->setAccessibleName(info.name);
  box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  return box;
}

void show_lengths_in(const QString& unit, const QWidget& form) {
  for (NumberBox* box : form.findChildren<NumberBox*>()) box->show_lengths_in(unit);
}

void connect_number(NumberBox* box, QObject* context, const std::function<void(double)>& take,
                    const std::function<void()>& done) {
  QObject::connect(box, &NumberBox::changing, context, take);
  QObject::connect(box, &NumberBox::edited, context, [take, done](double number) {
    take(number);
    done();
  });
}

QStringList local_files(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls()) {
    if (url.isLocalFile()) files << url.toLocalFile();
  }
  return files;
}

QLabel* hint_label(const QString& text, QWidget* parent) {
  auto* label = new ThemedLabel(&ThemeColours::faint_text, parent);
  label->setText(text);
  label->setAlignment(Qt::AlignCenter);
  label->setMargin(2 * Grid);
  return label;
}

}  // namespace editor
