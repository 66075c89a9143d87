#pragma once

#include <QWidget>
#include <vector>

#include "grf/model.h"

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace editor {

/// Edits the terms of a weighted sum: a weight and the name of a BRDF per row.
class TermsEditor : public QWidget {
  Q_OBJECT

 public:
  explicit TermsEditor(QWidget* parent = nullptr);

  /// Sets the names that a term can refer to.
  void set_names(const std::vector<QString>& names);
  /// Sets the terms, without a signal. Mixed terms are shown as such until one is added.
  void set_terms(const std::vector<grf::CombineTerm>& terms, bool are_mixed);

 signals:
  void changing(const std::vector<grf::CombineTerm>& terms);
  void edited(const std::vector<grf::CombineTerm>& terms);

 private:
  void rebuild();
  void add_row(std::size_t index);
  void add_term();

  std::vector<QString> names_;
  std::vector<grf::CombineTerm> terms_;
  bool are_mixed_ = false;
  QVBoxLayout* rows_ = nullptr;
  QWidget* holder_ = nullptr;
  QLabel* hint_ = nullptr;
  QToolButton* add_ = nullptr;
};

}  // namespace editor
