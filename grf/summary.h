#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grf/math.h"
#include "grf/scene.h"
#include "grf/topology.h"

namespace grf {

/// Statistics of one mesh, in its own coordinates.
struct MeshSummary {
  std::string name;  ///< its name, or that of the definition that it is an instance of; may be empty
  std::size_t vertices = 0;
  std::size_t faces = 0;
  Topology topology;
};

/// Statistics of a scene, as `grfconvert info` prints them. Instances count; lengths are in world units.
struct Summary {
  std::size_t meshes = 0;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t triangles = 0;  ///< triangles of the triangulated faces
  std::size_t instances = 0;  ///< meshes that are placed by `use`; they count as meshes too
  std::size_t lights = 0;     ///< light blocks, mesh lights, and meshes with faces that emit
  std::size_t brdfs = 0;      ///< definitions, and distinct inline ones of faces
  std::size_t pdfs = 0;
  std::size_t textures = 0;  ///< distinct images that faces or definitions name
  // Sums over all meshes: see Topology.
  std::size_t boundary_edges = 0;
  std::size_t boundary_loops = 0;
  std::size_t nonmanifold_edges = 0;
  std::size_t nonmanifold_vertices = 0;
  std::vector<MeshSummary> different_meshes;  ///< distinct meshes, in the order of their first instance
  Box3f bounds;                               ///< empty if there is nothing
  double area = 0;
};

Summary summarize(const Scene& scene);  ///< Counts and measures a scene, instances included.

}  // namespace grf
