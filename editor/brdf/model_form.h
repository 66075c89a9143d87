// Forms for BRDFs and sampling schemes, made from the tables that describe them: no model is known by name
// here.
#pragma once

#include <QWidget>
#include <vector>

#include "editor/brdf/made_brdf.h"
#include "grf/catalogue.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace editor {

class DataFileRow;
class ParameterRow;
class TermsEditor;

/// A chooser of models, and a row for each parameter. It edits several models at once: a change of a
/// parameter is one of each, and what differs is shown as mixed. Values that `grf::check` finds wrong stay in
/// the form, with its messages, and are not reported until they are right.
class ModelForm : public QWidget {
  Q_OBJECT

 public:
  /// The messages of the last check, none if all is right.
  const std::vector<QString>& mistakes() const { return mistakes_; }

 signals:
  void mistakes_changed();

 protected:
  /// `kind` is what messages and names of controls call a model: BRDF or PDF.
  ModelForm(std::vector<grf::ModelInfo> infos, QString kind, QWidget* parent);

  void show_models(std::vector<grf::BrdfModel> models);
  const std::vector<grf::BrdfModel>& shown_models() const { return models_; }
  void show_definitions(Definitions definitions);
  const Definitions& definitions() const { return definitions_; }

  virtual std::vector<QString> check(const grf::BrdfModel& model) const = 0;
  virtual void report(bool is_done) = 0;

  /// It has no focus of its own: the list of models takes it.
  void focusInEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void build_chooser();
  void choose(int index);
  void rebuild();
  void add_rows();
  void refresh();
  void refresh_extras();
  void apply(bool is_done);
  void check_models();
  void show_mistakes();
  void change(const grf::ParameterInfo& parameter, const grf::Value& value, bool is_done);
  /// The model that all have in common, or null.
  /// That all models have; empty: there is none.
  std::string common_keyword() const;
  const grf::ModelInfo* info() const;

  std::vector<grf::ModelInfo> infos_;
  QString kind_;
  std::vector<grf::BrdfModel> models_;
  Definitions definitions_;
  std::vector<QString> mistakes_;
  const grf::ModelInfo* shown_info_ = nullptr;

  QComboBox* chooser_ = nullptr;
  QLabel* paper_ = nullptr;
  QVBoxLayout* rows_layout_ = nullptr;
  QWidget* rows_holder_ = nullptr;
  std::vector<ParameterRow*> rows_;
  TermsEditor* terms_ = nullptr;
  DataFileRow* data_file_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* message_ = nullptr;
};

class BrdfForm : public ModelForm {
  Q_OBJECT

 public:
  explicit BrdfForm(QWidget* parent = nullptr);

  /// What is edited, without a signal; none: the form says what to do.
  void set_models(std::vector<grf::BrdfModel> models) { show_models(std::move(models)); }
  const std::vector<grf::BrdfModel>& models() const { return shown_models(); }

  /// What the terms of a sum can name.
  void set_definitions(Definitions definitions) { show_definitions(std::move(definitions)); }

 signals:
  /// While a control is dragged; as many models as were set, in their order.
  void changing(const std::vector<grf::BrdfModel>& models);
  /// Once, when it is released.
  void edited(const std::vector<grf::BrdfModel>& models);

 protected:
  std::vector<QString> check(const grf::BrdfModel& model) const override;
  void report(bool is_done) override;
};

/// The same for sampling schemes.
class PdfForm : public ModelForm {
  Q_OBJECT

 public:
  explicit PdfForm(QWidget* parent = nullptr);

  void set_models(const std::vector<grf::PdfModel>& models);
  std::vector<grf::PdfModel> models() const;

 signals:
  void changing(const std::vector<grf::PdfModel>& models);
  void edited(const std::vector<grf::PdfModel>& models);

 protected:
  std::vector<QString> check(const grf::BrdfModel& model) const override;
  void report(bool is_done) override;
};

}  // namespace editor
