#pragma once

#include <QWidget>

#include "editor/rendering/cost_run.h"

class QCheckBox;
class QLineEdit;
class QListWidget;

namespace editor {

class NumberBox;

/// The form of a cost study: what it compares.
class CostForm : public QWidget {
  Q_OBJECT

 public:
  explicit CostForm(QWidget* parent = nullptr);

  /// The settings, without a crop window.
  CostSettings settings() const;
  /// Sets the compared settings to those of a study, so that it is continued with all its curves.
  void show_settings_of(const CostStudy& study);
  /// Whether only the region of the mode Rendered is measured.
  bool is_limited() const;

 private:
  QListWidget* schemes_;
  QCheckBox* path_;
  QCheckBox* naive_;
  QLineEdit* ways_;
  QLineEdit* samples_;
  NumberBox* rounds_;
  QCheckBox* region_;
};

}  // namespace editor
