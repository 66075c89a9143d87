#include "editor/panels/parts.h"

#include <QEvent>
#include <QLabel>
#include <QToolButton>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/number_box.h"

namespace editor {
namespace {

/// A label in a colour of the theme that the palette has no role for.
class ThemedLabel : public QLabel {
 public:
  ThemedLabel(QColor ThemeColours::*colour, QWidget* parent) : QLabel(parent), colour_(colour) {
    setWordWrap(true);
    apply_colour();
  }

 protected:
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::PaletteChange) apply_colour();
    QLabel::changeEvent(event);
  }

 private:
  void apply_colour() {
    const QColor wanted = colours_of(theme_of(palette())).*colour_;
    if (palette().color(QPalette::WindowText) == wanted) return;
    QPalette own;
    own.setColor(QPalette::WindowText, wanted);
    setPalette(own);
  }

  QColor ThemeColours::*colour_;
};

}  // namespace

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

void show_problem(QLabel* label, const QString& problem) {
  label->setText(problem);
  label->setVisible(!problem.isEmpty());
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

void connect_number(NumberBox* box, QObject* context, const std::function<void(double)>& take,
                    const std::function<void()>& done) {
  QObject::connect(box, &NumberBox::changing, context, take);
  QObject::connect(box, &NumberBox::edited, context, [take, done](double number) {
    take(number);
    done();
  });
}

QLabel* hint_label(const QString& text, QWidget* parent) {
  auto* label = new ThemedLabel(&ThemeColours::faint_text, parent);
  label->setText(text);
  label->setAlignment(Qt::AlignCenter);
  label->setMargin(2 * Grid);
  return label;
}

}  // namespace editor
