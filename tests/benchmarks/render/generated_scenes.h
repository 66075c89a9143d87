// Scenes of the benchmark that are too large to be written by hand, as texts in GRF. Each is the same on
// every machine.
#pragma once

#include <string>

#include "renderer/image/image.h"

namespace benchmark {

/// A hall of 16 m with this many rectangular lamps under its ceiling, a square number: of different sizes,
/// colours and radiances, some of them tilted, and about the same power in total for any number. Partitions,
/// tables and columns hide most lamps from most points. The text includes sphere.grf and knot.grf, with the
/// BRDFs `metal` and `coated`.
std::string hall_of_lamps(int lamps);

/// Hills with this many instances of one tree, a square number: a trunk, branches, and this many leaves, each
/// of which is a quad. There is no light in it.
std::string forest(int trees, int leaves);

/// Vases on stairs, each with a texture of its own that repeats around it, and a floor with the last one:
/// vases turn, mirror and scale their textures by uv from -4 to 4. A third of them are coated. A vase has
/// `segments` quads around its axis and half as many along it.
std::string stairs_of_vases(int textures, int segments);

/// The name of the file of a texture of `stairs_of_vases`.
std::string texture_name(int index);

/// A pattern that repeats, of colours, lines and detail of its own for each index.
image::Image texture_pattern(int index, int size);

}  // namespace benchmark
