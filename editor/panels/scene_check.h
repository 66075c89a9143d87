#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include "editor/document/document.h"
#include "grf/catalogue.h"

namespace editor {

/// Checks a document's scene in a thread, a moment after each edit.
class SceneCheck : public QObject {
  Q_OBJECT

 public:
  /// The document outlives this.
  SceneCheck(Document& document, grf::Catalogue catalogue, QObject* parent = nullptr);
  /// Waits for a check that is running.
  ~SceneCheck() override;

  /// Diagnostics of the last check.
  const grf::Diagnostics& diagnostics() const { return diagnostics_; }
  bool is_up_to_date() const { return !is_outdated_ && !is_running_; }

 signals:
  void checked();

 private:
  void start();
  void take_result();

  Document& document_;
  const grf::Catalogue catalogue_;
  grf::Diagnostics diagnostics_;
  QTimer pause_;
  bool is_outdated_ = true;
  bool is_running_ = false;  // until its result is taken
  QFutureWatcher<grf::Diagnostics> running_;
};

}  // namespace editor
