// Images as NumPy arrays.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "renderer/image/image_file.h"

namespace python {

namespace py = pybind11;

/// Returns linear RGB of shape (height, width, 3), rows from the top.
py::array_t<float> array_of(const image::Image& image);

/// Returns a layer of shape (height, width, channels), or (height, width) for one channel.
py::array_t<float> array_of(const image::ImageLayer& layer, int width, int height);

/// Adds `read_image` and `write_image` to the module.
void define_images(py::module_& module);

}  // namespace python
