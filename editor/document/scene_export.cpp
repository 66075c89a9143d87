#include "editor/document/scene_export.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <optional>

#include "converters/format.h"
#include "converters/grf2008.h"
#include "editor/document/document.h"
#include "grf/relocate.h"

namespace editor {

ExportRequest export_request(const Document& document) {
  return {document.scene(), document.path(), document.imports(), {}, nullptr, false};
}

std::vector<const convert::Format*> export_formats() {
  std::vector<const convert::Format*> formats;
  for (const convert::Format& format : convert::formats()) {
    if (format.write != nullptr) formats.push_back(&format);
  }
  return formats;
}

grf::Diagnostics write(const ExportRequest& request) {
  grf::Diagnostics diagnostics;
  const std::string path = request.path.toStdString();
  std::optional<grf::Scene> scene = moved(request.scene, request.from, request.path);
  // A file of GRF is written whole: files that it includes are not to be changed by an export.
  if (request.format->name == "grf") scene = grf::flatten(*scene, path);
  if (request.is_grf2008) scene = convert::to_grf2008(*scene, path, diagnostics);
  if (scene) static_cast<void>(request.format->write(*scene, path, diagnostics));
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
