// Rays that start on a surface, or run along edges and through vertices.
#include <functional>
#include <numbers>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "renderer/transport/camera.h"
#include "renderer/transport/integrators/shading_point.h"
#include "tests/stability/naive_tracer.h"
#include "tests/transport/scene_helpers.h"

namespace test {
namespace {

using grf::Vec3d;
using transport::CompiledScene;
using transport::ShadingPoint;
using transport::SurfacePoint;
using transport::Vec3f;

const Vec3f Angles(0.3F, 0.5F, 0.7F);

/// Numbers of failed rays.
struct Counts {
  std::uint64_t rays = 0, ours = 0, naive = 0;

  Counts operator+(const Counts& other) const {
    return {rays + other.rays, ours + other.ours, naive + other.naive};
  }
  Errors shares() const {
    return {static_cast<double>(ours) / static_cast<double>(rays),
            static_cast<double>(naive) / static_cast<double>(rays)};
  }
};

enum class Aim { Edges, Vertices };

/// A closed room: the box from -1 to 1 with a transform.
struct Room {
  Vec3f scale, angles, offset;
  std::string around = {};  ///< other blocks of the scene

  grf::Matrix44d map() const { return map_of(scale, angles, offset); }
  CompiledScene compiled(const std::string& mesh) const {
    return scene_of(placed(mesh, scale, angles, offset) + around);
  }
};

/// Traces rays from about the room's middle to its edges or vertices, through which none may escape.
Counts leaks_to(Aim aim, const Room& room, const CompiledScene& scene, const NaiveTracer& naive,
                std::uint32_t first, std::uint32_t last) {
  const grf::Matrix44d map = room.map();
  Counts counts;
  for (std::uint32_t i = first; i < last; ++i) {
    const auto a = transport::sobol_point(i, 1);
    const auto b = transport::sobol_point(i, 2);
    Vec3f target(2 * a.x - 1, 2 * a.y - 1, 2 * a.z - 1);
    for (std::uint32_t k = 0; k < (aim == Aim::Edges ? 2U : 3U); ++k) {
      float& component = target[static_cast<int>((i + k) % 3)];
      component = component < 0 ? -1.0F : 1.0F;
    }
    const Vec3d place = Vec3d(b.x - 0.5, b.y - 0.5, b.z - 0.5) * 0.2;
    const Vec3f origin(place * map);
    const Vec3f direction = Vec3f(Vec3d(target) * map) - origin;
    ++counts.rays;
    if (!scene.intersect({origin, direction})) ++counts.ours;
    if (!naive.intersect(origin, direction)) ++counts.naive;
  }
  return counts;
}

Errors leaks(Aim aim, const Room& room, std::uint32_t rays) {
  const CompiledScene scene = room.compiled(box("brdf diffuse"));
  const NaiveTracer naive(triangles_of(scene.geometry()));
  const auto counts = tbb::parallel_reduce(
      tbb::blocked_range<std::uint32_t>(0, rays, 10'000), Counts(),
      [&](const tbb::blocked_range<std::uint32_t>& range, const Counts& before) {
        return before + leaks_to(aim, room, scene, naive, range.begin(), range.end());
      },
      [](const Counts& a, const Counts& b) { return a + b; });
  return counts.shares();
}

const Room Cube = {Vec3f(1), Angles, Vec3f(0.2F)};
constexpr std::uint32_t MillionRays = 1'000'000;

Errors leaks_through_edges() { return leaks(Aim::Edges, Cube, MillionRays); }
Errors leaks_through_vertices() { return leaks(Aim::Vertices, Cube, MillionRays); }
Errors many_leaks_through_edges() { return leaks(Aim::Edges, Cube, 100 * MillionRays); }
Errors many_leaks_through_vertices() { return leaks(Aim::Vertices, Cube, 100 * MillionRays); }
Errors leaks_of_long_room() {
  return leaks(Aim::Vertices, {Vec3f(1, 2, 30), Vec3f(1, 2, 3), Vec3f(7)}, MillionRays);
}

/// Samples a uniform direction on the side of the normal.
Vec3f direction_over(Random& random, const Vec3f& normal) {
  const Vec3f direction = random.direction(random.uniform(-1, 1));
  return direction.dot(normal) < 0 ? -direction : direction;
}

/// Traces rays from wall to wall of a closed cube. A ray fails if it is_unoccluded or hits the wall that it
/// leaves. Naive code offsets the origin by 1e-4 of the last ray's length.
Errors errors_from_wall_to_wall(const Room& room) {
  constexpr float Epsilon = 1e-4F;
  const CompiledScene scene = room.compiled(box("brdf diffuse"));
  // The shift is in world coordinates.
  const Vec3f shift(scene.origin());
  const NaiveTracer naive(triangles_of(scene.geometry(), shift));
  Random random;
  Counts counts;
  while (counts.rays < 20'000) {
    const Vec3f origin = scene.to_local(Vec3d(0) * room.map());
    const Vec3f direction = random.direction(random.uniform(-1, 1));
    ++counts.rays;
    const SurfacePoint point = scene.intersect({origin, direction}).value();
    const Vec3f onwards = direction_over(random, point.geometric_normal);
    const auto next = scene.intersect({point.origin_towards(onwards), onwards, point.id});
    if (!next || next->geometric_normal.dot(point.geometric_normal) > 0.9F) ++counts.ours;
    const auto hit = naive.intersect(origin + shift, direction);
    if (hit) {
      const Vec3f met = origin + shift + direction * hit->distance;
      const auto naive_next = naive.intersect(met + hit->normal * Epsilon, onwards);
      if (naive_next && naive_next->normal.dot(hit->normal) < 0.9F) continue;
    }
    ++counts.naive;
  }
  return counts.shares();
}

Errors at_scale_of_millionth() { return errors_from_wall_to_wall({Vec3f(1e-6F), Angles, Vec3f(0)}); }
Errors at_scale_of_million() { return errors_from_wall_to_wall({Vec3f(1e6F), Angles, Vec3f(2e5F)}); }
Errors far_from_origin() { return errors_from_wall_to_wall({Vec3f(1), Angles, Vec3f(1e6F, -1e6F, 1e6F)}); }

/// Writes a ground of this half side, under everything, about the origin.
std::string landscape(float side) {
  return quad("brdf diffuse",
              fmt::format("(-{0},{1},{0}) ({0},{1},{0}) ({0},{1},-{0}) (-{0},{1},-{0})", side, -side / 10));
}
/// A cube of 2 mm in a landscape of a kilometre, and one of 2 m 10 km from the middle of one of 20 km: the
/// scene is about the origin, so that no shift helps.
Errors watch_in_landscape() {
  return errors_from_wall_to_wall({Vec3f(1e-3F), Angles, Vec3f(200, 3, -100), landscape(500)});
}
Errors house_far_away() {
  return errors_from_wall_to_wall({Vec3f(1), Angles, Vec3f(9000, 30, -4000), landscape(10'000)});
}

/// Continues from hits at edges, in any direction into the cube or along the edge; nothing may escape. Naive
/// code offsets the origin by 1e-4.
Errors on_from_edges() {
  const CompiledScene scene = Cube.compiled(box("brdf diffuse"));
  const NaiveTracer naive(triangles_of(scene.geometry()));
  const grf::Matrix44d map = Cube.map();
  const Vec3f origin(Vec3d(0.1, 0.05, -0.1) * map);
  Random random;
  Counts counts;
  while (counts.rays < 100'000) {
    Vec3f place(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    Vec3f along(0);
    const int axis = static_cast<int>(counts.rays % 3);
    along[axis] = 1;
    for (const int i : {(axis + 1) % 3, (axis + 2) % 3}) place[i] = place[i] < 0 ? -1.0F : 1.0F;
    const Vec3f target(Vec3d(place) * map);
    const Vec3f edge = Vec3f(Vec3d(place + along) * map) - target;
    const SurfacePoint point = scene.intersect({origin, target - origin}).value();
    const bool is_along = random.uniform(0, 1) < 0.5F;
    Vec3f onwards = is_along ? edge : direction_over(random, point.geometric_normal);
    if (onwards.dot(point.geometric_normal) < 0) onwards = -onwards;
    ++counts.rays;
    if (!scene.intersect({point.origin_towards(onwards), onwards, point.id})) ++counts.ours;
    const auto hit = naive.intersect(origin, target - origin);
    const Vec3f start = hit ? origin + (target - origin) * hit->distance + hit->normal * 1e-4F : target;
    if (!naive.intersect(start, onwards)) ++counts.naive;
  }
  return counts.shares();
}

/// Traces rays from wall to wall of a cube that is an instance. Naive code rounds the exact point on the
/// wall, and offsets it by 1e-4.
Errors errors_in_instance(const Vec3f& scale) {
  const Room room = {scale, Angles, scale * 0.2F};
  const std::string use = "use cube";
  const std::string text = "def cube = " + box("brdf diffuse") + "begin " +
                           placed(use, room.scale, room.angles, room.offset) +
                           placed(use, scale, Vec3f(0), scale * 20) + "end ";
  grf::Diagnostics diagnostics;
  transport::CompileSettings settings;
  settings.most_copied_triangles = 0;
  const auto scene =
      transport::compile(grf::read_text(text, "test.grf", diagnostics).value(), diagnostics, settings);
  const Vec3f origin = scene->to_local(Vec3d(0) * room.map());
  Random random;
  Counts counts;
  while (counts.rays < 100'000) {
    const Vec3f target(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const Vec3f direction = scene->to_local(Vec3d(target) * room.map()) - origin;
    const SurfacePoint point = scene->intersect({origin, direction}).value();
    const Vec3f inside =
        point.geometric_normal.dot(direction) > 0 ? -point.geometric_normal : point.geometric_normal;
    const Vec3f onwards = direction_over(random, inside);
    const auto is_wrong = [&](const std::optional<SurfacePoint>& next) {
      return !next || next->geometric_normal.dot(point.geometric_normal) > 0.9F;
    };
    ++counts.rays;
    if (is_wrong(scene->intersect({point.origin_towards(onwards), onwards, point.id}))) ++counts.ours;
    const float longest = std::max({std::abs(target.x), std::abs(target.y), std::abs(target.z)});
    const Vec3f met = scene->to_local(Vec3d(target) / longest * room.map());
    if (is_wrong(scene->intersect({met + inside * 1e-4F, onwards}))) ++counts.naive;
  }
  return counts.shares();
}

Errors in_tiny_instance() { return errors_in_instance(Vec3f(1e-6F, 2e-6F, 0.5e-6F)); }
Errors in_long_instance() { return errors_in_instance(Vec3f(0.01F, 1, 100)); }

/// Writes two triangles of a square of side 2 at this height, rotated and translated.
std::string square(float height) {
  return placed(quad("brdf diffuse", fmt::format("(-1,-1,{0}) (1,-1,{0}) (1,1,{0}) (-1,1,{0})", height)),
                Vec3f(1), Angles, Vec3f(3, 4, 5));
}

/// Counts failures of rays up from the middle of the first square, the scene's first two triangles.
template <class Wrong>
Counts rays_up(const CompiledScene& scene, Wrong wrong) {
  Random random;
  Counts counts;
  while (counts.rays < 100'000) {
    const SurfacePoint point = scene.front_point({0, static_cast<std::uint32_t>(counts.rays % 2)},
                                                 {random.uniform(0.3F, 0.4F), random.uniform(0.3F, 0.4F)});
    const reflectance::Frame frame(point.geometric_normal);
    const Vec3f direction = frame.to_world(random.direction(random.uniform(0.1F, 1)));
    ++counts.rays;
    const auto [ours, naive] = wrong(point, direction);
    if (ours) ++counts.ours;
    if (naive) ++counts.naive;
  }
  return counts;
}

struct Wrong {
  bool ours, naive;
};

/// Naive code excludes only the triangle that a ray starts on.
Errors coincident() {
  const CompiledScene scene = scene_of(square(0) + square(0));
  return rays_up(scene,
                 [&](const SurfacePoint& point, const Vec3f& direction) {
                   return Wrong{!scene.is_unoccluded({point.origin_towards(direction), direction, point.id}),
                                !scene.is_unoccluded({point.position, direction, point.id})};
                 })
      .shares();
}

/// Tests a sheet 1e-5 above the square, which rays from the square must hit. Naive code offsets by 1e-4.
Errors nearly_coincident() {
  const CompiledScene scene = scene_of(square(0) + square(1e-5F));
  return rays_up(scene,
                 [&](const SurfacePoint& point, const Vec3f& direction) {
                   return Wrong{
                       scene.is_unoccluded({point.origin_towards(direction), direction, point.id}),
                       scene.is_unoccluded({point.position + point.geometric_normal * 1e-4F, direction})};
                 })
      .shares();
}

/// Writes a light of radiance 1, 1e-5 above the square, facing down. Naive code offsets by 1e-4.
std::string lamp_on_square() {
  return square(0) + placed("light begin (-1,-1,1e-5) (0,2,0) (2,0,0) rgb (1,1,1) end ", Vec3f(1), Angles,
                            Vec3f(3, 4, 5));
}

Errors errors_of_light(const CompiledScene& scene, const SurfacePoint& point, std::uint32_t seed) {
  const Vec3f& normal = point.geometric_normal;
  const Vec3f naive_origin = point.position + normal * 1e-4F;
  constexpr int Samples = 1024;
  double ours = 0;
  double naive = 0;
  for (std::uint32_t i = 0; i < Samples; ++i) {
    const auto xi = transport::sobol_point(i, seed);
    if (const auto light = scene.lights().sample(point.position, normal, xi.z, xi.xy())) {
      const Vec3f end =
          transport::offset_towards(light->position, light->error, light->normal, -light->direction);
      const Vec3f origin = point.origin_towards(light->direction);
      const bool is_lit = !scene.is_occluded({origin, end - origin, point.id}, light->emitter);
      if (is_lit) ours += light->direction.dot(normal) / light->pdf / Samples;
    }
    if (const auto light = scene.lights().sample(naive_origin, normal, xi.z, xi.xy()))
      naive += light->direction.dot(normal) / light->pdf / Samples;
  }
  // The light covers the point's whole hemisphere.
  return {relative_error(ours, std::numbers::pi), relative_error(naive, std::numbers::pi)};
}

Errors lamp_on_a_square() {
  const CompiledScene scene = scene_of(lamp_on_square());
  Random random;
  Errors errors;
  for (std::uint32_t i = 0; i < 20; ++i) {
    const SurfacePoint point =
        scene.front_point({0, i % 2}, {random.uniform(0.2F, 0.4F), random.uniform(0.2F, 0.4F)});
    errors.include(errors_of_light(scene, point, i));
  }
  return errors;
}

/// Looks up or down from points of a square, with no other face; no ray may hit the square. Naive code uses
/// the eye as it is.
Errors eye_in_a_face() {
  const CompiledScene scene = scene_of(square(0));
  const grf::Matrix44d map = map_of(Vec3f(1), Angles, Vec3f(3, 4, 5));
  const Vec3d centre = Vec3d(0) * map;
  const Vec3d normal = Vec3d(0, 0, 1) * map - centre;
  constexpr int Width = 8;
  Random random;
  Counts counts;
  while (counts.rays < 100'000) {
    transport::View view;
    view.eye = Vec3d(random.uniform(-0.9F, 0.9F), random.uniform(-0.9F, 0.9F), 0) * map;
    view.target = view.eye + (random.uniform(0, 1) < 0.5F ? normal : -normal);
    const transport::Camera ours = transport::camera_of(scene, view, Width, Width);
    const transport::Camera naive(transport::relative_to(scene.origin(), view), Width, Width);
    for (int i = 0; i < Width * Width; ++i) {
      const auto x = static_cast<float>(i % Width) + 0.5F;
      const auto y = static_cast<float>(i / Width) + 0.5F;
      ++counts.rays;
      if (!scene.is_unoccluded(ours.ray(x, y))) ++counts.ours;
      if (!scene.is_unoccluded(naive.ray(x, y))) ++counts.naive;
    }
  }
  return counts.shares();
}

/// Writes a cube with arbitrary vertex normals.
std::string box_with_normals(Random& random) {
  std::string text = "begin mesh brdf diffuse begin vertexs ";
  for (int i = 0; i < 8; ++i) {
    const Vec3f normal = random.direction(random.uniform(-1, 1));
    text += fmt::format("normal ({},{},{}) ({},{},{}) ", normal.x, normal.y, normal.z, i % 2 * 2 - 1,
                        i / 2 % 2 * 2 - 1, i / 4 * 2 - 1);
  }
  return text +
         "end vertexs begin faces (0,1,3,2) (4,6,7,5) (0,4,5,1) (2,3,7,6) (0,2,6,4) (1,5,7,3) end faces end "
         "mesh ";
}

/// Calls `use` with the hits of rays in boxes with such normals.
void with_bad_normals(
    const std::function<void(const CompiledScene&, const SurfacePoint&, const Vec3f& back, Random&)>& use) {
  Random random;
  for (int i = 0; i < 20; ++i) {
    const CompiledScene scene = scene_of(box_with_normals(random));
    for (int k = 0; k < 5000; ++k) {
      const Vec3f direction = random.direction(random.uniform(-1, 1));
      use(scene, scene.intersect({Vec3f(0), direction}).value(), -direction, random);
    }
  }
}

Errors normals_that_point_away() {
  Counts counts;
  with_bad_normals([&](const CompiledScene& scene, const SurfacePoint& point, const Vec3f& back, Random&) {
    ++counts.rays;
    if (ShadingPoint(point, *scene.reflector(*point.surface), back).u.z <= 0) ++counts.ours;
    if (point.shading_normal.dot(back) <= 0) ++counts.naive;
  });
  return counts.shares();
}

/// Naive code accepts any direction above the shading normal, which faces the viewer.
Errors leaks_by_normals() {
  Counts counts;
  with_bad_normals([&](const CompiledScene& scene, const SurfacePoint& point, const Vec3f& back,
                       Random& random) {
    ++counts.rays;
    const ShadingPoint shading(point, *scene.reflector(*point.surface), back);
    const Vec3f direction = direction_over(random, shading.frame.z);
    if (shading.is_above(direction)) {
      std::uint64_t rays = 0;
      const auto ray = shading.ray_towards(scene, direction, rays);
      if (ray && !scene.intersect(*ray)) ++counts.ours;
    }
    const Vec3f normal = point.shading_normal.dot(back) < 0 ? -point.shading_normal : point.shading_normal;
    const Vec3f naive = direction.dot(normal) < 0 ? -direction : direction;
    if (!scene.intersect({point.origin_towards(naive), naive, point.id})) ++counts.naive;
  });
  return counts.shares();
}

/// Returns the radiance of a white ball in a white environment; naive code starts each ray at the end of the
/// one before, and accepts hits from 0 on.
double naive_brightness(const CompiledScene& scene, float distance, int paths) {
  const NaiveTracer naive(triangles_of(scene.geometry()));
  Random random;
  double sum = 0;
  for (int i = 0; i < paths; ++i) {
    Vec3f origin(0, 0, distance);
    Vec3f direction(random.uniform(-0.2F, 0.2F), random.uniform(-0.2F, 0.2F), -1);
    direction.normalize();
    bool is_lit = false;
    for (int events = 0; events <= 1 && !is_lit; ++events) {
      const auto hit = naive.intersect(origin, direction);
      is_lit = !hit;
      if (!hit) break;
      origin += direction * hit->distance;
      const Vec3f normal = hit->normal.dot(direction) > 0 ? -hit->normal : hit->normal;
      direction = reflectance::Frame(normal).to_world(
          reflectance::cosine_direction({random.uniform(0, 1), random.uniform(0, 1)}));
    }
    if (is_lit) sum += 1.0 / paths;
  }
  return sum;
}

Errors white_ball() {
  const CompiledScene scene = scene_of(sphere("brdf diffuse kd=1", 16, false));
  RenderSetup look;
  look.depth = 1;
  look.background = 1;
  const double ours = mean_radiance(render(scene, look)).mean;
  return {relative_error(ours, 1), relative_error(naive_brightness(scene, 4, 5000), 1)};
}

}  // namespace

std::vector<HardCase> ray_cases() {
  constexpr std::string_view NoIdea = "each triangle separately, in float (Moeller and Trumbore)";
  constexpr std::string_view Robust = "Embree's robust mode: edges are watertight";
  constexpr std::string_view GetOut = "fraction of rays that escape";
  constexpr std::string_view Wrong = "fraction of rays that escape, or hit the wall that they leave";
  constexpr std::string_view Offset = "offset of 1e-4 of the ray's length";
  constexpr std::string_view Bounded = "offset by the error bound; exclude the triangle";
  return {
      {"Closed cube, a million rays to its edges", NoIdea, Robust, 0.04, 0, 0, leaks_through_edges, GetOut},
      {"Closed cube, a million rays to its vertices", NoIdea, Robust, 0.05, 0, 0, leaks_through_vertices,
       GetOut},
      {"Closed cube, a hundred million rays to its edges", NoIdea, Robust, 0.04, 0, 0,
       many_leaks_through_edges, GetOut, Kind::Long},
      {"Closed cube, a hundred million rays to its vertices", NoIdea, Robust, 0.05, 0, 0,
       many_leaks_through_vertices, GetOut, Kind::Long},
      {"Closed room of 2 x 4 x 60, a million rays to its vertices", NoIdea, Robust, 0.2, 0.01, 5e-3,
       leaks_of_long_room, GetOut},
      {"From wall to wall of a tiny cube of 1e-6", Offset, Bounded, 1, 0, 0, at_scale_of_millionth, Wrong},
      {"From wall to wall of a huge cube of 1e6", Offset, Bounded, 0.5, 0, 0, at_scale_of_million, Wrong},
      {"From wall to wall of a cube of 1, 1e6 from the origin", Offset,
       "coordinates relative to the scene's centre", 0.5, 0, 0, far_from_origin, Wrong},
      {"From wall to wall of a cube of 2 mm in a landscape of 1 km", Offset, Bounded, 1e-3, 0, 0,
       watch_in_landscape, Wrong},
      {"From wall to wall of a cube of 2 m, 10 km from the middle of the scene", Offset, Bounded, 0.5, 0, 0,
       house_far_away, Wrong},
      {"From hits at edges of a cube, into it or along them", Offset, "kept off the edges by the error bound",
       0.1, 0, 0, on_from_edges, GetOut},
      {"From wall to wall of a cube that is an instance, scaled to 1e-6", Offset,
       "the bound includes the transform's rounding", 1, 0, 0, in_tiny_instance, Wrong},
      {"From wall to wall of an instance scaled by 0.01, 1 and 100", Offset,
       "the bound includes the transform's rounding, at edges too", 4e-5, 0, 0, in_long_instance, Wrong},
      {"Two coincident squares", "exclude the triangle only", Bounded, 0.5, 0, 0, coincident,
       "fraction of rays from one that hit the other"},
      {"A camera whose eye lies in a tilted square", "the eye as it is, rounded",
       "the eye moved off the face by the error bound", 0.5, 0, 0, eye_in_a_face,
       "fraction of camera rays that hit the square"},
      {"A sheet 1e-5 above a square", Offset, Bounded, 1, 0, 0, nearly_coincident,
       "fraction of rays from the square that miss it"},
      {"A light 1e-5 above a square", Offset, Bounded, 1, 0.01, 4e-4, lamp_on_a_square,
       "relative error of the irradiance of 1024 samples", Kind::Noisy},
      {"Vertex normals that point away", "as they are", "the geometric normal for those", 0.4, 0, 0,
       normals_that_point_away, "fraction of points that are black"},
      {"Arbitrary vertex normals, in a closed cube", "directions above the shading normal",
       "only those also above the surface", 0.4, 0, 0, leaks_by_normals, GetOut},
      {"White furnace: a white ball in a white environment", "each ray from the end of the last", Bounded,
       0.4, 1e-5, 0, white_ball, "relative error of the radiance"},
  };
}

}  // namespace test
