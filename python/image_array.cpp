#include "python/image_array.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

#include <pybind11/stl/filesystem.h>

#include "python/messages.h"

namespace python {
namespace {

using FloatArray = py::array_t<float, py::array::c_style | py::array::forcecast>;

py::array_t<float> read_image(const std::filesystem::path& path) {
  grf::Diagnostics diagnostics;
  std::optional<image::Image> image;
  {
    const py::gil_scoped_release released;
    image = image::read_image(path.string(), diagnostics);
  }
  if (!image) raise_error(diagnostics);
  return array_of(*image);
}

void write_image(const std::filesystem::path& path, const FloatArray& array, float exposure) {
  constexpr py::ssize_t LargestSide = std::numeric_limits<int>::max();
  if (array.ndim() != 3 || array.shape(2) != 3 || array.size() == 0 ||
      std::max(array.shape(0), array.shape(1)) > LargestSide)
    throw py::value_error("an image has the shape (height, width, 3)");
  image::ImageFile file;
  file.exposure = exposure;
  file.image.width = static_cast<int>(array.shape(1));
  file.image.height = static_cast<int>(array.shape(0));
  const auto* pixels = reinterpret_cast<const grf::Colour*>(array.data());
  file.image.pixels.assign(pixels, pixels + array.shape(0) * array.shape(1));
  grf::Diagnostics diagnostics;
  bool is_written = false;
  {
    const py::gil_scoped_release released;
    is_written = image::write_image(file, path.string(), diagnostics);
  }
  if (!is_written) raise_error(diagnostics);
}

}  // namespace

py::array_t<float> array_of(const image::Image& image) {
  const std::vector<py::ssize_t> shape = {image.height, image.width, 3};
  return py::array_t<float>(shape, &image.pixels.data()->x);
}

py::array_t<float> array_of(const image::ImageLayer& layer, int width, int height) {
  std::vector<py::ssize_t> shape = {height, width};
  if (layer.channel_count() > 1) shape.push_back(static_cast<py::ssize_t>(layer.channel_count()));
  return py::array_t<float>(shape, layer.values.data());
}

void define_images(py::module_& module) {
  module.def("read_image", &read_image, py::arg("path"),
             "Read an image as linear RGB of shape (height, width, 3), rows from the top: OpenEXR, Radiance, "
             "PFM, PNG, JPEG, TGA or WebP.");
  module.def("write_image", &write_image, py::arg("path"), py::arg("image"), py::arg("exposure") = 0.0F,
             "Write linear RGB of shape (height, width, 3) in the format of the name: exr, hdr and pfm store "
             "it, png, jpg and tga sRGB of 8 bits, with an exposure in stops.");
}

}  // namespace python
