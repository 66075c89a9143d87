// A control for each kind of value that an option may have.
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>

#include "renderer/options/render_options.h"

namespace editor {

/// Shows the words of an option and lets them be changed.
class OptionField : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

  /// Nothing: the option is not given, and the default is shown as such.
  virtual void show_words(const std::optional<QStringList>& words) = 0;
  /// Relative paths start there; empty: at no folder yet.
  virtual void set_folder(const QString& folder) { (void)folder; }

 signals:
  /// The words that it should have; none: it is not given. Also while typing or stepping.
  void edited(const QStringList& words);
  /// What was edited is as it should be: what comes next is another step of undo.
  void finished();
};

/// By the kind of the option's value; it takes the focus for its first control.
OptionField* make_option_field(const options::OptionInfo& option, QWidget* parent);

/// The values that are legal, in words.
QString legal_values(const options::OptionInfo& option);

}  // namespace editor
