#include "editor/document/preferences.h"

#include <QSettings>
#include <algorithm>

namespace editor {
namespace {

QString one_of(const QStringList& choices, const char* key, const QString& otherwise) {
  const QString value = QSettings().value(key).toString();
  return choices.contains(value) ? value : otherwise;
}

int number_in(int least, int most, const char* key, int otherwise) {
  bool is_number = false;
  const int value = QSettings().value(key).toInt(&is_number);
  return is_number ? std::clamp(value, least, most) : otherwise;
}

}  // namespace

Preferences Preferences::load() {
  Preferences result;
  result.language = one_of({"en", "es"}, "language", result.language);
  result.theme = one_of({"dark", "light"}, "theme", result.theme);
  result.length_unit = one_of({"m", "cm", "mm", "in"}, "length_unit", result.length_unit);
  result.is_z_up = one_of({"y", "z"}, "import/up", "y") == "z";
  result.undo_steps = number_in(0, MostUndoSteps, "undo_steps", result.undo_steps);
  result.threads = number_in(0, MostThreads, "threads", result.threads);
  result.autosave_seconds = number_in(1, MostAutosaveSeconds, "autosave_seconds", result.autosave_seconds);
  return result;
}

void Preferences::store() const {
  QSettings settings;
  settings.setValue("language", language);
  settings.setValue("theme", theme);
  settings.setValue("length_unit", length_unit);
  settings.setValue("import/up", is_z_up ? "z" : "y");
  settings.setValue("undo_steps", undo_steps);
  settings.setValue("threads", threads);
  settings.setValue("autosave_seconds", autosave_seconds);
}

}  // namespace editor
