#include "editor/document/file_watch.h"

#include <QFileInfo>
#include <utility>

namespace editor {
namespace {

constexpr int QuietMilliseconds = 150;

}  // namespace

FileStamp FileStamp::of(const QString& file) {
  const QFileInfo info(file);
  return info.exists() ? FileStamp{info.size(), info.lastModified()} : FileStamp{};
}

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
  quiet_.setSingleShot(true);
  quiet_.setInterval(QuietMilliseconds);
  connect(&quiet_, &QTimer::timeout, this, &FileWatch::compare);
  const auto wait = [this] { quiet_.start(); };
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, wait);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, wait);
}

void FileWatch::follow(const QStringList& files) {
  const std::map<QString, FileStamp> before = std::exchange(files_, {});
  for (const QString& file : files) {
    const QString path = QFileInfo(file).absoluteFilePath();
    const auto known = before.find(path);
    files_.emplace(path, known == before.end() ? FileStamp::of(path) : known->second);
  }
  const QStringList watched = watcher_.files() + watcher_.directories();
  if (!watched.isEmpty()) watcher_.removePaths(watched);
  watch();
  quiet_.start();
}

/// A file that replaces another is detected in its folder, and must be watched again.
void FileWatch::watch() {
  QStringList paths;
  for (const auto& [file, stamp] : files_) paths << file << QFileInfo(file).absolutePath();
  paths.removeDuplicates();
  if (!paths.isEmpty()) watcher_.addPaths(paths);
}

void FileWatch::compare() {
  watch();
  QStringList others;
  for (auto& [file, stamp] : files_) {
    const FileStamp now = FileStamp::of(file);
    if (now != stamp) others.append(file);
    stamp = now;
  }
  if (!others.isEmpty()) emit changed(others);
}

}  // namespace editor
