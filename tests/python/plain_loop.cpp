// The loop of `bpt brdf eval` over directions in memory, to compare times with.
#include <stdexcept>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "renderer/reflectance/brdf_instance.h"

namespace {

namespace py = pybind11;
using Array = py::array_t<float, py::array::c_style | py::array::forcecast>;
using reflectance::Rgb;
using reflectance::Vec3f;

class Loop {
 public:
  Loop(const std::string& text, const Array& wi, const Array& wo)
      : instance_(read(text)), v_(of(wi)), u_(of(wo)) {
    values_.resize(u_.size());
  }

  void run() {
    for (std::size_t i = 0; i < u_.size(); ++i) values_[i] = instance_.reflector.evaluate(u_[i], v_[i]);
  }

  py::array_t<float> values() {
    run();
    const std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(values_.size()), 3};
    return py::array_t<float>(shape, &values_.front().x);
  }

 private:
  static reflectance::SampledInstance read(const std::string& text) {
    grf::Diagnostics diagnostics;
    auto instance = reflectance::read_sampled_instance(text, "own", diagnostics);
    if (!instance) throw std::invalid_argument(diagnostics.to_text());
    return *std::move(instance);
  }
  static std::vector<Vec3f> of(const Array& array) {
    const auto* first = reinterpret_cast<const Vec3f*>(array.data());
    return {first, first + array.shape(0)};
  }

  reflectance::SampledInstance instance_;
  std::vector<Vec3f> v_, u_;
  std::vector<Rgb> values_;
};

}  // namespace

PYBIND11_MODULE(plain_loop, module) {
  py::class_<Loop>(module, "Loop")
      .def(py::init<const std::string&, const Array&, const Array&>())
      .def("run", &Loop::run)
      .def("values", &Loop::values);
}
