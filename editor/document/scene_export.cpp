#include "editor/document/scene_export.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <optional>

#include "converters/format.h"
#include "converters/grf2008.h"
#include "editor/document/document.h"
#include "editor/document/op_files.h"
#include "grf/relocate.h"

namespace editor {

ExportRequest export_request(const Document& document) {
  return {document.scene(),
          document.path(),
          document.imports(),
          {},
          nullptr,
          false,
          document.options().valid_options()};
}

std::vector<const convert::Format*> export_formats() {
  std::vector<const convert::Format*> formats;
  for (const convert::Format& format : convert::formats()) {
    if (format.write != nullptr) formats.push_back(&format);
  }
  return formats;
}

namespace {

/// Writes a scene with its view, which a format takes as an OP file.
void write_view(const grf::Scene& scene, const ExportRequest& request, grf::Diagnostics& diagnostics) {
  const QTemporaryDir folder;
  if (!folder.isValid()) return diagnostics.error({}, folder.errorString().toStdString());
  const QString op_file = folder.filePath("view.op");
  options::RenderOptions view = request.view;
  view.scene = request.path.toStdString();
  if (!write_op_file(view, op_file, diagnostics)) return;
  request.format->write_view(scene, request.path.toStdString(), {op_file.toStdString()}, diagnostics);
}

}  // namespace

grf::Diagnostics write(const ExportRequest& request) {
  grf::Diagnostics diagnostics;
  const std::string path = request.path.toStdString();
  std::optional<grf::Scene> scene = moved(request.scene, request.from, request.path);
  // A file of GRF is written whole: files that it includes are not to be changed by an export.
  if (request.format->name == "grf") scene = grf::flatten(*scene, path);
  if (request.is_grf2008) scene = convert::to_grf2008(*scene, path, diagnostics);
  if (!scene) return diagnostics;
  if (request.format->write_view != nullptr) {
    write_view(*scene, request, diagnostics);
  } else {
    request.format->write(*scene, path, diagnostics);
  }
  return diagnostics;
}

grf::Diagnostics try_to_write(ExportRequest request) {
  const QTemporaryDir folder;
  if (!folder.isValid()) {
    grf::Diagnostics diagnostics;
    diagnostics.error({}, folder.errorString().toStdString());
    return diagnostics;
  }
  const std::string_view extension = request.format->extensions.front();
  request.path =
      folder.filePath("scene." + QString::fromUtf8(extension.data(), static_cast<int>(extension.size())));
  return write(request);
}

}  // namespace editor
