#include "python/messages.h"

#include <algorithm>
#include <string>
#include <vector>

namespace python {
namespace {

using grf::Diagnostic;
using grf::Severity;

constexpr const char* ErrorText =
    R"(Bad input, such as a file that cannot be read.

The message has each error and warning with its file, line and column, and the source line.

Attributes: message (of the first error, without its location), file, line and column (of the same; None
where unknown; lines and columns count from 1), diagnostics (all errors, warnings and notes).)";

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "";
}

py::object file_of(const Diagnostic& diagnostic) {
  if (!diagnostic.location.file) return py::none();
  return text_of(diagnostic.location.file->path);
}
py::object line_of(const Diagnostic& diagnostic) {
  return diagnostic.location.line > 0 ? py::object(py::int_(diagnostic.location.line)) : py::none();
}
/// A column without a line is an offset in a binary file, which the message has.
py::object column_of(const Diagnostic& diagnostic) {
  const bool is_known = diagnostic.location.line > 0 && diagnostic.location.column > 0;
  return is_known ? py::object(py::int_(diagnostic.location.column)) : py::none();
}

}  // namespace

void define_messages(py::module_& module) {
  py::class_<Diagnostic>(module, "Diagnostic", "An error, a warning or a note about a file.")
      .def_property_readonly(
          "severity", [](const Diagnostic& diagnostic) { return name_of(diagnostic.severity); },
          "'error', 'warning' or 'note'.")
      .def_property_readonly(
          "message", [](const Diagnostic& diagnostic) { return text_of(diagnostic.message); },
          "What is wrong, without the location.")
      .def_property_readonly("file", &file_of, "The path of the file, or None.")
      .def_property_readonly("line", &line_of, "The line, from 1, or None.")
      .def_property_readonly("column", &column_of, "The column in characters, from 1, or None.")
      .def("__str__", [](const Diagnostic& diagnostic) { return text_of(grf::to_text(diagnostic)); })
      .def("__repr__", [](const Diagnostic& diagnostic) {
        return py::str("<granada.Diagnostic {}: {}>")
            .format(name_of(diagnostic.severity), text_of(diagnostic.message));
      });
  const py::object error = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc("granada.Error", ErrorText, PyExc_Exception, nullptr));
  for (const char* name : {"message", "file", "line", "column"}) error.attr(name) = py::none();
  error.attr("diagnostics") = py::tuple();
  module.attr("Error") = error;
}

py::str text_of(const std::string& text) {
  PyObject* decoded = PyUnicode_DecodeFSDefaultAndSize(text.data(), static_cast<Py_ssize_t>(text.size()));
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

py::list entries_of(const grf::Diagnostics& diagnostics) {
  py::list entries;
  for (const Diagnostic& diagnostic : diagnostics.entries()) entries.append(diagnostic);
  return entries;
}

void raise_error(const grf::Diagnostics& diagnostics) {
  const py::object type = py::module_::import("granada._granada").attr("Error");
  std::string text = diagnostics.to_text();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const py::object error = type(text_of(text));
  error.attr("diagnostics") = entries_of(diagnostics);
  const std::vector<Diagnostic>& entries = diagnostics.entries();
  const auto first = std::find_if(entries.begin(), entries.end(), [](const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::Error;
  });
  if (first != entries.end()) {
    error.attr("message") = text_of(first->message);
    error.attr("file") = file_of(*first);
    error.attr("line") = line_of(*first);
    error.attr("column") = column_of(*first);
  }
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

}  // namespace python
