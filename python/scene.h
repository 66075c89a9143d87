// The class `granada.Scene`.
#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "converters/format.h"
#include "grf/diagnostics.h"

namespace python {

namespace py = pybind11;

/// A scene and where it came from.
struct Scene {
  std::string path;
  std::string format;
  convert::Import import;
  grf::Diagnostics diagnostics;  ///< of reading
};

/// What `granada.check` finds.
struct Report {
  bool is_valid = false;
  py::list diagnostics;
  py::list risks;
};

/// Adds `Mesh` and `Surface` to the module.
void define_meshes(py::module_& module);

/// Returns a list of `granada.Mesh`, one for each place.
py::list meshes_of(const Scene& scene);

}  // namespace python
