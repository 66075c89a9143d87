// Finds faces by what they are: direction, area, height, material, and similarity to selected ones.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "editor/document/face_selection.h"

namespace editor {

/// The attributes in which a face must agree with selected ones to be similar: all that are set. Surface
/// attributes and the object are those of one selected face; normal and area are compared with their means
/// over all selected faces.
struct Similarity {
  bool brdf = false;
  bool pdf = false;
  bool colour = false;
  bool texture = false;
  bool emission = false;
  bool object = false;                        ///< the mesh
  std::optional<double> normal_radians = {};  ///< largest angle to the mean normal, weighted by area
  std::optional<double> area_fraction = {};   ///< largest deviation from the mean area, relative to it

  /// All attributes of surfaces.
  static Similarity of_surface() {
    return {.brdf = true, .pdf = true, .colour = true, .texture = true, .emission = true};
  }
  bool compares_surfaces() const { return brdf || pdf || colour || texture || emission || object; }
  bool empty() const { return !compares_surfaces() && !normal_radians && !area_fraction; }
};

/// A closed interval.
struct ValueRange {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  bool has(double value) const { return value >= least && value <= most; }
  bool is_bounded() const {
    return least > -std::numeric_limits<double>::infinity() || most < std::numeric_limits<double>::infinity();
  }
};

/// The directions within an angle of an axis.
struct DirectionRange {
  grf::Vec3d axis{0, 1, 0};  ///< unit, in world space
  double radians = 0;
};

/// Conditions on faces; those that are set must all hold. The geometric ones are in world space, and hold for
/// a face if they do in one instance of its mesh.
struct FaceQuery {
  std::optional<DirectionRange> normal;
  ValueRange area;    ///< square of the scene's unit
  ValueRange height;  ///< of all corners, along y
  /// The name of a BRDF's definition, or the keyword of its model or of a term; case-insensitive, with the
  /// wildcards * ? [] of fnmatch. Empty for any.
  std::string material;
  Similarity similarity;

  bool is_geometric() const {
    return normal || area.is_bounded() || height.is_bounded() || similarity.normal_radians ||
           similarity.area_fraction;
  }
};

/// All faces of all meshes for which the query holds; none if it asks for similarity and no face is selected.
FaceSelection find_faces(const FaceQuery& query, const FaceSelection& selected, const SceneObjects& objects);

/// All faces of all meshes that are similar to selected ones.
inline FaceSelection select_similar(const FaceSelection& selection, const SceneObjects& objects,
                                    const Similarity& similarity) {
  FaceQuery query;
  query.similarity = similarity;
  return find_faces(query, selection, objects);
}

}  // namespace editor
