#pragma once

#include <QWidget>
#include <vector>

#include "editor/brdf/compiled_brdf.h"
#include "grf/catalogue.h"

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace editor {

class DataFileRow;
class ParameterRows;
class LayersEditor;
class TermsEditor;

/// A form for BRDFs, generated from the models' parameter tables: a model chooser, and a row for each
/// parameter. It edits several BRDFs at once: a parameter change applies to all, and differing values are
/// shown as mixed. Values that `grf::check` rejects stay in the form with its messages, and are not reported
/// until they are valid.
class BrdfForm : public QWidget {
  Q_OBJECT

 public:
  explicit BrdfForm(QWidget* parent = nullptr);

  /// Leaves out the buttons for images that vary parameters, where there are no faces.
  void leave_out_images();

  /// Sets the BRDFs that are edited, without a signal; without any, the form says what to do.
  void set_models(std::vector<grf::BrdfModel> models);
  const std::vector<grf::BrdfModel>& models() const { return models_; }

  /// Sets the definitions that the terms of a sum can refer to.
  void set_definitions(Definitions definitions);

  /// The messages of the last check, empty if all values are valid.
  const std::vector<QString>& errors() const { return errors_; }

 signals:
  /// Emitted while a control is dragged, with as many models as were set, in their order.
  void changing(const std::vector<grf::BrdfModel>& models);
  /// Emitted once, when the control is released.
  void edited(const std::vector<grf::BrdfModel>& models);

 protected:
  /// Passes the focus to the list of models.
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
  /// The keyword that all models share; empty if they differ.
  std::string common_keyword() const;

  std::vector<grf::ModelInfo> infos_;
  std::vector<grf::BrdfModel> models_;
  Definitions definitions_;
  std::vector<QString> errors_;
  const grf::ModelInfo* info_ = nullptr;  ///< of the model that all share; null if they differ

  QComboBox* chooser_ = nullptr;
  QLabel* paper_;
  QVBoxLayout* rows_;  ///< the rows of the parameters come last, after the other fields of the model
  ParameterRows* parameters_;
  TermsEditor* terms_ = nullptr;
  LayersEditor* layers_ = nullptr;
  DataFileRow* data_file_ = nullptr;
  QLabel* hint_;
  QLabel* message_;
};

}  // namespace editor
