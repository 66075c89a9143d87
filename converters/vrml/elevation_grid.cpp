#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "converters/vrml/vrml97_geometry.h"
#include "converters/wording.h"

namespace convert::vrml {
namespace {

class GridReader {
 public:
  GridReader(const Node& node, Report& report)
      : node_(node), reader_(node, report.diagnostics()), report_(report) {}

  std::optional<Polygons> run() {
    if (!read_heights()) return std::nullopt;
    for (std::size_t j = 0; j + 1 < rows_; ++j) {
      for (std::size_t i = 0; i + 1 < columns_; ++i) {
        polygons_.add_face(
            std::array{vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
      }
    }
    read_colours_of_grid();
    const bool has_normals = read_normals();
    read_texture_coordinates();
    if (!reader_.flag("ccw", true)) polygons_.reverse_faces();
    if (!has_normals) add_crease_normals(polygons_, reader_.number("creaseAngle", 0));
    if (report_.failed()) return std::nullopt;
    return std::move(polygons_);
  }

 private:
  std::uint32_t vertex(std::size_t i, std::size_t j) const {
    return static_cast<std::uint32_t>(i + j * columns_);
  }

  bool read_heights() {
    const int columns = reader_.integer("xDimension", 0);
    const int rows = reader_.integer("zDimension", 0);
    const double x_spacing = reader_.number("xSpacing", 1);
    const double z_spacing = reader_.number("zSpacing", 1);
    const auto heights = reader_.numbers("height");
    if (report_.failed()) return false;
    columns_ = static_cast<std::size_t>(std::max(columns, 0));
    rows_ = static_cast<std::size_t>(std::max(rows, 0));
    if (heights.size() != columns_ * rows_) {
      reader_.error_at("height", fmt::format("the field 'height' has {}, expected {} times {}",
                                             counted(heights.size(), "number", "numbers"), columns, rows));
      return false;
    }
    polygons_.positions.reserve(heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i) {
      polygons_.positions.emplace_back(grf::Vec3d(x_spacing * static_cast<double>(i % columns_), heights[i],
                                                  z_spacing * static_cast<double>(i / columns_)));
    }
    return true;
  }

  /// Returns whether there are at least as many values as vertices, or faces.
  bool has_enough(std::string_view field, std::size_t values, bool per_vertex) {
    const std::size_t expected = per_vertex ? polygons_.positions.size() : polygons_.face_count();
    if (values >= expected) return true;
    reader_.error_at(field, fmt::format("the field '{}' has {}, expected {}", field,
                                        counted(values, "value", "values"), expected));
    return false;
  }

  void read_colours_of_grid() {
    const Node* node = report_.node_of(node_, "color", "Color");
    if (node == nullptr) return;
    auto colours = read_colours(*node, report_);
    const bool per_vertex = reader_.flag("colorPerVertex", true);
    if (!has_enough("color", colours.size(), per_vertex)) return;
    if (per_vertex) {
      polygons_.colours = picked(colours, polygons_.corners);
    } else {
      colours.resize(polygons_.face_count());
      polygons_.face_colours = std::move(colours);
    }
  }

  bool read_normals() {
    const Node* node = report_.node_of(node_, "normal", "Normal");
    if (node == nullptr) return false;
    auto normals = read_vectors(*node, "vector", report_);
    const bool per_vertex = reader_.flag("normalPerVertex", true);
    if (!has_enough("normal", normals.size(), per_vertex)) return true;
    normals.resize(per_vertex ? polygons_.positions.size() : polygons_.face_count());
    polygons_.normals =
        per_vertex ? picked(normals, polygons_.corners) : spread_over_corners(normals, polygons_);
    return true;
  }

  void read_texture_coordinates() {
    if (const Node* node = report_.node_of(node_, "texCoord", "TextureCoordinate")) {
      const auto uvs = read_uvs(*node, report_);
      if (has_enough("texCoord", uvs.size(), true)) polygons_.uvs = picked(uvs, polygons_.corners);
      return;
    }
    for (const std::uint32_t corner : polygons_.corners) {
      polygons_.uvs.emplace_back(
          grf::Vec2d(static_cast<double>(corner % columns_) / static_cast<double>(columns_ - 1),
                     static_cast<double>(corner / columns_) / static_cast<double>(rows_ - 1)));
    }
  }

  const Node& node_;
  NodeReader reader_;
  Report& report_;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  Polygons polygons_ = {};
};

}  // namespace

std::optional<Polygons> read_elevation_grid(const Node& node, Report& report) {
  return GridReader(node, report).run();
}

}  // namespace convert::vrml
