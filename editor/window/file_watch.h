#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <map>

namespace editor {

/// Which contents a file has, as far as can be told without reading it.
struct FileStamp {
  qint64 bytes = -1;  ///< -1: it does not exist
  QDateTime modified;

  static FileStamp of(const QString& file);
  bool operator==(const FileStamp&) const = default;
};

/// Tells that files are others than they were, once they are left alone for a moment: editors write a file in
/// parts, or put another one in its place.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent = nullptr);

  /// These, whether they exist or not, in place of those before. What has become of a file since it was first
  /// given is told even if it is given again.
  void follow(const QStringList& files);

 signals:
  /// A file has other contents, came to be, or is gone.
  void changed();

 private:
  void watch();
  void compare();

  QFileSystemWatcher watcher_;
  QTimer quiet_;
  std::map<QString, FileStamp> files_;
};

}  // namespace editor
