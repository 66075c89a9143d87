#pragma once

#include <QPlainTextEdit>
#include <QTemporaryDir>

#include "editor/programs/child_process.h"
#include "grf/scene.h"

namespace editor {

/// Shows how a scene differs from its file, line by line, as `diff -u` does. Both are written anew first, so
/// that layout makes no difference.
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
