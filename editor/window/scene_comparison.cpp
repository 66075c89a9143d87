#include "editor/window/scene_comparison.h"

#include <QFontDatabase>

#include "editor/controls/text.h"
#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace editor {

SceneComparison::SceneComparison(QWidget* parent) : QPlainTextEdit(parent) {
  setReadOnly(true);
  setLineWrapMode(NoWrap);
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setAccessibleName(tr("Differences between the scene and its file"));
  connect(&diff_, &ChildProcess::wrote, this,
          [this](const QByteArray& line) { appendPlainText(QString::fromUtf8(line).remove('\n')); });
  connect(&diff_, &ChildProcess::ended, this, &SceneComparison::end);
}

void SceneComparison::compare(const grf::Scene& scene, const QString& file) {
  clear();
  diff_.kill();
  grf::Diagnostics diagnostics;
  const auto on_disk = grf::read(file.toStdString(), diagnostics);
  const QString theirs = folder_.filePath("file.grf");
  const QString ours = folder_.filePath("scene.grf");
  if (!on_disk || !grf::replace_file(theirs.toStdString(), grf::to_text(*on_disk), diagnostics) ||
      !grf::replace_file(ours.toStdString(), grf::to_text(scene), diagnostics))
    return setPlainText(text_of(diagnostics));
  diff_.start("diff", {"-u", "--label", file, "--label", tr("the scene in this window"), theirs, ours});
}

void SceneComparison::end(const ChildEnd& end) {
  if (end.cause == ChildEnd::Cause::NotStarted) setPlainText(tr("Cannot start diff: %1").arg(end.why));
  if (end.cause == ChildEnd::Cause::Returned && end.code == 0)
    setPlainText(tr("The scene and its file do not differ."));
  moveCursor(QTextCursor::Start);
}

}  // namespace editor
