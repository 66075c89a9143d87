#include "editor/document/recovery.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUuid>
#include <QtConcurrent>
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/save.h"
#include "editor/document/scene_places.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace editor {
namespace {

const QString SceneFile = QStringLiteral("scene.grf");
const QString RecordFile = QStringLiteral("work.json");
const QString LockFile = QStringLiteral("lock");

/// Converts the references of a file's blocks to another file.
grf::BlockList moved(const grf::BlockList& list, const std::string& from, const std::string& to) {
  grf::Scene scene = {list};
  grf::relocate(scene, from, to);
  return std::move(scene.contents);
}

/// Copies a scene with all its included files into one folder, under new names, since the user's files must
/// not be overwritten.
class Packing {
 public:
  explicit Packing(std::string folder) : folder_(std::move(folder)) {}

  grf::Scene pack(const grf::Scene& scene, const std::string& path) {
    return {packed(scene.contents, path, folder_ + "/" + SceneFile.toStdString())};
  }
  /// The original names of included files, by their numbers.
  const QJsonArray& names() const { return names_; }

 private:
  grf::BlockList packed(const grf::BlockList& list, const std::string& path, const std::string& to) {
    std::vector<std::string> files;
    for_each_include(list, [&](const grf::Include& include) { files.push_back(include.file); });
    grf::BlockList result = moved(list, path, to);
    std::size_t number = 0;
    for_each_include(result, [&](grf::Include& include) {
      const std::string file = files[number++];
      const std::string name = "include_" + std::to_string(names_.size()) + ".grf";
      names_.append(QString::fromStdString(file));
      const grf::BlockList contents = *include.contents;
      include.file = name;
      include.contents = packed(contents, grf::path_beside(path, file), folder_ + "/" + name);
      include.origin = {};
    });
    return result;
  }

  std::string folder_;
  QJsonArray names_;
};

/// The inverse. Included files get their names back; whether they were changed is found by comparing
/// contents.
class Unpacking {
 public:
  Unpacking(std::string folder, const QJsonArray& names) : folder_(std::move(folder)), names_(names) {}

  grf::Scene unpack(const grf::Scene& scene, const std::string& path) {
    return {unpacked(scene.contents, folder_ + "/" + SceneFile.toStdString(), path)};
  }

 private:
  grf::BlockList unpacked(const grf::BlockList& list, const std::string& from, const std::string& path) {
    grf::BlockList result = moved(list, from, path);
    for_each_include(result, [&](grf::Include& include) {
      const std::string name = "include_" + std::to_string(next_) + ".grf";
      const std::string file = names_[next_++].toString().toStdString();
      const grf::BlockList contents = *include.contents;
      include.file = file;
      include.contents = unpacked(contents, folder_ + "/" + name, grf::path_beside(path, file));
      include.origin = {};
    });
    return result;
  }

  std::string folder_;
  const QJsonArray& names_;
  int next_ = 0;
};

QJsonObject record_in(const QString& folder) {
  QFile file(folder + "/" + RecordFile);
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QJsonDocument::fromJson(file.readAll()).object();
}

bool write_record(const QString& folder, const QJsonObject& record) {
  QSaveFile file(folder + "/" + RecordFile);
  if (!file.open(QIODevice::WriteOnly)) return false;
  file.write(QJsonDocument(record).toJson());
  return file.commit();
}

/// Returns an error message, or nothing. The scene is written before the record: a session without a record
/// has no autosave.
QString write_work(const QString& folder, const SaveRequest& work) {
  const QString path = work.path;
  Packing packing(folder.toStdString());
  const grf::Scene packed = packing.pack(work.scene, path.toStdString());
  const QString scene_file = folder + "/" + SceneFile;
  grf::Diagnostics diagnostics;
  if (!grf::write(packed, scene_file.toStdString(), diagnostics) ||
      !write_editor_state(work.state, *work.objects, scene_file, diagnostics)) {
    return QString::fromStdString(diagnostics.to_text());
  }
  QJsonArray folders;
  for (const auto& import : work.imports) folders.append(import->path());
  const QJsonObject record = {{"path", path},
                              {"imports", folders},
                              {"saved", QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs)},
                              {"includes", packing.names()}};
  return write_record(folder, record) ? QString() : Recovery::tr("Cannot write the folder %1.").arg(folder);
}

/// Includes by file path. The same text is parsed differently where other names are in scope.
using IncludesOfFiles = std::map<std::string, std::vector<grf::Include>>;

const grf::Include* find_alike(const IncludesOfFiles& includes, const std::string& file,
                               const grf::BlockList& contents) {
  const auto of_file = includes.find(file);
  if (of_file == includes.end()) return nullptr;
  const auto alike = std::ranges::find_if(
      of_file->second, [&](const grf::Include& other) { return *other.contents == contents; });
  return alike == of_file->second.end() ? nullptr : &*alike;
}

/// Marks included files that equal those on disk as unchanged, so that saving does not rewrite them.
void take_origins(grf::BlockList& list, const std::string& path, const IncludesOfFiles& on_disk) {
  for_each_include(list, [&](grf::Include& include) {
    const std::string file = grf::path_beside(path, include.file);
    if (const grf::Include* alike = find_alike(on_disk, file, *include.contents)) {
      include.contents = alike->contents;
      include.origin = alike->origin;
    } else {
      take_origins(include.contents.edit(), file, on_disk);
    }
  });
}

void collect(const grf::BlockList& list, const std::string& path, IncludesOfFiles& includes) {
  for_each_include(list, [&](const grf::Include& include) {
    const std::string file = grf::path_beside(path, include.file);
    if (find_alike(includes, file, *include.contents) != nullptr) return;
    includes[file].push_back(include);
    collect(*include.contents, file, includes);
  });
}

}  // namespace

Recovery::Recovery(Document& document, const QString& sessions, int delay, QObject* parent)
    : QObject(parent),
      document_(document),
      sessions_(sessions),
      folder_(sessions + "/" + QUuid::createUuid().toString(QUuid::WithoutBraces)) {
  timer_.setSingleShot(true);
  timer_.setInterval(delay);
  connect(&timer_, &QTimer::timeout, this, &Recovery::keep);
  connect(&writing_, &QFutureWatcher<QString>::finished, this, [this] {
    const QString problem = writing_.result();
    if (!document_.is_modified()) discard_own();  // it was saved meanwhile
    if (!problem.isEmpty()) return emit failed(problem);
    emit kept();
  });
  connect(&document_, &Document::changed, this, [this] {
    // The timer is not restarted at each change, which would postpone the autosave for ever.
    if (document_.is_modified() && !timer_.isActive()) timer_.start();
  });
  connect(&document_, &Document::editor_state_changed, this, [this] {
    if (document_.is_modified() && !timer_.isActive()) timer_.start();
  });
  connect(&document_, &Document::modified_changed, this, [this](bool is_modified) {
    if (is_modified && !timer_.isActive()) timer_.start();
    if (!is_modified) discard_own();
  });
}

Recovery::~Recovery() {
  timer_.stop();
  writing_.waitForFinished();
  remove_own();
}

QString Recovery::default_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery";
}

std::vector<LostWork> Recovery::lost_work() const {
  std::vector<LostWork> lost;
  for (const QString& name : QDir(sessions_).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString folder = sessions_ + "/" + name;
    const QJsonObject record = record_in(folder);
    if (folder == folder_ || record.isEmpty()) continue;
    QLockFile lock(folder + "/" + LockFile);
    if (!take_lock(lock)) continue;
    lost.push_back({folder, record["path"].toString(),
                    QDateTime::fromString(record["saved"].toString(), Qt::ISODateWithMs),
                    record["imports"].toVariant().toStringList()});
  }
  std::ranges::sort(lost, [](const LostWork& a, const LostWork& b) { return a.saved > b.saved; });
  return lost;
}

std::optional<grf::Scene> Recovery::read(const LostWork& work, grf::Diagnostics& diagnostics) {
  const auto scene = grf::read((work.folder + "/" + SceneFile).toStdString(), diagnostics);
  if (!scene) return std::nullopt;
  const QJsonArray names = record_in(work.folder)["includes"].toArray();
  const std::string path = work.path.toStdString();
  grf::Scene result = Unpacking(work.folder.toStdString(), names).unpack(*scene, path);
  grf::Diagnostics ignored_diagnostics;
  if (const auto on_disk = path.empty() ? std::nullopt : grf::read(path, ignored_diagnostics)) {
    IncludesOfFiles includes;
    collect(on_disk->contents, path, includes);
    take_origins(result.contents, path, includes);
  }
  return result;
}

EditorState Recovery::read_state(const LostWork& work, const SceneObjects& objects,
                                 grf::Diagnostics& diagnostics) {
  return read_editor_state(work.folder + "/" + SceneFile, objects, diagnostics);
}

void Recovery::discard(const LostWork& work) { QDir(work.folder).removeRecursively(); }

// Changes made during an autosave are autosaved next.
void Recovery::keep() {
  timer_.stop();
  if (!document_.is_modified()) return;
  if (writing_.isRunning()) return timer_.start();
  if (!QDir().mkpath(folder_)) return emit failed(tr("Cannot create the folder %1.").arg(folder_));
  if (!lock_) {
    lock_.emplace(folder_ + "/" + LockFile);
    take_lock(*lock_);
  }
  SaveRequest work;
  work.scene = document_.scene();
  work.path = document_.path();
  work.imports = document_.imports();
  work.state = document_.editor_state();
  work.objects = document_.shared_objects();
  writing_.setFuture(QtConcurrent::run(write_work, folder_, work));
}

void Recovery::discard_own() {
  timer_.stop();
  if (!writing_.isRunning()) remove_own();  // else after writing, so that the window does not wait
}

void Recovery::remove_own() {
  lock_.reset();
  if (QDir(folder_).exists()) QDir(folder_).removeRecursively();
}

}  // namespace editor
