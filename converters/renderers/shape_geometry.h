// The triangles of a shape, as renderers read them.
#pragma once

#include <optional>

#include "converters/renderers/render_scene.h"
#include "grf/mesh.h"
#include "renderer/image/image.h"

namespace convert {

/// The vertex attributes that a renderer needs of a shape.
struct GeometryNeeds {
  bool normals = true;  ///< those of vertices, where the shape has any
  bool uvs = false;     ///< those of the mesh, 0 where it has none
  /// Texture coordinates along the tangents of an anisotropic BRDF, where the mesh has none.
  bool tangents = false;
  /// Colours of vertices, multiplied by this colour. Absent: none.
  std::optional<grf::Colour> vertex_colours;
};

/// Makes the mesh of a shape in world space: its faces in their order, cut into the same triangles as in our
/// own renderer, counter-clockwise seen from the front also under a transform that mirrors. Only vertices
/// that faces use are kept. Triangles with a corner that lacks a normal get their own normal where others
/// have those of vertices. Triangles without area are left out of shapes that emit.
grf::MeshDraft geometry_of(const RenderShape& shape, const GeometryNeeds& needs);

/// Replaces the colours of a mesh's vertices by an image, in which each triangle has a square of four texels,
/// and by texture coordinates with which bilinear interpolation gives the colours between its corners.
image::Image bake_vertex_colours(grf::MeshDraft& mesh);

/// Returns the mean colour of the mesh's vertices, over the area of the shape's faces.
grf::Colour mean_vertex_colour(const RenderShape& shape);

}  // namespace convert
