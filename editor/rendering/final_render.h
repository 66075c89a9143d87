#pragma once

#include <QFutureWatcher>
#include <QLockFile>
#include <QObject>
#include <QSet>
#include <QTemporaryDir>
#include <memory>
#include <optional>

#include "editor/document/import_folder.h"
#include "editor/programs/bundled_program.h"
#include "editor/rendering/render_report.h"
#include "editor/rendering/renderer_process.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/options/render_options.h"
#include "renderer/transport/image/image.h"

namespace editor {

/// What a final render is made of.
struct FinalRenderRequest {
  grf::Scene scene;
  QString path;  ///< of the scene's file; empty: it has none yet
  options::RenderOptions options;
  ImportFolders imports;     ///< with images that the scene names
  bool may_replace = false;  ///< an image that this session has not made
};

/// What a final render left.
struct FinalRenderResult {
  QString image;  ///< path
  QString copy;   ///< of that image, which later renders do not replace; there until this session ends
  RenderSummary summary;
  bool is_stopped = false;  ///< before it had all samples, or its target
};

/// Renders with the program `bpt`, from a snapshot of the scene: editing goes on meanwhile. One at a time.
class FinalRender : public QObject {
  Q_OBJECT

 public:
  explicit FinalRender(QString program = bundled_program("bpt"), QObject* parent = nullptr);
  /// A render that goes on is stopped, and its image kept, if that takes no more than some seconds.
  ~FinalRender() override;

  /// HOST:PORT where a viewer hears tev's protocol: whoever listens there passes to `show` what comes. Empty:
  /// nobody does.
  void set_display(const QString& address) { display_ = address; }

  /// Where such a render goes: the options' output; else beside the scene, under its name with .exr; else a
  /// temporary folder.
  QString output_of(const FinalRenderRequest& request) const;
  /// Whether the output exists, and was not made by this session.
  bool is_foreign(const QString& output) const;
  /// Renders to the request's output. What keeps it from that is said by `failed`.
  void start(FinalRenderRequest request);
  /// Ends the render; the image is kept, and marked as stopped.
  void stop();
  bool is_running() const { return is_running_; }
  const QString& output() const { return output_; }

  /// The image so far, under the name by which it was announced: that of another program is passed over.
  void show(const QString& name, const std::shared_ptr<const transport::Image>& image);

 signals:
  void started(const QString& output);
  void progressed(const editor::RenderReport& report);
  /// So far, or the whole one.
  void image_changed(std::shared_ptr<const transport::Image> image);
  /// A line of what the program says of its work.
  void logged(const QString& line);
  /// With an image.
  void finished(const editor::FinalRenderResult& result);
  /// There is no image, and why; a text without its stop.
  void failed(const QString& why);

 private:
  /// What was written for the program to read.
  struct Files {
    QString options;  ///< path of an OP file; empty: it could not be written
    QString problem;
  };

  /// What a render left, and its image; null: it cannot be read.
  struct Left {
    FinalRenderResult result;
    std::shared_ptr<const transport::Image> image;
  };

  static Left read_result(FinalRenderResult result, const QString& copy);
  bool lock_output();
  void run(const Files& files);
  void read(const QByteArray& line);
  void end(const RendererEnd& end);
  void finish();
  void give_up(const QString& why);

  QString display_;
  QTemporaryDir folder_;  ///< of this session
  int number_ = 0;        ///< of the render in this session
  bool is_running_ = false;
  bool is_stopped_ = false;
  QString output_;
  QSet<QString> made_;  ///< images of this session
  std::unique_ptr<QLockFile> lock_;
  QFutureWatcher<Files> writing_;
  QFutureWatcher<Left> reading_;
  RendererProcess process_;
  std::optional<RenderSummary> summary_;
};

}  // namespace editor
