// Diagnostics become objects and exceptions of Python.
#pragma once

#include <string>

#include <pybind11/pybind11.h>

#include "grf/diagnostics.h"

namespace python {

namespace py = pybind11;

/// Adds `Diagnostic` and the exception `Error` to the module.
void define_messages(py::module_& module);

/// Returns text in UTF-8 as a string. Paths may have other bytes, which are kept as by Python's
/// `os.fsdecode`.
py::str text_of(const std::string& text);

/// Returns a list of `granada.Diagnostic`.
py::list entries_of(const grf::Diagnostics& diagnostics);

/// Raises `granada.Error` with all entries, at the location of the first error.
[[noreturn]] void raise_error(const grf::Diagnostics& diagnostics);

}  // namespace python
