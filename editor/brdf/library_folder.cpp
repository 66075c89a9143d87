#include "editor/brdf/library_folder.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSaveFile>

#include "editor/brdf/brdf_library.h"
#include "editor/document/brdf_mime.h"
#include "grf/catalogue.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/write.h"
#include "renderer/reflectance/brdf.h"

namespace editor {

QString LibraryFolder::file_of(const QString& name) const { return QDir(path_).filePath(name + ".brdf"); }

std::vector<LibraryFile> LibraryFolder::files(std::vector<QString>& problems) const {
  std::vector<LibraryFile> found;
  if (path_.isEmpty()) return found;
  static const std::vector<grf::ModelInfo> infos = reflectance::brdf_infos();
  const QDir folder(path_);
  for (const QFileInfo& info : folder.entryInfoList({"*.brdf"}, QDir::Files, QDir::Name | QDir::IgnoreCase)) {
    grf::Diagnostics diagnostics;
    const std::string path = info.filePath().toStdString();
    const auto text = grf::read_file(path, diagnostics);
    const auto brdf = text ? grf::read_brdf(*text, path, diagnostics) : std::nullopt;
    if (brdf && grf::check(*brdf, infos, "BRDF", diagnostics)) {
      found.push_back({info.completeBaseName(), *brdf});
    } else if (!diagnostics.entries().empty()) {
      problems.push_back(QString("%1: %2").arg(
          info.fileName(), QString::fromStdString(diagnostics.entries().front().message)));
    }
  }
  return found;
}

QString LibraryFolder::free_name(const QString& name) const {
  QString clean = name.trimmed();
  clean.replace(QRegularExpression("[/\\\\:*?\"<>|\\x00-\\x1f]"), "-");
  while (clean.startsWith('.')) clean.remove(0, 1);
  if (clean.isEmpty()) clean = "brdf";
  QString free = clean;
  for (int i = 2; QFile::exists(file_of(free)); ++i) free = QString("%1 %2").arg(clean).arg(i);
  return free;
}

QString LibraryFolder::add(const QString& name, const grf::BrdfModel& brdf) const {
  if (path_.isEmpty()) return BrdfLibrary::tr("Choose a folder for the library first.");
  if (!brdf.terms.empty())
    return BrdfLibrary::tr("Cannot save a sum of BRDFs: it needs the definitions of its scene.");
  if (!QDir().mkpath(path_)) return BrdfLibrary::tr("Cannot create the folder '%1'.").arg(path_);
  QSaveFile file(file_of(name));
  const QByteArray text = QByteArray::fromStdString(grf::to_text(self_contained(brdf)) + "\n");
  const bool is_written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit();
  return is_written ? QString()
                    : BrdfLibrary::tr("Cannot write '%1': %2.").arg(file.fileName(), file.errorString());
}

QString LibraryFolder::rename(const QString& name, const QString& new_name) const {
  if (new_name == name) return {};
  const QString free = free_name(new_name);
  QFile file(file_of(name));
  if (file.rename(file_of(free))) return {};
  return BrdfLibrary::tr("Cannot rename '%1': %2.").arg(name, file.errorString());
}

QString LibraryFolder::remove(const QString& name) const {
  QFile file(file_of(name));
  if (file.moveToTrash()) return {};
  return BrdfLibrary::tr("Cannot move '%1' to the trash: %2.").arg(name, file.errorString());
}

}  // namespace editor
