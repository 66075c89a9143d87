#pragma once

#include <QDialog>
#include <QKeySequence>
#include <QList>
#include <functional>
#include <utility>
#include <vector>

#include "editor/document/preferences.h"

class QComboBox;
class QFormLayout;
class QKeySequenceEdit;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace editor {

class NumberBox;
class ShortcutKeys;

/// Edits the preferences and the shortcuts. Each change is applied and stored at once.
class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  /// Shows the stored preferences. The keys outlive the dialog.
  explicit PreferencesDialog(ShortcutKeys& keys, QWidget* parent = nullptr);
  ~PreferencesDialog() override;

 signals:
  void changed(const editor::Preferences& preferences);

 private:
  QWidget* make_general_page();
  QWidget* make_work_page();
  QWidget* make_farm_page();
  QWidget* make_keys_page();
  QComboBox* add_list(QFormLayout& form, const QString& label, const QString& name, const QString& tip,
                      const std::vector<std::pair<QString, QString>>& choices, const QString& now,
                      const std::function<void(const QString& choice)>& take);
  void add_text(QFormLayout& form, const QString& label, const QString& name, const QString& tip,
                QString FarmAccess::*field);
  void add_number(QFormLayout& form, const QString& label, const QString& name, const QString& tip, int least,
                  int most, const QString& unit, int Preferences::*field);
  void change(const Preferences& preferences);
  void show_keys();
  void show_entry();
  void set_keys(const QList<QKeySequence>& keys);
  int entry() const;

  ShortcutKeys& keys_;
  Preferences preferences_;
  QTreeWidget* list_ = nullptr;
  QKeySequenceEdit* edit_ = nullptr;
  QPushButton* default_ = nullptr;
  QLabel* problem_ = nullptr;
};

}  // namespace editor
