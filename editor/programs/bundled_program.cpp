#include "editor/programs/bundled_program.h"

#include <QCoreApplication>
#include <QStandardPaths>

namespace editor {

QString bundled_program(const QString& name) {
  const QString beside = QStandardPaths::findExecutable(name, {QCoreApplication::applicationDirPath()});
  return beside.isEmpty() ? QStandardPaths::findExecutable(name) : beside;
}

}  // namespace editor
