// Meshes as NumPy arrays, which share their memory with the scene.
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "grf/visit.h"
#include "grf/write.h"
#include "python/scene.h"

namespace python {
namespace {

/// Attributes of faces, with references resolved.
struct Surface {
  std::string text;
  std::string brdf;
  grf::Colour colour;
  std::optional<grf::Colour> emission;
};

/// A mesh at one place of the scene.
struct Mesh {
  grf::Mesh mesh;
  std::string name;  ///< of the mesh, or of the definition that it is an instance of
  grf::Matrix44d to_world;
  std::vector<Surface> surfaces;
};

/// Returns an array over memory that `owner` keeps; it cannot be written.
template <class Number, class Owner>
py::array_t<Number> view_of(const Number* data, std::vector<py::ssize_t> shape, const Owner& owner) {
  const py::capsule keeper(new Owner(owner), [](void* kept) { delete static_cast<Owner*>(kept); });
  py::array_t<Number> array(std::move(shape), data, keeper);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::ssize_t signed_size(std::size_t size) { return static_cast<py::ssize_t>(size); }

py::array_t<float> positions_of(const Mesh& mesh) {
  const auto& positions = mesh.mesh.geometry->positions;
  const float* first = positions.empty() ? nullptr : &positions.front().x;
  return view_of(first, {signed_size(positions.size()), 3}, mesh.mesh.geometry);
}

/// Returns an attribute of vertices, NaN where a vertex has none; None if no vertex has one.
template <class Vector>
py::object attribute_of(const grf::OptionalVertexValues<Vector>& values, std::size_t vertices) {
  if (values.empty()) return py::none();
  const auto components = static_cast<py::ssize_t>(Vector::dimensions());
  py::array_t<float> array({signed_size(vertices), components});
  float* number = array.mutable_data();
  for (std::size_t i = 0; i < vertices; ++i) {
    for (int k = 0; k < components; ++k)
      *number++ = values.has(i) ? values[i][k] : std::numeric_limits<float>::quiet_NaN();
  }
  return py::object(array);
}

py::array_t<std::uint32_t> faces_of(const Mesh& mesh) {
  const grf::Geometry& geometry = *mesh.mesh.geometry;
  const std::size_t count = geometry.face_count();
  const std::size_t corners = count > 0 ? geometry.face(0).size() : 3;
  for (std::size_t i = 0; i < count; ++i) {
    if (geometry.face(i).size() != corners)
      throw py::value_error(
          "the faces have different numbers of corners: use corners and face_offsets, or triangles");
  }
  return view_of(geometry.corners.data(), {signed_size(count), signed_size(corners)}, mesh.mesh.geometry);
}

py::array_t<std::uint32_t> triangles_of(const Mesh& mesh) {
  const grf::Triangulation& triangulation = mesh.mesh.geometry.triangulation();
  py::array_t<std::uint32_t> triangles({signed_size(triangulation.size()), py::ssize_t{3}});
  std::uint32_t* corner = triangles.mutable_data();
  for (std::size_t i = 0; i < triangulation.size(); ++i) {
    for (const std::uint32_t vertex : triangulation[i]) *corner++ = vertex;
  }
  return triangles;
}

py::array_t<std::uint32_t> face_of_triangle(const Mesh& mesh) {
  const grf::Geometry& geometry = *mesh.mesh.geometry;
  py::array_t<std::uint32_t> faces(signed_size(geometry.triangle_count()));
  std::uint32_t* face = faces.mutable_data();
  for (std::size_t i = 0; i < geometry.face_count(); ++i) {
    for (std::size_t k = 2; k < geometry.face(i).size(); ++k) *face++ = static_cast<std::uint32_t>(i);
  }
  return faces;
}

py::array_t<double> world_positions_of(const Mesh& mesh) {
  const auto& positions = mesh.mesh.geometry->positions;
  py::array_t<double> array({signed_size(positions.size()), py::ssize_t{3}});
  auto* world = reinterpret_cast<grf::Vec3d*>(array.mutable_data());
  for (std::size_t i = 0; i < positions.size(); ++i) world[i] = grf::Vec3d(positions[i]) * mesh.to_world;
  return array;
}

py::array_t<double> matrix_of(const Mesh& mesh) {
  // Imath has row vectors, NumPy's users have columns.
  const grf::Matrix44d columns = mesh.to_world.transposed();
  return py::array_t<double>({4, 4}, &columns[0][0]);
}

/// Returns the text of a BRDF that needs no definition of the scene; empty if there is none such.
std::string brdf_text(const grf::ResolvedSurface& resolved) {
  if (resolved.brdf == nullptr || !resolved.brdf->terms.empty()) return "";
  return grf::to_text(*resolved.brdf);
}

std::vector<Surface> surfaces_of(const grf::Mesh& mesh, const grf::Scope& scope) {
  std::vector<Surface> surfaces;
  for (const grf::Surface& surface : mesh.surfaces) {
    const grf::ResolvedSurface resolved = grf::resolve(surface, scope);
    std::string text = grf::to_text(surface);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    surfaces.push_back({std::move(text), brdf_text(resolved), resolved.colour, resolved.emission});
  }
  return surfaces;
}

py::tuple tuple_of(const grf::Colour& colour) { return py::make_tuple(colour.x, colour.y, colour.z); }

constexpr const char* SurfaceBrdfText =
    R"(The BRDF as text for granada.BRDF, also if the scene defines it by name.

It is None for a face without one, where 'diffuse kd=0.5' holds, and for sums and layers, which name other
definitions: granada.BRDF('scene.grf:NAME') has those.)";

void define_surfaces(py::module_& module) {
  py::class_<Surface>(module, "Surface", "The attributes that some faces of a mesh share.")
      .def_readonly("text", &Surface::text, "The attributes as GRF text, a line each.")
      .def_property_readonly(
          "brdf",
          [](const Surface& surface) {
            return surface.brdf.empty() ? py::none() : py::object(py::str(surface.brdf));
          },
          SurfaceBrdfText)
      .def_property_readonly(
          "colour", [](const Surface& surface) { return tuple_of(surface.colour); },
          "The factor of the BRDF, RGB.")
      .def_property_readonly(
          "emission",
          [](const Surface& surface) {
            return surface.emission ? py::object(tuple_of(*surface.emission)) : py::none();
          },
          "Emitted radiance in W/(sr m2), RGB, or None.")
      .def("__repr__",
           [](const Surface& surface) { return py::str("<granada.Surface {!r}>").format(surface.text); });
}

}  // namespace

void define_meshes(py::module_& module) {
  define_surfaces(module);
  using Indices = py::array_t<std::uint32_t>;
  py::class_<Mesh>(module, "Mesh",
                   "A mesh at one place of a scene. Arrays that share memory cannot be written.")
      .def_readonly("name", &Mesh::name, "Its name, or that of the definition that it is an instance of.")
      .def_property_readonly("positions", &positions_of, "Vertex positions in its own coordinates, (n, 3).")
      .def_property_readonly("world_positions", &world_positions_of, "Vertex positions in the world, (n, 3).")
      .def_property_readonly("to_world", &matrix_of,
                             "The matrix (4, 4) that column vectors are multiplied by.")
      .def_property_readonly("faces", &faces_of,
                             "Vertex indices (faces, corners), if all faces have as many corners.")
      .def_property_readonly(
          "corners",
          [](const Mesh& mesh) -> Indices {
            const auto& corners = mesh.mesh.geometry->corners;
            return view_of(corners.data(), {signed_size(corners.size())}, mesh.mesh.geometry);
          },
          "Vertex indices of all faces, one face after the other.")
      .def_property_readonly(
          "face_offsets",
          [](const Mesh& mesh) -> Indices {
            const auto& offsets = mesh.mesh.geometry->face_offsets;
            return view_of(offsets.data(), {signed_size(offsets.size())}, mesh.mesh.geometry);
          },
          "The first corner of each face, and the number of corners.")
      .def_property_readonly("triangles", &triangles_of, "Vertex indices (n, 3) of the triangulated faces.")
      .def_property_readonly("face_of_triangle", &face_of_triangle,
                             "The face of each of these triangles, (n,).")
      .def_property_readonly(
          "surface_of_face",
          [](const Mesh& mesh) -> Indices {
            const auto& surfaces = *mesh.mesh.surface_of_face;
            return view_of(surfaces.data(), {signed_size(surfaces.size())}, mesh.mesh.surface_of_face);
          },
          "The index in `surfaces` of each face's surface, (faces,).")
      .def_property_readonly(
          "normals",
          [](const Mesh& mesh) {
            return attribute_of(mesh.mesh.geometry->normals, mesh.mesh.geometry->positions.size());
          },
          "Vertex normals (n, 3), NaN where a vertex has none; None if none has one.")
      .def_property_readonly(
          "colours",
          [](const Mesh& mesh) {
            return attribute_of(mesh.mesh.geometry->colours, mesh.mesh.geometry->positions.size());
          },
          "Vertex colours (n, 3), likewise.")
      .def_property_readonly(
          "uvs",
          [](const Mesh& mesh) {
            return attribute_of(mesh.mesh.geometry->uvs, mesh.mesh.geometry->positions.size());
          },
          "Texture coordinates (n, 2), likewise.")
      .def_readonly("surfaces", &Mesh::surfaces,
                    "The surfaces; the first has the attributes of the mesh itself.")
      .def("__repr__", [](const Mesh& mesh) {
        return py::str("<granada.Mesh {!r}: {} vertices, {} faces>")
            .format(mesh.name, mesh.mesh.geometry->positions.size(), mesh.mesh.face_count());
      });
}

py::list meshes_of(const Scene& scene) {
  py::list meshes;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const bool has_own_name = !mesh.name.empty() || placement.instance_of == nullptr;
    meshes.append(Mesh{mesh, has_own_name ? mesh.name : placement.instance_of->name, placement.to_world,
                       surfaces_of(mesh, placement.scope)});
  };
  grf::visit(scene.import.scene, visitor, scene.path);
  return meshes;
}

}  // namespace python
