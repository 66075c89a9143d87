#pragma once

#include "editor/options/option_field.h"

class QCompleter;
class QLineEdit;

namespace editor {

/// A path field with completion and a file dialog. Paths in or near the current folder are relative.
class PathField : public OptionField {
  Q_OBJECT

 public:
  PathField(const options::OptionInfo& option, options::PathOption value, QWidget* parent);

  void show_words(const std::optional<QStringList>& words) override;
  void set_folder(const QString& folder) override;

  /// Formats a file system path as it is shown in the field.
  QString relative(const QString& path) const;

 private:
  void browse();
  void complete();
  void take(const QString& text);

  const options::PathOption value_;
  QString folder_;
  QLineEdit* text_;
  QCompleter* completer_ = nullptr;
};

}  // namespace editor
