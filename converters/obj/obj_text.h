// The text of an OBJ file, parsed and checked statement by statement.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "converters/obj/obj_corner.h"
#include "converters/obj/wavefront_text.h"
#include "grf/diagnostics.h"
#include "grf/math.h"
#include "grf/mesh.h"

namespace convert {

/// The name of a material library, and where it was named.
struct LibraryName {
  std::string name;
  grf::SourceLocation location;
};

/// Numbers that faces which follow each other have in common, such as the index of their material.
class FaceRuns {
  struct Run {
    std::size_t first_face;
    std::uint32_t number;
  };

 public:
  /// The face has the number, and so have those after it. Before the first face of all the number is 0.
  void add(std::size_t face, std::uint32_t number);

  bool empty() const { return runs_.empty(); }

  /// Goes through the faces in their order.
  class Cursor {
   public:
    explicit Cursor(const FaceRuns& runs) : next_(runs.runs_.data()), end_(next_ + runs.runs_.size()) {}
    /// The number of a face that is not before the last one asked for.
    std::uint32_t number_of(std::size_t face) {
      for (; next_ != end_ && next_->first_face <= face; ++next_) number_ = next_->number;
      return number_;
    }
    /// The first face behind the last one asked for that has another number, or `faces` if there is none.
    std::size_t end_of_run(std::size_t faces) const { return next_ == end_ ? faces : next_->first_face; }

   private:
    const Run* next_;
    const Run* end_;
    std::uint32_t number_ = 0;
  };

 private:
  std::vector<Run> runs_;
};

struct ObjText {
  // Each number is the float nearest to its text.
  std::vector<grf::Vec3f> positions;
  grf::OptionalVertexValues<grf::Colour> colours;
  std::vector<grf::Vec2f> texture_coordinates;
  std::vector<grf::Vec3f> normals;

  /// The different corners that faces have.
  std::vector<ObjCorner> corners;
  std::vector<std::uint32_t> face_corners;        ///< indices of corners, of all faces one after the other
  std::vector<std::uint32_t> face_offsets = {0};  ///< where each face's begin, and one end
  std::vector<std::string> meshes;     ///< their names: of `o` and `g` statements that faces follow
  FaceRuns mesh_of_face;               ///< indices of their names
  std::vector<std::string> materials;  ///< their names; the first one stands for none
  FaceRuns material_of_face;           ///< indices of their names
  FaceRuns smoothing;                  ///< groups, 0 for none; empty where no face has a group and no normals
  std::vector<LibraryName> libraries;

  std::size_t face_count() const { return face_offsets.size() - 1; }
  /// Indices of `corners`, three or more.
  std::span<const std::uint32_t> face(std::size_t index) const {
    return std::span(face_corners)
        .subspan(face_offsets[index], face_offsets[index + 1] - face_offsets[index]);
  }

  // What is left out.
  std::size_t lines = 0;
  std::size_t points = 0;
  std::size_t short_faces = 0;  ///< of one or two corners
  std::size_t loose_vertices = 0;
  std::size_t deep_texture_coordinates = 0;   ///< with a third number that is not 0
  std::map<std::string, std::size_t> unread;  ///< statements that are not read, by keyword
};

/// Parses all statements. Returns nothing after an error.
std::optional<ObjText> parse_obj(const SourceText& source, grf::Diagnostics& diagnostics);

}  // namespace convert
