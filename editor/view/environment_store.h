#pragma once

#include <QObject>
#include <QThreadPool>
#include <memory>
#include <string>

#include "editor/document/file_watch.h"
#include "editor/programs/image_process.h"
#include "editor/view/scene_environment.h"
#include "renderer/options/render_options.h"

namespace editor {

/// Loads the environment map or backplate of a scene for the views. A thread reads it by a child process,
/// reduces it and finds its lights, once, and again when its file changes; a rotation or a brightness needs
/// nothing of that.
class EnvironmentStore : public QObject {
  Q_OBJECT

 public:
  explicit EnvironmentStore(ImageProcess images = ImageProcess());
  ~EnvironmentStore() override { stop_.request_stop(); }

  /// Sets the options that name the image. The former environment is shown until the new one is read.
  void set_options(const options::RenderOptions& render_options);
  /// The environment as far as it is loaded; null: the scene has none.
  const std::shared_ptr<const SceneEnvironment>& environment() const { return environment_; }
  bool is_complete() const { return !is_reading_; }
  /// How often an image was read so far.
  int readings() const { return reading_; }

 signals:
  /// Emitted when there is another environment.
  void changed();
  /// Emitted with the reason when an image cannot be read.
  void failed(const QString& message);

 private:
  /// A loaded map is as its file has it, without rotation and brightness.
  struct Loaded {
    std::shared_ptr<const SceneEnvironment> environment;
    std::string problem;
  };

  void start_reading();
  void show_loaded();
  static Loaded read(const ImageProcess& images, const std::string& path, bool is_backplate,
                     const std::stop_token& stop);

  const ImageProcess images_;
  std::stop_source stop_;
  QThreadPool threads_;  // of its own: they wait for processes, which may hang
  std::string path_;     // of the image; empty: none
  bool is_backplate_ = false;
  float rotation_ = 0;  // degrees
  float scale_ = 1;
  int reading_ = 0;  // number of the latest reading
  bool is_reading_ = false;
  std::shared_ptr<const SceneEnvironment> loaded_;
  std::shared_ptr<const SceneEnvironment> environment_;
  FileWatch watch_;
};

}  // namespace editor
