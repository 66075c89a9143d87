#include "converters/vrml/geometry_readers.h"

#include <fmt/format.h>

#include "converters/vrml/primitives.h"

namespace convert::vrml {

std::vector<grf::Vec3f> read_vectors(const Node& node, std::string_view field, Report& report) {
  const std::span<const double> numbers = NodeReader(node, report.diagnostics()).numbers(field, 3);
  std::vector<grf::Vec3f> vectors;
  vectors.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    vectors.emplace_back(grf::Vec3d(numbers[i], numbers[i + 1], numbers[i + 2]));
  }
  return vectors;
}

std::vector<grf::Vec2f> read_uvs(const Node& node, Report& report) {
  const std::span<const double> numbers = NodeReader(node, report.diagnostics()).numbers("point", 2);
  std::vector<grf::Vec2f> uvs;
  uvs.reserve(numbers.size() / 2);
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    uvs.emplace_back(grf::Vec2d(numbers[i], numbers[i + 1]));
  }
  return uvs;
}

double read_size(const Node& node, std::string_view field, double fallback, Report& report) {
  const NodeReader reader(node, report.diagnostics());
  const double size = reader.number(field, fallback);
  if (!(size > 0)) {
    reader.error_at(field,
                    fmt::format("the field '{}' of {} is {}, expected more than 0", field, node.type, size));
  }
  return size;
}

void note_tessellation(Report& report) {
  report.add("curved solid became polygons", "curved solids became polygons",
             fmt::format("they have {} sides around", SidesOfRound));
}

}  // namespace convert::vrml
