#pragma once

#include <QStringList>
#include <vector>

#include "editor/image/image_entry.h"

namespace editor {

/// A list of uniquely named images, with the shown image A and the reference B, of which one layer is shown.
class ImageSelection {
 public:
  const std::vector<ImageEntry>& entries() const { return entries_; }
  QStringList names() const;
  /// The entry of A; it holds no image if none is selected.
  const ImageEntry& image() const { return named(image_); }
  const ImageEntry& reference() const { return named(reference_); }
  /// The names of the layers of A.
  QStringList layers() const;
  /// The shown layer; empty for the image itself, also if A does not have the chosen layer.
  QString layer() const;

  /// Adds or updates an image by its name. A new one becomes A, and one with `is_wanted`.
  void put(const ImageEntry& entry, bool is_wanted);
  void remove(const QString& name);
  /// Makes an image A. If it was B, the two are exchanged.
  void select(const QString& name);
  /// Makes an image B, or none if the name is empty. If it was A, the two are exchanged.
  void select_reference(const QString& name);
  void swap();
  /// Chooses the layer that is shown; empty for the image itself. It stays the choice for other images.
  void select_layer(const QString& name) { layer_ = name; }

  /// The entry name of a file: short, unless an image of another folder has that name.
  QString name_of(const QString& path) const;

 private:
  const ImageEntry& named(const QString& name) const;

  std::vector<ImageEntry> entries_;
  QString image_;
  QString reference_;
  QString layer_;
};

/// The layer of an image with this name; null if it has none.
const image::ImageLayer* find_layer(const ImageEntry& entry, const QString& name);

}  // namespace editor
