// Scenes of all formats, and their meshes as NumPy arrays.
#include "python/scene.h"

#include <limits>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "converters/input.h"
#include "converters/output.h"
#include "converters/risks/risk.h"
#include "converters/scene_building.h"
#include "grf/check.h"
#include "grf/read.h"
#include "grf/summary.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "python/messages.h"
#include "python/module.h"
#include "renderer/reflectance/scheme.h"

namespace python {
namespace {

using Path = std::filesystem::path;

/// Finds a format by its name; null for None.
const convert::Format* format_of(const std::optional<std::string>& name) {
  if (!name) return nullptr;
  const convert::Format* format = convert::find_format(*name);
  if (format != nullptr) return format;
  std::vector<std::string> names;
  for (const convert::Format& each : convert::formats()) names.emplace_back(each.name);
  const std::string advice = grf::did_you_mean(*name, names);
  throw py::value_error("there is no format '" + *name + "'" + (advice.empty() ? "" : ": " + advice));
}

/// Returns the format to write a file in.
const convert::Format& output_format(const std::string& path, const std::optional<std::string>& name) {
  const convert::Format* format = name ? format_of(name) : convert::format_of_name(path);
  if (format == nullptr) throw py::value_error("the format of '" + path + "' is unknown: give it by format=");
  if (format->write != nullptr) return *format;
  throw py::value_error("files of the format '" + std::string(format->name) + "' cannot be written");
}

std::optional<Scene> read(const std::string& path, const std::optional<std::string>& format,
                          const std::string& variant, grf::Diagnostics& diagnostics) {
  const convert::InputOptions options = {path, format_of(format), {std::nullopt, variant}};
  const py::gil_scoped_release released;
  auto input = convert::read_input(options, diagnostics);
  if (!input) return std::nullopt;
  return Scene{path, std::string(input->format->name), std::move(input->import), diagnostics};
}

Scene read_scene(const Path& path, const std::optional<std::string>& format, const std::string& variant) {
  grf::Diagnostics diagnostics;
  auto scene = read(path.string(), format, variant, diagnostics);
  if (!scene) raise_error(diagnostics);
  return *std::move(scene);
}

Scene read_text(const std::string& text, const Path& path) {
  grf::Diagnostics diagnostics;
  std::optional<grf::Scene> scene;
  {
    const py::gil_scoped_release released;
    scene = grf::read_text(text, path.string(), diagnostics);
    if (scene && !grf::check(*scene, reflectance::catalogue(), diagnostics)) scene.reset();
  }
  if (!scene) raise_error(diagnostics);
  return {path.string(), "grf", {*std::move(scene), {}, true, {}}, diagnostics};
}

py::list write(const Scene& scene, const Path& path, const std::optional<std::string>& format,
               const std::optional<Path>& op_file) {
  convert::OutputOptions options = {path.string(), nullptr, {op_file ? op_file->string() : ""}};
  options.format = &output_format(options.path, format);
  if (op_file && options.format->write_view == nullptr)
    throw py::value_error("files of the format '" + std::string(options.format->name) + "' have no view");
  grf::Diagnostics diagnostics;
  bool is_written = false;
  {
    const py::gil_scoped_release released;
    grf::Scene written = scene.import.scene;
    if (!scene.import.is_grf && options.format->name == "grf") convert::name_meshes(written, scene.path);
    is_written =
        convert::write_output(written, scene.import.files, scene.path, options, diagnostics).has_value();
  }
  if (!is_written) raise_error(diagnostics);
  return entries_of(diagnostics);
}

py::list convert_file(const Path& input, const Path& output, const std::optional<std::string>& from,
                      const std::optional<std::string>& to, const std::optional<Path>& op_file) {
  output_format(output.string(), to);  // before much is read
  const Scene scene = read_scene(input, from, "");
  py::list entries = entries_of(scene.diagnostics);
  for (const py::handle entry : write(scene, output, to, op_file)) entries.append(entry);
  return entries;
}

py::list risks_of(const grf::Scene& scene) {
  std::vector<convert::Risk> risks;
  {
    const py::gil_scoped_release released;
    risks = convert::risks_of(scene, reflectance::catalogue());
  }
  py::list list;
  for (const convert::Risk& risk : risks) {
    py::dict facts;
    facts["kind"] = convert::info_of(risk.kind).name;
    facts["message"] = text_of(risk.message);
    facts["advice"] = convert::info_of(risk.kind).advice;
    facts["share"] = risk.share;
    facts["faces"] =
        py::array_t<std::uint32_t>(static_cast<py::ssize_t>(risk.faces.size()), risk.faces.data());
    facts["line"] = risk.location.line > 0 ? py::object(py::int_(risk.location.line)) : py::none();
    list.append(facts);
  }
  return list;
}

Report check(const Path& path, const std::optional<std::string>& format, bool deep) {
  grf::Diagnostics diagnostics;
  const auto scene = read(path.string(), format, "", diagnostics);
  return {scene.has_value(), entries_of(diagnostics),
          scene && deep ? risks_of(scene->import.scene) : py::list()};
}

py::dict summary_of(const Scene& scene) {
  grf::Summary summary;
  {
    const py::gil_scoped_release released;
    summary = grf::summarize(scene.import.scene);
  }
  py::dict facts;
  facts["meshes"] = summary.meshes;
  facts["vertices"] = summary.vertices;
  facts["faces"] = summary.faces;
  facts["triangles"] = summary.triangles;
  facts["instances"] = summary.instances;
  facts["lights"] = summary.lights;
  facts["brdfs"] = summary.brdfs;
  facts["pdfs"] = summary.pdfs;
  facts["textures"] = summary.textures;
  facts["area"] = summary.area;
  facts["boundary_edges"] = summary.boundary_edges;
  facts["boundary_loops"] = summary.boundary_loops;
  facts["nonmanifold_edges"] = summary.nonmanifold_edges;
  facts["nonmanifold_vertices"] = summary.nonmanifold_vertices;
  facts["bounds"] = py::none();
  const grf::Box3f& bounds = summary.bounds;
  if (!bounds.isEmpty())
    facts["bounds"] =
        py::make_tuple(py::array_t<float>(3, &bounds.min.x), py::array_t<float>(3, &bounds.max.x));
  return facts;
}

constexpr const char* WriteText =
    R"(Write the scene in the format of the name, or in `format`, and return what was lost as diagnostics.

op_file is an OP file with the view, for formats that have one (pbrt, Mitsuba). Raises granada.Error, and
leaves the file unchanged, if it cannot be written.)";

constexpr const char* ReadText =
    R"(Read a scene in any format that grfconvert reads, and check it.

The format is detected unless it is given; variant is that of a glTF file's materials. Raises granada.Error
if the file cannot be read, or if the scene has an error. Files from strangers are read in this process;
`grfconvert` reads each in a process of its own.)";

constexpr const char* CheckText =
    R"(Check a file and return a Report; errors in it are not raised.

With deep=True also look for risks: what can make images of a valid scene wrong or noisy.)";

}  // namespace

void define_scenes(py::module_& module) {
  define_meshes(module);
  py::class_<Report>(module, "Report", "What `check` finds in a file.")
      .def_readonly("valid", &Report::is_valid,
                    "Whether the file could be read, and its scene has no errors.")
      .def_readonly("diagnostics", &Report::diagnostics, "Errors, warnings and notes.")
      .def_readonly(
          "risks", &Report::risks,
          "What can make images wrong or noisy, as dicts, the worst first; empty without deep=True.")
      .def("__bool__", [](const Report& report) { return report.is_valid; });
  py::class_<Scene>(module, "Scene", "A scene as it was read from a file.")
      .def_property_readonly(
          "path", [](const Scene& scene) { return text_of(scene.path); },
          "The file that it was read from: its file names are relative to it.")
      .def_readonly("format", &Scene::format, "The name of its format, such as 'grf' or 'obj'.")
      .def_property_readonly(
          "diagnostics", [](const Scene& scene) { return entries_of(scene.diagnostics); },
          "Warnings and notes of reading.")
      .def_property_readonly(
          "text", [](const Scene& scene) { return grf::to_text(scene.import.scene); },
          "The scene as GRF text. Included files are only named in it.")
      .def_property_readonly("meshes", &meshes_of,
                             "The meshes in the order of the file, one for each place of an instance.")
      .def("summary", &summary_of,
           "Return counts, the area in world units and the bounds, as `grfconvert info` prints them.")
      .def("write", &write, py::arg("path"), py::arg("format") = py::none(), py::arg("op_file") = py::none(),
           WriteText)
      .def("__repr__",
           [](const Scene& scene) { return py::str("<granada.Scene {!r}>").format(text_of(scene.path)); });
  module.def("read", &read_scene, py::arg("path"), py::arg("format") = py::none(), py::arg("variant") = "",
             ReadText);
  module.def("read_text", &read_text, py::arg("text"), py::arg("path") = Path("text.grf"),
             "Read a scene from GRF text; file names in it are relative to the folder of `path`.");
  module.def("convert", &convert_file, py::arg("input"), py::arg("output"),
             py::arg("from_format") = py::none(), py::arg("to_format") = py::none(),
             py::arg("op_file") = py::none(),
             "Convert a file, and return warnings and losses as diagnostics. Raises granada.Error.");
  module.def("check", &check, py::arg("path"), py::arg("format") = py::none(), py::arg("deep") = false,
             CheckText);
}

}  // namespace python
