// The parts of the extension module `granada._granada`.
#pragma once

#include <pybind11/pybind11.h>

namespace python {

namespace py = pybind11;

void define_brdfs(py::module_& module);
void define_scenes(py::module_& module);
void define_renders(py::module_& module);

}  // namespace python
