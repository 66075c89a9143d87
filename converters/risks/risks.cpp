#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "converters/mesh_operations/orient.h"
#include "converters/risks/lamp_solids.h"
#include "converters/risks/mesh_risks.h"
#include "converters/risks/risk.h"
#include "grf/bvh.h"
#include "grf/topology.h"
#include "grf/vertex_tree.h"
#include "grf/visit.h"
#include "grf/wording.h"
#include "grf/write.h"

namespace convert {
namespace {

using grf::Box3d;
using grf::Mesh;
using grf::Placement;
using grf::Vec3d;

// A mesh whose extent is less than this many float steps at its coordinates is resolved coarsely.
constexpr double FewSteps = 10'000;
// Albedos are accurate to 0.01.
constexpr float ClearlyOver = 1.02F;

std::string named(std::string_view kind, const std::string& name) {
  return name.empty() ? fmt::format("the {}", kind) : fmt::format("the {} '{}'", kind, name);
}

double largest_component(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A place where a mesh is drawn.
struct Instance {
  const Mesh* mesh = nullptr;
  grf::Matrix44d to_world;
  grf::ScenePath path;  ///< of the block
  grf::SourceLocation location;
  Box3d bounds;  ///< in world space
};

class RiskSearch {
 public:
  explicit RiskSearch(const grf::Catalogue& catalogue) : catalogue_(catalogue) {}

  std::vector<Risk> run(const grf::Scene& scene) {
    grf::SceneVisitor visitor;
    visitor.mesh = [this](const Mesh& mesh, const Placement& placement, const grf::Block& block) {
      add_instance(mesh, placement, block);
      if (placement.instance_of == nullptr) add_mesh(mesh, placement, block.location);
    };
    visitor.definition = [this](const grf::Definition& definition, const Placement& placement) {
      const auto* mesh = std::get_if<grf::Shared<Mesh>>(&definition.body);
      if (mesh != nullptr) add_mesh(**mesh, placement, definition.location);
    };
    visitor.light = [this](const grf::AreaLight& light, const Placement& placement, const grf::Block& block) {
      lamps_.add(light, placement, block.location);
    };
    visitor.mesh_light = [this](const grf::MeshLight& light, const Placement& placement,
                                const grf::Block& block) {
      lamps_.add(light, placement, block.location);
      add_faces(*light.mesh, {RiskKind::FacesWithoutArea, faces_without_area(*light.mesh), "no area"},
                placement, block.location);
    };
    grf::visit(scene, visitor);
    add_inward_faces();
    add_duplicate_meshes();
    add_far_meshes();
    add_lamps_in_solids();
    std::stable_sort(risks_.begin(), risks_.end(), [](const Risk& a, const Risk& b) {
      return std::tuple(a.kind, -a.share) < std::tuple(b.kind, -b.share);
    });
    return std::move(risks_);
  }

 private:
  struct FoundFaces {
    RiskKind kind;
    std::vector<std::uint32_t> faces;
    std::string_view defect;
  };

  void add(RiskKind kind, double share, grf::ScenePathView path, const grf::SourceLocation& location,
           std::string message, std::vector<std::uint32_t> faces = {}) {
    risks_.push_back(
        {kind, share, {path.begin(), path.end()}, location, std::move(faces), std::move(message)});
  }

  void add_faces(const Mesh& mesh, FoundFaces found, const Placement& placement,
                 const grf::SourceLocation& location) {
    if (found.faces.empty()) return;
    const std::size_t count = found.faces.size();
    const double share = static_cast<double>(count) / static_cast<double>(mesh.face_count());
    std::string message = fmt::format("{} of {} {} {}", grf::counted(count, "face", "faces"),
                                      named("mesh", mesh.name), count == 1 ? "has" : "have", found.defect);
    add(found.kind, share, placement.path, location, std::move(message), std::move(found.faces));
  }

  /// Finds the risks that a mesh has wherever it is drawn.
  void add_mesh(const Mesh& mesh, const Placement& placement, const grf::SourceLocation& location) {
    const auto found = [&](RiskKind kind, std::vector<std::uint32_t> faces, std::string_view defect) {
      add_faces(mesh, {kind, std::move(faces), defect}, placement, location);
    };
    found(RiskKind::FacesWithoutArea, faces_without_area(mesh), "no area");
    std::vector<std::uint32_t> duplicates = duplicate_faces(mesh);
    // Duplicates share all edges in the same direction, as faces of opposite orientation would.
    if (duplicates.empty()) find_inward_faces(mesh, placement, location);
    found(RiskKind::DuplicateFaces, std::move(duplicates), "the corners of another face");
    found(RiskKind::NormalsAgainstFaces, faces_against_normals(mesh), "normals that point to the back");
    found(RiskKind::UvWithoutArea, faces_without_uv_area(mesh),
          "a texture, and texture coordinates without area");
    add_energy_gain(mesh, placement, location);
  }

  void find_inward_faces(const Mesh& mesh, const Placement& placement, const grf::SourceLocation& location) {
    const std::vector<bool> inward = inward_faces(mesh.geometry, OpenParts::ByMajority);
    std::vector<std::uint32_t> faces;
    for (std::uint32_t face = 0; face < inward.size(); ++face) {
      if (inward[face]) faces.push_back(face);
    }
    if (!faces.empty()) {
      inward_.push_back({&mesh, {placement.path.begin(), placement.path.end()}, location, std::move(faces)});
    }
  }

  void add_instance(const Mesh& mesh, const Placement& placement, const grf::Block& block) {
    if (mesh.face_count() == 0) return;
    first_instance_.try_emplace(&mesh, instances_.size());
    instances_.push_back({&mesh,
                          placement.to_world,
                          {placement.path.begin(), placement.path.end()},
                          block.location,
                          mesh.geometry.vertices().bounds_under(placement.to_world)});
    lamps_.add_emitting(mesh, placement, block.location);
  }

  /// The largest albedo of a BRDF over angles; an upper bound for sums.
  float largest_albedo(const grf::BrdfModel& brdf, const grf::Scope& scope) {
    float sum = 0;
    for (const grf::WeightedBrdf& summand : grf::summands_of(brdf, scope)) {
      const grf::ModelInfo* info = grf::find_model(catalogue_.brdfs, summand.model->keyword);
      if (info == nullptr || info->largest_albedo == nullptr) continue;
      const auto [known, is_new] = albedos_.try_emplace(grf::to_text(*summand.model));
      if (is_new) known->second = info->largest_albedo(*summand.model).albedo;
      sum += summand.weight * known->second;
    }
    return sum;
  }

  void add_energy_gain(const Mesh& mesh, const Placement& placement, const grf::SourceLocation& location) {
    std::vector<float> gains;
    for (const grf::Surface& surface : mesh.surfaces) {
      const grf::ResolvedSurface resolved = grf::resolve(surface, placement.scope);
      const float colour = std::max({resolved.colour.x, resolved.colour.y, resolved.colour.z});
      gains.push_back(
          resolved.brdf == nullptr ? 0 : colour * largest_albedo(*resolved.brdf, resolved.brdf_scope));
    }
    float largest = 0;
    std::vector<std::uint32_t> faces;
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
      const float gain = gains[(*mesh.surface_of_face)[face]];
      if (gain < ClearlyOver) continue;
      largest = std::max(largest, gain);
      faces.push_back(face);
    }
    if (faces.empty()) return;
    const std::string message =
        fmt::format("{} of {} reflect up to {:.3g} times the light that they receive",
                    grf::counted(faces.size(), "face", "faces"), named("mesh", mesh.name), largest);
    add(RiskKind::EnergyGain, 1 - 1.0 / largest, placement.path, location, message, std::move(faces));
  }

  /// Whether a mesh is the room of others: the bounds of its first instance contain the centre of another
  /// instance or a point of a lamp. `points` are the boxes of `centres`, of the instances first.
  bool is_room(const Mesh& mesh, const std::vector<Box3d>& points, const grf::Bvh& centres) const {
    const auto room = first_instance_.find(&mesh);
    if (room == first_instance_.end()) return false;
    const Box3d& bounds = instances_[room->second].bounds;
    const double found = centres.highest(
        [&](const Box3d& box) { return box.intersects(bounds) ? 1 : 0; },
        [&](std::size_t i) { return i != room->second && bounds.intersects(points[i].min) ? 1 : 0; }, 0, 0);
    return found > 0;
  }

  void add_inward_faces() {
    std::vector<Box3d> points;
    for (const Instance& instance : instances_) points.emplace_back(instance.bounds.center());
    for (const Vec3d& point : lamps_.points()) points.emplace_back(point);
    const grf::Bvh centres(points);
    for (Inward& inward : inward_) {
      const bool is_whole = inward.faces.size() == inward.mesh->face_count();
      if (is_whole && is_room(*inward.mesh, points, centres)) continue;
      const double share =
          static_cast<double>(inward.faces.size()) / static_cast<double>(inward.mesh->face_count());
      const std::string message =
          is_whole ? fmt::format("the fronts of {} point inward", named("mesh", inward.mesh->name))
                   : fmt::format("the front{} of {} of {} disagree{} with the faces around",
                                 inward.faces.size() == 1 ? "" : "s",
                                 grf::counted(inward.faces.size(), "face", "faces"),
                                 named("mesh", inward.mesh->name), inward.faces.size() == 1 ? "s" : "");
      add(RiskKind::InwardFaces, share, inward.path, inward.location, message, std::move(inward.faces));
    }
  }

  /// Finds meshes with equal geometry at the same place. Only meshes with the same bounds are compared, each
  /// with at most 16 others.
  void add_duplicate_meshes() {
    std::map<std::array<double, 6>, std::vector<const Instance*>> at_place;
    for (const Instance& instance : instances_) {
      const Box3d& box = instance.bounds;
      std::vector<const Instance*>& there =
          at_place[{box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z}];
      const auto same = std::find_if(there.begin(), there.end(), [&](const Instance* other) {
        return other->to_world == instance.to_world && other->mesh->geometry == instance.mesh->geometry;
      });
      if (same == there.end()) {
        if (there.size() < 16) there.push_back(&instance);
      } else {
        add(RiskKind::DuplicateMesh, 1, instance.path, instance.location,
            fmt::format("{} lies exactly on {}", named("mesh", instance.mesh->name),
                        (*same)->mesh->name.empty() || (*same)->mesh->name == instance.mesh->name
                            ? "an equal one"
                            : named("mesh", (*same)->mesh->name)));
      }
    }
  }

  // A scene that is far away as a whole is moved to the origin for rendering.
  void add_far_meshes() {
    Box3d scene;
    for (const Instance& instance : instances_) scene.extendBy(instance.bounds);
    const Vec3d middle = scene.isEmpty() ? Vec3d(0) : scene.center();
    for (const Instance& instance : instances_) {
      const Box3d& bounds = instance.bounds;
      const double from_origin = std::max(largest_component(bounds.min), largest_component(bounds.max));
      const double from_middle =
          std::max(largest_component(bounds.min - middle), largest_component(bounds.max - middle));
      const double farthest = std::min(from_origin, from_middle);
      const double extent = bounds.size().length();
      const double steps = extent / (farthest * std::numeric_limits<float>::epsilon());
      if (extent <= 0 || steps >= FewSteps) continue;
      add(RiskKind::FarFromMiddle, 1 - steps / FewSteps, instance.path, instance.location,
          fmt::format(
              "{} is {:.3g} in size, {:.3g} from the middle of the scene: single precision resolves it "
              "to 1/{:.0f}",
              named("mesh", instance.mesh->name), extent, farthest, steps));
    }
  }

  void add_lamps_in_solids() {
    LampSolids solids;
    for (const Instance& instance : instances_)
      solids.add(*instance.mesh, instance.to_world, instance.bounds);
    for (const Lamp* lamp : lamps_.largest()) {
      const Mesh* solid = solids.around(*lamp);
      if (solid == nullptr) continue;
      add(RiskKind::LampInSolid, 1, lamp->path, lamp->location,
          fmt::format("a lamp is inside {}: it illuminates nothing outside", named("mesh", solid->name)),
          lamp->faces);
    }
  }

  struct Inward {
    const Mesh* mesh;
    grf::ScenePath path;
    grf::SourceLocation location;
    std::vector<std::uint32_t> faces;
  };

  const grf::Catalogue& catalogue_;
  std::map<std::string, float> albedos_;  ///< by the text of the BRDF
  std::vector<Instance> instances_;
  std::unordered_map<const Mesh*, std::size_t> first_instance_;  ///< index in instances_
  std::vector<Inward> inward_;
  Lamps lamps_;
  std::vector<Risk> risks_;
};

}  // namespace

const std::vector<RiskInfo>& risk_infos() {
  using enum RiskKind;
  static const std::vector<RiskInfo> infos = {
      {LampInSolid, "lamp_in_solid", "A lamp is inside a solid",
       "the winding number of a closed mesh with outward fronts about all tested points of the lamp is over "
       "3/4",
       "Move the lamp out, or open the solid."},
      {EnergyGain, "energy_gain", "A BRDF reflects more light than it receives",
       "the largest albedo over angles, summed over terms, times the colour is over 1.02",
       "Lower its weights or the faces' colour."},
      {DuplicateMesh, "duplicate_mesh", "A mesh lies exactly on another", "geometry and transform are equal",
       "Delete one of them."},
      {DuplicateFaces, "duplicate_faces", "Faces have the same corners",
       "corners are at the same positions in the same order; opposite orientations are the two sides of a "
       "sheet",
       "Delete the duplicates."},
      {NormalsAgainstFaces, "normals_against_faces", "Normals point to the back",
       "all vertex normals of a face are over 90 degrees from the face's own",
       "Recompute the normals of the faces."},
      {InwardFaces, "inward_faces", "Fronts point inward",
       "fronts disagree across a shared edge, in a mesh without duplicate faces, or those of a closed part "
       "point "
       "inward; a mesh around a lamp or another mesh is a room, whose fronts may point inward",
       "Flip the faces."},
      {FarFromMiddle, "far_from_middle", "A mesh is far from the middle of the scene",
       "its extent is under 10,000 steps of single precision at its largest distance, per axis, from the "
       "origin or the middle of the scene, whichever is nearer",
       "Render it in a scene of its own, or move it nearer."},
      {UvWithoutArea, "uv_without_area", "Texture coordinates have no area",
       "a textured face covers under 1e-10 of its image", "Project texture coordinates."},
      {FacesWithoutArea, "faces_without_area", "Faces have no area",
       "the area is under 1e-7 of the longest edge squared", "Delete the faces."},
  };
  return infos;
}

const RiskInfo& info_of(RiskKind kind) { return risk_infos()[static_cast<std::size_t>(kind)]; }

std::vector<Risk> risks_of(const grf::Scene& scene, const grf::Catalogue& catalogue) {
  return RiskSearch(catalogue).run(scene);
}

}  // namespace convert
