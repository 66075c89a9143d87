// Triangles without a good normal, and polygons that are not fans.
#include <numbers>

#include "grf/triangulation.h"
#include "tests/stability/naive_tracer.h"
#include "tests/transport/scene_helpers.h"

namespace test {
namespace {

using grf::Vec3d;
using transport::CompiledScene;
using transport::SurfacePoint;
using transport::Vec3f;
using Corners = NaiveTracer::Corners;

Vec3f any_point(Random& random, float size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// Compiles a mesh of separate triangles, in this order.
CompiledScene scene_of_triangles(const std::vector<Corners>& triangles) {
  std::string text = "begin mesh brdf diffuse begin vertexs\n";
  for (const Corners& corners : triangles) {
    for (const Vec3f& p : corners) text += fmt::format("({},{},{})\n", p.x, p.y, p.z);
  }
  text += "end vertexs begin faces\n";
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    text += fmt::format("({},{},{})\n", 3 * i, 3 * i + 1, 3 * i + 2);
  }
  return scene_of(text + "end faces end mesh");
}

Vec3d exact_normal(const Corners& c) {
  const Vec3d a(c[0]);
  return (Vec3d(c[1]) - a).cross(Vec3d(c[2]) - a).normalized();
}

/// Returns the angle in radians; infinite if the normal is not a unit vector.
double angle_between(const Vec3f& normal, const Vec3d& exact) {
  if (!(std::abs(normal.length() - 1) < 1e-3)) return INFINITY;
  const Vec3d n(normal);
  return 2 * std::atan2((n - exact).length(), (n + exact).length());
}

template <class Triangle>
std::vector<Corners> random_triangles(int count, Triangle triangle) {
  Random random;
  std::vector<Corners> triangles;
  for (int i = 0; i < count; ++i) triangles.push_back(triangle(random));
  return triangles;
}

/// Tests triangles whose third corner is 1e-6 to 1e-4 of their length off their longest edge.
Errors slivers() {
  const auto triangles = random_triangles(2000, [](Random& random) {
    const Vec3f a = any_point(random, 1);
    const Vec3f b = any_point(random, 1);
    const Vec3f off = any_point(random, 1) * random.log_uniform(1e-6F, 1e-4F);
    return Corners{a, b, a + (b - a) * random.uniform(0.2F, 0.8F) + off};
  });
  const CompiledScene scene = scene_of_triangles(triangles);
  Errors errors;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    const Vec3d exact = exact_normal(triangles[i]);
    if (!(exact.length() > 0.5)) continue;  // rounding moved the corner to the edge
    errors.include({angle_between(scene.front_point({0, i}, {0.3F, 0.3F}).geometric_normal, exact),
                    angle_between((b - a).cross(c - a).normalized(), exact)});
  }
  return errors;
}

struct Aimed {
  int rays = 0, missed = 0, naive_missed = 0, wrong = 0, naive_wrong = 0;
};

/// Traces a ray to each triangle's interior, from a distance of about 1 and not from the side.
Aimed aimed_at(const std::vector<Corners>& triangles, const CompiledScene& scene, const NaiveTracer& naive) {
  Random random;
  Aimed aimed;
  for (const Corners& corners : triangles) {
    const auto& [a, b, c] = corners;
    const Vec3f target = a * 0.3F + b * 0.3F + c * 0.4F;
    const Vec3d normal = exact_normal(corners);
    Vec3f back = random.direction(random.uniform(-1, 1));
    while (normal.length() > 0.5 && std::abs(Vec3d(back).dot(normal)) < 0.5) {
      back = random.direction(random.uniform(-1, 1));
    }
    const Vec3f origin = target + back;
    const Vec3f direction = (target - origin).normalized();
    ++aimed.rays;
    const auto point = scene.intersect({origin, direction});
    if (!point) ++aimed.missed;
    if (point && !(std::abs(point->geometric_normal.length() - 1) < 1e-3F)) ++aimed.wrong;
    const auto hit = naive.intersect(origin, direction);
    if (!hit) ++aimed.naive_missed;
    if (hit && !(std::abs(hit->normal.length() - 1) < 1e-3F)) ++aimed.naive_wrong;
  }
  return aimed;
}

/// Tests right angles between edges of 1e-6.
Errors tiny_triangles() {
  const auto triangles = random_triangles(500, [](Random& random) {
    const reflectance::Frame frame(random.direction(random.uniform(-1, 1)));
    const Vec3f a = any_point(random, 1e-3F);
    return Corners{a, a + frame.x * 1.4e-6F, a + frame.y * 1.4e-6F};
  });
  const Aimed aimed = aimed_at(triangles, scene_of_triangles(triangles), NaiveTracer(triangles, 0, 1e-8F));
  return {aimed.missed / double(aimed.rays), aimed.naive_missed / double(aimed.rays)};
}

/// Tests three collinear corners at integer coordinates, two of them often equal.
Errors without_area() {
  const auto triangles = random_triangles(2000, [](Random& random) {
    const auto number = [&] { return std::floor(random.uniform(-4, 5)); };
    const Vec3f a(number(), number(), number());
    const Vec3f step(number(), number(), number());
    return Corners{a, a + step * number(), a + step * number()};
  });
  const Aimed aimed = aimed_at(triangles, scene_of_triangles(triangles), NaiveTracer(triangles));
  return {aimed.wrong / double(aimed.rays), aimed.naive_wrong / double(aimed.rays)};
}

/// Measures the distance to their plane of hits on unit triangles, by rays from far away.
Errors hits_from_afar() {
  Random random;
  Errors errors;
  for (int i = 0; i < 200; ++i) {
    const Corners corners{any_point(random, 1), any_point(random, 1), any_point(random, 1)};
    const CompiledScene scene = scene_of_triangles({corners});
    const Vec3d normal = exact_normal(corners);
    const auto off_plane = [&](const Vec3f& p) {
      return std::abs((Vec3d(p) - Vec3d(corners[0])).dot(normal));
    };
    const Vec3f target = (corners[0] + corners[1] + corners[2]) / 3;
    const float distance = random.log_uniform(1e3F, 1e5F);
    const Vec3f origin = target + random.direction(random.uniform(-1, 1)) * distance;
    const Vec3f direction = (target - origin).normalized();
    const auto point = scene.intersect({origin, direction});
    const auto hit = NaiveTracer({corners}).intersect(origin, direction);
    if (point) errors.ours = std::max(errors.ours, off_plane(point->position));
    if (hit) errors.naive = std::max(errors.naive, off_plane(origin + direction * hit->distance));
  }
  return errors;
}

/// Measures the tangents of triangles whose uv are collinear or equal, against unit ones in the plane.
Errors uv_without_area() {
  Random random;
  Errors errors;
  for (int i = 0; i < 50; ++i) {
    const grf::Vec2f uv(random.uniform(0, 1), random.uniform(0, 1));
    const grf::Vec2f step = i % 2 == 0 ? grf::Vec2f(0) : grf::Vec2f(0.25F, 0.5F);
    const auto corner = [&](int k, const Vec3f& p) {
      const grf::Vec2f at = uv + step * static_cast<float>(k);
      return fmt::format("uv ({},{}) ({},{},{}) ", at.x, at.y, p.x, p.y, p.z);
    };
    const CompiledScene scene = scene_of(
        "begin mesh brdf ward sx=0.1 sy=0.3 begin vertexs " + corner(0, {-1, -1, 0}) + corner(1, {1, -1, 0}) +
        corner(2, {0, 1, 0}) + "end vertexs begin faces (0,1,2) end faces end mesh");
    const SurfacePoint point = scene.intersect({Vec3f(0, 0, 1), Vec3f(0, 0, -1)}).value();
    const auto error = [](const Vec3f& tangent) {
      const double off = std::abs(tangent.length() - 1) + std::abs(tangent.z);
      return std::isfinite(off) ? off : INFINITY;
    };
    const float area = step.cross(step * 2.0F);
    const Vec3f naive = (Vec3f(2, 0, 0) * (step.y * 2) - Vec3f(1, 2, 0) * step.y) / area;
    const reflectance::Frame frame(point.shading_normal, point.tangent);
    errors.include({error(frame.x), error(naive / std::sqrt(naive.dot(naive)))});
  }
  return errors;
}

using Polygon = std::vector<Vec3f>;

/// Computes Newell's normal: its components are twice the projected areas along the axes.
Vec3d newell(const Polygon& polygon) {
  Vec3d sum(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += (Vec3d(polygon[i]) - Vec3d(polygon[0]))
               .cross(Vec3d(polygon[(i + 1) % polygon.size()]) - Vec3d(polygon[0]));
  }
  return sum;
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles fan_of(const Polygon& polygon) {
  Triangles fan;
  for (std::uint32_t i = 1; i + 1 < polygon.size(); ++i) fan.push_back({0, i, i + 1});
  return fan;
}

/// Returns the relative error of the area covered, in the plane of the polygon's own normal.
double area_error(const Polygon& polygon, const Triangles& triangles) {
  const Vec3d normal = newell(polygon);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3d origin(polygon[a]);
    sum += std::abs((Vec3d(polygon[b]) - origin).cross(Vec3d(polygon[c]) - origin).dot(normal));
  }
  return relative_error(sum, normal.dot(normal));
}

Errors errors_of_area(const Polygon& polygon) {
  Triangles triangles;
  grf::triangulate(polygon, triangles);
  return {area_error(polygon, triangles), area_error(polygon, fan_of(polygon))};
}

/// Returns true if a polygon winds once about a point, seen along its own normal.
bool is_star(const Polygon& polygon, const Vec3f& centre) {
  const Vec3d normal = newell(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d a = Vec3d(polygon[i]) - Vec3d(centre);
    const Vec3d b = Vec3d(polygon[(i + 1) % polygon.size()]) - Vec3d(centre);
    if (a.cross(b).dot(normal) <= 0) return false;
  }
  return true;
}

/// Makes a star-shaped polygon with radii from 0.1 to 1, about a plane that is tilted and off the origin.
Polygon star(Random& random, float height) {
  const reflectance::Frame frame(random.direction(random.uniform(-1, 1)));
  const Vec3f centre = any_point(random, 10);
  const int corners = 5 + static_cast<int>(random.uniform(0, 40));
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const float angle = 2 * reflectance::Pi * static_cast<float>(i) / static_cast<float>(corners);
    const float radius = random.uniform(0.1F, 1);
    polygon.push_back(centre + frame.x * (radius * std::cos(angle)) + frame.y * (radius * std::sin(angle)) +
                      frame.z * random.uniform(-height, height));
  }
  return is_star(polygon, centre) ? polygon : star(random, height);
}

Errors concave() {
  Random random;
  Errors errors;
  for (int i = 0; i < 1000; ++i) errors.include(errors_of_area(star(random, 0)));
  return errors;
}

Errors not_planar() {
  Random random;
  Errors errors;
  for (int i = 0; i < 1000; ++i) errors.include(errors_of_area(star(random, 0.2F)));
  return errors;
}

/// Tests a square with a square hole anywhere in it, cut open along a line that is an edge twice.
Errors self_touching() {
  Random random;
  Errors errors;
  for (int i = 0; i < 1000; ++i) {
    const reflectance::Frame frame(random.direction(random.uniform(-1, 1)));
    const float x = random.uniform(-0.9F, 0.5F);
    const float y = random.uniform(-0.9F, 0.5F);
    const std::array<grf::Vec2f, 10> places = {{{-1, -1},
                                                {1, -1},
                                                {1, 1},
                                                {-1, 1},
                                                {-1, -1},
                                                {x, y},
                                                {x, y + 0.4F},
                                                {x + 0.4F, y + 0.4F},
                                                {x + 0.4F, y},
                                                {x, y}}};
    Polygon polygon;
    for (const grf::Vec2f& place : places) polygon.push_back(frame.x * place.x + frame.y * place.y);
    errors.include(errors_of_area(polygon));
  }
  return errors;
}

/// Tests faces with a notch at their first corner, lit from the side of Newell's normal.
Errors turned_over() {
  Random random;
  constexpr int Count = 1000;
  int ours = 0;
  int naive = 0;
  for (int i = 0; i < Count; ++i) {
    const Polygon polygon = star(random, 0);
    const Vec3d normal = newell(polygon);
    Triangles triangles;
    grf::triangulate(polygon, triangles);
    const bool turned = std::any_of(triangles.begin(), triangles.end(), [&](const auto& t) {
      const Vec3d a(polygon[t[0]]);
      return (Vec3d(polygon[t[1]]) - a).cross(Vec3d(polygon[t[2]]) - a).dot(normal) < 0;
    });
    const Vec3f of_corners = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[1]);
    if (turned) ++ours;
    if (Vec3d(of_corners).dot(normal) < 0) ++naive;
  }
  return {ours / double(Count), naive / double(Count)};
}

}  // namespace

std::vector<HardCase> triangle_cases() {
  constexpr std::string_view Area = "relative error of the area covered";
  return {
      {"Slivers: a corner 1e-6 to 1e-4 off the edge", "the cross product of two edges",
       "the same in double where its sine is under 1e-3", 0.6, 1e-5, 1e-7, slivers,
       "angular error of the normal, in radians"},
      {"Triangles of 1e-12 in area", "a determinant under 1e-8 is a miss", "no threshold: Embree's", 1, 0, 0,
       tiny_triangles, "fraction of rays to them that miss"},
      {"Triangles of zero area", "u < 0 or u > 1 is a miss: NaN is neither", "they are never hit", 1, 0, 0,
       without_area, "fraction of rays to them with a hit without a normal"},
      {"Triangles of 1, from 1e3 to 1e5 away", "origin + t direction", "interpolated between the corners",
       0.01, 1e-6, 8e-8, hits_from_afar, "distance of hits from their plane"},
      {"Texture coordinates of zero area", "a tangent of edges over the area in uv",
       "the cross product with the object's axis", INFINITY, 1e-6, 0, uv_without_area,
       "distance of the tangent from a unit vector"},
      {"Concave polygons", "a triangle fan about the first corner", "ear clipping in double", 5, 1e-12, 6e-16,
       concave, Area},
      {"Concave polygons that are not planar", "a triangle fan about the first corner",
       "ear clipping in the plane of the polygon's normal", 5, 1e-12, 7e-16, not_planar, Area},
      {"Polygons that touch themselves, round a hole", "a triangle fan about the first corner",
       "a corner coincident with an ear's own does not block it", 0.4, 1e-12, 4e-16, self_touching, Area},
      {"Front side of a concave polygon", "the normal at the second corner",
       "triangles are oriented by Newell's normal", 0.4, 0, 0, turned_over, "fraction of flipped polygons"},
  };
}

}  // namespace test
