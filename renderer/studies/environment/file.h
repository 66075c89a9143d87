// Environment maps for studies are read from files, or are a built-in sky, with a copy of fixed size for
// display and quadrature.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "renderer/studies/study_cache.h"
#include "renderer/studies/tool_state.h"
#include "renderer/transport/lights/environment_map.h"

namespace studies {

/// Returns the direction at a position (across, down) of an environment map, (0, 0) its upper left corner and
/// (1, 1) the lower right one.
reflectance::Vec3f map_direction(double across, double down);

struct MapPosition {
  double across = 0;
  double down = 0;
};
/// Inverts `map_direction`. The direction need not be of unit length.
MapPosition map_position(const reflectance::Vec3f& direction);

/// A latitude-longitude grid over the sphere, in the orientation of environment maps. Rows are from the top.
struct SphereGrid {
  int width = 0;
  int height = 0;

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  /// Returns the direction of a position in cells.
  reflectance::Vec3f direction(double x, double y) const { return map_direction(x / width, y / height); }
  /// Returns the solid angle of a rectangle of cells.
  double solid_angle(double top, double bottom, double across) const;
  std::size_t index_of(const reflectance::Vec3f& direction) const;
};

/// Returns the mean radiance over each cell of a grid, weighted by solid angle (box filter). Cells smaller
/// than texels repeat them.
std::vector<reflectance::Rgb> box_filtered(const image::Image& image, const SphereGrid& grid);

/// An environment map with its box-filtered copy. Samples are always drawn from the map itself.
struct FilteredMap {
  static constexpr SphereGrid Grid = {1024, 512};

  transport::EnvironmentMap map;
  std::vector<reflectance::Rgb> cells;
  std::string name;  ///< for people

  FilteredMap(transport::EnvironmentMap of, std::string called);
};

/// Returns a sky of 512 by 256 texels: a gradient with a sun 35 degrees high and 6 degrees wide, and dark
/// ground.
image::Image built_in_sky();

/// Reads an environment map, or makes the built-in sky if there is no file. An unreadable or black map is an
/// error. A map that a study still shows is not read again unless its file has changed.
std::shared_ptr<const FilteredMap> open_environment(const ToolState& state, StudyCache* cache,
                                                    grf::Diagnostics& diagnostics);

}  // namespace studies
