#pragma once

#include <QWidget>
#include <vector>

#include "editor/brdf/made_brdf.h"
#include "grf/catalogue.h"

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace editor {

class DataFileRow;
class ParameterRows;
class TermsEditor;

/// A form for BRDFs, made from the tables that describe them: a chooser of models, and a row for each
/// parameter. It edits several at once: a change of a parameter is one of each, and what differs is shown as
/// mixed. Values that `grf::check` finds wrong stay in the form, with its messages, and are not reported
/// until they are right.
class BrdfForm : public QWidget {
  Q_OBJECT

 public:
  explicit BrdfForm(QWidget* parent = nullptr);

  /// Sets the models that are edited, without a signal; with none, the form says what to do.
  void set_models(std::vector<grf::BrdfModel> models);
  const std::vector<grf::BrdfModel>& models() const { return models_; }

  /// Sets the definitions that the terms of a sum can name.
  void set_definitions(Definitions definitions);

  /// The messages of the last check, none if all is right.
  const std::vector<QString>& mistakes() const { return mistakes_; }

 signals:
  /// While a control is dragged; as many models as were set, in their order.
  void changing(const std::vector<grf::BrdfModel>& models);
  /// Once, when it is released.
  void edited(const std::vector<grf::BrdfModel>& models);

 protected:
  /// It has no focus of its own: the list of models takes it.
  void focusInEvent(QFocusEvent* event) override;

 private:
  void build_chooser();
  void choose(int index);
  void rebuild();
  void refresh();
  void refresh_chooser();
  void refresh_rows();
  void apply(bool is_done);
  void check_models();
  /// That all models have; empty: there is none.
  std::string common_keyword() const;

  std::vector<grf::ModelInfo> infos_;
  std::vector<grf::BrdfModel> models_;
  Definitions definitions_;
  std::vector<QString> mistakes_;
  const grf::ModelInfo* info_ = nullptr;  ///< of the model that all have in common; null: there is none

  QComboBox* chooser_ = nullptr;
  QLabel* paper_;
  QVBoxLayout* rows_;  ///< the parameters' rows come last, behind what else the model takes
  ParameterRows* parameters_;
  TermsEditor* terms_ = nullptr;
  DataFileRow* data_file_ = nullptr;
  QLabel* hint_;
  QLabel* message_;
};

}  // namespace editor
