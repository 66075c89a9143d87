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
class QSplitter;

namespace editor {

/// All there is for one BRDF: its form, and a sphere, the lobe, plots and the library, one at a time where
/// there is little room, and all at once in a large window. The views follow each drag of a control.
class BrdfEditor : public QWidget {
  Q_OBJECT

 public:
  enum class View { Sphere, Lobe, Plots, Library };

  explicit BrdfEditor(QWidget* parent = nullptr);

  /// The BRDFs of what is selected, without a signal; the views show the first.
  void set_models(const std::vector<grf::BrdfModel>& models);
  const std::vector<grf::BrdfModel>& models() const { return form_->models(); }
  /// The definitions in scope where they stand.
  void set_definitions(const Definitions& definitions);
  /// The sampling scheme of what is selected, whose density the plots show.
  void set_scheme(const std::optional<grf::PdfModel>& scheme) { plots_->set_scheme(scheme); }
  /// The view that is shown where there is room for one.
  void set_view(View view);

  BrdfForm& form() { return *form_; }
  LiveSphere& sphere() { return *sphere_; }
  LobeView& lobe() { return *lobe_; }
  BrdfPlots& plots() { return *plots_; }
  BrdfLibrary& library() { return *library_; }

  /// True where all views are shown.
  bool is_unfolded() const { return is_unfolded_; }

 signals:
  /// While a control is dragged; as many models as were set, in their order.
  void changing(const std::vector<grf::BrdfModel>& models);
  /// Once, when it is released.
  void edited(const std::vector<grf::BrdfModel>& models);
  /// Somebody took a definition of the scene out of the library, to share it by its name.
  void definition_chosen(const QString& name);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void add_view(View view, const char* icon_name, const QString& name, const QString& tip, QWidget* contents);
  QWidget* sphere_with_exposure();
  QWidget* lobe_with_choices();
  void arrange();
  void show_brdf();
  void replace(const grf::BrdfModel& brdf);

  Definitions definitions_;
  bool is_unfolded_ = false;
  View view_ = View::Sphere;
  BrdfForm* form_ = nullptr;
  LiveSphere* sphere_ = nullptr;
  LobeView* lobe_ = nullptr;
  BrdfPlots* plots_ = nullptr;
  BrdfLibrary* library_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QWidget* bar_ = nullptr;
  QButtonGroup* buttons_ = nullptr;
  std::array<QWidget*, 4> views_ = {};
  BackgroundJob<MadeBrdf> making_{this};
};

}  // namespace editor
