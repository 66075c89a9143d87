#include "editor/rendering/render_files.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include "editor/controls/text.h"
#include "editor/document/op_files.h"
#include "grf/relocate.h"
#include "grf/write.h"

namespace editor {

QString naming_path(const QString& scene_path) {
  return scene_path.isEmpty() ? QDir::current().filePath("Untitled.grf")
                              : QFileInfo(scene_path).absoluteFilePath();
}

// Included files are not overwritten: their edits are not saved yet.
bool write_snapshot(const grf::Scene& scene, const QString& scene_path, const QString& path,
                    grf::Diagnostics& diagnostics) {
  const std::string from = naming_path(scene_path).toStdString();
  grf::Scene snapshot = grf::flatten(scene, from);
  grf::relocate(snapshot, from, path.toStdString());
  return grf::write(snapshot, path.toStdString(), diagnostics);
}

QString write_snapshot_files(const grf::Scene& scene, const QString& scene_path,
                             const options::RenderOptions& render_options, const QString& base) {
  grf::Diagnostics diagnostics;
  const bool is_written = write_snapshot(scene, scene_path, base + ".grf", diagnostics) &&
                          write_op_file(render_options, base + ".op", diagnostics);
  return is_written ? QString() : text_of(diagnostics);
}

QString file_of_camera(const QString& file, const std::string& camera) {
  if (camera.empty()) return file;
  const QFileInfo info(file);
  QString name = QString::fromStdString(camera);
  name.replace(QRegularExpression("[^\\w -]"), "_");
  return info.dir().filePath(info.completeBaseName() + "_" + name + "." + info.suffix());
}

QString file_of_effect(const QString& file, const std::string& effect) {
  return file_of_camera(file, "effect_" + effect);
}

}  // namespace editor
