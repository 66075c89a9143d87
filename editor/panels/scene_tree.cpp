#include "editor/panels/scene_tree.h"

#include <QAction>
#include <QHeaderView>
#include <QLineEdit>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QStackedWidget>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/document/definitions.h"
#include "editor/document/light_edits.h"
#include "editor/document/object_edits.h"
#include "editor/panels/scene_model.h"

namespace editor {
namespace {

/// Adds all faces of an entry's meshes and of its descendants.
void add_faces(const SceneEntry& entry, FaceSelection& selection) {
  if (entry.mesh) selection.set_mesh(*entry.mesh);
  for (const auto& child : entry.children) add_faces(*child, selection);
}

/// Whether some faces of an entry's meshes or of its descendants are selected.
bool has_selection(const SceneEntry& entry) {
  return entry.has_selection ||
         std::ranges::any_of(entry.children, [](const auto& child) { return has_selection(*child); });
}

}  // namespace

SceneTree::SceneTree(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new SceneModel(document, this)),
      filter_(new QSortFilterProxyModel(this)),
      search_(new QLineEdit(this)),
      pages_(new QStackedWidget(this)),
      view_(new QTreeView(pages_)),
      problem_(problem_label(this)) {
  setAccessibleName(tr("Scene"));
  search_->setPlaceholderText(tr("Search"));
  search_->setAccessibleName(tr("Search the scene"));
  search_->setToolTip(tr("Show only items whose names contain this text"));
  search_->setClearButtonEnabled(true);
  filter_->setSourceModel(model_);
  filter_->setRecursiveFilteringEnabled(true);
  filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  make_view();
  pages_->addWidget(
      hint_label(tr("The scene is empty.\n\nOpen or import a file, or drop one on the window."), pages_));
  pages_->addWidget(view_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(Grid, Grid, Grid, Grid);
  layout->setSpacing(Grid);
  layout->addWidget(search_);
  layout->addWidget(pages_, 1);
  layout->addWidget(problem_);
  make_actions();
  connect(search_, &QLineEdit::textChanged, this, &SceneTree::show_search);
  connect(model_, &SceneModel::problem_found, this,
          [this](const QString& text) { show_or_hide(problem_, text); });
  connect(&document_, &Document::selection_changed, this, &SceneTree::show_selection);
  connect(&document_, &Document::changed, this, [this] {
    show_selection();
    show_selected_objects();
  });
  connect(&document_, &Document::selected_objects_changed, this, &SceneTree::show_selected_objects);
  connect(&document_, &Document::editor_state_changed, view_->viewport(), qOverload<>(&QWidget::update));
  show_selection();
}

void SceneTree::make_view() {
  view_->setModel(filter_);
  view_->setAccessibleName(tr("Items of the scene"));
  view_->setToolTip(
      tr("Scene outliner: objects, lights and definitions; selecting an item selects its faces"));
  view_->setHeaderHidden(true);
  view_->header()->setStretchLastSection(false);
  view_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  view_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  view_->header()->setMinimumSectionSize(3 * Grid);
  for (const int column : {SceneModel::VisibleColumn, SceneModel::LockedColumn}) {
    view_->header()->setSectionResizeMode(column, QHeaderView::Fixed);
    view_->header()->resizeSection(column, 3 * Grid);
  }
  view_->viewport()->installEventFilter(this);
  view_->header()->setResizeContentsPrecision(0);  // of the lines that are seen: there may be thousands
  view_->setUniformRowHeights(true);
  view_->setIndentation(2 * Grid);
  view_->setIconSize({2 * Grid, 2 * Grid});
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  view_->setDragEnabled(true);
  view_->setDragDropMode(QAbstractItemView::DragDrop);
  view_->setDefaultDropAction(Qt::MoveAction);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setContextMenuPolicy(Qt::ActionsContextMenu);
  view_->expandToDepth(0);
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &SceneTree::select_faces_of_chosen);
}

QAction* SceneTree::add_action(const QString& icon_name, const QString& text, const QKeySequence& shortcut,
                               const QString& tool_tip, void (SceneTree::*triggered)()) {
  auto* action = new QAction(icon(icon_name), text, this);
  action->setShortcut(shortcut);
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  action->setToolTip(tool_tip);
  connect(action, &QAction::triggered, this, triggered);
  view_->addAction(action);
  return action;
}

void SceneTree::make_actions() {
  rename_ = add_action("edit", tr("Rename"), Qt::Key_F2, tr("Rename the item"), &SceneTree::rename_chosen);
  duplicate_ = add_action("duplicate", tr("Duplicate"), QKeySequence(Qt::CTRL | Qt::Key_D),
                          tr("Duplicate the object beside itself, as an instance that shares its mesh"),
                          &SceneTree::duplicate_chosen);
  remove_ = add_action("delete", tr("Delete"), QKeySequence::Delete, tr("Delete the selected items"),
                       &SceneTree::remove_chosen);
  remove_unused_ = add_action("reset", tr("Delete unused definitions"), QKeySequence("Ctrl+Del"),
                              tr("Delete all definitions that nothing refers to"), &SceneTree::remove_unused);
  hide_ = add_action("eye", tr("Hide or show"), QKeySequence("Ctrl+H"),
                     tr("Hide the faces of the selected items in the view, or show them again"),
                     &SceneTree::toggle_hidden);
  lock_ = add_action("lock", tr("Lock or unlock"), QKeySequence("Ctrl+Shift+K"),
                     tr("Make the view not select the faces of the selected items, or select them again"),
                     &SceneTree::toggle_locked);
  update_actions();
}

void SceneTree::update_actions() {
  const std::vector<const SceneEntry*> entries = chosen_entries();
  rename_->setEnabled(entries.size() == 1 && entries.front()->can_be_renamed());
  duplicate_->setEnabled(entries.size() == 1 && entries.front()->is_object() &&
                         entries.front()->kind != SceneEntry::Kind::Observer);
  hide_->setEnabled(!entries.empty());
  lock_->setEnabled(!entries.empty());
  remove_->setEnabled(std::ranges::any_of(
      entries, [](const SceneEntry* entry) { return entry->kind != SceneEntry::Kind::Group; }));
}

/// Adds the faces to the set, or removes them if all are in it.
void SceneTree::toggle(FaceSelection EditorState::*set, const std::vector<const SceneEntry*>& entries) {
  FaceSelection faces(document_.objects());
  for (const SceneEntry* entry : entries) add_faces(*entry, faces);
  if (faces.empty()) return;
  EditorState state = document_.editor_state();
  FaceSelection outside = faces;
  outside.remove(state.*set);
  outside.empty() ? (state.*set).remove(faces) : (state.*set).add(faces);
  document_.set_editor_state(std::move(state));
}

/// Handles clicks on the columns that hide and lock, which select no item. On one of several selected items
/// they apply to all of these.
bool SceneTree::eventFilter(QObject* watched, QEvent* event) {
  const bool is_press =
      event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
  if (watched != view_->viewport() || !is_press) return QWidget::eventFilter(watched, event);
  const auto& pointer = static_cast<QMouseEvent&>(*event);
  const QModelIndex index = view_->indexAt(pointer.position().toPoint());
  if (pointer.button() != Qt::LeftButton || index.column() < SceneModel::VisibleColumn) return false;
  const SceneEntry* entry = model_->entry(filter_->mapToSource(index));
  std::vector<const SceneEntry*> entries = chosen_entries();
  if (std::ranges::find(entries, entry) == entries.end()) entries = {entry};
  toggle(index.column() == SceneModel::LockedColumn ? &EditorState::locked : &EditorState::hidden, entries);
  return true;
}

QSize SceneTree::sizeHint() const { return {280, 640}; }

void SceneTree::choose(grf::ScenePathView path) {
  const QModelIndex index = filter_->mapFromSource(model_->index_at(path));
  if (!index.isValid()) return;
  view_->scrollTo(index);
  view_->setCurrentIndex(index);
}

std::vector<const SceneEntry*> SceneTree::chosen_entries() const {
  std::vector<const SceneEntry*> entries;
  for (const QModelIndex& index : view_->selectionModel()->selectedRows()) {
    entries.push_back(model_->entry(filter_->mapToSource(index)));
  }
  return entries;
}

void SceneTree::select_faces_of_chosen() {
  update_actions();
  if (is_selecting_ || model_->is_updating()) return;
  const QScopedValueRollback guard(is_selecting_, true);
  const std::vector<const SceneEntry*> entries = chosen_entries();
  FaceSelection selection(document_.objects());
  for (const SceneEntry* entry : entries) {
    add_faces(*entry, selection);
    if (entry->is_definition())
      selection.add(faces_with(document_.scene(), document_.objects(), entry->path));
  }
  const grf::ScenePath path = entries.size() == 1 ? entries.front()->path : grf::ScenePath();
  document_.select(std::move(selection));
  std::vector<grf::ScenePath> objects;
  for (const SceneEntry* entry : entries) {
    if (entry->is_object()) objects.push_back(entry->path);
  }
  document_.select_objects(std::move(objects));
  show_or_hide(problem_, {});
  emit chosen(path);
}

// After a selection made elsewhere, the item of its first face becomes the current one.
void SceneTree::show_selection() {
  pages_->setCurrentIndex(document_.scene().contents.blocks.empty() ? 0 : 1);
  if (is_selecting_) return;
  const QScopedValueRollback guard(is_selecting_, true);
  const auto entries = chosen_entries();
  const bool is_shown =
      std::ranges::any_of(entries, [](const SceneEntry* entry) { return has_selection(*entry); });
  if (is_shown) return;
  const QModelIndex first = filter_->mapFromSource(model_->first_with_selection());
  if (!first.isValid()) {
    const bool are_chosen_without_faces = document_.selection().empty() && !entries.empty();
    if (!are_chosen_without_faces) view_->selectionModel()->clearSelection();
    return;
  }
  view_->scrollTo(first);
  view_->selectionModel()->setCurrentIndex(first,
                                           QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

/// Selects the items of objects that were selected elsewhere.
void SceneTree::show_selected_objects() {
  if (is_selecting_ || document_.selected_objects().empty()) return;
  const QScopedValueRollback guard(is_selecting_, true);
  QItemSelection rows;
  QModelIndex active;
  for (const grf::ScenePath& path : document_.selected_objects()) {
    const QModelIndex index = filter_->mapFromSource(model_->index_at(path));
    if (!index.isValid()) continue;
    rows.select(index, index);
    active = index;
  }
  if (!active.isValid()) return;
  view_->scrollTo(active);
  view_->selectionModel()->setCurrentIndex(active, QItemSelectionModel::NoUpdate);
  view_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

void SceneTree::show_search() {
  filter_->setFilterFixedString(search_->text());
  if (!search_->text().isEmpty()) {
    view_->expandAll();
  } else if (view_->currentIndex().isValid()) {
    view_->scrollTo(view_->currentIndex());
  }
}

void SceneTree::rename_chosen() { view_->edit(view_->currentIndex().siblingAtColumn(0)); }

void SceneTree::duplicate_chosen() {
  // The copy is offset by a part of the scene, so that it is visible.
  constexpr double Part = 0.1;
  const grf::Box3d& bounds = document_.objects().bounds;
  const double offset = bounds.isEmpty() ? 1 : Part * bounds.size().length();
  const SceneEntry& entry = *chosen_entries().front();
  grf::Diagnostics diagnostics;
  auto scene = duplicate_object(document_.scene(), entry.path, grf::Vec3d(offset, 0, 0), diagnostics);
  put(tr("Duplicate %1").arg(entry.name), std::move(scene), diagnostics);
}

void SceneTree::remove_chosen() {
  grf::Diagnostics diagnostics;
  const std::vector<const SceneEntry*> entries = chosen_entries();
  std::vector<grf::ScenePath> paths;
  std::vector<ObserverObject> observers;
  for (const SceneEntry* entry : entries) {
    if (entry->kind == SceneEntry::Kind::Observer) {
      observers.push_back({entry->path, entry->observer, grf::Vec3d(0)});
    } else if (entry->kind != SceneEntry::Kind::Group) {
      paths.push_back(entry->path);
    }
  }
  const std::size_t count = paths.size() + observers.size();
  if (count == 0) return;
  const QString text =
      count == 1 ? tr("Delete %1").arg(entries.front()->name) : tr("Delete %1 objects").arg(count);
  put(text, remove_objects(document_.scene(), paths, observers, diagnostics), diagnostics);
}

void SceneTree::remove_unused() {
  grf::Scene scene = remove_unused_definitions(document_.scene());
  const bool is_unchanged = scene == document_.scene();
  show_or_hide(problem_, is_unchanged ? tr("All definitions are used.") : QString());
  if (!is_unchanged) document_.replace(tr("Delete unused definitions"), std::move(scene));
}

void SceneTree::put(const QString& text, std::optional<grf::Scene> scene,
                    const grf::Diagnostics& diagnostics) {
  show_or_hide(problem_, scene ? QString() : QString::fromStdString(diagnostics.entries().front().message));
  if (scene) document_.replace(text, std::move(*scene));
}

}  // namespace editor
