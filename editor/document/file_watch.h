#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <map>

namespace editor {

/// Identifies the contents of a file by its metadata.
struct FileStamp {
  qint64 bytes = -1;  ///< -1 if it does not exist
  QDateTime modified;

  static FileStamp of(const QString& file);
  bool operator==(const FileStamp&) const = default;
};

/// Detects changed files after a short delay, since editors write a file in parts or replace it.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent = nullptr);

  /// Watches these files, existing or not, instead of the former ones. A change since a file was first
  /// watched is reported even if it is passed again.
  void follow(const QStringList& files);

 signals:
  /// Emitted with the absolute paths of files that were modified, created or deleted.
  void changed(const QStringList& files);

 private:
  void watch();
  void compare();

  QFileSystemWatcher watcher_;
  QTimer quiet_;
  std::map<QString, FileStamp> files_;
};

}  // namespace editor
