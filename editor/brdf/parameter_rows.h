#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "grf/catalogue.h"

class QVBoxLayout;

namespace editor {

class ParameterRow;

/// A row for each parameter of a model, for several instances at once; values that differ are shown as mixed.
class ParameterRows : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterRows(QWidget* parent = nullptr);

  /// Shows instances of one model, at least one. The model's description outlives this; null shows no rows.
  void show_models(const grf::ModelInfo* info, const std::vector<const grf::Model*>& models);
  /// Marks the rows that the messages of `grf::check` refer to.
  void show_errors(const std::vector<QString>& errors);

 signals:
  /// Emitted with an edit to apply to each instance; `is_done` once the control is released.
  void edited(const std::function<void(grf::Model&)>& edit, bool is_done);

 private:
  void add_rows();

  const grf::ModelInfo* info_ = nullptr;
  QVBoxLayout* column_;
  std::vector<ParameterRow*> rows_;
};

}  // namespace editor
