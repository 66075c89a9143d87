#include "editor/document/save.h"

#include <utility>

#include "editor/document/image_files.h"
#include "editor/document/op_files.h"
#include "editor/document/scene_places.h"
#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace editor {
namespace {

void collect(const grf::BlockList& list, const std::string& path, bool only_changed, QStringList& files) {
  for_each_include(list, [&](const grf::Include& include) {
    const std::string file = grf::canonical_path(grf::path_beside(path, include.file));
    const bool is_as_read = include.origin.path == file && include.origin.contents == include.contents;
    if (!only_changed || !is_as_read) files.append(QString::fromStdString(file));
    collect(*include.contents, file, only_changed, files);
  });
}

}  // namespace

SaveResult write(SaveRequest request) {
  SaveResult result;
  grf::Diagnostics& diagnostics = result.diagnostics;
  const std::string path = request.path.toStdString();
  result.copied = copy_images(request.scene, request.from, request.imports, path, diagnostics);
  if (diagnostics.error_count() == 0) {
    grf::Scene scene = request.scene;
    grf::relocate(scene, request.from, path, result.copied);
    result.is_done = grf::write(scene, path, diagnostics);
  }
  if (result.is_done && request.options) {
    auto text = OpDocument::write_beside(*request.options, request.path, diagnostics);
    result.is_done = text.has_value();
    if (text) result.options = std::move(*text);
  }
  if (result.is_done) {
    result.is_done = write_editor_state(request.state, *request.objects, request.path, diagnostics);
  }
  result.request = std::move(request);
  return result;
}

QStringList included_paths(const grf::BlockList& blocks, const std::string& path, bool only_changed) {
  QStringList files;
  collect(blocks, path, only_changed, files);
  files.removeDuplicates();
  return files;
}

QStringList files_beside(const SaveRequest& request) {
  QStringList files;
  if (request.options) files.append(op_file_beside(request.path));
  return files + included_paths(request.scene.contents, request.from, true);
}

}  // namespace editor
