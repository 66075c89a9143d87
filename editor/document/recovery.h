// Autosave keeps unsaved work, so that it can be recovered after a crash.
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

#include "editor/document/editor_state.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace editor {

class Document;

/// The unsaved work of a session that was not closed properly.
struct LostWork {
  QString folder;       ///< folder of the autosave
  QString path;         ///< of the edited scene; empty if it was never saved
  QDateTime saved;      ///< time of the last autosave
  QStringList imports;  ///< folders with images of its scene
};

/// Autosaves a document: a few seconds after a change it is written to a folder of this session. The folder
/// is removed when nothing is unsaved, or the session is closed properly.
class Recovery : public QObject {
  Q_OBJECT

 public:
  /// `sessions` is the folder of all sessions; `delay` is the time from a change to its autosave, in
  /// milliseconds.
  Recovery(Document& document, const QString& sessions, int delay = 3000, QObject* parent = nullptr);
  ~Recovery() override;

  /// The default folder of all sessions.
  static QString default_folder();

  /// The work of sessions that crashed; the latest first.
  std::vector<LostWork> lost_work() const;
  /// Reads an autosaved scene, to be set as that of its path. Returns nothing after an error.
  static std::optional<grf::Scene> read(const LostWork& work, grf::Diagnostics& diagnostics);
  /// Reads the hidden, locked and named faces of an autosaved scene with these objects.
  static EditorState read_state(const LostWork& work, const SceneObjects& objects,
                                grf::Diagnostics& diagnostics);
  static void discard(const LostWork& work);

  /// Sets the time from a change to its autosave, in milliseconds, from the next change on.
  void set_delay(int delay) { timer_.setInterval(delay); }

  /// Autosaves now, in a thread.
  void keep();

 signals:
  void kept();
  /// Emitted when the autosave failed: the disk is full, or the folder cannot be written.
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
