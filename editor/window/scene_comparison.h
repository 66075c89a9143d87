#pragma once

#include <QPlainTextEdit>
#include <QTemporaryDir>

#include "editor/programs/child_process.h"
#include "grf/scene.h"

namespace editor {

/// Shows the differences between a scene and its file, line by line, as `diff -u` does. Both are rewritten
/// first, so that formatting does not matter.
class SceneComparison : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit SceneComparison(QWidget* parent = nullptr);

  void compare(const grf::Scene& scene, const QString& file);

 private:
  void end(const ChildEnd& end);

  QTemporaryDir folder_;
  ChildProcess diff_;
};

}  // namespace editor
