#pragma once

#include <QStringList>
#include <vector>

#include "editor/image/image_entry.h"

namespace editor {

/// Images of different names, of which A is shown and B, another one, is what A is compared with.
class ImageSelection {
 public:
  const std::vector<ImageEntry>& entries() const { return entries_; }
  QStringList names() const;
  /// The entries hold no image if none is selected.
  const ImageEntry& image() const { return named(image_); }
  const ImageEntry& reference() const { return named(reference_); }

  /// Adds an image, or a new state of the one of that name. A new one becomes A, and one that is wanted.
  void put(const ImageEntry& entry, bool is_wanted);
  void remove(const QString& name);
  /// Makes an image A. If it was B, the two are exchanged.
  void select(const QString& name);
  /// Makes an image B, or none if the name is empty. If it was A, the two are exchanged.
  void select_reference(const QString& name);
  void swap();

  /// The name of a file's entry: short, unless an image of another folder is called so.
  QString name_of(const QString& path) const;

 private:
  const ImageEntry& named(const QString& name) const;

  std::vector<ImageEntry> entries_;
  QString image_;
  QString reference_;
};

}  // namespace editor
