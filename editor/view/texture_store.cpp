#include "editor/view/texture_store.h"

#include <QtConcurrent>
#include <algorithm>
#include <utility>

namespace editor {

void TextureStore::set_paths(const std::vector<std::string>& paths) {
  std::map<std::string, Entry> old = std::exchange(entries_, {});
  for (const std::string& path : paths) {
    const auto known = old.find(path);
    if (known != old.end()) {
      entries_.insert(*known);
      continue;
    }
    if (!entries_.try_emplace(path).second) continue;
    QtConcurrent::run(&threads_, read, images_, path, stop_.get_token()).then(this, [this, path](Entry read) {
      const auto entry = entries_.find(path);
      if (entry == entries_.end() || entry->second.is_read) return;
      entry->second = std::move(read);
      if (!entry->second.problem.empty()) emit failed(QString::fromStdString(entry->second.problem));
      emit changed(path);
    });
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
  auto image = images.read(path, diagnostics, {}, stop);
  if (image) return {std::make_shared<const transport::Image>(*std::move(image)), {}, true};
  const bool has_error = diagnostics.error_count() > 0;  // no message if it was stopped
  return {nullptr, has_error ? path + ": " + diagnostics.entries().front().message : std::string(), true};
}

}  // namespace editor
