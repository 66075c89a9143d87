#include "editor/image/shown_image.h"

#include <algorithm>
#include <cmath>

#include "editor/controls/text.h"
#include "editor/image/image_selection.h"

namespace editor {

void update_shown(const ImageEntry& entry, const QString& layer, ShownImage& shown) {
  if (layer.isEmpty() || !entry.image) {
    shown = {entry.name, entry.image, layer, {}, entry.layers};
    return;
  }
  const image::ImageLayer* found = find_layer(entry, layer);
  const QString name = entry.name + " · " + layer;
  if (found == nullptr) {
    shown = {name, nullptr, layer, {}, entry.layers};
  } else if (shown.layer != layer || shown.layers != entry.layers || !shown.image) {
    const int width = entry.image->width;
    const int height = entry.image->height;
    shown = {name, std::make_shared<const image::Image>(image::image_of(*found, width, height)), layer,
             text_of(found->channels), entry.layers};
  }
  shown.name = name;
}

ScreenSettings default_settings(const QString& layer) {
  ScreenSettings settings;
  const QString name = layer.section('.', -1);
  if (name == "variance" || name == "error") settings.colouring = Colouring::FalseColour;
  return settings;
}

void fit_range(const ShownImage& shown, const ImageStatistics& statistics, ScreenSettings& settings) {
  settings.is_radiance = shown.layer.isEmpty();
  settings.is_relative_error = shown.layer.section('.', -1) == "error" && shown.channels.isEmpty();
  if (settings.is_radiance || shown.channels.startsWith('R')) return;
  const float least = statistics.least_value;
  const float largest = statistics.largest_value;
  if (shown.channels.size() > 1) {
    settings.white = std::max(std::abs(least), std::abs(largest));
    settings.black = least < 0 ? -settings.white : 0;
  } else {
    settings.black = shown.channels == "Z" ? least : std::min(least, 0.0F);
    settings.white = largest;
  }
  if (!(settings.white > settings.black)) settings.white = settings.black + 1;
}

SharedImage in_range(const ShownImage& shown, const ScreenSettings& settings) {
  if (!shown.image || (settings.black == 0 && settings.white == 1)) return shown.image;
  auto image = std::make_shared<image::Image>(*shown.image);
  for (grf::Colour& pixel : image->pixels)
    pixel = (pixel - grf::Colour(settings.black)) / (settings.white - settings.black);
  return image;
}

}  // namespace editor
