#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QStringList>

#include "editor/programs/bundled_program.h"
#include "editor/programs/child_process.h"

namespace editor {

/// How a run of the renderer ended.
struct RendererEnd {
  bool is_interrupted = false;  ///< it was asked to end early, and did
  QString problem;              ///< why it failed, which may be lines; empty: it did not
};

/// Runs the program `bpt`, one command at a time, and hears it line by line.
class RendererProcess : public QObject {
  Q_OBJECT

 public:
  explicit RendererProcess(QString program = bundled_program("bpt"), QObject* parent = nullptr);
  /// Why it cannot be run; empty: as far as is known it can.
  QString why_missing() const;
  void start(const QStringList& arguments);
  /// Asks for what there is so far. `ended` follows.
  void interrupt() { process_.interrupt(); }
  /// Ends it at once, with nothing kept. No signal comes.
  void kill() { process_.kill(); }
  /// What it said of its work since it was started.
  const QStringList& lines() const { return log_; }

 signals:
  /// A line of its standard output.
  void reported(const QByteArray& line);
  /// A line of what it says of its work.
  void logged(const QString& line);
  void ended(const editor::RendererEnd& end);

 private:
  void log(const QByteArray& bytes);
  void end(const ChildEnd& end);

  const QString program_;
  ChildProcess process_;
  QStringList log_;
};

}  // namespace editor
