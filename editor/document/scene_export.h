// A scene is exported to another format, and the losses are known before.
#pragma once

#include <QString>
#include <vector>

#include "editor/document/import_folder.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/options/render_options.h"

namespace convert {
struct Format;
}

namespace editor {

class Document;

/// A snapshot of a scene to be exported, which any thread may write.
struct ExportRequest {
  grf::Scene scene;
  QString from;           ///< the file to which the scene's file names are relative; empty if there is none
  ImportFolders imports;  ///< keeps the images of imported models
  QString path;           ///< of the file to be written
  const convert::Format* format = nullptr;
  bool is_grf2008 = false;  ///< write GRF in its grammar of 2008, without extensions
  /// The camera, film and environment map, with absolute paths, for formats with a view.
  options::RenderOptions view;
};

/// A snapshot of a document, without path and format.
ExportRequest export_request(const Document& document);

/// The formats that can be written, in the order of convert::formats().
std::vector<const convert::Format*> export_formats();

/// Writes the file. Returns the diagnostics, with losses and errors.
grf::Diagnostics write(const ExportRequest& request);

/// Writes the file to a temporary folder. Returns the diagnostics that `write` would return.
grf::Diagnostics try_to_write(ExportRequest request);

}  // namespace editor
