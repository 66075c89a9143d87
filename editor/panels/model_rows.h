// These rows of the Surface dock choose a BRDF or a sampling scheme.
#pragma once

#include <functional>
#include <optional>

#include "editor/panels/surface_row.h"
#include "grf/catalogue.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace editor {

class ParameterRows;

/// Chooses a named BRDF of the scene, or a new inline one of a model.
class BrdfRow : public SurfaceRow {
  Q_OBJECT

 public:
  BrdfRow(Document& document, const grf::Catalogue& catalogue, QWidget* parent = nullptr);
  void show_summary(const SelectionSummary& summary) override;

 signals:
  void edit_requested();
  void pick_requested();
  void problem_found(const QString& problem);

 private:
  void fill(const SelectionSummary& summary);
  void choose(int index);
  void assign(const QString& text, const AttributeEdit<grf::BrdfAttribute>& brdf);
  void define_common();

  const grf::Catalogue& catalogue_;
  CommonValue<grf::BrdfAttribute> common_;
  QComboBox* choice_;
  QToolButton* edit_;
  QToolButton* define_;
  QToolButton* pick_;
  QToolButton* reset_;
};

/// Chooses a named sampling scheme, or an inline one with a row for each parameter.
class PdfRow : public SurfaceRow {
  Q_OBJECT

 public:
  PdfRow(Document& document, const grf::Catalogue& catalogue, QWidget* parent = nullptr);
  void show_summary(const SelectionSummary& summary) override;

 private:
  void fill(const SelectionSummary& summary);
  /// Selects a scheme; one that is unknown or has invalid values is shown as such.
  void select_model(const grf::PdfModel& model);
  void choose(int index);
  void assign(const QString& text, const AttributeEdit<grf::PdfAttribute>& pdf);
  void show_parameters();
  void edit_parameters(const std::function<void(grf::Model&)>& edit, bool is_done);

  const grf::Catalogue& catalogue_;
  std::optional<grf::PdfModel> model_;  ///< the inline scheme that the rows show
  QComboBox* choice_;
  ParameterRows* parameters_;
  QLabel* problem_;
  QToolButton* reset_;
};

}  // namespace editor
