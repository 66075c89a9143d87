#pragma once

#include <QObject>
#include <QThreadPool>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/programs/image_process.h"

namespace editor {

/// An image that faces name; null if it cannot be read.
struct ReadTexture {
  std::string path;
  std::shared_ptr<const transport::Image> image;

  bool operator==(const ReadTexture&) const = default;
};

/// The images that faces name, read in processes of their own, each once.
class TextureStore : public QObject {
  Q_OBJECT

 public:
  explicit TextureStore(ImageProcess images = ImageProcess()) : images_(std::move(images)) {}
  ~TextureStore() override { stop_.request_stop(); }

  /// Starts to read those that are new, and forgets the others.
  void set_paths(const std::vector<std::string>& paths);
  /// Whether nothing more will come.
  bool is_complete() const;

  /// Those that were read.
  std::vector<ReadTexture> textures() const;

 signals:
  /// An image has come.
  void changed(const std::string& path);
  /// An image cannot be read; why, in words.
  void failed(const QString& message);

 private:
  struct Entry {
    std::shared_ptr<const transport::Image> image;
    std::string problem;  ///< empty: there is none
    bool is_read = false;
  };

  static Entry read(const ImageProcess& images, const std::string& path, const std::stop_token& stop);

  const ImageProcess images_;
  std::stop_source stop_;
  QThreadPool threads_;  // of its own: they wait for processes, which may hang
  std::map<std::string, Entry> entries_;
};

}  // namespace editor
