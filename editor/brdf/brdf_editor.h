#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "editor/brdf/brdf_library.h"
#include "editor/brdf/brdf_plots.h"
#include "editor/brdf/live_sphere.h"
#include "editor/brdf/lobe_view.h"
#include "editor/brdf/model_form.h"

class QButtonGroup;
class QComboBox;
class QSplitter;

namespace editor {

/// The BRDF editor: the form of a BRDF, and four views (sphere, lobe, plots, library), one at a time where
/// space is limited, all at once in a large window. The views follow each drag of a control.
class BrdfEditor : public QWidget {
  Q_OBJECT

 public:
  enum class View { Sphere, Lobe, Plots, Library };

  explicit BrdfEditor(QWidget* parent = nullptr);

  /// Sets the BRDFs of the selection, without a signal; the views show the first.
  void set_models(const std::vector<grf::BrdfModel>& models);
  const std::vector<grf::BrdfModel>& models() const { return form_->models(); }
  /// Sets the definitions in scope of the selection.
  void set_definitions(const Definitions& definitions);
  /// Sets the sampling scheme of the selection, whose pdf the plots show.
  void set_scheme(const std::optional<grf::PdfModel>& scheme) { plots_->set_scheme(scheme); }
  /// Sets the environment map of the scene, which can light the sphere; empty: it has none.
  void set_environment(const std::optional<studies::Environment>& environment);
  /// Sets the view that is shown where there is space for one.
  void set_view(View view);

  BrdfForm& form() { return *form_; }
  LiveSphere& sphere() { return *sphere_; }
  LobeView& lobe() { return *lobe_; }
  BrdfPlots& plots() { return *plots_; }
  BrdfLibrary& library() { return *library_; }

  /// True where all views are shown.
  bool is_unfolded() const { return is_unfolded_; }

 signals:
  /// Emitted while a control is dragged, with as many models as were set, in their order.
  void changing(const std::vector<grf::BrdfModel>& models);
  /// Emitted once, when the control is released.
  void edited(const std::vector<grf::BrdfModel>& models);
  /// Emitted when a definition of the scene is chosen in the library, to be shared by its name.
  void definition_chosen(const QString& name);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void add_view(View view, const char* icon_name, const QString& name, const QString& tip, QWidget* contents);
  QWidget* sphere_with_exposure();
  QWidget* light_choice();
  void light_sphere();
  QWidget* lobe_with_choices();
  void arrange();
  void show_brdf();
  void replace(const grf::BrdfModel& brdf);

  Definitions definitions_;
  bool is_unfolded_ = false;
  View view_ = View::Sphere;
  BrdfForm* form_ = nullptr;
  LiveSphere* sphere_ = nullptr;
  QComboBox* light_ = nullptr;
  std::optional<studies::Environment> environment_;
  LobeView* lobe_ = nullptr;
  BrdfPlots* plots_ = nullptr;
  BrdfLibrary* library_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QWidget* bar_ = nullptr;
  QButtonGroup* buttons_ = nullptr;
  std::array<QWidget*, 4> views_ = {};
  BackgroundJob<CompiledBrdf> making_{this};
};

}  // namespace editor
