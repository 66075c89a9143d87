// The options of a render come from its file and from keyword arguments.
#pragma once

#include <optional>
#include <string>

#include <pybind11/pybind11.h>

#include "grf/diagnostics.h"
#include "renderer/options/render_options.h"

namespace python {

namespace py = pybind11;

/// Reads an OP file, or takes the default options for another file, and sets the options that arguments name.
/// Nothing after an error in the file; an error in an argument is a TypeError or a ValueError.
std::optional<options::RenderOptions> render_options_of(const std::string& path, const py::kwargs& arguments,
                                                        grf::Diagnostics& diagnostics);

}  // namespace python
