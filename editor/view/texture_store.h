#pragma once

#include <QObject>
#include <QThreadPool>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/document/file_watch.h"
#include "editor/programs/image_process.h"

namespace editor {

/// A texture image; null if it cannot be read.
struct ReadTexture {
  std::string path;
  std::shared_ptr<const image::Image> image;

  bool operator==(const ReadTexture&) const = default;
};

/// Loads the textures of faces in child processes, each once, and again when its file changes.
class TextureStore : public QObject {
  Q_OBJECT

 public:
  explicit TextureStore(ImageProcess images = ImageProcess());
  ~TextureStore() override { stop_.request_stop(); }

  /// Starts to load new ones, and drops unused ones.
  void set_paths(const std::vector<std::string>& paths);
  /// Whether everything is loaded.
  bool is_complete() const;

  /// The loaded textures.
  std::vector<ReadTexture> textures() const;

 signals:
  /// Emitted when a texture was loaded.
  void changed(const std::string& path);
  /// Emitted with the reason when a texture cannot be read.
  void failed(const QString& message);

 private:
  struct Entry {
    std::shared_ptr<const image::Image> image;
    std::string problem;  ///< error message; empty if there is none
    bool is_read = false;
    int reading = 0;  ///< number of the latest reading
  };

  void start_reading(const std::string& path);
  void read_changed(const QStringList& files);

  static Entry read(const ImageProcess& images, const std::string& path, const std::stop_token& stop);

  const ImageProcess images_;
  std::stop_source stop_;
  QThreadPool threads_;  // of its own: they wait for processes, which may hang
  std::map<std::string, Entry> entries_;
  int readings_ = 0;
  FileWatch watch_;
};

}  // namespace editor
