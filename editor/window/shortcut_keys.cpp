#include "editor/window/shortcut_keys.h"

#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QVariantMap>

#include "editor/controls/actions.h"

namespace editor {
namespace {

QString plain_text(const QAction& action) { return action.text().remove('&'); }

void collect(const QMenu& menu, const QString& name, std::vector<ShortcutKeys::Entry>& entries) {
  for (QAction* action : menu.actions()) {
    const QString text = name + " > " + plain_text(*action);
    if (action->menu() != nullptr) {
      collect(*action->menu(), text, entries);
    } else if (!action->isSeparator()) {
      entries.push_back({action, text, action->shortcuts()});
    }
  }
}

/// The entries have the names of the window's language, so that each language has its own shortcuts.
QString settings_key() {
  return "shortcuts/" +
         QCoreApplication::translate("ShortcutKeys", "en", "code of the language of the texts");
}

QVariantMap stored() { return QSettings().value(settings_key()).toMap(); }

}  // namespace

ShortcutKeys::ShortcutKeys(const QMainWindow& window) : window_(window) {
  for (const QAction* title : window.menuBar()->actions()) {
    if (title->menu() != nullptr) collect(*title->menu(), plain_text(*title), entries_);
  }
  const QVariantMap chosen = stored();
  for (const Entry& entry : entries_) {
    if (!chosen.contains(entry.name)) continue;
    set_shortcuts(*entry.action, QKeySequence::listFromString(chosen[entry.name].toString()));
  }
}

const QAction* ShortcutKeys::other_with(const QKeySequence& keys, const Entry& entry) const {
  if (keys.isEmpty()) return nullptr;
  for (const QAction* action : window_.findChildren<QAction*>()) {
    if (action != entry.action && action->shortcuts().contains(keys)) return action;
  }
  return nullptr;
}

void ShortcutKeys::set(const Entry& entry, const QList<QKeySequence>& keys) {
  set_shortcuts(*entry.action, keys);
  QVariantMap chosen = stored();
  if (entry.action->shortcuts() == entry.defaults) {
    chosen.remove(entry.name);
  } else {
    chosen[entry.name] = QKeySequence::listToString(entry.action->shortcuts());
  }
  QSettings().setValue(settings_key(), chosen);
}

void ShortcutKeys::reset() {
  for (const Entry& entry : entries_) set_shortcuts(*entry.action, entry.defaults);
  QSettings().remove(settings_key());
}

}  // namespace editor
