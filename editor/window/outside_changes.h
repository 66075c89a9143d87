#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <map>

#include "editor/document/file_watch.h"

namespace editor {

class Document;

/// Detects which files of the document other programs have changed since they were read or saved: the scene's
/// own file, its includes, and its options.
class OutsideChanges : public QObject {
  Q_OBJECT

 public:
  OutsideChanges(const Document& document, QObject* parent);

  /// The files whose contents differ from what the document has read, without deleted ones.
  QStringList files() const;
  /// Whether the document has read or written the file.
  bool knows(const QString& file) const { return known_.contains(file); }
  /// Pauses reports while the document itself is written.
  void set_paused(bool is_paused) { is_paused_ = is_paused; }
  /// Accepts the current contents of these files: the document keeps its own.
  void ignore();

 signals:
  /// Emitted when a file has changed.
  void found(const QStringList& files);

 private:
  void follow();
  void compare();

  const Document& document_;
  FileWatch watch_;
  std::map<QString, FileStamp> known_;
  bool is_paused_ = false;
};

}  // namespace editor
