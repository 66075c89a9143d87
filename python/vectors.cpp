#include "python/vectors.h"

#include <cmath>

#include <pybind11/stl.h>

namespace python {
namespace {

bool is_real(const py::array& array) {
  return py::isinstance<py::array_t<float>>(array) || py::isinstance<py::array_t<double>>(array);
}

/// Returns an argument as an array of float or double.
py::array real_array(const py::object& argument) {
  py::array array = py::array::ensure(argument);
  if (array && !is_real(array)) array = py::array_t<double>::ensure(argument);
  if (!array) {
    PyErr_Clear();
    throw py::type_error("expected an array of numbers");
  }
  // Neither aligned nor in the machine's byte order is what readers take.
  const bool is_plain =
      array.attr("flags").attr("aligned").cast<bool>() && array.dtype().attr("isnative").cast<bool>();
  return is_plain ? array : py::array(array.attr("astype")(py::dtype::of<double>()));
}

}  // namespace

py::array vectors_of(const py::object& argument, py::ssize_t components, const char* name) {
  py::array array = real_array(argument);
  if (array.ndim() > 0 && array.shape(array.ndim() - 1) == components) return array;
  throw py::value_error("the last axis of " + std::string(name) + " has to have " +
                        std::to_string(components) + " numbers; the shape is " +
                        py::str(array.attr("shape")).cast<std::string>());
}

py::array numbers_of(const py::object& argument) {
  const py::array array = real_array(argument);
  return array[py::make_tuple(py::ellipsis(), py::none())];
}

Shape common_shape(const std::vector<py::array>& arrays) {
  py::list shapes;
  for (const py::array& array : arrays) {
    py::list shape;
    for (py::ssize_t i = 0; i + 1 < array.ndim(); ++i) shape.append(array.shape(i));
    shapes.append(py::tuple(shape));
  }
  Shape common;
  for (const py::handle size : py::module_::import("numpy").attr("broadcast_shapes")(*shapes))
    common.push_back(size.cast<py::ssize_t>());
  return common;
}

std::size_t size_of(const Shape& shape) {
  std::size_t size = 1;
  for (const py::ssize_t side : shape) size *= static_cast<std::size_t>(side);
  return size;
}

Shape with_axis(Shape shape, py::ssize_t size) {
  shape.push_back(size);
  return shape;
}

py::object result_of(const py::array& array) { return array[py::tuple()]; }

// NumPy's `reshape` copies only what cannot be walked with one stride.
RowReader::RowReader(const py::array& array, const Shape& shape)
    : rows_(py::module_::import("numpy")
                .attr("broadcast_to")(array, with_axis(shape, array.shape(array.ndim() - 1)))
                .attr("reshape")(size_of(shape), array.shape(array.ndim() - 1))),
      data_(static_cast<const char*>(rows_.data())),
      stride_(rows_.strides(0)),
      component_stride_(rows_.strides(1)),
      is_double_(py::isinstance<py::array_t<double>>(rows_)) {}

template <class Real>
void RowReader::read_as(std::size_t first, std::span<reflectance::Vec3f> vectors) const {
  const auto number_at = [](const char* place) {
    return static_cast<float>(*reinterpret_cast<const Real*>(place));
  };
  constexpr auto Size = static_cast<py::ssize_t>(sizeof(Real));
  if (component_stride_ == Size && stride_ == 3 * Size) {
    // Numbers without gaps, which the compiler converts several at a time.
    const auto* numbers = reinterpret_cast<const Real*>(row(first));
    float* written = &vectors.front().x;
    for (std::size_t i = 0; i < 3 * vectors.size(); ++i) written[i] = static_cast<float>(numbers[i]);
    return;
  }
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const char* vector = row(first + i);
    vectors[i] = {number_at(vector), number_at(vector + component_stride_),
                  number_at(vector + 2 * component_stride_)};
  }
}

void RowReader::read(std::size_t first, std::span<reflectance::Vec3f> vectors) const {
  is_double_ ? read_as<double>(first, vectors) : read_as<float>(first, vectors);
}

double RowReader::number(std::size_t i) const {
  return is_double_ ? *reinterpret_cast<const double*>(row(i))
                    : double(*reinterpret_cast<const float*>(row(i)));
}

void FirstWrongRow::check_units(std::span<const reflectance::Vec3f> directions, std::size_t first) {
  constexpr float Tolerance = 2e-3F;  // of the square
  // False for NaN, too.
  const auto is_unit = [](const reflectance::Vec3f& v) { return std::abs(v.length2() - 1) < Tolerance; };
  bool are_units = true;
  for (const reflectance::Vec3f& direction : directions) are_units &= is_unit(direction);
  if (are_units) return;
  note(first + static_cast<std::size_t>(std::find_if_not(directions.begin(), directions.end(), is_unit) -
                                        directions.begin()));
}

void FirstWrongRow::raise(const char* argument, const char* what_is_wrong) const {
  if (first_ == std::numeric_limits<std::size_t>::max()) return;
  throw py::value_error(std::string(argument) + "[" + std::to_string(first_) + "] " + what_is_wrong);
}

}  // namespace python
