#pragma once

#include <QWidget>
#include <vector>

#include "editor/document/op_document.h"

class QLabel;
class QLineEdit;
class QScrollArea;

namespace editor {

class OptionRow;

/// A form of all options in their groups, with a search.
class OptionsForm : public QWidget {
  Q_OBJECT

 public:
  OptionsForm(OpDocument& document, QWidget* parent);

  /// Shows and focuses an option, and clears a search that hides it.
  void go_to(const options::OptionInfo& option);
  void show_option(const options::OptionInfo& option);
  /// Whether the option's control is enabled: the other options leave it an effect.
  bool is_usable(const options::OptionInfo& option) const;
  OptionRow* row_of(const options::OptionInfo& option) const;
  QLineEdit* search() const { return search_; }

 private:
  void make_rows(QWidget* page);
  void show_state();
  void show_messages();
  void filter(const QString& text);

  struct Group {
    QLabel* title;
    std::vector<OptionRow*> rows;
  };

  OpDocument& document_;
  QLineEdit* search_;
  QScrollArea* scroll_;
  QLabel* nothing_;
  std::vector<Group> groups_;
};

/// The option that a message refers to, if any: that of its line, or the first that it names.
const options::OptionInfo* option_of(const grf::Diagnostic& diagnostic, const options::OpText& text);

}  // namespace editor
