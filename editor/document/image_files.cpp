#include "editor/document/image_files.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <set>
#include <string_view>
#include <variant>

#include "grf/text_file.h"
#include "grf/visit.h"
#include "renderer/image/image_file.h"

namespace editor {
namespace {

/// Adds the images of a BRDF's parameters. Those of a BRDF file are beside it and not beside the scene.
void add_maps(const grf::BrdfModel& brdf, std::set<std::string>& names) {
  if (!brdf.instance_file.empty()) return;
  for (const grf::Argument& argument : brdf.arguments) {
    if (argument.map) names.insert(argument.map->file);
  }
}

/// Names of image files as the scene's own file writes them.
std::set<std::string> image_names(const grf::Scene& scene, const std::string& path) {
  std::set<std::string> names;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    if (placement.file != path) return;
    for (const grf::Surface& surface : mesh.surfaces) {
      const auto* texture = surface.texture ? std::get_if<grf::Texture>(&*surface.texture) : nullptr;
      if (texture != nullptr) names.insert(texture->file);
      const auto* brdf = surface.brdf ? std::get_if<grf::BrdfModel>(&*surface.brdf) : nullptr;
      if (brdf != nullptr) add_maps(*brdf, names);
    }
  };
  visitor.definition = [&](const grf::Definition& definition, const grf::Placement& placement) {
    if (placement.file != path) return;
    if (const auto* texture = std::get_if<grf::Texture>(&definition.body)) names.insert(texture->file);
    if (const auto* brdf = std::get_if<grf::BrdfModel>(&definition.body)) add_maps(*brdf, names);
  };
  grf::visit(scene, visitor, path);
  return names;
}

bool have_same_bytes(const QString& a, const QString& b) {
  QFile first(a);
  QFile second(b);
  return first.open(QIODevice::ReadOnly) && second.open(QIODevice::ReadOnly) &&
         first.size() == second.size() && first.readAll() == second.readAll();
}

/// Copies a file and returns its new name; empty after an error.
QString copied(const QString& file, const QDir& folder) {
  const QFileInfo info(file);
  for (int number = 1;; ++number) {
    QString name = number == 1
                       ? info.fileName()
                       : QString("%1_%2.%3").arg(info.completeBaseName()).arg(number).arg(info.suffix());
    const QString path = folder.filePath(name);
    if (!QFile::exists(path)) return QFile::copy(file, path) ? name : QString();
    if (have_same_bytes(file, path)) return name;
  }
}

}  // namespace

std::map<std::string, std::string> copy_images(const grf::Scene& scene, const std::string& from,
                                               const ImportFolders& folders, const std::string& to,
                                               grf::Diagnostics& diagnostics) {
  std::map<std::string, std::string> names;
  if (folders.empty()) return names;
  const QDir destination = QFileInfo(QString::fromStdString(to)).dir();
  for (const std::string& name : image_names(scene, from)) {
    const QFileInfo file(QString::fromStdString(grf::path_beside(from, name)));
    const bool is_ours = std::ranges::any_of(folders, [&](const auto& folder) {
      return QFileInfo(folder->path()).canonicalFilePath() == file.canonicalPath();
    });
    if (!is_ours) continue;
    const QString copy = copied(file.filePath(), destination);
    if (copy.isEmpty()) {
      diagnostics.error(grf::whole_file(to),
                        "cannot copy the image " + file.filePath().toStdString() + " to the scene's folder");
    } else {
      names[name] = copy.toStdString();
    }
  }
  return names;
}

bool is_copied(const ImportFolder& folder, const std::string& from,
               const std::map<std::string, std::string>& copied) {
  std::set<std::string> originals;
  for (const auto& [name, copy] : copied) originals.insert(grf::canonical_path(grf::path_beside(from, name)));
  const QStringList images = QDir(folder.path()).entryList(QDir::Files);
  return std::ranges::all_of(images, [&](const QString& image) {
    return originals.contains(grf::canonical_path((folder.path() + "/" + image).toStdString()));
  });
}

bool is_image(const QString& file) {
  return std::ranges::any_of(image::ReadableExtensions, [&](std::string_view extension) {
    return image::has_extension(file.toStdString(), extension);
  });
}

}  // namespace editor
