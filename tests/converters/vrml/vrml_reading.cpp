#include "tests/converters/vrml/vrml_reading.h"

#include "grf/summary.h"

namespace convert {
namespace {

Reading read_text(std::string_view header, std::string_view text) {
  const test::TemporaryFolder folder;
  return read_path(folder.add("model.wrl", std::string(header) + "\n" + std::string(text)));
}

}  // namespace

Reading read_vrml97(std::string_view text) { return read_text("#VRML V2.0 utf8", text); }
Reading read_vrml1(std::string_view text) { return read_text("#VRML V1.0 ascii", text); }
grf::Mesh mesh97(std::string_view text) { return only_mesh(read_vrml97(text)); }
grf::Mesh mesh1(std::string_view text) { return only_mesh(read_vrml1(text)); }

std::string shape(std::string_view geometry, std::string_view appearance) {
  std::string text = "Shape { geometry " + std::string(geometry);
  if (!appearance.empty()) text += " appearance Appearance { " + std::string(appearance) + " }";
  return text + " }\n";
}

std::string square(std::string_view fields) {
  return "IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }"
         " coordIndex [ 0 1 2 -1 0 2 3 -1 ] " +
         std::string(fields) + " }";
}

std::vector<grf::Vec3f> corners_of(const grf::Mesh& mesh, std::size_t face) {
  std::vector<grf::Vec3f> corners;
  for (const std::uint32_t vertex : mesh.face(face)) corners.push_back(mesh.geometry->positions[vertex]);
  return corners;
}

std::vector<grf::Vec3f> normals_of(const grf::Mesh& mesh, std::size_t face) {
  std::vector<grf::Vec3f> normals;
  for (const std::uint32_t vertex : mesh.face(face)) {
    normals.push_back(mesh.geometry->normals.has(vertex) ? mesh.geometry->normals[vertex] : grf::Vec3f(0));
  }
  return normals;
}

double area_of(const grf::Mesh& mesh) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    area += grf::doubled_area_vector(*mesh.geometry, i, grf::Matrix44d()).length() / 2;
  }
  return area;
}

// The divergence theorem, on a fan of triangles.
double volume_of(const grf::Mesh& mesh) {
  double volume = 0;
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const auto corners = corners_of(mesh, i);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      volume += grf::Vec3d(corners[0]).dot(grf::Vec3d(corners[k]).cross(grf::Vec3d(corners[k + 1]))) / 6;
    }
  }
  return volume;
}

}  // namespace convert
