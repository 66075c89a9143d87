#pragma once

#include <QWidget>

#include "editor/document/op_document.h"

class QLabel;
class QToolButton;

namespace editor {

class OptionField;
class ThemedLabel;

/// An option: its key, control, meaning, default and legal values; whether it is set, why it has no effect,
/// or its errors.
class OptionRow : public QWidget {
  Q_OBJECT

 public:
  OptionRow(const options::OptionInfo& option, OpDocument& document, QWidget* parent);

  const options::OptionInfo& option() const { return option_; }
  OptionField& field() { return *field_; }

  /// Updates the row from the document.
  void show_state(const options::RenderOptions& partial);
  void show_message(const QString& message, bool is_error);
  /// Whether its key, meaning or default matches the query: see matches_search.
  bool matches(const QString& query) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const options::OptionInfo& option_;
  OpDocument& document_;
  OptionField* field_;
  QLabel* key_;
  QLabel* meaning_;
  ThemedLabel* message_;
  QToolButton* reset_ = nullptr;
  bool is_given_ = false;
  bool has_error_ = false;
};

}  // namespace editor
