#include <algorithm>
#include <cmath>
#include <deque>

#include "converters/vrml/transforms.h"
#include "converters/vrml/vrml97_geometry.h"

namespace convert::vrml {
namespace {

using grf::Matrix44d;
using grf::Vec2d;
using grf::Vec3d;

/// The local frame of a cross-section at a point of the spine: x, normal and z.
struct Frame {
  Vec3d x, y, z;
};

/// The frames of cross-sections along a spine (ISO/IEC 14772-1, 6.18.3).
class Spine {
 public:
  explicit Spine(std::vector<Vec3d> points) : points_(std::move(points)) {}

  bool is_closed() const { return points_.size() > 2 && points_.front() == points_.back(); }

  std::vector<Frame> frames() const {
    std::vector<Vec3d> ys = directions();
    std::vector<Vec3d> zs;
    for (std::size_t i = 0; i < points_.size(); ++i) zs.push_back(bend(i));
    if (!fill_gaps(ys)) std::fill(ys.begin(), ys.end(), Vec3d(0, 1, 0));
    if (!fill_gaps(zs)) return straight_frames(ys);
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i > 0 && zs[i].dot(zs[i - 1]) < 0) zs[i] = -zs[i];
      frames.push_back({ys[i].cross(zs[i]).normalized(), ys[i], zs[i]});
    }
    return frames;
  }

 private:
  std::size_t last() const { return points_.size() - 1; }

  std::vector<Vec3d> directions() const {
    std::vector<Vec3d> directions;
    for (std::size_t i = 0; i <= last(); ++i) {
      const bool is_end = i == 0 || i == last();
      const Vec3d& next = is_end && is_closed() ? points_[1] : points_[std::min(i + 1, last())];
      const Vec3d& before = is_end && is_closed() ? points_[last() - 1] : points_[i == 0 ? 0 : i - 1];
      directions.push_back((next - before).normalized());
    }
    return directions;
  }

  /// Returns the axis about which the spine bends at a point; zero if it is straight, or ends.
  Vec3d bend(std::size_t i) const {
    const bool is_end = i == 0 || i == last();
    if (is_end && !is_closed()) return Vec3d(0);
    const Vec3d to_next = (points_[is_end ? 1 : i + 1] - points_[i]).normalized();
    const Vec3d to_last = (points_[is_end ? last() - 1 : i - 1] - points_[i]).normalized();
    const Vec3d axis = to_next.cross(to_last);
    constexpr double Straight = 1e-9;
    return axis.length() > Straight ? axis.normalized() : Vec3d(0);
  }

  /// Replaces zero vectors by the previous value, or else by the first non-zero one. False if all are zero.
  static bool fill_gaps(std::vector<Vec3d>& values) {
    const auto first =
        std::find_if(values.begin(), values.end(), [](const Vec3d& v) { return v != Vec3d(0); });
    if (first == values.end()) return false;
    Vec3d last = *first;
    for (Vec3d& value : values) {
      if (value == Vec3d(0)) value = last;
      last = value;
    }
    return true;
  }

  // Along a straight spine, the frame is rotated by the smallest angle to align its normal with the spine.
  static std::vector<Frame> straight_frames(const std::vector<Vec3d>& ys) {
    const Vec3d& y = ys.front();
    Vec3d axis = Vec3d(0, 1, 0).cross(y);
    if (axis.length() == 0) axis = Vec3d(1, 0, 0);
    Matrix44d turn;
    turn.setAxisAngle(axis.normalized(), std::atan2(Vec3d(0, 1, 0).cross(y).length(), y.y));
    const Frame frame{Vec3d(1, 0, 0) * turn, y, Vec3d(0, 0, 1) * turn};
    return std::vector<Frame>(ys.size(), frame);
  }

  std::vector<Vec3d> points_;
};

/// Computes the arc length of each point of a polyline, normalised to 0..1.
template <class Point>
std::vector<double> fractions(const std::vector<Point>& points) {
  std::vector<double> fractions = {0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    fractions.push_back(fractions.back() + (points[i] - points[i - 1]).length());
  }
  const double whole = fractions.back();
  for (double& fraction : fractions) fraction /= whole > 0 ? whole : 1;
  return fractions;
}

class ExtrusionReader {
 public:
  ExtrusionReader(const Node& node, Report& report)
      : node_(node), reader_(node, report.diagnostics()), report_(report) {}

  std::optional<Polygons> run() {
    read_lines();
    if (report_.failed()) return std::nullopt;
    if (spine_.size() < 2 || section_.size() < 2) return Polygons{};
    if (!report_.count_generated(node_, spine_.size() * section_.size())) return std::nullopt;
    add_positions();
    add_sides();
    if (reader_.flag("beginCap", true)) add_cap(0, false);
    if (reader_.flag("endCap", true)) add_cap(spine_.size() - 1, true);
    if (!reader_.flag("ccw", true)) polygons_.reverse_faces();
    add_crease_normals(polygons_, reader_.number("creaseAngle", 0));
    if (report_.failed()) return std::nullopt;
    return std::move(polygons_);
  }

 private:
  void read_lines() {
    for (const auto& point : read_points("spine", 3, {0, 0, 0, 0, 1, 0})) {
      spine_.emplace_back(point[0], point[1], point[2]);
    }
    for (const auto& point : read_points("crossSection", 2, {1, 1, 1, -1, -1, -1, -1, 1, 1, 1})) {
      section_.emplace_back(point[0], point[1]);
    }
    scales_ = read_points("scale", 2, {1, 1});
    orientations_ = read_points("orientation", 4, {0, 0, 1, 0});
  }

  /// Reads a list of vectors.
  std::vector<std::span<const double>> read_points(std::string_view field, std::size_t size,
                                                   std::initializer_list<double> fallback) {
    std::span<const double> numbers = reader_.numbers(field, size);
    if (reader_.find(field) == nullptr) numbers = defaults_.emplace_back(fallback);
    std::vector<std::span<const double>> points;
    for (std::size_t i = 0; i < numbers.size(); i += size) points.push_back(numbers.subspan(i, size));
    return points;
  }

  /// Returns the value at a point of the spine; the last value is repeated.
  static std::span<const double> at(const std::vector<std::span<const double>>& values, std::size_t i) {
    return values.empty() ? std::span<const double>() : values[std::min(i, values.size() - 1)];
  }

  void add_positions() {
    const std::vector<Frame> frames = Spine(spine_).frames();
    for (std::size_t i = 0; i < spine_.size(); ++i) {
      const Matrix44d turn = rotation_of(at(orientations_, i));
      const auto scale = at(scales_, i);
      const Vec2d factors = scale.empty() ? Vec2d(1) : Vec2d(scale[0], scale[1]);
      for (const Vec2d& point : section_) {
        const Vec3d p = Vec3d(point.x * factors.x, 0, point.y * factors.y) * turn;
        polygons_.positions.emplace_back(spine_[i] + frames[i].x * p.x + frames[i].y * p.y +
                                         frames[i].z * p.z);
      }
    }
    const auto ring = polygons_.positions.end() - static_cast<std::ptrdiff_t>(section_.size());
    is_closed_ = std::equal(ring, polygons_.positions.end(), polygons_.positions.begin());
  }

  // The first and last point of a closed line are one vertex.
  std::uint32_t vertex(std::size_t i, std::size_t k) const {
    if (is_closed_ && i + 1 == spine_.size()) i = 0;
    if (section_.front() == section_.back() && k + 1 == section_.size()) k = 0;
    return static_cast<std::uint32_t>(i * section_.size() + k);
  }

  void add_corner(std::size_t i, std::size_t k, const Vec2d& uv) {
    polygons_.corners.push_back(vertex(i, k));
    polygons_.uvs.emplace_back(uv);
  }

  void add_sides() {
    const std::vector<double> u = fractions(section_);
    const std::vector<double> v = fractions(spine_);
    for (std::size_t i = 0; i + 1 < spine_.size(); ++i) {
      for (std::size_t k = 0; k + 1 < section_.size(); ++k) {
        add_corner(i, k, {u[k], v[i]});
        add_corner(i, k + 1, {u[k + 1], v[i]});
        add_corner(i + 1, k + 1, {u[k + 1], v[i + 1]});
        add_corner(i + 1, k, {u[k], v[i + 1]});
        polygons_.face_ends.push_back(polygons_.corners.size());
      }
    }
  }

  void add_cap(std::size_t i, bool looks_ahead) {
    const bool is_loop = section_.front() == section_.back();
    const std::size_t count = section_.size() - (is_loop ? 1 : 0);
    if (count < 3) return;
    Vec2d least = section_.front();
    Vec2d most = least;
    for (const Vec2d& point : section_) {
      least = {std::min(least.x, point.x), std::min(least.y, point.y)};
      most = {std::max(most.x, point.x), std::max(most.y, point.y)};
    }
    const double size = std::max(most.x - least.x, most.y - least.y);
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t k = looks_ahead ? n : count - 1 - n;
      add_corner(i, k, (section_[k] - least) / (size > 0 ? size : 1));
    }
    polygons_.face_ends.push_back(polygons_.corners.size());
  }

  const Node& node_;
  NodeReader reader_;
  Report& report_;
  std::vector<Vec3d> spine_;
  std::vector<Vec2d> section_;
  std::vector<std::span<const double>> scales_;
  std::vector<std::span<const double>> orientations_;
  std::deque<std::vector<double>> defaults_;
  bool is_closed_ = false;  // the last cross-section is the first
  Polygons polygons_ = {};
};

}  // namespace

std::optional<Polygons> read_extrusion(const Node& node, Report& report) {
  return ExtrusionReader(node, report).run();
}

}  // namespace convert::vrml
