#include "editor/tools/shader_text_view.h"

#include <QComboBox>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QVBoxLayout>

#include "editor/controls/form_widgets.h"

namespace editor {

ShaderTextView::ShaderTextView(QWidget* parent)
    : QWidget(parent),
      chooser_(narrow_list(tr("BRDF"), tr("The BRDF whose shader is shown"), 12, this)),
      message_(problem_label(this)),
      text_(new QPlainTextEdit(this)) {
  setWindowTitle(tr("Shader - BRDF viewer"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(Grid, Grid, Grid, Grid);
  chooser_->addItems({tr("BRDF A"), tr("BRDF B")});
  text_->setReadOnly(true);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  text_->setAccessibleName(tr("Fragment shader"));
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(chooser_);
  column->addWidget(message_);
  column->addWidget(text_, 1);
  connect(chooser_, &QComboBox::currentIndexChanged, this, &ShaderTextView::refresh);
}

QSize ShaderTextView::sizeHint() const { return {100 * Grid, 80 * Grid}; }

QString ShaderTextView::message() const { return message_->isHidden() ? QString() : message_->text(); }

void ShaderTextView::set_sources(const std::array<ShaderSource, 2>& sources) {
  if (sources == sources_) return;
  sources_ = sources;
  refresh();
}

void ShaderTextView::refresh() {
  const ShaderSource& source = sources_[static_cast<std::size_t>(std::max(0, chooser_->currentIndex()))];
  show_or_hide(message_, source.text.isEmpty() ? tr("This BRDF has no shader: it is shaded on the CPU.")
                                               : source.log.trimmed());
  const QStringList lines = source.text.isEmpty() ? QStringList() : source.text.split('\n');
  QStringList numbered;
  for (qsizetype i = 0; i < lines.size(); ++i) numbered.append(QString("%1  %2").arg(i + 1, 4).arg(lines[i]));
  const int at = text_->verticalScrollBar()->value();
  text_->setPlainText(numbered.join('\n'));
  text_->verticalScrollBar()->setValue(at);
}

}  // namespace editor
