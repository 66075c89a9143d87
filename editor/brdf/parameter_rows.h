#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "grf/catalogue.h"

class QVBoxLayout;

namespace editor {

class ParameterRow;

/// A row for each parameter of a model, which shows the values of several instances at once: those that
/// differ as mixed.
class ParameterRows : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterRows(QWidget* parent = nullptr);

  /// The descriptor outlives this; null: there are no rows. All instances are of that model, and one is
  /// there.
  void show_models(const grf::ModelInfo* info, const std::vector<const grf::Model*>& models);
  /// Marks the rows that the messages of `grf::check` are about.
  void show_mistakes(const std::vector<QString>& mistakes);

 signals:
  /// A control changes each of the instances so; done once it is let go.
  void edited(const std::function<void(grf::Model&)>& edit, bool is_done);

 private:
  void add_rows();

  const grf::ModelInfo* info_ = nullptr;
  QVBoxLayout* column_;
  std::vector<ParameterRow*> rows_;
};

}  // namespace editor
