#include "converters/gltf/gltf_grf.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "converters/scene_building.h"
#include "grf/read.h"

namespace convert {
namespace {

using tinygltf::Value;

/// Restores the lists of one mesh.
class ListReader {
 public:
  ListReader(const GltfMeshLists& lists, const grf::Mesh& stub, GltfAccessors& accessors)
      : lists_(lists), stub_(stub), accessors_(accessors) {}

  bool run(grf::Mesh& mesh) {
    mesh_.name = stub_.name;
    mesh_.comments = stub_.comments;
    mesh_.surfaces = {stub_.surfaces.front()};
    if (!read_vertices() || !read_faces()) return false;
    mesh_.free_spare_memory();
    mesh = std::move(mesh_);
    return true;
  }

 private:
  bool check(bool holds, const char* what) {
    if (!holds) accessors_.fail(what);
    return holds;
  }

  template <class Vector>
  bool read(const std::optional<int>& accessor, std::size_t count, std::vector<Vector>& values) {
    if (!accessor) return true;
    auto read = accessors_.vectors<Vector>(*accessor);
    if (!read) return false;
    values = std::move(*read);
    return check(values.size() == count, "a list of a mesh has another length than its vertices");
  }

  bool read(const std::optional<int>& accessor, std::vector<std::uint32_t>& values) {
    if (!accessor) return true;
    auto read = accessors_.integers(*accessor);
    if (!read) return false;
    values = std::move(*read);
    return true;
  }

  bool read_vertices() {
    const std::size_t count = lists_.vertices;
    std::vector<grf::Vec3f> normals;
    std::vector<grf::Colour> colours;
    std::vector<grf::Vec2f> uvs;
    std::vector<grf::Colour> irradiance;
    std::vector<std::uint32_t> present;
    const bool read_all =
        read(lists_.positions, count, mesh_.positions) && read(lists_.normals, count, normals) &&
        read(lists_.colours, count, colours) && read(lists_.uvs, count, uvs) &&
        read(lists_.irradiance, count, irradiance) && read(lists_.present, present) &&
        check(mesh_.positions.size() == count, "a mesh has no positions") &&
        check(present.empty() || present.size() == count, "a mesh lacks what its vertices have");
    if (!read_all) return false;
    const auto has = [&](std::size_t vertex, unsigned bit) {
      return present.empty() ? bit != HasRays : (present[vertex] & bit) != 0;
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (!normals.empty() && has(i, HasNormal)) mesh_.normals.set(i, normals[i]);
      if (!colours.empty() && has(i, HasColour)) mesh_.colours.set(i, colours[i]);
      if (!uvs.empty() && has(i, HasUv)) mesh_.uvs.set(i, uvs[i]);
      if (!irradiance.empty() && has(i, HasIrradiance)) mesh_.irradiance.set(i, irradiance[i]);
    }
    return !lists_.ray_counts || read_rays(present);
  }

  bool read_rays(const std::vector<std::uint32_t>& present) {
    std::vector<std::uint32_t> counts;
    if (!read(lists_.ray_counts, counts)) return false;
    std::size_t total = 0;
    for (const std::uint32_t count : counts) total += count;
    std::vector<grf::Vec3f> directions;
    std::vector<grf::Colour> values;
    const bool read_all = check(counts.size() == lists_.vertices && present.size() == counts.size(),
                                "a mesh lacks the lengths of its lists of rays") &&
                          read(lists_.ray_directions, total, directions) &&
                          read(lists_.ray_values, total, values) &&
                          check(directions.size() == total && values.size() == total, "a mesh lacks rays");
    if (!read_all) return false;
    std::size_t next = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if ((present[i] & HasRays) == 0) continue;
      std::vector<grf::DirectionalIrradiance> rays(counts[i]);
      for (auto& ray : rays) {
        if (next == total) return check(false, "a mesh lacks rays");
        ray = {directions[next], values[next]};
        ++next;
      }
      mesh_.irradiance.set(i, std::move(rays));
    }
    return true;
  }

  bool read_faces() {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> sizes;
    std::vector<std::uint32_t> surfaces;
    if (!read(lists_.corners, corners) || !read(lists_.sizes, sizes) || !read(lists_.surfaces, surfaces))
      return false;
    for (const std::uint32_t corner : corners) {
      if (corner >= lists_.vertices) return check(false, "a face has a vertex that does not exist");
    }
    const std::size_t faces = sizes.empty() ? corners.size() / 3 : sizes.size();
    const bool fits = check(faces == lists_.faces && (faces == 0 || stub_.face_count() > 0) &&
                                (surfaces.empty() || surfaces.size() == faces),
                            "the lists of faces of a mesh differ in length");
    if (!fits) return false;
    grf::SurfaceIndex index(mesh_.surfaces);
    std::vector<std::uint32_t> surface_of;
    for (std::size_t i = 0; i < stub_.face_count(); ++i)
      surface_of.push_back(index.index_of(stub_.surface(i)));
    std::size_t next = 0;
    for (std::size_t i = 0; i < faces; ++i) {
      const std::size_t size = sizes.empty() ? 3 : sizes[i];
      const std::uint32_t surface = surfaces.empty() ? 0 : surfaces[i];
      if (size < 3 || size > corners.size() - next || surface >= surface_of.size()) {
        return check(false, "a face has corners or a surface that do not exist");
      }
      mesh_.add_face(std::span(corners).subspan(next, size), surface_of[surface]);
      next += size;
    }
    return check(next == corners.size(), "a mesh has corners that are no face's");
  }

  const GltfMeshLists& lists_;
  const grf::Mesh& stub_;
  GltfAccessors& accessors_;
  grf::MeshDraft mesh_;
};

GltfMeshLists lists_of(const Value& record) {
  const auto integer = [&](const char* name) -> std::optional<int> {
    if (!record.Has(name) || !record.Get(name).IsInt()) return std::nullopt;
    return record.Get(name).Get<int>();
  };
  GltfMeshLists lists;
  lists.vertices = static_cast<std::size_t>(std::max(integer("vertices").value_or(0), 0));
  lists.faces = static_cast<std::size_t>(std::max(integer("faces").value_or(0), 0));
  for_each_list(lists, [&](const char* name, std::optional<int>& accessor) { accessor = integer(name); });
  return lists;
}

}  // namespace

grf::Mesh without_lists(const grf::Mesh& mesh) {
  grf::MeshDraft carrier;
  carrier.name = mesh.name;
  carrier.comments = mesh.comments;
  carrier.surfaces = mesh.surfaces;
  carrier.positions = {grf::Vec3f(0, 0, 0), grf::Vec3f(1, 0, 0), grf::Vec3f(0, 1, 0)};
  const std::vector<bool> used = grf::used_surfaces(mesh);
  constexpr std::array<std::uint32_t, 3> Corners = {0, 1, 2};
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    if (used[i]) carrier.add_face(Corners, i);
  }
  return carrier;
}

std::optional<grf::Scene> read_grf_extras(const GltfFile& file, GltfAccessors& accessors,
                                          grf::Diagnostics& diagnostics) {
  const Value& extras = file.model.extras.Get("grf");
  if (!extras.Has("scene") || !extras.Get("scene").IsString())
    return accessors.fail("the extras have no scene");
  // Line numbers in the scene's text are not those of the file.
  auto scene = grf::read_text(extras.Get("scene").Get<std::string>(), file.path + "#grf", diagnostics);
  if (!scene) return std::nullopt;
  const Value none;
  const Value& records = extras.Has("meshes") ? extras.Get("meshes") : none;
  std::size_t next = 0;
  bool filled = true;
  for_each_mesh(scene->contents, [&](grf::Shared<grf::Mesh>& mesh) {
    if (!filled) return;
    const std::size_t place = next++;
    filled = place < records.ArrayLen();
    if (!filled) {
      accessors.fail("the extras have fewer meshes than their scene");
      return;
    }
    const GltfMeshLists lists = lists_of(records.Get(static_cast<int>(place)));
    const grf::Mesh stub = *mesh;
    filled = ListReader(lists, stub, accessors).run(mesh.edit());
  });
  if (filled && next != records.ArrayLen())
    return accessors.fail("the extras have more meshes than their scene");
  if (!filled) return std::nullopt;
  return scene;
}

}  // namespace convert
