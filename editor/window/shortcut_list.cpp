#include "editor/window/shortcut_list.h"

#include <QAction>
#include <QDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/controls/search_terms.h"

namespace editor {
namespace {

const char ListName[] = "shortcuts";

/// Mouse and keyboard gestures of the 3D view: see SceneView.
constexpr std::pair<const char*, const char*> Gestures[] = {
    {QT_TRANSLATE_NOOP("QDialog", "Click"),
     QT_TRANSLATE_NOOP("QDialog", "Select a face; with Shift add it, with Ctrl remove it")},
    {QT_TRANSLATE_NOOP("QDialog", "Drag from a face"),
     QT_TRANSLATE_NOOP("QDialog", "Select the faces in a box, with Alt in a lasso")},
    {QT_TRANSLATE_NOOP("QDialog", "Alt + click"),
     QT_TRANSLATE_NOOP("QDialog",
                       "Select the face loop through the nearest edge; with Ctrl the loop that crosses it")},
    {QT_TRANSLATE_NOOP("QDialog", "[ and ], Shift + wheel"),
     QT_TRANSLATE_NOOP("QDialog", "Change the radius of the brush")},
    {QT_TRANSLATE_NOOP("QDialog", "Drag from the background, or middle button"),
     QT_TRANSLATE_NOOP("QDialog", "Orbit")},
    {QT_TRANSLATE_NOOP("QDialog", "Shift + middle button"), QT_TRANSLATE_NOOP("QDialog", "Pan")},
    {QT_TRANSLATE_NOOP("QDialog", "Wheel, + and -"), QT_TRANSLATE_NOOP("QDialog", "Zoom")},
    {QT_TRANSLATE_NOOP("QDialog", "Right button, with W A S D Q E"),
     QT_TRANSLATE_NOOP("QDialog", "Look around and fly")},
    {QT_TRANSLATE_NOOP("QDialog", "Double click"), QT_TRANSLATE_NOOP("QDialog", "Set the orbit centre")},
    {QT_TRANSLATE_NOOP("QDialog", "Arrows"), QT_TRANSLATE_NOOP("QDialog", "Orbit; with Shift pan")},
    {QT_TRANSLATE_NOOP("QDialog", "Space"),
     QT_TRANSLATE_NOOP("QDialog", "Select or deselect the face in the middle")},
    {QT_TRANSLATE_NOOP("QDialog", "Escape"), QT_TRANSLATE_NOOP("QDialog", "Cancel a gesture")},
};

void add_row(QTreeWidgetItem& group, QAction& action, const QString& before = {}) {
  QStringList keys;
  for (const QKeySequence& each : action.shortcuts()) keys.append(each.toString(QKeySequence::NativeText));
  auto* row = new QTreeWidgetItem(&group, {keys.join(", "), before + action.text().remove('&')});
  row->setToolTip(1, action.statusTip().isEmpty() ? action.toolTip() : action.statusTip());
  row->setData(1, Qt::UserRole, QVariant::fromValue<QObject*>(&action));
}

/// Adds the actions of a menu; those of submenus are prefixed by the submenu's name.
void add_actions(QTreeWidgetItem& group, const QMenu& menu, const QString& before = {}) {
  for (QAction* action : menu.actions()) {
    if (action->menu() != nullptr) add_actions(group, *action->menu(), action->text().remove('&') + ": ");
    if (!action->isSeparator() && action->menu() == nullptr) add_row(group, *action, before);
  }
}

QTreeWidgetItem* new_group(QTreeWidget& list, const QString& name) {
  auto* group = new QTreeWidgetItem(&list, {name});
  QFont bold = list.font();
  bold.setBold(true);
  group->setFont(0, bold);
  return group;
}

/// Whether the shortcut works only in one control, and the action is in no menu.
bool is_of_control(const QAction& action) {
  const QObjectList places = action.associatedObjects();
  const bool has_menu = std::ranges::any_of(
      places, [](const QObject* place) { return qobject_cast<const QMenu*>(place) != nullptr; });
  return !has_menu && !action.shortcut().isEmpty() && action.shortcutContext() != Qt::WindowShortcut;
}

void add_keys_of_controls(QTreeWidget& list, const QMainWindow& window) {
  for (const QWidget* control : window.findChildren<QWidget*>()) {
    if (control->accessibleName().isEmpty()) continue;
    auto* group = new_group(list, control->accessibleName());
    for (QAction* action : control->actions()) {
      if (is_of_control(*action)) add_row(*group, *action);
    }
    if (group->childCount() == 0) delete group;
  }
}

void fill(QTreeWidget& list, const QMainWindow& window) {
  list.clear();
  for (const QAction* entry : window.menuBar()->actions()) {
    auto* group = new_group(list, entry->text().remove('&'));
    add_actions(*group, *entry->menu());
    if (group->childCount() == 0) delete group;
  }
  add_keys_of_controls(list, window);
  auto* gestures = new_group(list, QDialog::tr("3D view"));
  for (const auto& [keys, what] : Gestures)
    new QTreeWidgetItem(gestures, {QDialog::tr(keys), QDialog::tr(what)});
  list.expandAll();
}

void filter(const QTreeWidget& list, const QString& words) {
  for (int i = 0; i < list.topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = list.topLevelItem(i);
    bool has_any = false;
    for (int k = 0; k < group->childCount(); ++k) {
      QTreeWidgetItem* row = group->child(k);
      const bool fits = matches_search(row->text(0) + ' ' + row->text(1) + ' ' + row->toolTip(1), words);
      row->setHidden(!fits);
      has_any = has_any || fits;
    }
    group->setHidden(!has_any);
  }
}

/// Runs the action of a row, if it has one that is enabled, and closes the list.
void run(QDialog& dialog, const QTreeWidgetItem* row) {
  auto* action =
      row != nullptr ? qobject_cast<QAction*>(row->data(1, Qt::UserRole).value<QObject*>()) : nullptr;
  if (action == nullptr || !action->isEnabled()) return;
  dialog.hide();
  action->trigger();
}

/// The first row that the search left, or null.
QTreeWidgetItem* first_row(const QTreeWidget& list) {
  for (QTreeWidgetItemIterator each(const_cast<QTreeWidget*>(&list), QTreeWidgetItemIterator::NotHidden);
       *each != nullptr; ++each) {
    if ((*each)->parent() != nullptr) return *each;
  }
  return nullptr;
}

QDialog* make_dialog(QMainWindow& window) {
  auto* dialog = new QDialog(&window);
  dialog->setObjectName(ListName);
  dialog->setWindowTitle(QDialog::tr("Actions and keyboard shortcuts"));
  auto* search = new QLineEdit(dialog);
  search->setPlaceholderText(QDialog::tr("Search"));
  search->setAccessibleName(QDialog::tr("Search actions and shortcuts"));
  search->setToolTip(
      QDialog::tr("Show only actions whose key, name or description has these words or a synonym"));
  search->setClearButtonEnabled(true);
  auto* list = new QTreeWidget(dialog);
  list->setAccessibleName(QDialog::tr("Shortcuts"));
  list->setToolTip(QDialog::tr("Keys and their actions; Return or a double click runs one"));
  list->setHeaderLabels({QDialog::tr("Keys"), QDialog::tr("Action")});
  list->setRootIsDecorated(false);
  list->setIndentation(2 * Grid);
  auto* column = new QVBoxLayout(dialog);
  column->addWidget(search);
  column->addWidget(list, 1);
  QObject::connect(search, &QLineEdit::textChanged, list,
                   [list](const QString& words) { filter(*list, words); });
  QObject::connect(search, &QLineEdit::returnPressed, dialog,
                   [dialog, list] { run(*dialog, first_row(*list)); });
  QObject::connect(list, &QTreeWidget::itemActivated, dialog,
                   [dialog](const QTreeWidgetItem* row) { run(*dialog, row); });
  dialog->resize(80 * Grid, 90 * Grid);
  return dialog;
}

}  // namespace

void show_shortcuts(QMainWindow& window) {
  auto* dialog = window.findChild<QDialog*>(ListName);
  if (dialog == nullptr) dialog = make_dialog(window);
  auto* list = dialog->findChild<QTreeWidget*>();
  fill(*list, window);  // new pages may have shortcuts, too
  list->resizeColumnToContents(0);
  filter(*list, dialog->findChild<QLineEdit*>()->text());
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
  auto* search = dialog->findChild<QLineEdit*>();
  search->setFocus();
  search->selectAll();
}

}  // namespace editor
