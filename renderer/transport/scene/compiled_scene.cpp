#include "renderer/transport/scene/compiled_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "renderer/transport/scene/hit.h"
#include "renderer/transport/sobol.h"

namespace transport {
namespace {

using grf::Vec3d;

/// The rounding of a triangle's corners, relative to the bound of the error of points that are interpolated
/// between them.
constexpr double CornerRounding = 0x1p-24 / InterpolationError;

/// Returns a channel of a texel in all three components. A texture of alpha has it there.
Rgb channel_of(const Rgb& texel, grf::ImageChannel channel) {
  switch (channel) {
    case grf::ImageChannel::Red:
      return Rgb(texel.x);
    case grf::ImageChannel::Green:
      return Rgb(texel.y);
    case grf::ImageChannel::Blue:
      return Rgb(texel.z);
    case grf::ImageChannel::Alpha:
    case grf::ImageChannel::Rgb:
      break;
  }
  return texel;
}

/// The plane of a triangle of the scene.
struct FacePlane {
  Vec3d corner;
  Vec3d normal;      ///< unit, or 0
  double error = 0;  ///< bounds the error of a point of the triangle along the normal
};

FacePlane plane_of(const Geometry& geometry, const TriangleId& id) {
  const Instance& instance = geometry.instances[id.instance];
  const TriangleMesh& mesh = geometry.meshes[instance.mesh];
  const auto corner = [&](std::size_t i) {
    const Vec3d position(mesh.positions[mesh.triangles[id.triangle].corners[i]]);
    if (id.instance == 0) return position;
    return position * Imath::M33d(instance.to_scene.linear) + Vec3d(instance.to_scene.translation);
  };
  const Vec3d a = corner(0);
  const Vec3d normal = (corner(1) - a).cross(corner(2) - a).normalized();
  constexpr float Middle = 1 / 3.0F;
  const SurfacePoint middle = HitTriangle(geometry, {id, Middle, Middle, 0}, Ray()).point();
  return {a, normal, Vec3d(absolute(Vec3f(normal))).dot(Vec3d(middle.error))};
}

}  // namespace

CompiledScene::CompiledScene(std::shared_ptr<const Geometry> geometry, RayCaster caster,
                             std::vector<CompiledSurface> surfaces, std::vector<VaryingSurface> varying,
                             ReflectorSet reflectors, std::vector<TextureFile> textures,
                             std::vector<Emitter> emitters)
    : geometry_(std::move(geometry)),
      surfaces_(std::move(surfaces)),
      varying_(std::move(varying)),
      reflectors_(std::move(reflectors)),
      textures_(std::move(textures)),
      lights_(std::move(emitters)),
      caster_(std::move(caster)),
      has_cutouts_(std::ranges::any_of(geometry_->meshes, &TriangleMesh::has_cutouts)),
      has_glass_(std::ranges::any_of(surfaces_, &CompiledSurface::is_glass)) {}

/// Stops a ray at each triangle by chance, by a hash of the triangle: the order of hits does not matter.
class CompiledScene::NearestStop : public HitFilter {
 public:
  NearestStop(const CompiledScene& scene, const Ray& ray, std::uint32_t chance)
      : scene_(scene), ray_(ray), chance_(chance) {}

  bool stops(const TriangleHit& hit) override {
    const float opacity = scene_.opacity_at(hit, ray_);
    if (opacity <= 0 || opacity >= 1) return opacity >= 1;
    const std::uint32_t bits = hash(hash(chance_, hit.id.instance), hit.id.triangle);
    return static_cast<float>(bits >> 8U) * 0x1p-24F < opacity;
  }

 private:
  const CompiledScene& scene_;
  const Ray& ray_;
  std::uint32_t chance_;
};

/// Multiplies what triangles let pass, in the order of their numbers: that of hits may depend on how the
/// acceleration structure was built, and Embree may report a hit twice.
class CompiledScene::Passage : public HitFilter {
 public:
  Passage(const CompiledScene& scene, const Ray& ray) : scene_(scene), ray_(ray) {}

  bool stops(const TriangleHit& hit) override {
    const float opacity = scene_.opacity_at(hit, ray_);
    const CompiledSurface& surface = scene_.surface_at(hit);
    if (opacity >= 1 && !surface.is_pane) return true;
    if (!(opacity > 0)) return false;
    Rgb passed(1 - opacity);
    if (surface.is_pane) passed += scene_.passing_pane(hit, ray_, surface) * opacity;
    passed_.push_back({{hit.id.instance, hit.id.triangle}, passed});
    return reflectance::is_black(passed);
  }

  Rgb transmittance() {
    std::ranges::sort(passed_, {}, [](const auto& passed) { return passed.first; });
    Rgb product(1);
    for (std::size_t i = 0; i < passed_.size(); ++i) {
      if (i == 0 || passed_[i].first != passed_[i - 1].first) product *= passed_[i].second;
    }
    return product;
  }

 private:
  const CompiledScene& scene_;
  const Ray& ray_;
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, Rgb>> passed_;
};

const CompiledSurface& CompiledScene::surface_at(const TriangleHit& hit) const {
  const Instance& instance = geometry_->instances[hit.id.instance];
  const Triangle& triangle = geometry_->meshes[instance.mesh].triangles[hit.id.triangle];
  return surfaces_[instance.first_surface + triangle.surface];
}

float CompiledScene::opacity_at(const TriangleHit& hit, const Ray& ray) const {
  const CompiledSurface& surface = surface_at(hit);
  if (surface.alpha == InvalidIndex) return surface.opacity.value;
  const HitTriangle met(*geometry_, hit, ray);
  const Texture& texture = *textures_[surface.alpha].texture;
  // A filtered alpha would make holes vanish or grow with the distance.
  if (surface.opacity.kind == grf::Opacity::Kind::Mask) {
    return texture.alpha(met.uv(), 0) >= surface.opacity.value ? 1 : 0;
  }
  return surface.opacity.value *
         texture.alpha(met.uv(), met.uv_scale() * ray.cone.at(hit.distance * ray.direction.length()).width);
}

Rgb CompiledScene::colour_at(const HitTriangle& hit, const CompiledSurface& surface, float width) const {
  Rgb colour = surface.colour * hit.vertex_colour();
  if (surface.texture != InvalidIndex) {
    const Texture& texture = *textures_[surface.texture].texture;
    colour *= texture.lookup(hit.uv(), hit.uv_scale() * width);
  }
  return colour;
}

const reflectance::Reflector& CompiledScene::vary(const reflectance::Reflector& constant,
                                                  const SurfacePoint& point,
                                                  std::optional<reflectance::Reflector>& varied) const {
  const VaryingSurface& varying = varying_[point.surface->varying];
  std::vector<Rgb> texels;
  texels.reserve(varying.textures.size());
  for (std::size_t i = 0; i < varying.textures.size(); ++i) {
    const Rgb texel = textures_[varying.textures[i]].texture->lookup(point.uv, point.uv_footprint);
    texels.push_back(channel_of(texel, varying.brdf->maps()[i].channel));
  }
  return varied.emplace(constant.with(varying.brdf->at(texels)));
}

/// Returns what a pane lets pass of light along a ray.
Rgb CompiledScene::passing_pane(const TriangleHit& hit, const Ray& ray,
                                const CompiledSurface& surface) const {
  const auto* glass = std::get_if<reflectance::Glass>(&reflector(surface)->brdf());
  const HitTriangle met(*geometry_, hit, ray);
  const float length = ray.direction.length();
  const float cosine = std::abs(ray.direction.dot(met.point().geometric_normal)) / length;
  const float width = ray.cone.at(hit.distance * length).width;
  return glass->split(cosine, false).transmitted * colour_at(met, surface, width);
}

float CompiledScene::opacity_of_emitter(const LightSample& light) const {
  const TriangleId& id = geometry_->emitter_triangles[light.emitter];
  const Instance& instance = geometry_->instances[id.instance];
  const Triangle& triangle = geometry_->meshes[instance.mesh].triangles[id.triangle];
  if (surfaces_[instance.first_surface + triangle.surface].alpha == InvalidIndex) return 1;
  // The corners of a mirrored instance are in the other order.
  const bool turns = id.instance != 0 && instance.to_scene.linear.determinant() < 0;
  const Vec2f weights = turns ? Vec2f(light.place.y, light.place.x) : light.place;
  return opacity_at(TriangleHit{id, weights.x, weights.y, 0}, Ray());
}

std::optional<SurfacePoint> CompiledScene::intersect(const Ray& ray, std::uint32_t chance) const {
  NearestStop filter(*this, ray, chance);
  const auto met = caster_.intersect(ray, has_cutouts_ ? &filter : nullptr);
  if (!met) return std::nullopt;
  const HitTriangle hit(*geometry_, *met, ray);
  const CompiledSurface& surface = surfaces_[hit.instance().first_surface + hit.triangle().surface];
  std::optional<SurfacePoint> point = hit.point();
  point->surface = &surface;
  point->colour = colour_at(hit, surface, point->cone.width);
  if (surface.varying != InvalidIndex) {
    point->uv = hit.uv();
    point->uv_footprint = hit.uv_scale() * point->cone.width;
  }
  point->irradiance = hit.irradiance();
  if (surface.is_anisotropic) point->tangent = hit.tangent(surface.axis, point->shading_normal);
  if (!reflectance::is_black(surface.emission)) {
    const TriangleMesh& mesh = geometry_->meshes[hit.instance().mesh];
    point->emitter =
        geometry_->emitter_table[hit.instance().first_emitter + mesh.emitting_number(met->id.triangle)];
  }
  if (!hit.triangle().is_flat && surface.reflector != InvalidIndex)
    point->terminator_offset = hit.terminator_offset();
  return point;
}

SurfacePoint CompiledScene::front_point(const TriangleId& id, const Vec2f& weights) const {
  const TriangleHit met{id, weights.x, weights.y, 0};
  const Vec3f normal = HitTriangle(*geometry_, met, Ray()).point().geometric_normal;
  const Ray ray{Vec3f(0), -normal};
  const HitTriangle hit(*geometry_, met, ray);
  SurfacePoint point = hit.point();
  point.surface = &surfaces_[hit.instance().first_surface + hit.triangle().surface];
  point.colour = Rgb(1);
  if (!hit.triangle().is_flat) point.terminator_offset = hit.terminator_offset();
  return point;
}

std::optional<RayStart> CompiledScene::offset_start(const SurfacePoint& point, const Vec3f& geometric_side,
                                                    std::uint64_t& rays) const {
  // A smaller offset does not leave the triangle; normals that point away from it may even lead below it.
  const float least = 4 * absolute(point.geometric_normal).dot(point.error);
  if (!(point.terminator_offset.dot(geometric_side) > least)) return std::nullopt;
  const Vec3f foot =
      offset_towards(point.position, point.error, point.geometric_normal, point.terminator_offset);
  const Vec3f raised = point.position + point.terminator_offset;
  ++rays;
  if (is_occluded({foot, raised - foot, point.id})) return std::nullopt;
  return RayStart{raised, TriangleId()};
}

Vec3d CompiledScene::off_faces(const Vec3d& point, const Vec3d& direction) const {
  if (bounds().isEmpty()) return point;
  const Vec3d farthest(
      std::max(std::abs(bounds().min.x - origin().x), std::abs(bounds().max.x - origin().x)),
      std::max(std::abs(bounds().min.y - origin().y), std::abs(bounds().max.y - origin().y)),
      std::max(std::abs(bounds().min.z - origin().z), std::abs(bounds().max.z - origin().z)));
  // Twice the largest error of three corners, since the point is rounded too.
  const double reach = 2 * 3 * InterpolationError * farthest.length();
  std::vector<FacePlane> planes;
  for (const TriangleId& id : caster_.triangles_near(Vec3f(point), static_cast<float>(reach))) {
    planes.push_back(plane_of(*geometry_, id));
  }
  // In an edge or corner, moving off one face may lead back to another.
  constexpr int Passes = 4;
  Vec3d moved = point;
  for (int pass = 0; pass < Passes; ++pass) {
    for (const FacePlane& plane : planes) {
      const double height = (moved - plane.corner).dot(plane.normal);
      if (std::abs(height) >= plane.error) continue;
      const double side =
          std::abs(height) > CornerRounding * plane.error ? height : direction.dot(plane.normal);
      moved += plane.normal * (std::copysign(plane.error, side) - height);
    }
  }
  return moved;
}

Rgb CompiledScene::transmittance_to_end(const Ray& ray, std::uint32_t emitter) const {
  const bool has_emitter = emitter != InvalidIndex;
  const TriangleId target = has_emitter ? geometry_->emitter_triangles[emitter] : TriangleId();
  const std::uint32_t count = !has_emitter ? 0 : lights_[emitter].is_triangle ? 1 : 2;
  if (!has_cutouts_) return Rgb(caster_.is_occluded(ray, target, count, nullptr) ? 0.0F : 1.0F);
  Passage passage(*this, ray);
  return caster_.is_occluded(ray, target, count, &passage) ? Rgb(0) : passage.transmittance();
}

Rgb CompiledScene::transmittance(const Ray& ray) const {
  if (!has_cutouts_) return Rgb(caster_.is_unoccluded(ray, nullptr) ? 1.0F : 0.0F);
  Passage passage(*this, ray);
  return caster_.is_unoccluded(ray, &passage) ? passage.transmittance() : Rgb(0);
}

std::size_t CompiledScene::triangle_count() const {
  std::size_t count = 0;
  for (const Instance& instance : geometry_->instances) {
    count += geometry_->meshes[instance.mesh].triangles.size();
  }
  return count;
}

std::size_t CompiledScene::bytes() const {
  std::size_t bytes = geometry_->bytes() + surfaces_.capacity() * sizeof(CompiledSurface);
  for (const TextureFile& file : textures_) bytes += file.texture->bytes();
  return bytes;
}

bool CompiledScene::is_diffuse() const {
  return varying_.empty() &&
         std::all_of(reflectors_.reflectors.begin(), reflectors_.reflectors.end(),
                     [](const reflectance::Reflector& reflector) { return reflector.is_diffuse(); });
}

}  // namespace transport
