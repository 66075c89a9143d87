#include "converters/gltf/gltf_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include "converters/text_encoding.h"

namespace convert {
namespace {

constexpr const char* Lights = "KHR_lights_punctual";

constexpr double LargestRadius = 0.05;  ///< of a point or spot light, in metres
constexpr double RadiusPerDiagonal = 0.005;
constexpr double DistancePerDiagonal = 100;  ///< of a directional light
constexpr double SunRadius = 0.00465;        ///< of the sun as seen from the earth, in radians

/// The radiance at which a mesh emits, and its faces around the origin.
struct Emitter {
  double radiance = 0;  ///< for an intensity of 1
  grf::MeshDraft faces;
};

/// Makes an icosahedron: three golden rectangles have its corners, and its faces are all triangles of edges.
/// In the mean over all directions, a convex body's projected area is a fourth of its surface (Cauchy).
Emitter icosahedron(double radius) {
  const double golden = std::numbers::phi;
  const double half_edge = radius / std::sqrt(1 + golden * golden);
  std::vector<grf::Vec3d> places;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double x : {-half_edge, half_edge}) {
      for (const double y : {-golden * half_edge, golden * half_edge}) {
        grf::Vec3d& place = places.emplace_back(0);
        place[axis] = x;
        place[(axis + 1) % 3] = y;
      }
    }
  }
  const auto is_edge = [&](std::uint32_t a, std::uint32_t b) {
    return (places[a] - places[b]).length() < 2.1 * half_edge;
  };
  Emitter emitter;
  for (const grf::Vec3d& place : places) emitter.faces.positions.emplace_back(place);
  for (std::uint32_t a = 0; a < places.size(); ++a) {
    for (std::uint32_t b = a + 1; b < places.size(); ++b) {
      for (std::uint32_t c = b + 1; c < places.size(); ++c) {
        if (!is_edge(a, b) || !is_edge(b, c) || !is_edge(a, c)) continue;
        const bool is_outward = places[a].dot(places[b].cross(places[c])) > 0;
        emitter.faces.add_face(std::array{a, is_outward ? b : c, is_outward ? c : b}, 0);
      }
    }
  }
  const double surface = 5 * std::sqrt(3.0) * 4 * half_edge * half_edge;
  emitter.radiance = 4 / surface;
  return emitter;
}

/// Makes a regular polygon of 24 corners that faces a direction.
Emitter disc(double radius, const grf::Vec3d& direction) {
  constexpr std::uint32_t Corners = 24;
  const grf::Vec3d other = std::abs(direction.x) < 0.5 ? grf::Vec3d(1, 0, 0) : grf::Vec3d(0, 1, 0);
  const grf::Vec3d x = direction.cross(other).normalized();
  const grf::Vec3d y = direction.cross(x);
  Emitter emitter;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < Corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / Corners;
    emitter.faces.positions.emplace_back(x * (radius * std::cos(angle)) + y * (radius * std::sin(angle)));
    corners.push_back(i);
  }
  emitter.faces.add_face(corners, 0);
  emitter.radiance = 1 / (radius * radius * Corners / 2 * std::sin(2 * std::numbers::pi / Corners));
  return emitter;
}

grf::Colour radiance_of(const tinygltf::Light& light, double scale) {
  const bool has_colour = light.color.size() == 3;
  grf::Colour radiance(1);
  for (int k = 0; k < 3; ++k) {
    const double channel = has_colour ? light.color[static_cast<std::size_t>(k)] : 1;
    radiance[k] = static_cast<float>(channel * light.intensity * scale);
  }
  return radiance;
}

bool is_valid(const grf::Colour& radiance) {
  return std::isfinite(radiance.x) && std::isfinite(radiance.y) && std::isfinite(radiance.z) &&
         std::min({radiance.x, radiance.y, radiance.z}) >= 0;
}

}  // namespace

bool GltfLights::has_light(const tinygltf::Node& node) { return node.extensions.contains(Lights); }

void GltfLights::take(const tinygltf::Node& node, const grf::Matrix44d& to_scene) {
  const tinygltf::Value& value = node.extensions.at(Lights);
  const int index = value.Has("light") && value.Get("light").IsInt() ? value.Get("light").Get<int>() : -1;
  grf::Vec3d towards;
  to_scene.multDirMatrix(grf::Vec3d(0, 0, -1), towards);
  const grf::Vec3d place = to_scene.translation();
  const bool is_placed =
      std::isfinite(place.length()) && std::isfinite(towards.length()) && towards.length() > 0;
  if (index < 0 || static_cast<std::size_t>(index) >= file_.model.lights.size() || !is_placed)
    return losses_.add(Loss::LightSource);
  const tinygltf::Light& light = file_.model.lights[static_cast<std::size_t>(index)];
  const bool is_known = light.type == "point" || light.type == "spot" || light.type == "directional";
  if (!is_known || !is_valid(radiance_of(light, 1))) return losses_.add(Loss::LightSource);
  if (light.type == "spot") losses_.add(Loss::SpotCone);
  losses_.add(Loss::PunctualLight);
  placed_.push_back({&light, place, towards.normalized()});
}

std::vector<grf::Block> GltfLights::blocks(const grf::Box3d& bounds,
                                           const grf::SourceLocation& location) const {
  const double diagonal = bounds.isEmpty() ? 1 : std::max(1e-6, bounds.size().length());
  const double radius = std::min(LargestRadius, RadiusPerDiagonal * diagonal);
  std::vector<grf::Block> blocks;
  for (const Placed& placed : placed_) {
    const bool is_distant = placed.light->type == "directional";
    const double distance = DistancePerDiagonal * diagonal;
    Emitter emitter = placed.light->type == "point" ? icosahedron(radius)
                      : is_distant                  ? disc(distance * SunRadius, placed.direction)
                                                    : disc(radius, placed.direction);
    grf::Vec3d place = placed.place;
    // The intensity of a directional light is its irradiance, which falls with the squared distance.
    if (is_distant) {
      place = (bounds.isEmpty() ? grf::Vec3d(0) : bounds.center()) - placed.direction * distance;
      emitter.radiance *= distance * distance;
    }
    for (grf::Vec3f& position : emitter.faces.positions) position = grf::Vec3f(grf::Vec3d(position) + place);
    grf::Surface& surface = emitter.faces.surfaces.front();
    surface.emission = radiance_of(*placed.light, emitter.radiance);
    grf::BrdfModel black;
    black.keyword = "diffuse";
    black.arguments = {{"kd", 0.0F, location}};
    black.location = location;
    surface.brdf = std::move(black);
    emitter.faces.name = on_one_line(placed.light->name);
    grf::Block block;
    block.content = grf::Shared<grf::Mesh>(grf::Mesh(std::move(emitter.faces)));
    block.location = location;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace convert
