#include "editor/document/transform_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <ImathMatrixAlgo.h>
#include <fmt/format.h>

namespace editor {
namespace {

using grf::Matrix44d;
using grf::Vec3d;
using grf::Vec3f;
using Kind = grf::TransformStep::Kind;
using Matrix33d = Imath::M33d;

constexpr double DegreesPerRadian = 180 / std::numbers::pi;
/// Angles are exact on a grid of this many steps per degree, far above the resolution of `float` radians.
constexpr double StepsPerDegree = 10000;
constexpr double FloatEpsilon = std::numeric_limits<float>::epsilon();

/// The decimal that a file shows for this number.
double written(float number) { return std::stod(fmt::format("{}", number)); }

Vec3d written(const Vec3f& vector) { return {written(vector.x), written(vector.y), written(vector.z)}; }

/// Rounds a decimal, computed in double from numbers of this size, to its first twelve digits.
double without_rounding_error(double number, double size) {
  if (number == 0) return 0;
  const int decimals = 11 - static_cast<int>(std::floor(std::log10(std::max(size, std::abs(number)))));
  return std::stod(fmt::format("{:.{}f}", number, std::clamp(decimals, 0, 60)));
}

/// The angle of a rotation step in degrees, on the grid where the number in radians stands for it.
double degrees_of(float radians) {
  const double degrees = double{radians} * DegreesPerRadian;
  const double on_grid = std::round(degrees * StepsPerDegree) / StepsPerDegree;
  return static_cast<float>(on_grid / DegreesPerRadian) == radians ? on_grid : degrees;
}

Vec3d degrees_of(const Vec3f& radians) {
  return {degrees_of(radians.x), degrees_of(radians.y), degrees_of(radians.z)};
}

/// Rounds to the grid of angles, or returns nothing for a vector that is not on it.
std::optional<Vec3d> on_grid(const Vec3d& degrees) {
  Vec3d rounded;
  for (int axis = 0; axis < 3; ++axis) {
    rounded[axis] = std::round(degrees[axis] * StepsPerDegree) / StepsPerDegree;
    if (std::abs(rounded[axis] - degrees[axis]) > 1e-9) return std::nullopt;
    if (rounded[axis] <= -180) rounded[axis] += 360;
    rounded[axis] += 0.0;  // no negative zero
  }
  return rounded;
}

Vec3f radians_of(const Vec3d& degrees) { return Vec3f(degrees / DegreesPerRadian); }

/// Cosine and sine, exact for multiples of a quarter turn.
std::pair<double, double> cosine_and_sine(double degrees) {
  static constexpr std::array<std::pair<double, double>, 4> Quarters = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const double quarters = degrees / 90;
  if (quarters == std::round(quarters)) {
    const double turn = quarters - 4 * std::floor(quarters / 4);
    return Quarters[static_cast<std::size_t>(turn)];
  }
  return {std::cos(degrees / DegreesPerRadian), std::sin(degrees / DegreesPerRadian)};
}

/// The matrix of a rotation about an axis (Rodrigues), for row vectors.
Matrix33d rotation_about(const Vec3d& axis, double degrees) {
  const Vec3d n = axis.normalized();
  const auto [c, s] = cosine_and_sine(degrees);
  const double t = 1 - c;
  return {t * n.x * n.x + c,       t * n.x * n.y + s * n.z, t * n.x * n.z - s * n.y,
          t * n.x * n.y - s * n.z, t * n.y * n.y + c,       t * n.y * n.z + s * n.x,
          t * n.x * n.z + s * n.y, t * n.y * n.z - s * n.x, t * n.z * n.z + c};
}

Matrix33d rotation_of(const Vec3d& degrees) {
  return rotation_about({1, 0, 0}, degrees.x) * rotation_about({0, 1, 0}, degrees.y) *
         rotation_about({0, 0, 1}, degrees.z);
}

/// The angles about x, then y, then z of a rotation, in degrees; about z it is 0 where y is a quarter turn.
Vec3d angles_of(const Matrix33d& m) {
  const double cosine = std::hypot(m[0][0], m[0][1]);
  const double y = std::atan2(-m[0][2], cosine);
  const bool is_locked = cosine < 1e-9;
  const double x = is_locked ? std::atan2(-m[2][1], m[1][1]) : std::atan2(m[1][2], m[2][2]);
  const double z = is_locked ? 0 : std::atan2(m[0][1], m[0][0]);
  return Vec3d(x, y, z) * DegreesPerRadian;
}

/// Whether decomposing a rotation with these angles gives the same angles.
bool is_restored(const Vec3d& degrees) {
  const auto angles = on_grid(angles_of(rotation_of(degrees)));
  return angles && *angles == degrees;
}

/// The last steps of a transform, those that edits change: scale, up to two rotations and up to two
/// translations. A rotation before the scale belongs to them, too.
struct Tail {
  std::vector<grf::TransformStep> others;  ///< the steps before
  std::optional<Vec3d> first_rotation;     ///< degrees, as all rotations
  Vec3d scale = Vec3d(1);
  std::vector<Vec3d> rotations;
  std::vector<Vec3f> translations;
};

Tail tail_of(TransformSteps steps) {
  Tail tail;
  const auto take = [&steps](Kind kind) -> std::optional<Vec3f> {
    if (steps.empty() || steps.back().kind != kind) return std::nullopt;
    const Vec3f value = steps.back().value;
    steps.pop_back();
    return value;
  };
  for (int i = 0; i < 2; ++i) {
    if (const auto value = take(Kind::Translation))
      tail.translations.insert(tail.translations.begin(), *value);
  }
  for (int i = 0; i < 2; ++i) {
    if (const auto value = take(Kind::Rotation))
      tail.rotations.insert(tail.rotations.begin(), degrees_of(*value));
  }
  if (const auto value = take(Kind::Scale)) {
    tail.scale = written(*value);
    if (const auto first = take(Kind::Rotation)) tail.first_rotation = degrees_of(*first);
  }
  tail.others = std::move(steps);
  return tail;
}

TransformSteps steps_of(const Tail& tail) {
  TransformSteps steps = tail.others;
  const auto add_rotation = [&steps](const Vec3d& degrees) {
    if (degrees != Vec3d(0)) steps.push_back({Kind::Rotation, radians_of(degrees)});
  };
  if (tail.first_rotation) add_rotation(*tail.first_rotation);
  if (tail.scale != Vec3d(1)) steps.push_back({Kind::Scale, Vec3f(tail.scale)});
  for (const Vec3d& rotation : tail.rotations) add_rotation(rotation);
  for (const Vec3f& translation : tail.translations) {
    if (translation != Vec3f(0)) steps.push_back({Kind::Translation, translation});
  }
  return steps;
}

Vec3d position_of(const Tail& tail) {
  Vec3d position(0);
  for (const Vec3f& translation : tail.translations) position += written(translation);
  return position;
}

Matrix33d rotation_of(const std::vector<Vec3d>& rotations) {
  Matrix33d product;
  for (const Vec3d& rotation : rotations) product *= rotation_of(rotation);
  return product;
}

/// The exact sum as a number that a file shows as this decimal; nothing if `float` has no such number.
std::optional<float> exact_sum(float number, double offset) {
  const double start = written(number);
  const double sum = without_rounding_error(start + offset, std::abs(start));
  const auto rounded = static_cast<float>(sum);
  return written(rounded) == sum ? std::optional(rounded + 0.0F) : std::nullopt;
}

void translate(Tail& tail, const Vec3d& offset) {
  if (offset == Vec3d(0)) return;
  if (tail.translations.empty()) {
    tail.translations.emplace_back(offset);
    return;
  }
  Vec3f& last = tail.translations.back();
  Vec3f sum;
  bool is_exact = true;
  for (int axis = 0; axis < 3; ++axis) {
    const auto exact = exact_sum(last[axis], offset[axis]);
    is_exact = is_exact && exact;
    sum[axis] = exact.value_or(static_cast<float>(written(last[axis]) + offset[axis]));
  }
  if (is_exact || tail.translations.size() == 2) {
    last = sum;
  } else {
    tail.translations.emplace_back(offset);
  }
}

/// Sets the position after an action about a pivot, rounded to few digits if computing made more of them.
void set_position(Tail& tail, const Vec3d& position, const Vec3d& pivot) {
  const Vec3d before = position_of(tail);
  const double size = std::max({position.length(), before.length(), pivot.length()});
  Vec3d offset;
  for (int axis = 0; axis < 3; ++axis) {
    const double rounded = shortest_near(position[axis], 4 * FloatEpsilon * size);
    offset[axis] = without_rounding_error(rounded - before[axis], size);
  }
  translate(tail, offset);
}

/// A rotation step with this matrix after it: exact if its angles are on the grid before and after.
std::optional<Vec3d> turned_exactly(const Vec3d& degrees, const Matrix33d& turn) {
  if (!is_restored(degrees)) return std::nullopt;
  return on_grid(angles_of(rotation_of(degrees) * turn));
}

void turn_by(Tail& tail, const Matrix33d& turn) {
  if (!tail.rotations.empty()) {
    Vec3d& last = tail.rotations.back();
    const auto exact = turned_exactly(last, turn);
    if (exact || tail.rotations.size() == 2) {
      last = exact.value_or(angles_of(rotation_of(last) * turn));
      return;
    }
  }
  const Vec3d angles = angles_of(turn);
  tail.rotations.push_back(on_grid(angles).value_or(angles));
}

Matrix33d diagonal(const Vec3d& factors) { return {factors.x, 0, 0, 0, factors.y, 0, 0, 0, factors.z}; }

/// The diagonal of a matrix, or nothing if it has other elements.
std::optional<Vec3d> diagonal_of(const Matrix33d& m) {
  const double size = std::max({std::abs(m[0][0]), std::abs(m[1][1]), std::abs(m[2][2])});
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      if (row != column && std::abs(m[row][column]) > 1e-6 * size) return std::nullopt;
    }
  }
  return Vec3d(m[0][0], m[1][1], m[2][2]);
}

Vec3d angles_near_grid(const Matrix33d& rotation) {
  const Vec3d angles = angles_of(rotation);
  return on_grid(angles).value_or(angles);
}

/// Appends any linear action to scale and rotations of the tail, by the singular value decomposition.
void append_linear(Tail& tail, const Matrix33d& action) {
  const Matrix33d first = tail.first_rotation ? rotation_of(*tail.first_rotation) : Matrix33d();
  const Matrix33d linear = first * diagonal(tail.scale) * rotation_of(tail.rotations) * action;
  Matrix33d before;
  Matrix33d after;
  Vec3d factors;
  Imath::jacobiSVD(linear, before, factors, after, std::numeric_limits<double>::epsilon(), true);
  tail.first_rotation = angles_near_grid(before);
  for (int axis = 0; axis < 3; ++axis) {
    tail.scale[axis] = shortest_near(factors[axis], 2 * FloatEpsilon * std::abs(factors[axis]));
  }
  tail.rotations = {angles_near_grid(after.transposed())};
}

Matrix33d linear_of(const Matrix44d& m) {
  return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

/// Scales by the lengths of the rows, and rotates by their directions.
ObjectTransform decomposed(const Matrix44d& matrix) {
  ObjectTransform result;
  result.position = matrix.translation();
  Matrix33d rows = linear_of(matrix);
  const bool is_mirrored = rows.determinant() < 0;
  std::array<Vec3d, 3> axes = {Vec3d(rows[0][0], rows[0][1], rows[0][2]),
                               Vec3d(rows[1][0], rows[1][1], rows[1][2]),
                               Vec3d(rows[2][0], rows[2][1], rows[2][2])};
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d& direction = axes[static_cast<std::size_t>(axis)];
    result.scale[axis] = direction.length() * (is_mirrored ? -1 : 1);
    direction /= result.scale[axis];
  }
  result.has_shear = std::abs(axes[0].dot(axes[1])) > 1e-6 || std::abs(axes[1].dot(axes[2])) > 1e-6 ||
                     std::abs(axes[2].dot(axes[0])) > 1e-6;
  const Vec3d y = (axes[1] - axes[0] * axes[0].dot(axes[1])).normalized();
  const Vec3d z = axes[0].cross(y);
  result.rotation = angles_of({axes[0].x, axes[0].y, axes[0].z, y.x, y.y, y.z, z.x, z.y, z.z});
  return result;
}

}  // namespace

double shortest_near(double number, double tolerance) {
  if (std::abs(number) <= tolerance) return 0;
  for (int digits = 1; digits <= 6; ++digits) {
    const double candidate = std::stod(fmt::format("{:.{}e}", number, digits - 1));
    if (std::abs(candidate - number) <= tolerance) return candidate;
  }
  return number;
}

ObjectTransform object_transform_of(const TransformSteps& steps) {
  const Tail tail = tail_of(steps);
  if (!tail.others.empty() || tail.first_rotation || tail.rotations.size() > 1)
    return decomposed(grf::matrix_of(steps));
  ObjectTransform result;
  result.position = position_of(tail);
  if (!tail.rotations.empty()) result.rotation = tail.rotations.front();
  result.scale = tail.scale;
  return result;
}

TransformSteps steps_of(const ObjectTransform& transform) {
  Tail tail;
  tail.scale = transform.scale;
  tail.rotations = {transform.rotation};
  tail.translations = {Vec3f(transform.position)};
  return steps_of(tail);
}

void translate(TransformSteps& steps, const grf::Vec3d& offset) {
  Tail tail = tail_of(std::move(steps));
  const double size = offset.length();
  translate(tail, {without_rounding_error(offset.x, size), without_rounding_error(offset.y, size),
                   without_rounding_error(offset.z, size)});
  steps = steps_of(tail);
}

void rotate(TransformSteps& steps, const grf::Vec3d& axis, double degrees, const grf::Vec3d& pivot) {
  Tail tail = tail_of(std::move(steps));
  const Matrix33d turn = rotation_about(axis, degrees);
  const Vec3d position = pivot + (position_of(tail) - pivot) * turn;
  turn_by(tail, turn);
  set_position(tail, position, pivot);
  steps = steps_of(tail);
}

void scale(TransformSteps& steps, const grf::Vec3d& factors, const grf::Matrix44d& axes,
           const grf::Vec3d& pivot) {
  Tail tail = tail_of(std::move(steps));
  const Matrix33d to_world = linear_of(axes);
  const Matrix33d action = to_world.transposed() * diagonal(factors) * to_world;
  const Matrix33d rotation = rotation_of(tail.rotations);
  const Vec3d position = pivot + (position_of(tail) - pivot) * action;
  if (const auto own = diagonal_of(rotation * action * rotation.transposed())) {
    for (int axis = 0; axis < 3; ++axis) {
      const double product = tail.scale[axis] * (*own)[axis];
      tail.scale[axis] = shortest_near(product, 2 * FloatEpsilon * std::abs(product));
    }
  } else {
    append_linear(tail, action);
  }
  set_position(tail, position, pivot);
  steps = steps_of(tail);
}

void transform(TransformSteps& steps, const grf::Matrix44d& action) {
  Tail tail = tail_of(std::move(steps));
  const Vec3d position = position_of(tail) * action;
  append_linear(tail, linear_of(action));
  set_position(tail, position, position);
  steps = steps_of(tail);
}

}  // namespace editor
