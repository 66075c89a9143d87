#include <algorithm>
#include <cmath>
#include <numbers>

#include "samples/shapes/shape.h"

namespace shape {
namespace {

constexpr double Pi = std::numbers::pi;

/// From the tip of the tail, in turns that lift off the ground, to the snout, turned aside.
V3d spine(double along) {
  static const std::vector<V3d> points = {
      {-2.1, 0.1, -0.75}, {-1.75, 0.08, -0.35}, {-1.75, 0.12, 0.25}, {-1.3, 0.2, 0.62}, {-0.8, 0.36, 0.4},
      {-0.55, 0.5, -0.1}, {-0.2, 0.56, -0.42},  {0.3, 0.5, -0.42},   {0.7, 0.5, -0.08}, {0.85, 0.62, 0.32},
      {0.7, 0.9, 0.58},   {0.62, 1.16, 0.56},   {0.8, 1.32, 0.38},   {1.05, 1.3, 0.33}, {1.3, 1.2, 0.36},
  };
  return curve_through(points, along);
}

/// The side of the back: over the body, and behind the neck where that rises.
V3d back_side(double along) {
  const double neck = smooth_step(0.58, 0.7, along) * (1 - smooth_step(0.8, 0.9, along));
  return V3d(0, 1, 0) * (1 - neck) + V3d(-0.8, 0.3, -0.6) * neck;
}

/// 0 at both ends, where it falls as a sphere's does.
double round_ends(double along, double length) {
  const double to_end = std::clamp(std::min(along, 1 - along) / length, 0.0, 1.0);
  return std::sqrt(to_end * (2 - to_end));
}

/// A bump of height 1 and period 2 pi, narrower than a sine's.
double ridge(double angle) { return std::exp(3 * (std::cos(angle) - 1)); }

/// Scales in rows, whose edges go up and down.
double scales(double along, double around, double rows, double columns) {
  const double row = rows * along + 0.5 * std::sin(columns * around) * std::sin(rows * along * Pi);
  const double step = row - std::floor(row);
  return smooth_step(0, 0.55, step) * (1 - smooth_step(0.55, 1, step));
}

double body_radius(double along, double around) {
  const double tail = 0.025 + 0.2 * smooth_step(0, 0.5, along);
  const double neck = 1 - 0.55 * smooth_step(0.5, 0.72, along);
  const double head = 0.06 * std::exp(-std::pow((along - 0.9) / 0.035, 2));
  const double jaw = 1 + 0.2 * std::cos(2 * around) * smooth_step(0.9, 0.97, along);
  const double size = (tail * neck + head) * jaw * (1 - 0.45 * smooth_step(0.92, 1, along));
  const double covered = smooth_step(0.02, 0.1, along) * (1 - smooth_step(0.86, 0.92, along));
  const double back = 0.12 * ridge(around) + 0.05 * ridge(3 * around + Pi);
  const double plates = scales(along, around, 64, 9) * (0.06 + 0.03 * std::cos(around));
  return size * (1 + covered * (back + plates)) * round_ends(along, 0.02);
}

/// Half the width of the body at a height of the curve, for what grows out of it.
double girth(double along) { return body_radius(along, Pi / 2); }

V3d to_the_side(double along) {
  const V3d tangent = spine(along + 1e-4) - spine(along - 1e-4);
  return tangent.cross(V3d(0, 1, 0)).normalized();
}

V3d top(double along) {
  const V3d tangent = (spine(along + 1e-4) - spine(along - 1e-4)).normalized();
  return tangent.cross(back_side(along)).normalized().cross(tangent);
}

V3d forwards(double along) { return V3d(0, 1, 0).cross(to_the_side(along)); }

/// A tube that narrows from `thick` to `thin`; for `up` see `tube`.
Surface limb(const std::vector<V3d>& points, double thick, double thin, double muscle,
             const V3d& up = V3d(0, 1, 0)) {
  const auto radius = [=](double along, double around) {
    const double swell = muscle * std::exp(-std::pow((along - 0.3) / 0.16, 2));
    const double rings = 0.05 * std::sin(30 * Pi * along) * std::cos(4 * around);
    return (thick + (thin - thick) * along) * (1 + swell + rings) * round_ends(along, 0.06);
  };
  return tube([=](double along) { return curve_through(points, along); }, radius, [=](double) { return up; });
}

/// A leg that goes out, down to the ground and forwards, with three claws.
void add_leg(Builder& builder, double at, double side, double triangles) {
  const V3d out = to_the_side(at) * side;
  const V3d ahead = forwards(at);
  const V3d root = spine(at) + out * (0.35 * girth(at));
  const V3d knee = root + out * 0.34 + ahead * 0.1 + V3d(0, 0.06, 0);
  V3d heel = root + out * 0.36 - ahead * 0.1;
  heel.y = 0.1;
  V3d foot = heel + ahead * 0.12;
  foot.y = 0.035;
  builder.add(limb({root, knee, heel, foot}, 0.13, 0.05, 0.35, out + V3d(0, 1, 0) + ahead), triangles * 0.7,
              4);
  for (int claw = -1; claw <= 1; ++claw) {
    const V3d spread = ahead + out * (0.55 * claw);
    const V3d middle = foot + spread * 0.07 + V3d(0, 0.025, 0);
    V3d tip = foot + spread * 0.15;
    tip.y = 0.01;
    builder.add(limb({foot, middle, tip}, 0.04, 0.012, 0.3), triangles * 0.1, 3);
  }
}

/// A membrane between ribs, as a tube that is far wider than thick and hangs back from its leading edge.
void add_wing(Builder& builder, double at, double side, double triangles) {
  const V3d out = to_the_side(at) * side;
  const V3d back = -forwards(at);
  const V3d root = spine(at) + V3d(0, 0.6 * girth(at), 0);
  const std::vector<V3d> edge = {root, root + out * 0.3 + V3d(0, 0.5, 0),
                                 root + out * 0.7 + back * 0.1 + V3d(0, 0.78, 0),
                                 root + out * 1.05 + back * 0.5 + V3d(0, 0.62, 0)};
  const Surface wing = [=](double along, double around) {
    const double across = 0.5 - 0.5 * std::cos(around);  // 0 at the leading edge
    const double ribs = std::cos(10 * Pi * along);
    const double chord = (0.62 - 0.34 * along) * (1 + 0.12 * ribs) * round_ends(along, 0.08);
    const double thickness = 0.012 * (1 + 0.7 * ribs) + 0.02 * std::exp(-12 * across);
    const V3d hang = (back - V3d(0, 0.45, 0) + out * (0.3 * along)).normalized();
    const V3d sail = hang.cross(out + V3d(0, 0.3, 0)).normalized() * (side * std::sin(around));
    const double billow = 0.12 * std::sin(Pi * across) * (1 - 0.4 * ribs) * round_ends(along, 0.2);
    return curve_through(edge, along) + hang * (chord * across) +
           sail * (thickness * round_ends(along, 0.08)) + V3d(0, billow, 0);
  };
  builder.add(wing, triangles, 1.2);
}

/// From the neck to the tail, the highest in the middle, leaning back.
void add_spikes(Builder& builder, int count, double triangles) {
  for (int i = 0; i < count; ++i) {
    const double at = 0.06 + 0.8 * (i + 0.5) / count;
    const double height = 0.05 + 0.13 * std::sin(Pi * std::pow(at, 0.8));
    const V3d up = top(at);
    const V3d back = (spine(at - 1e-3) - spine(at)).normalized();
    const V3d root = spine(at) + up * (0.9 * girth(at));
    const std::vector<V3d> points = {root - up * 0.02, root + up * (0.6 * height) + back * 0.02,
                                     root + up * height + back * (0.5 * height)};
    builder.add(limb(points, 0.25 * height, 0.04 * height, 0.1, up.cross(back)), triangles / count, 3);
  }
}

void add_head(Builder& builder, double triangles) {
  const double at = 0.9;
  for (const double side : {-1.0, 1.0}) {
    const V3d out = to_the_side(at) * side;
    const V3d back = -forwards(at);
    const V3d root = spine(at) + out * 0.08 + V3d(0, 0.08, 0);
    builder.add(limb({root, root + back * 0.14 + out * 0.08 + V3d(0, 0.12, 0),
                      root + back * 0.34 + out * 0.1 + V3d(0, 0.16, 0),
                      root + back * 0.44 + out * 0.02 + V3d(0, 0.3, 0)},
                     0.05, 0.008, 0, out),
                triangles * 0.3, 6);
    const V3d eye = spine(0.935) + out * 0.085 + V3d(0, 0.06, 0);
    const auto ball = [](double along, double) {
      return 0.03 * std::sqrt(std::max(0.0, 4 * along * (1 - along)));
    };
    builder.add(tube([=](double along) { return eye + out * (0.06 * (along - 0.5)); }, ball,
                     [](double) { return V3d(0, 1, 0); }),
                triangles * 0.05, 1);
    const V3d lip = spine(0.975) + out * 0.05 - V3d(0, 0.02, 0);
    builder.add(limb({lip, lip + out * 0.2 + V3d(0, 0.05, 0), lip + out * 0.3 + back * 0.2 - V3d(0, 0.1, 0),
                      lip + out * 0.36 + back * 0.3 - V3d(0, 0.02, 0)},
                     0.02, 0.006, 0),
                triangles * 0.15, 8);
  }
}

}  // namespace

grf::Mesh dragon(int triangles) {
  Builder builder;
  builder.add(tube(spine, body_radius, back_side), 0.5 * triangles, 5);
  for (const double side : {-1.0, 1.0}) {
    add_leg(builder, 0.36, side, 0.05 * triangles);
    add_leg(builder, 0.62, side, 0.05 * triangles);
    add_wing(builder, 0.56, side, 0.08 * triangles);
  }
  add_spikes(builder, 34, 0.09 * triangles);
  add_head(builder, 0.05 * triangles);
  return builder.mesh();
}

}  // namespace shape
