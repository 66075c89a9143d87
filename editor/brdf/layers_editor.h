#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "grf/model.h"

class QComboBox;
class QLabel;

namespace editor {

/// Chooses the BRDFs of the scene that a layered model consists of: a list for its base, and one for its top.
class LayersEditor : public QWidget {
  Q_OBJECT

 public:
  /// For a keyword with layers, see grf::layer_names.
  explicit LayersEditor(const std::string& keyword, QWidget* parent = nullptr);

  /// Sets the names that a layer can refer to.
  void set_names(const std::vector<QString>& names);
  /// Sets the layers, without a signal: none are shown if there are not as many as the model has.
  void set_terms(const std::vector<grf::CombineTerm>& terms);

 signals:
  /// Reports the layers once each has a BRDF.
  void edited(const std::vector<grf::CombineTerm>& terms);

 private:
  void refresh();
  void report();

  std::vector<QString> names_;
  std::vector<grf::CombineTerm> terms_;
  std::vector<QComboBox*> lists_;
  QLabel* hint_ = nullptr;
};

}  // namespace editor
