#include "editor/document/preferences.h"

#include <QSettings>
#include <algorithm>
#include <utility>

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

/// The keys of the settings with the fields that they keep.
constexpr std::pair<const char*, QString FarmAccess::*> FarmKeys[] = {
    {"farm/server", &FarmAccess::server},
    {"farm/token_file", &FarmAccess::token_file},
    {"farm/authority_file", &FarmAccess::authority_file},
    {"farm/certificate_file", &FarmAccess::certificate_file},
    {"farm/key_file", &FarmAccess::key_file}};

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
  for (const auto& [key, field] : FarmKeys) result.farm.*field = QSettings().value(key).toString();
  result.shows_welcome = QSettings().value("shows_welcome", true).toBool();
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
  for (const auto& [key, field] : FarmKeys) settings.setValue(key, farm.*field);
  settings.setValue("shows_welcome", shows_welcome);
}

}  // namespace editor
