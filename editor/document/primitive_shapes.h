// Primitive shapes are polygon meshes: plane, box, sphere, cylinder, disc and torus.
#pragma once

#include <string_view>

#include "editor/document/object_placement.h"
#include "grf/math.h"
#include "grf/mesh.h"
#include "grf/scene.h"

namespace editor {

/// The parameters of a primitive shape that stands on y = 0, centred about the y axis; lengths are positive.
struct PrimitiveShape {
  enum class Kind { Plane, Box, Sphere, Cylinder, Disc, Torus };

  Kind kind = Kind::Box;
  double width = 1;     ///< along x, of plane and box
  double height = 1;    ///< along y, of box and cylinder
  double depth = 1;     ///< along z, of plane and box
  double radius = 0.5;  ///< of sphere, cylinder, disc and torus; a torus's is to the middle of its tube
  double tube_radius = 0.125;  ///< of a torus
  int segments = 32;           ///< about the y axis, at least 3; spheres and tubes have half as many across
};

/// The name of a kind in lower case: "sphere".
std::string_view name_of(PrimitiveShape::Kind kind);

/// The shape of a kind whose longest side is `size`.
PrimitiveShape shape_of_size(PrimitiveShape::Kind kind, double size);

/// Generates the mesh of a shape, named after its kind. Fronts are outward (those of plane and disc upward),
/// normals are smooth on round sides and flat elsewhere, texture coordinates are in 0..1.
grf::Mesh mesh_of(const PrimitiveShape& shape);

/// A quarter of the longest side of a box, rounded to 1, 2 or 5 times a power of ten; 1 for an empty box or a
/// point.
double proportionate_size(const grf::Box3d& bounds);

/// Adds a mesh at a position in world space. Its name gets a number if the scene has a mesh of that name.
TransformedObjects add_mesh(const grf::Scene& scene, const SceneObjects& objects, grf::Mesh mesh,
                            const grf::Vec3d& position);

}  // namespace editor
