// Work that was not saved, kept on disk so that a crash loses none of it.
#pragma once

#include <QDateTime>
#include <QFutureWatcher>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <optional>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

class Document;

/// What a session that ended without being closed had not saved.
struct LostWork {
  QString folder;       ///< where it is kept
  QString path;         ///< of the scene that was edited; empty: it was never saved
  QDateTime saved;      ///< when it was kept last
  QStringList imports;  ///< folders of images that its scene names
};

/// Keeps the unsaved work of a document: a few seconds after a change it is written to a folder of this
/// session. The folder is gone once there is nothing unsaved, or the session ends as it should.
class Recovery : public QObject {
  Q_OBJECT

 public:
  /// The folder of all sessions, and how long after a change the work is written, in milliseconds.
  Recovery(Document& document, const QString& sessions, int delay = 3000, QObject* parent = nullptr);
  ~Recovery() override;

  /// Where sessions keep their work if nobody says otherwise.
  static QString default_folder();

  /// What sessions left that are no more; the latest first.
  std::vector<LostWork> lost_work() const;
  /// The scene of one, to be taken as that of its path. Nothing after an error.
  static std::optional<grf::Scene> read(const LostWork& work, grf::Diagnostics& diagnostics);
  static void discard(const LostWork& work);

  /// Writes what is unsaved, in a thread.
  void keep();

 signals:
  void kept();
  /// Work could not be kept: the disk is full, or the folder cannot be written.
  void failed(const QString& message);

 private:
  void discard_own();
  void remove_own();

  Document& document_;
  const QString sessions_;
  const QString folder_;
  std::optional<QLockFile> lock_;  ///< held while this session lives
  QFutureWatcher<QString> writing_;
  QTimer timer_;
};

}  // namespace editor
