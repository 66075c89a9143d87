#include "editor/options/option_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/search_terms.h"
#include "editor/controls/text.h"
#include "editor/options/option_field.h"
#include "renderer/options/scheme_model.h"

namespace editor {
namespace {

constexpr int KeyWidth = 24 * Grid;

QString help_of(const options::OptionInfo& option) {
  return QObject::tr("%1\nValues: %2. Default: %3.")
      .arg(text_of(option.meaning), legal_values(option), text_of(option.default_value));
}

}  // namespace

OptionRow::OptionRow(const options::OptionInfo& option, OpDocument& document, QWidget* parent)
    : QWidget(parent),
      option_(option),
      document_(document),
      field_(make_option_field(option, this)),
      key_(new QLabel(text_of(option.key), this)),
      meaning_(new ThemedLabel(&ThemeColours::faint_text, this)),
      message_(new ThemedLabel(&ThemeColours::faint_text, this)) {
  meaning_->setText(tr("%1. Default: %2; %3.")
                        .arg(text_of(option.meaning), text_of(option.default_value), legal_values(option)));
  message_->hide();
  key_->setMinimumWidth(KeyWidth);
  key_->setFixedHeight(3 * Grid);  // height of one control
  key_->setBuddy(field_);
  const auto reset = [this] {
    document_.set_words(option_, {});
    document_.finish_step();
  };
  reset_ = tool_button("reset", tr("Reset %1").arg(text_of(option.key)), {}, reset, this);
  auto* line = new QHBoxLayout;
  line->setSpacing(Grid);
  line->addWidget(key_, 0, Qt::AlignTop);
  line->addWidget(field_, 1);
  line->addWidget(reset_, 0, Qt::AlignTop);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * Grid, Grid, Grid, Grid);
  column->setSpacing(Grid / 2);
  column->addLayout(line);
  column->addWidget(message_);
  column->addWidget(meaning_);
  connect(field_, &OptionField::edited, this,
          [this](const QStringList& words) { document_.set_words(option_, words); });
  connect(field_, &OptionField::finished, &document_, &OpDocument::finish_step);
}

void OptionRow::show_state(const options::RenderOptions& partial) {
  const auto given = document_.op_text().words_of(option_);
  std::optional<QStringList> words;
  if (given) {
    words.emplace();
    for (const std::string& word : *given) *words << QString::fromStdString(word);
  }
  field_->show_words(words);
  is_given_ = given.has_value();
  enable(reset_, tr("Reset to the default: remove the line from the file."),
         is_given_ ? QString() : tr("Already at its default: the file does not set it."));
  const auto why = options::why_unused(partial, option_);
  field_->setEnabled(!why);
  key_->setEnabled(!why);
  const QString reason = why ? tr("No effect: %1.").arg(QString::fromStdString(*why)) : QString();
  field_->setToolTip(why ? reason + "\n" + help_of(option_) : help_of(option_));
  show_message(reason, false);
}

void OptionRow::show_message(const QString& message, bool is_error) {
  has_error_ = is_error;
  message_->set_colour(is_error ? &ThemeColours::error : &ThemeColours::faint_text);
  show_or_hide(message_, message);
  update();
}

bool OptionRow::matches(const QString& query) const {
  return matches_search(key_->text() + ' ' + meaning_->text(), query);
}

/// Paints a bar at the left of options that the file sets.
void OptionRow::paintEvent(QPaintEvent*) {
  if (!is_given_) return;
  const ThemeColours colours = colours_of(theme_of(palette()));
  QPainter painter(this);
  painter.fillRect(QRect(0, Grid, 3, height() - 2 * Grid), has_error_ ? colours.error : colours.accent);
}

}  // namespace editor
