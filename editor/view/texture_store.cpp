#include "editor/view/texture_store.h"

#include <QFileInfo>
#include <QtConcurrent>
#include <algorithm>
#include <utility>

namespace editor {

TextureStore::TextureStore(ImageProcess images) : images_(std::move(images)) {
  connect(&watch_, &FileWatch::changed, this, &TextureStore::read_changed);
}

void TextureStore::set_paths(const std::vector<std::string>& paths) {
  std::map<std::string, Entry> old = std::exchange(entries_, {});
  for (const std::string& path : paths) {
    const auto known = old.find(path);
    if (known != old.end()) {
      entries_.insert(*known);
    } else if (entries_.try_emplace(path).second) {
      start_reading(path);
    }
  }
  const auto has_same_path = [](const auto& a, const auto& b) { return a.first == b.first; };
  if (std::ranges::equal(old, entries_, has_same_path)) return;
  QStringList files;
  for (const auto& [path, entry] : entries_) files.append(QString::fromStdString(path));
  watch_.follow(files);
}

void TextureStore::start_reading(const std::string& path) {
  const int reading = ++readings_;
  entries_[path].reading = reading;
  const auto take = [this, path, reading](Entry read) {
    const auto entry = entries_.find(path);
    if (entry == entries_.end() || entry->second.reading != reading) return;
    entry->second = std::move(read);
    entry->second.reading = reading;
    if (!entry->second.problem.empty()) emit failed(QString::fromStdString(entry->second.problem));
    emit changed(path);
  };
  QtConcurrent::run(&threads_, read, images_, path, stop_.get_token()).then(this, take);
}

/// The former image is shown until the new one is read.
void TextureStore::read_changed(const QStringList& files) {
  for (const auto& [path, entry] : entries_) {
    if (files.contains(QFileInfo(QString::fromStdString(path)).absoluteFilePath())) start_reading(path);
  }
}

bool TextureStore::is_complete() const {
  return std::ranges::all_of(entries_, [](const auto& entry) { return entry.second.is_read; });
}

std::vector<ReadTexture> TextureStore::textures() const {
  std::vector<ReadTexture> textures;
  for (const auto& [path, entry] : entries_) {
    if (entry.is_read) textures.push_back({path, entry.image});
  }
  return textures;
}

TextureStore::Entry TextureStore::read(const ImageProcess& images, const std::string& path,
                                       const std::stop_token& stop) {
  grf::Diagnostics diagnostics;
  auto image = images.read(path, diagnostics, {}, stop, image::Alpha::Kept);
  if (image) return {std::make_shared<const image::Image>(*std::move(image)), {}, true, 0};
  const bool has_error = diagnostics.error_count() > 0;  // no message if it was stopped
  return {nullptr, has_error ? path + ": " + diagnostics.entries().front().message : std::string(), true, 0};
}

}  // namespace editor
