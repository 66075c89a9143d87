#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <map>

#include "editor/window/file_watch.h"

namespace editor {

class Document;

/// Knows which files of the document another program has changed since they were read or saved: the scene's
/// own, those that it includes, and its options.
class OutsideChanges : public QObject {
  Q_OBJECT

 public:
  OutsideChanges(const Document& document, QObject* parent);

  /// The files that hold now what the document has not read. Those that are gone are none of them.
  QStringList files() const;
  /// Whether the document has read or written the file.
  bool knows(const QString& file) const { return known_.contains(file); }
  /// While the document itself is written nothing is said.
  void set_paused(bool is_paused) { is_paused_ = is_paused; }
  /// Counts what these files hold as known: the author keeps what the document has.
  void ignore();

 signals:
  /// Another file has changed, or a file has changed again.
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
