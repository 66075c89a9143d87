#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grf/math.h"
#include "grf/scene.h"
#include "grf/topology.h"

namespace grf {

/// The figures of one mesh, in its own coordinates.
struct MeshSummary {
  std::string name;  ///< or that of the definition by which it is placed; may be empty
  std::size_t vertices = 0;
  std::size_t faces = 0;
  Topology topology;
};

/// The figures of a scene. What is placed several times counts as often; lengths are in world units.
struct Summary {
  std::size_t meshes = 0;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t triangles = 0;  ///< what the faces give when they are cut into triangles
  std::size_t instances = 0;  ///< meshes that are placed by `use`; they count as meshes too
  std::size_t lights = 0;     ///< light blocks, mesh lights, and meshes with faces that emit
  std::size_t brdfs = 0;      ///< definitions, and different ones that faces have on the spot
  std::size_t pdfs = 0;
  std::size_t textures = 0;  ///< different images that faces or definitions name
  // The sums of what each mesh has: see Topology.
  std::size_t boundary_edges = 0;
  std::size_t boundary_loops = 0;
  std::size_t nonmanifold_edges = 0;
  std::size_t nonmanifold_vertices = 0;
  std::vector<MeshSummary> different_meshes;  ///< each once, in the order in which they are placed first
  Box3f bounds;                               ///< empty if there is nothing
  double area = 0;
};

Summary summarize(const Scene& scene);

}  // namespace grf
