#pragma once

#include <QFutureWatcher>
#include <QLockFile>
#include <QObject>
#include <QSet>
#include <QTemporaryDir>
#include <memory>
#include <optional>

#include "editor/document/import_folder.h"
#include "editor/document/preferences.h"
#include "editor/programs/bundled_program.h"
#include "editor/rendering/render_report.h"
#include "editor/rendering/renderer_process.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/image/image.h"
#include "renderer/options/render_options.h"

namespace editor {

/// The input of a final render.
struct FinalRenderRequest {
  grf::Scene scene;
  QString path;  ///< of the scene's file; empty if it has none
  options::RenderOptions options;
  ImportFolders imports;                ///< folders with images that the scene uses
  bool may_overwrite = false;           ///< whether to overwrite an image of another session
  std::optional<FarmAccess> farm = {};  ///< none: this machine renders
};

/// The result of a final render.
struct FinalRenderResult {
  QString image;   ///< path; of an animation, that of the last frame
  QString copy;    ///< path of a copy that later renders do not overwrite, until this session ends
  QString former;  ///< path of such a copy of the image that this one replaced; empty if there was none
  RenderSummary summary;
  bool is_stopped = false;  ///< before it had all samples or reached its target error
};

/// Renders a snapshot of the scene with the program `bpt`, while editing continues. One render at a time.
class FinalRender : public QObject {
  Q_OBJECT

 public:
  explicit FinalRender(QString program = bundled_program("bpt"), QObject* parent = nullptr);
  /// Stops a running render and keeps its image, if that takes no more than some seconds.
  ~FinalRender() override;

  /// Sets HOST:PORT of a viewer with tev's protocol, which passes received images to `show`. Empty: none.
  void set_display(const QString& address) { display_ = address; }

  /// The output path: that of the options; else beside the scene, under its name with .exr; else in a
  /// temporary folder.
  QString output_of(const FinalRenderRequest& request) const;
  /// The images that a render writes: the output, or one per frame of an animation, as `bpt` names them.
  QStringList images_of(const FinalRenderRequest& request) const;
  /// Whether the output exists and was not rendered in this session.
  bool is_from_other_session(const QString& output) const;
  /// Whether an image was, or is being, rendered in this session.
  bool has_rendered(const QString& image) const { return image == output_ || rendered_.contains(image); }
  /// Renders to the request's output. `failed` reports why it cannot start.
  void start(FinalRenderRequest request);
  /// Stops the render; the image is kept and marked as stopped.
  void stop();
  bool is_running() const { return is_running_; }
  /// The image that is rendered: of an animation, the current frame.
  const QString& output() const { return output_; }

  /// Shows the image rendered so far if it has the announced name; images of other programs are ignored.
  void show(const QString& name, const std::shared_ptr<const image::Image>& image);

 signals:
  void started(const QString& output);
  void progressed(const editor::RenderReport& report);
  /// Emitted with the image rendered so far, or the final one.
  void image_changed(std::shared_ptr<const image::Image> image);
  /// Emitted with a line of the program's log.
  void logged(const QString& line);
  /// Emitted when there is an image.
  void finished(const editor::FinalRenderResult& result);
  /// Emitted with the reason, without a full stop, when there is no image.
  void failed(const QString& why);

 private:
  /// The input files of the program.
  struct Files {
    QString options;  ///< path of an OP file; empty if it could not be written
    QString problem;
    QString former;  ///< path of a copy of the image that is replaced; empty if there is none
  };

  /// The result and its image; null if it cannot be read.
  struct Outcome {
    FinalRenderResult result;
    std::shared_ptr<const image::Image> image;
  };

  static Outcome read_result(FinalRenderResult result, const QString& copy);
  bool lock_output();
  void run(const Files& files);
  void run_on_farm();
  void read(const QByteArray& line);
  void end(const RendererEnd& end);
  void finish();
  void give_up(const QString& why);

  QString display_;
  QTemporaryDir folder_;  ///< for this session
  int number_ = 0;        ///< number of the render in this session
  bool is_running_ = false;
  bool is_stopped_ = false;
  QString output_;
  QStringList images_;  ///< of the current render
  int done_images_ = 0;
  QSet<QString> rendered_;  ///< images rendered in this session
  QString options_file_;    ///< of the current render
  std::optional<FarmAccess> farm_;
  std::unique_ptr<QLockFile> lock_;
  QFutureWatcher<Files> writing_;
  QFutureWatcher<Outcome> reading_;
  RendererProcess process_;
  std::optional<RenderSummary> summary_;
  QString former_;  ///< see FinalRenderResult
};

}  // namespace editor
