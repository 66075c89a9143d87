// The stages of a preview go from coarse to fine.
#pragma once

#include <optional>
#include <vector>

#include "renderer/transport/render.h"

namespace job {

/// A rectangle in fractions of an image's width and height, from its upper left corner.
struct PreviewRegion {
  double left = 0;
  double top = 0;
  double right = 1;
  double bottom = 1;

  bool operator==(const PreviewRegion&) const = default;
};

/// Returns the pixels of an image that a region touches, at least one.
transport::CropWindow pixels_of(const PreviewRegion& region, int width, int height);

/// Returns the settings of a preview's successive renders, of which the last is the one asked for. Those
/// before it have an eighth, a quarter and half of its resolution and one sample per pixel; stages that would
/// be less than 12 pixels across are skipped. With a region, only that is rendered.
std::vector<transport::RenderSettings> preview_stages(const transport::RenderSettings& whole,
                                                      const std::optional<PreviewRegion>& region = {});

/// Returns the image so far, of the crop window; tiles without samples are filled from `before`, a whole
/// image of the same view.
image::Image completed(const transport::Render& render, const image::Image& before);

/// Returns the whole image of these settings with this one in their crop window, black elsewhere.
image::Image in_whole_image(image::Image cropped, const transport::RenderSettings& settings);

}  // namespace job
