#include "editor/controls/notice_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "editor/appearance/theme.h"
#include "editor/controls/tab_order.h"

namespace editor {

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent), text_(new QLabel), choices_(new QHBoxLayout) {
  setAccessibleName(tr("Notice"));
  setAutoFillBackground(true);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * Grid, Grid, Grid, Grid);
  row->setSpacing(Grid);
  row->addWidget(text_, 1);
  row->addLayout(choices_);
  hide();
}

void NoticeBar::show_notice(Kind kind, const QString& text, const std::vector<Choice>& choices) {
  kind_ = kind;
  text_->setText(text);
  while (QLayoutItem* item = choices_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  const auto add = [this](const Choice& choice) {
    auto* button = new QPushButton(choice.text);
    button->setToolTip(choice.tip);
    button->setAccessibleName(choice.text);
    choices_->addWidget(button, 0, Qt::AlignTop);
    connect(button, &QPushButton::clicked, this, [this, action = choice.action] {
      hide();
      if (action) action();
    });
  };
  for (const Choice& choice : choices) add(choice);
  add({tr("Close"), tr("Close this notice"), {}});
  lead_tab_through({this});
  update();
  show();
}

QString NoticeBar::text() const { return text_->text(); }

// Paints a stripe in the notice's colour on the left, so that the text keeps its contrast.
void NoticeBar::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  const ThemeColours colours = colours_of(theme_of(palette()));
  QPainter painter(this);
  painter.fillRect(0, height() - 1, width(), 1, colours.line);
  painter.fillRect(0, 0, Grid / 2, height(), kind_ == Kind::Error ? colours.error : colours.accent);
}

}  // namespace editor
