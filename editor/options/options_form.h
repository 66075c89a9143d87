#pragma once

#include <QWidget>
#include <vector>

#include "editor/document/op_document.h"

class QLabel;
class QLineEdit;
class QScrollArea;

namespace editor {

class OptionRow;

/// All options in their groups, and a search.
class OptionsForm : public QWidget {
  Q_OBJECT

 public:
  OptionsForm(OpDocument& document, QWidget* parent);

  /// Shows an option and gives it the focus, whatever is searched for.
  void go_to(const options::OptionInfo& option);
  void show_option(const options::OptionInfo& option);
  /// Whether its control can be used: the other options leave it an effect.
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

/// What a message is about, if that is an option: that of its line, or the first that it names.
const options::OptionInfo* option_of(const grf::Diagnostic& diagnostic, const options::OpText& text);

}  // namespace editor
