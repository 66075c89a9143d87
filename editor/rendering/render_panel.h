#pragma once

#include <QPointer>
#include <QString>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "editor/jobs/background_job.h"
#include "editor/rendering/final_render.h"
#include "editor/rendering/preview.h"
#include "editor/rendering/render_forecast.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QPlainTextEdit;
class QProgressBar;

namespace editor {

class Document;
class ErrorCurve;
class FittedImage;
class ForecastRow;
class Job;
class JobList;
class NoiseWindow;
class OpDocument;
class RenderHistory;
class RenderSettingsRow;
class ScaleBar;
struct EffectRender;

/// A preview in a 3D view replaces the size and the camera of the render options by these.
struct PreviewView {
  QSize size;  ///< device pixels
  transport::View camera;
  bool denoises = false;
  std::optional<job::PreviewRegion> region = {};  ///< renders nothing else

  bool operator==(const PreviewView&) const = default;
};

/// The Render dock: a progressive preview that follows edits, and final renders by `bpt`, which are jobs in a
/// queue.
class RenderPanel : public QWidget {
  Q_OBJECT

 public:
  /// The panel renders the document and edits its render options. Document and jobs outlive it.
  RenderPanel(Document& document, JobList& jobs, const QString& program = bundled_program("bpt"),
              QWidget* parent = nullptr);

  /// Sets the view of previews, which is more precise than the options' camera. It applies from the next
  /// change of the options until they have another camera.
  void set_view(const transport::View& view) { view_ = view; }

  /// Sets the number of threads where the render options leave it open; 0: one per core. A running preview
  /// restarts.
  void set_threads(int threads);
  /// Sets the farm on which final renders can be made; one without a server is none.
  void set_farm(const FarmAccess& farm);
  /// Shows the preview in a 3D view: it is started, and follows that view and the edits until it is stopped.
  /// Without a view the preview is stopped.
  void set_preview_view(const std::optional<PreviewView>& view);

  Preview& preview() { return preview_; }
  FinalRender& final_render() { return final_; }
  /// A final render of the scene and its options as they are now.
  FinalRenderRequest final_request() const;
  /// The render of this session that wrote an image, or of which it is a copy; else the last render that
  /// replaced an image. Null if there is none.
  const FinalRenderResult* last_render_of(const QString& image) const;
  // Actions for menus; their shortcuts are those of the window.
  QAction* preview_action() const { return preview_action_; }
  QAction* render_action() const { return render_action_; }
  QAction* cameras_action() const { return cameras_action_; }
  QAction* effects_action() const { return effects_action_; }
  QAction* animation_action() const { return animation_action_; }
  QAction* compare_action() const { return compare_action_; }
  QAction* stop_action() const { return stop_action_; }
  QAction* options_action() const { return options_action_; }
  /// Opens the window that shows where the noise is from.
  QAction* noise_action() const { return noise_action_; }
  /// Switches the preview, here and in a view, from its colours to the relative error of its pixels.
  QAction* error_action() const { return error_action_; }

 signals:
  /// Emitted before a preview starts, which shows what the document has then.
  void preview_starting();
  /// Requests the window of all options.
  void options_requested();
  /// Requests to open an image file in the image view.
  void image_opened(const QString& path);
  /// Requests to compare the image of the last render with its former state in the image view.
  void comparison_requested();
  /// Requests to show the image view, in which the images of renders appear.
  void images_requested();
  /// Requests to open the preview in the image view.
  void preview_opened();
  /// Emitted when the OP file beside the scene differs from the current render settings, which saving the
  /// scene writes.
  void op_file_differs(const QString& path);

 private:
  void make_actions();
  void lay_out();
  QWidget* make_controls();
  QWidget* make_picture();
  QPlainTextEdit* make_log();
  void connect_preview();
  void connect_final();
  void connect_forecast();
  void outdate_forecast();
  void follow_forecast();
  void show_forecast_options();
  void make_forecast();
  void make_accuracy_actions();
  void show_noise();
  QLabel* make_visible_noise(QWidget* parent);
  void show_visible_noise(const std::optional<VisibleNoiseReport>& noise);
  void list_preview(job::PreviewState state);
  void toggle_preview();
  void restart_preview();
  options::RenderOptions options_with_threads() const;
  void start_preview();
  void follow();
  options::RenderOptions preview_options() const;
  void show_in_preview(const grf::Scene& scene);
  void render();
  void render_cameras();
  void render_effects();
  void choose_effects(const FinalRenderRequest& request, const std::vector<EffectRender>& effects);
  void render_animation();
  void queue(std::vector<FinalRenderRequest> requests);
  void begin(Job& job, const FinalRenderRequest& request);
  void end_job();
  void stop();
  bool may_overwrite(const QStringList& images);
  void keep_op_file();
  void show_options();
  void finish(const FinalRenderResult& result);
  QComboBox* make_machines(QWidget* parent);
  void show_progress(double done, std::optional<double> seconds_left, std::optional<double> error,
                     const std::optional<FarmReport>& farm = {});
  void show_status(const QString& text);
  void log(const QString& text);
  void open_image();
  void update_actions();

  enum Machines { ThisMachine, OnFarm };  ///< entries of the list

  Document& document_;
  JobList& jobs_;
  FarmAccess farm_;
  QComboBox* machines_ = nullptr;
  QPointer<Job> job_;          ///< the running render
  QPointer<Job> preview_job_;  ///< the preview while it renders
  OpDocument& options_;
  std::optional<transport::View> view_;
  int threads_ = 0;
  std::optional<PreviewView> preview_view_;
  bool follows_ = false;                         ///< whether the preview of a view follows edits
  options::RenderOptions previewed_options_;     ///< of the last preview
  QString image_path_;                           ///< of the shown image; empty for the preview
  std::vector<FinalRenderResult> replacements_;  ///< the last render of each image that replaced one
  options::RenderOptions forecast_options_;      ///< what the last forecast depends on
  bool is_forecast_outdated_ = true;
  bool resumes_after_ = false;  ///< whether the preview was paused for a render

  QAction* preview_action_;
  QAction* render_action_;
  QAction* cameras_action_;
  QAction* effects_action_;
  QAction* animation_action_;
  QAction* compare_action_;
  QAction* stop_action_;
  QAction* options_action_;
  QAction* error_action_;
  QAction* noise_action_;
  RenderSettingsRow* settings_;
  QCheckBox* without_hidden_;
  ForecastRow* forecast_row_;
  QProgressBar* progress_;
  QLabel* status_;
  QLabel* visible_noise_;
  FittedImage* image_;
  ScaleBar* error_scale_;
  ErrorCurve* curve_;
  QPlainTextEdit* log_;
  RenderHistory* history_;
  BackgroundJob<grf::Scene> hiding_{this};  ///< removes hidden faces for the preview
  Preview preview_;
  FinalRender final_;
  RenderForecast forecast_;
  const QString program_;
  QPointer<NoiseWindow> noise_window_;
  QTimer forecast_timer_;  ///< runs while edits may follow
};

}  // namespace editor
