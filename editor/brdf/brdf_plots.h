#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "editor/brdf/lobe_curves.h"
#include "editor/jobs/background_job.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QCustomPlot;
class QHBoxLayout;
class QLineEdit;

namespace editor {

class ThemedLabel;

/// Plots a BRDF in the plane of incidence, polar and Cartesian, with the pdf of a sampling scheme, and its
/// albedo against the view angle. The curves are computed in threads, which are cancelled when the BRDF
/// changes.
class BrdfPlots : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { Polar, Cartesian, Albedo };

  explicit BrdfPlots(QWidget* parent = nullptr);

  /// Sets the BRDF; for null, the hint is shown instead: why not, or what to do.
  void set_brdf(SharedBrdf brdf, const QString& hint = {});
  /// Sets the scheme whose pdf is drawn, if any. The user may choose another one.
  void set_scheme(const std::optional<grf::PdfModel>& scheme);
  void set_kind(Kind kind);
  Kind kind() const { return kind_; }

  /// The curves that are drawn now.
  const LobeCurves& curves() const { return curves_; }
  const plot::AlbedoCurve& albedo() const { return albedo_; }
  bool is_busy() const { return curves_job_.is_busy() || albedo_job_.is_busy(); }

  /// Exports the plot as .svg, .png or .pdf, or its values as .csv. Returns an error message, empty on
  /// success.
  QString export_to(const QString& path);

 signals:
  void updated();  ///< the plot was redrawn with new values

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void build_kinds(QHBoxLayout& row);
  void build_choices(QHBoxLayout& row);
  void build_views(QHBoxLayout& row);
  void take_views();
  void compute();
  void compute_albedo(int samples);
  void draw();
  void draw_lobes();
  void show_words(const QString& text, bool is_warning);
  void choose_export();
  plot::LobeStyle style() const;

  SharedBrdf brdf_;
  std::vector<double> views_ = {0, 30, 60, 80};  // degrees from the normal, from 0 to under 90
  Kind kind_ = Kind::Polar;
  LobeCurves curves_;
  plot::AlbedoCurve albedo_;
  bool curves_are_old_ = true;
  bool albedo_is_old_ = true;

  QButtonGroup* kinds_ = nullptr;
  QComboBox* quantity_ = nullptr;
  QComboBox* channel_ = nullptr;
  QCheckBox* logarithmic_ = nullptr;
  QLineEdit* view_line_ = nullptr;
  QComboBox* scheme_ = nullptr;
  std::optional<grf::PdfModel> own_scheme_;  ///< set by the caller, with parameters
  QCustomPlot* plot_ = nullptr;
  QString hint_;  // instead of plots
  ThemedLabel* words_ = nullptr;
  QWidget* lobe_controls_ = nullptr;
  BackgroundJob<LobeCurves> curves_job_{this};
  BackgroundJob<plot::AlbedoCurve> albedo_job_{this};
};

}  // namespace editor
