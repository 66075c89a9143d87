// Vectors are read from NumPy arrays where they are, with NumPy's broadcasting.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "renderer/parallel/loops.h"
#include "renderer/reflectance/geometry.h"

namespace python {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

/// An argument as an array of float or double, of which the last axis has `components` numbers. Raises a
/// ValueError that names the argument if it has not.
py::array vectors_of(const py::object& argument, py::ssize_t components, const char* name);
/// An argument likewise as an array of numbers, as vectors of one component.
py::array numbers_of(const py::object& argument);

/// The shape to which the axes before the last one are broadcast. Raises a ValueError if they cannot.
Shape common_shape(const std::vector<py::array>& arrays);
std::size_t size_of(const Shape& shape);
Shape with_axis(Shape shape, py::ssize_t size);

/// Returns an array as Python's callers expect: a number instead of one without axes.
py::object result_of(const py::array& array);

/// Reads the last axis of an array that was broadcast to a shape, row by row in the order of C. Rows may be
/// read without the interpreter's lock.
class RowReader {
 public:
  RowReader(const py::array& array, const Shape& shape);

  /// Reads rows of three numbers from a row on, as many as there is space for.
  void read(std::size_t first, std::span<reflectance::Vec3f> vectors) const;
  /// Reads the first number of a row.
  double number(std::size_t i) const;

 private:
  template <class Real>
  void read_as(std::size_t first, std::span<reflectance::Vec3f> vectors) const;
  const char* row(std::size_t i) const { return data_ + static_cast<py::ssize_t>(i) * stride_; }

  py::array rows_;  ///< keeps the data
  const char* data_;
  py::ssize_t stride_;
  py::ssize_t component_stride_;
  bool is_double_;
};

/// The first row of an argument that is wrong, as several threads find it.
class FirstWrongRow {
 public:
  void check(bool is_right, std::size_t i) {
    if (!is_right) note(i);
  }
  /// Checks that directions, the first of which is that of row `first`, are unit vectors.
  void check_units(std::span<const reflectance::Vec3f> directions, std::size_t first);

  /// Raises a ValueError if there is one: "wi[3] is not a unit vector".
  void raise(const char* argument, const char* what_is_wrong) const;

 private:
  void note(std::size_t i) {
    std::size_t first = first_;
    while (i < first && !first_.compare_exchange_weak(first, i)) {
    }
  }

  std::atomic<std::size_t> first_ = std::numeric_limits<std::size_t>::max();
};

/// Calls `work(begin, end)` for subranges of 0 to count - 1 on all cores, without the interpreter's lock.
template <class Work>
void for_each_range(std::size_t count, const Work& work) {
  const py::gil_scoped_release released;
  parallel::for_each_range(count, work);
}

/// Vectors of one argument, as many as fit into the processor's nearest cache.
using Block = std::array<reflectance::Vec3f, 256>;

/// Calls `work(first, count)` likewise for blocks of rows.
template <class Work>
void for_each_block(std::size_t count, const Work& work) {
  for_each_range(count, [&](std::size_t begin, std::size_t end) {
    constexpr std::size_t Size = std::tuple_size_v<Block>;
    for (std::size_t first = begin; first < end; first += Size) work(first, std::min(Size, end - first));
  });
}

}  // namespace python
