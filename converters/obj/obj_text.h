// A parser of OBJ files: parses and validates statement by statement.
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

/// The name of a material library, and the location of the name.
struct LibraryName {
  std::string name;
  grf::SourceLocation location;
};

/// A run-length encoded number per face, such as the index of its material.
class FaceRuns {
  struct Run {
    std::size_t first_face;
    std::uint32_t number;
  };

 public:
  /// Sets the number of a face and those after it. Before the first face the number is 0.
  void add(std::size_t face, std::uint32_t number);

  bool empty() const { return runs_.empty(); }

  /// A forward iterator over the faces.
  class Cursor {
   public:
    explicit Cursor(const FaceRuns& runs) : next_(runs.runs_.data()), end_(next_ + runs.runs_.size()) {}
    /// Returns the number of a face that is not before the last one asked for.
    std::uint32_t number_of(std::size_t face) {
      for (; next_ != end_ && next_->first_face <= face; ++next_) number_ = next_->number;
      return number_;
    }
    /// Returns the first face after the last one asked for with another number, or `faces` if there is none.
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
  // Numbers are correctly rounded to float.
  std::vector<grf::Vec3f> positions;
  grf::OptionalVertexValues<grf::Colour> colours;
  std::vector<grf::Vec2f> texture_coordinates;
  std::vector<grf::Vec3f> normals;

  /// The distinct corners of faces.
  std::vector<ObjCorner> corners;
  std::vector<std::uint32_t> face_corners;        ///< indices of corners of all faces, concatenated
  std::vector<std::uint32_t> face_offsets = {0};  ///< the start of each face, and one past the last
  std::vector<std::string> meshes;                ///< names from `o` and `g` statements that faces follow
  FaceRuns mesh_of_face;                          ///< indices into `meshes`
  std::vector<std::string> materials;             ///< names; the first one means no material
  FaceRuns material_of_face;                      ///< indices into `materials`
  FaceRuns smoothing;  ///< smoothing groups, 0 for none; empty if no face has a group without normals
  std::vector<LibraryName> libraries;

  std::size_t face_count() const { return face_offsets.size() - 1; }
  /// Returns the face's indices into `corners`, three or more.
  std::span<const std::uint32_t> face(std::size_t index) const {
    return std::span(face_corners)
        .subspan(face_offsets[index], face_offsets[index + 1] - face_offsets[index]);
  }

  // Counts of skipped elements.
  std::size_t lines = 0;
  std::size_t points = 0;
  std::size_t degenerate_faces = 0;  ///< faces of one or two corners
  std::size_t loose_vertices = 0;
  std::size_t deep_texture_coordinates = 0;   ///< texture coordinates with a third number that is not 0
  std::map<std::string, std::size_t> unread;  ///< number of skipped statements, by keyword
};

/// Parses all statements. Returns nothing after an error.
std::optional<ObjText> parse_obj(const SourceText& source, grf::Diagnostics& diagnostics);

}  // namespace convert
