// The text of scenes that programs make, the same on every machine.
#pragma once

#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <ImathVec.h>

namespace shape {

using Imath::V3d;

constexpr double TwoPi = 2 * std::numbers::pi;

/// Uniform random numbers that are the same with every standard library, whose distributions differ. Call it
/// once per statement, since the order of evaluation within an expression differs between compilers.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double operator()(double from, double to) {
    return from + (to - from) * static_cast<double>(engine_()) / 4294967296.0;
  }

 private:
  std::mt19937 engine_;
};

/// Returns a vector in GRF, rounded to parts of 1 so that the text does not depend on the mathematical
/// library.
std::string text_of(const V3d& v, double parts = 1e4);

/// The vertices and faces of a mesh in GRF, from the attributes before each position.
class MeshText {
 public:
  /// Positions are rounded to these parts of 1.
  explicit MeshText(double parts = 1e4) : parts_(parts) {}

  /// Adds a vertex and returns its index. `attributes` are a normal, a colour or uv in GRF, or empty.
  int add_vertex(const V3d& position, const std::string& attributes = {});
  /// Faces are seen from the side on which their corners are counter-clockwise.
  void add_face(const std::vector<int>& corners);
  /// Adds attributes for the faces that follow.
  void add_attributes(const std::string& attributes) { faces_ += attributes + "\n"; }
  /// A parallelogram whose front is the side to which edge1 x edge2 points.
  void add_quad(const V3d& corner, const V3d& edge1, const V3d& edge2);
  /// An axis-aligned box seen from outside.
  void add_box(const V3d& low, const V3d& high);

  /// The `mesh` block. `attributes` hold for all faces.
  std::string block(const std::string& attributes) const;

 private:
  double parts_;
  std::string vertices_, faces_;
  int count_ = 0;
};

}  // namespace shape
