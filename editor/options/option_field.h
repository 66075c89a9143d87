// Each kind of option value has a control that edits it.
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>

#include "renderer/options/render_options.h"

namespace editor {

/// Edits the value of an option as words.
class OptionField : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

  /// Shows the words; without any the option is not set, and its default is shown as such.
  virtual void show_words(const std::optional<QStringList>& words) = 0;
  /// Sets the folder of relative paths; empty if there is none yet.
  virtual void set_folder(const QString& folder) { (void)folder; }

 signals:
  /// Emitted with the new words, none to unset the option; also while typing or stepping.
  void edited(const QStringList& words);
  /// Emitted when an edit is complete: the next one is another undo step.
  void finished();
};

/// Creates the control for an option's kind of value; its first control takes the focus.
OptionField* make_option_field(const options::OptionInfo& option, QWidget* parent);

/// Describes the legal values.
QString legal_values(const options::OptionInfo& option);

}  // namespace editor
