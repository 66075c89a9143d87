#include "editor/controls/notice_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStringList>

#include "editor/appearance/theme.h"
#include "editor/controls/tab_order.h"

namespace editor {
namespace {

/// Converts a message to HTML, with source lines and the carets under them in a fixed-width font.
QString html_of(const QString& text) {
  const QStringList lines = text.split('\n');
  QString html;
  for (qsizetype i = 0; i < lines.size(); ++i) {
    if (i + 1 < lines.size() && lines[i + 1].trimmed() == "^") {
      html += "<pre>" + lines[i].toHtmlEscaped() + "\n" + lines[i + 1] + "</pre>";
      ++i;
    } else {
      html += "<div>" + lines[i].toHtmlEscaped() + "</div>";
    }
  }
  return html;
}

}  // namespace

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent), label_(new QLabel), choices_(new QHBoxLayout) {
  setAccessibleName(tr("Notice"));
  setAutoFillBackground(true);
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::RichText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * Grid, Grid, Grid, Grid);
  row->setSpacing(Grid);
  row->addWidget(label_, 1);
  row->addLayout(choices_);
  hide();
}

void NoticeBar::show_notice(Kind kind, const QString& text, const std::vector<Choice>& choices) {
  kind_ = kind;
  text_ = text;
  label_->setText(html_of(text));
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

// Paints a stripe in the notice's colour on the left, so that the text keeps its contrast.
void NoticeBar::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  const ThemeColours colours = colours_of(theme_of(palette()));
  QPainter painter(this);
  painter.fillRect(0, height() - 1, width(), 1, colours.line);
  painter.fillRect(0, 0, Grid / 2, height(), kind_ == Kind::Error ? colours.error : colours.accent);
}

}  // namespace editor
