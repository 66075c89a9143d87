#include "editor/image/image_selection.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "editor/controls/text.h"

namespace editor {

const ImageEntry& ImageSelection::named(const QString& name) const {
  static const ImageEntry none;
  const auto found =
      std::ranges::find_if(entries_, [&](const ImageEntry& entry) { return entry.name == name; });
  return found == entries_.end() ? none : *found;
}

QStringList ImageSelection::names() const {
  QStringList names;
  for (const ImageEntry& entry : entries_) names << entry.name;
  return names;
}

void ImageSelection::put(const ImageEntry& entry, bool is_wanted) {
  const qsizetype place = names().indexOf(entry.name);
  if (place < 0) {
    entries_.push_back(entry);
  } else {
    entries_[static_cast<std::size_t>(place)] = entry;
  }
  if ((place < 0 || is_wanted) && reference_ != entry.name) image_ = entry.name;
}

void ImageSelection::remove(const QString& name) {
  std::erase_if(entries_, [&](const ImageEntry& entry) { return entry.name == name; });
  if (reference_ == name) reference_.clear();
  if (image_ == name) image_ = entries_.empty() ? QString() : entries_.back().name;
  if (reference_ == image_) reference_.clear();
}

void ImageSelection::select(const QString& name) {
  if (!named(name).image) return;
  if (reference_ == name) reference_ = image_;
  image_ = name;
}

void ImageSelection::select_reference(const QString& name) {
  if (!name.isEmpty() && !named(name).image) return;
  if (name == image_) return swap();
  reference_ = name;
}

void ImageSelection::swap() {
  if (reference().image) std::swap(image_, reference_);
}

QStringList ImageSelection::layers() const {
  QStringList names;
  if (!image().layers) return names;
  for (const image::ImageLayer& layer : *image().layers) names << text_of(layer.name);
  return names;
}

QString ImageSelection::layer() const { return find_layer(image(), layer_) != nullptr ? layer_ : QString(); }

QString ImageSelection::name_of(const QString& path) const {
  const QString name = QFileInfo(path).fileName();
  const ImageEntry& same = named(name);
  return same.image && same.path != path ? path : name;
}

const image::ImageLayer* find_layer(const ImageEntry& entry, const QString& name) {
  if (!entry.layers) return nullptr;
  const auto found = std::ranges::find(*entry.layers, name.toStdString(), &image::ImageLayer::name);
  return found == entry.layers->end() ? nullptr : &*found;
}

}  // namespace editor
