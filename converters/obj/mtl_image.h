#pragma once

#include <optional>
#include <string>

#include "converters/obj/wavefront_text.h"
#include "grf/math.h"

namespace convert {

/// A transform of texture coordinates: uv * scale + offset.
struct UvTransform {
  grf::Vec2d scale = grf::Vec2d(1);
  grf::Vec2d offset = grf::Vec2d(0);

  bool operator==(const UvTransform&) const = default;
  bool is_identity() const { return scale == grf::Vec2d(1) && offset == grf::Vec2d(0); }
  grf::Vec2f apply(const grf::Vec2f& uv) const { return grf::Vec2f(grf::Vec2d(uv) * scale + offset); }
};

/// An image in an MTL statement, with options such as `-s 2 2 1`.
struct MtlImage {
  std::string name;                ///< with `/` between folders, without quotes
  UvTransform uv;                  ///< the options `-s` and `-o`
  bool has_other_options = false;  ///< whether other options change its appearance
};

/// Parses a statement; returns nothing if it names no image.
std::optional<MtlImage> parse_image(const Statement& statement);

}  // namespace convert
