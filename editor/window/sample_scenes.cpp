#include "editor/window/sample_scenes.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>
#include <map>

namespace editor {
namespace {

QString title_of(const QFileInfo& file) {
  QString title = file.completeBaseName().replace('_', ' ');
  if (!title.isEmpty()) title[0] = title[0].toUpper();
  return title;
}

/// Returns whether all files that a scene names are there: some are made by a script of the samples.
bool has_its_files(const QString& scene) {
  QFile file(scene);
  if (!file.open(QIODevice::ReadOnly)) return false;
  static const QRegularExpression names(R"re("([^"\n]+\.[A-Za-z]\w*)")re");
  const QString text = QString::fromUtf8(file.readAll());
  const QDir folder = QFileInfo(scene).dir();
  for (auto found = names.globalMatch(text); found.hasNext();) {
    if (!QFileInfo::exists(folder.filePath(found.next().captured(1)))) return false;
  }
  return true;
}

/// Scenes of one title are told apart by their folders.
void add_folders_where_needed(std::vector<SampleScene>& scenes) {
  std::map<QString, int> counts;
  for (const SampleScene& scene : scenes) ++counts[scene.title];
  for (SampleScene& scene : scenes) {
    if (counts[scene.title] > 1) scene.title += " (" + QFileInfo(scene.file).dir().dirName() + ')';
  }
}

}  // namespace

QString samples_folder() {
  return QDir::cleanPath(QCoreApplication::applicationDirPath() + "/../share/granada/samples");
}

std::vector<SampleScene> sample_scenes(const QString& folder) {
  std::vector<SampleScene> result;
  for (const QFileInfo& group : QDir(folder).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QDir files(group.filePath());
    for (const QFileInfo& picture : files.entryInfoList({"*.png"}, QDir::Files)) {
      const QString name = files.filePath(picture.completeBaseName());
      if (!QFileInfo::exists(name + ".op")) continue;
      for (const char* ending : {".grf", ".igrf"}) {
        if (!QFileInfo::exists(name + ending) || !has_its_files(name + ending)) continue;
        result.push_back({title_of(picture), name + ending, picture.filePath()});
        break;
      }
    }
  }
  add_folders_where_needed(result);
  std::ranges::sort(result, {}, &SampleScene::title);
  return result;
}

}  // namespace editor
