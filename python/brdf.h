// A BRDF with its sampling scheme, over NumPy arrays.
#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "grf/model.h"
#include "python/vectors.h"
#include "renderer/reflectance/brdf_instance.h"

namespace python {

/// Samples of a BRDF, an array element each.
struct Samples {
  py::array_t<float> wi;
  py::array_t<float> weight;
  py::object pdf;
  py::object is_specular;
  py::object is_valid;
};

/// The class `granada.BRDF`. `wi` points towards the light (v in the sources), `wo` towards the eye (u).
class Brdf {
 public:
  /// Reads a BRDF and a scheme as `bpt brdf` does, without the interpreter's lock. Raises `granada.Error`.
  Brdf(const std::string& text, const std::string& scheme);

  py::object evaluate(const py::object& wi, const py::object& wo) const;
  py::object pdf(const py::object& wi, const py::object& wo) const;
  py::object specular_weight(const py::object& wo) const;
  Samples sample(const py::object& wo, const py::object& numbers) const;
  py::object albedo(const py::object& theta, const py::object& phi, int samples) const;

  std::string text() const;
  const std::string& keyword() const { return instance_.model.keyword; }
  const std::string& scheme() const { return scheme_; }

 private:
  static reflectance::SampledInstance read(const std::string& text, const std::string& scheme);

  std::string scheme_;
  reflectance::SampledInstance instance_;
};

}  // namespace python
