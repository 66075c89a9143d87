// An image of the list as it is displayed: itself, or one of its layers.
#pragma once

#include <QString>

#include "editor/image/image_entry.h"
#include "editor/image/screen_colours.h"

namespace editor {

struct ShownImage {
  QString name;         ///< with that of the layer; empty if there is no image
  SharedImage image;    ///< null if there is no image, or if it does not have the layer
  QString layer;        ///< name; empty for the image itself
  QString channels;     ///< letters of the layer's channels, if they have any
  SharedLayers layers;  ///< those of the entry
};

/// Shows an entry, or its layer of this name. A layer that is shown already is not converted again.
void update_shown(const ImageEntry& entry, const QString& layer, ShownImage& shown);

/// The settings that display a layer until they are changed: false colours for a variance or an error,
/// whose values differ by magnitudes.
ScreenSettings default_settings(const QString& layer);

/// Sets the values of a layer that are black and white: 0 and 1 for colours, equal distances from 0 for
/// vectors with negative components, the least and the largest value for a depth, and 0 and the largest one
/// for other values.
void fit_range(const ShownImage& shown, const ImageStatistics& statistics, ScreenSettings& settings);

/// Returns the image of a layer for an 8-bit file: black is 0 and white is 1.
SharedImage in_range(const ShownImage& shown, const ScreenSettings& settings);

}  // namespace editor
