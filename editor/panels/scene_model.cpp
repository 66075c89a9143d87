#include "editor/panels/scene_model.h"

#include <QFont>
#include <QMimeData>
#include <QScopedValueRollback>
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "editor/appearance/icons.h"
#include "editor/document/brdf_mime.h"
#include "editor/document/object_edits.h"
#include "editor/document/object_mime.h"
#include "editor/document/object_order.h"
#include "editor/document/scene_places.h"

namespace editor {
namespace {

/// Visits all entries, parents before their children, until the action returns false.
template <class Entry, class Action>
bool for_each_entry(Entry& entry, const Action& action) {
  return std::ranges::all_of(entry.children, [&action](const auto& child) {
    return action(*child) && for_each_entry(*child, action);
  });
}

/// Whether the faces of an item and of its descendants are all in a set; nothing for an item without faces.
std::optional<bool> all_faces_are_in(const SceneEntry& line, const FaceSelection& faces) {
  std::optional<bool> are_all;
  const auto add = [&](const SceneEntry& entry) {
    if (!entry.mesh) return true;
    are_all = faces.count(*entry.mesh) == faces.of_mesh(*entry.mesh).size();
    return *are_all;
  };
  if (add(line)) for_each_entry(line, add);
  return are_all;
}

/// The number of unchanged items at the beginning and at the end.
struct Kept {
  std::size_t first = 0;
  std::size_t last = 0;
};

// Items between those that match have changed. If as many of the same kinds remain, they count as renamed.
Kept kept(const std::vector<std::unique_ptr<SceneEntry>>& now,
          const std::vector<std::unique_ptr<SceneEntry>>& wanted) {
  const auto same_kind = [](const auto& a, const auto& b) { return a->kind == b->kind; };
  if (std::equal(now.begin(), now.end(), wanted.begin(), wanted.end(), same_kind)) return {now.size(), 0};
  const std::size_t common = std::min(now.size(), wanted.size());
  Kept same;
  while (same.first < common && now[same.first]->is_like(*wanted[same.first])) ++same.first;
  while (same.last < common - same.first &&
         now[now.size() - 1 - same.last]->is_like(*wanted[wanted.size() - 1 - same.last])) {
    ++same.last;
  }
  return same;
}

}  // namespace

SceneModel::SceneModel(Document& document, QObject* parent)
    : QAbstractItemModel(parent), document_(document), root_(entries_of(document)) {
  connect(&document_, &Document::changed, this, &SceneModel::update_scene);
  connect(&document_, &Document::selection_changed, this, [this] { update_selection(*root_); });
  update_selection(*root_);
}

SceneModel::~SceneModel() = default;

const SceneEntry* SceneModel::entry(const QModelIndex& index) const {
  return index.isValid() ? static_cast<const SceneEntry*>(index.constInternalPointer()) : root_.get();
}

QModelIndex SceneModel::index_of(const SceneEntry& entry) const {
  return entry.parent == nullptr ? QModelIndex() : createIndex(entry.row, 0, &entry);
}

QModelIndex SceneModel::first_with_selection() const {
  QModelIndex found;
  for_each_entry(std::as_const(*root_), [&](const SceneEntry& entry) {
    if (entry.has_selection) found = index_of(entry);
    return !entry.has_selection;
  });
  return found;
}

QModelIndex SceneModel::index_at(grf::ScenePathView path) const {
  QModelIndex found;
  for_each_entry(std::as_const(*root_), [&](const SceneEntry& entry) {
    const bool is_it = entry.kind != SceneEntry::Kind::Group &&
                       std::equal(path.begin(), path.end(), entry.path.begin(), entry.path.end());
    if (is_it) found = index_of(entry);
    return !is_it;
  });
  return found;
}

QModelIndex SceneModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, entry(parent)->children[static_cast<std::size_t>(row)].get());
}

QModelIndex SceneModel::parent(const QModelIndex& index) const {
  return index.isValid() ? index_of(*entry(index)->parent) : QModelIndex();
}

int SceneModel::rowCount(const QModelIndex& parent) const {
  return parent.column() > 0 ? 0 : static_cast<int>(entry(parent)->children.size());
}

int SceneModel::columnCount(const QModelIndex&) const { return ColumnCount; }

QIcon SceneModel::cached_icon(const QString& name) const {
  if (!icons_.contains(name)) icons_.insert(name, icon(name));
  return icons_.value(name);
}

/// Whether all faces of an item are hidden or locked; nothing for an item without faces.
QVariant SceneModel::face_state(const SceneEntry& line, int column, int role) const {
  const EditorState& state = document_.editor_state();
  const bool is_lock = column == LockedColumn;
  const auto is_all = all_faces_are_in(line, is_lock ? state.locked : state.hidden);
  if (!is_all) return {};
  switch (role) {
    case Qt::DecorationRole:
      return cached_icon(is_lock ? (*is_all ? "lock" : "unlocked") : (*is_all ? "eye_closed" : "eye"));
    case Qt::AccessibleTextRole:
      return is_lock ? (*is_all ? tr("locked") : tr("not locked")) : (*is_all ? tr("hidden") : tr("visible"));
    case Qt::ToolTipRole:
      return is_lock
                 ? (*is_all ? tr("Unlock the faces") : tr("Lock the faces: the view does not select them"))
                 : (*is_all ? tr("Show the faces") : tr("Hide the faces in the view"));
    default:
      return {};
  }
}

QVariant SceneModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const SceneEntry& line = *entry(index);
  if (index.column() >= VisibleColumn) return face_state(line, index.column(), role);
  if (role == Qt::ToolTipRole) return line.help;
  if (role == Qt::FontRole && line.has_selection) {
    QFont font;
    font.setBold(true);
    return font;
  }
  if (index.column() == DetailColumn) {
    if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return role == Qt::DisplayRole ? line.detail : QVariant();
  }
  if (role == Qt::DisplayRole || role == Qt::EditRole) return line.name;
  if (role != Qt::DecorationRole || line.kind == SceneEntry::Kind::Group) return {};
  return cached_icon(icon_of(line.kind));
}

bool SceneModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const QString name = value.toString().trimmed();
  if (!index.isValid() || role != Qt::EditRole || name == entry(index)->name) return false;
  grf::Diagnostics diagnostics;
  const grf::ScenePath path = entry(index)->path;
  auto scene = rename_object(document_.scene(), path, name.toStdString(), diagnostics);
  if (!scene) {
    emit problem_found(QString::fromStdString(diagnostics.entries().front().message));
    return false;
  }
  emit problem_found({});
  document_.replace(tr("Rename to %1").arg(name), std::move(*scene));
  return true;
}

Qt::ItemFlags SceneModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  const SceneEntry& line = *entry(index);
  if (index.column() == 0 && line.can_be_renamed()) flags |= Qt::ItemIsEditable;
  const bool has_mesh = line.kind == SceneEntry::Kind::DefinedMesh;
  const bool can_move = line.is_object() && line.kind != SceneEntry::Kind::Observer;
  if (can_move || has_mesh || line.kind == SceneEntry::Kind::Brdf) flags |= Qt::ItemIsDragEnabled;
  if (holds_objects(line)) flags |= Qt::ItemIsDropEnabled;
  return flags;
}

/// Whether objects can be dropped on an item.
bool SceneModel::holds_objects(const SceneEntry& line) const {
  return (line.kind == SceneEntry::Kind::Transform && !is_in_include(document_.scene(), line.path)) ||
         &line == root_->children.front().get();
}

QStringList SceneModel::mimeTypes() const { return {BrdfMimeType, BrdfNameMimeType, ObjectsMimeType}; }

bool SceneModel::canDropMimeData(const QMimeData* data, Qt::DropAction, int, int,
                                 const QModelIndex& parent) const {
  return data->hasFormat(ObjectsMimeType) && parent.isValid() && holds_objects(*entry(parent));
}

bool SceneModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                              const QModelIndex& parent) {
  const std::vector<grf::ScenePath> paths = paths_of(*data);
  if (paths.empty() || !canDropMimeData(data, action, row, column, parent)) return false;
  const grf::Scene& scene = document_.scene();
  const SceneEntry& around = *entry(parent);
  const auto& lines = around.children;
  const bool is_at_end = row < 0 || row >= static_cast<int>(lines.size());
  BlockPlace place = place_at_end(scene, around.path);
  if (!is_at_end) {
    place = place_before(scene, lines[static_cast<std::size_t>(row)]->path);
  } else if (!lines.empty() && row >= 0) {
    place = place_after(scene, lines.back()->path);
  }
  grf::Diagnostics diagnostics;
  const bool is_definition = definition_at(scene, paths.front()) != nullptr;
  auto edited = is_definition ? use_definition(scene, paths.front(), place, diagnostics)
                              : move_objects(scene, paths, place, diagnostics);
  if (!edited) {
    emit problem_found(QString::fromStdString(diagnostics.entries().front().message));
    return false;
  }
  emit problem_found({});
  document_.replace_objects(is_definition ? tr("Add instance") : tr("Move in the list"), std::move(*edited));
  return true;
}

QMimeData* SceneModel::mimeData(const QModelIndexList& indexes) const {
  std::vector<grf::ScenePath> paths;
  for (const QModelIndex& index : indexes) {
    const SceneEntry& line = *entry(index);
    const bool is_draggable = line.is_object() || line.kind == SceneEntry::Kind::DefinedMesh;
    if (index.column() == NameColumn && is_draggable) paths.push_back(line.path);
  }
  if (!paths.empty()) return mime_of(paths).release();
  for (const QModelIndex& index : indexes) {
    const grf::Definition* definition = definition_at(document_.scene(), entry(index)->path);
    const auto* brdf = definition == nullptr ? nullptr : std::get_if<grf::BrdfModel>(&definition->body);
    if (brdf != nullptr) return mime_of(*brdf, entry(index)->name).release();
  }
  return nullptr;
}

void SceneModel::update_scene(const Change& change) {
  // Surfaces of faces are not in the list, but the number of uses of a definition is.
  const bool is_of_faces_alone = !change.moves_objects() && !change.definitions;
  if (is_of_faces_alone && !change.references) {
    if (change.names) update_names(change);
    return;
  }
  const QScopedValueRollback guard(is_updating_, true);
  update_children(*root_, std::move(entries_of(document_)->children));
  update_selection(*root_);
}

/// Renames meshes, and transforms that are named after their contents.
void SceneModel::update_names(const Change& change) {
  const std::vector<MeshObject>& meshes = document_.objects().meshes;
  std::vector<bool> are_changed(meshes.size());
  for (const std::uint32_t mesh : change.meshes) are_changed[mesh] = true;
  for_each_entry(*root_, [&](SceneEntry& line) {
    if (line.kind != SceneEntry::Kind::Mesh || !line.mesh || !are_changed[*line.mesh]) return true;
    line.name = display_name_of(*meshes[*line.mesh].mesh);
    emit dataChanged(index_of(line), index_of(line));
    for (SceneEntry* around = line.parent; around->kind != SceneEntry::Kind::Group; around = around->parent) {
      if (around->kind != SceneEntry::Kind::Transform) continue;
      around->detail = contents_of(*around);
      const QModelIndex detail = index_of(*around).siblingAtColumn(1);
      emit dataChanged(detail, detail);
    }
    return true;
  });
}

void SceneModel::update_selection(SceneEntry& parent) {
  const FaceSelection& selection = document_.selection();
  // Views are notified once for all items of a parent, as in `update_children`.
  const SceneEntry* first = nullptr;
  const SceneEntry* last = nullptr;
  for (const auto& child : parent.children) {
    SceneEntry& line = *child;
    const bool has = line.mesh && *line.mesh < selection.mesh_count() && selection.count(*line.mesh) > 0;
    if (std::exchange(line.has_selection, has) != has) {
      last = &line;
      if (first == nullptr) first = last;
    }
    update_selection(line);
  }
  if (first != nullptr)
    emit dataChanged(index_of(*first), index_of(*last).siblingAtColumn(DetailColumn), {Qt::FontRole});
}

void SceneModel::update_children(SceneEntry& now, std::vector<std::unique_ptr<SceneEntry>> wanted) {
  auto& children = now.children;
  const auto [first, last] = kept(children, wanted);
  const auto at = [](auto& list, std::size_t place) {
    return list.begin() + static_cast<std::ptrdiff_t>(place);
  };
  const QModelIndex index = index_of(now);
  const std::size_t gone = children.size() - first - last;
  if (gone > 0) {
    beginRemoveRows(index, static_cast<int>(first), static_cast<int>(first + gone - 1));
    children.erase(at(children, first), at(children, first + gone));
    now.number_children();
    endRemoveRows();
  }
  const std::size_t added = wanted.size() - first - last;
  std::vector<std::unique_ptr<SceneEntry>> fresh(std::make_move_iterator(at(wanted, first)),
                                                 std::make_move_iterator(at(wanted, first + added)));
  if (added > 0) {
    beginInsertRows(index, static_cast<int>(first), static_cast<int>(first + added - 1));
    children.insert(at(children, first), std::make_move_iterator(fresh.begin()),
                    std::make_move_iterator(fresh.end()));
    now.number_children();
    endInsertRows();
  }
  // Views are notified once for all items, since their work per call may be proportional to all.
  SceneEntry* first_other = nullptr;
  SceneEntry* last_other = nullptr;
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (wanted[i] == nullptr || !update_entry(*children[i], *wanted[i])) continue;
    last_other = children[i].get();
    if (first_other == nullptr) first_other = last_other;
  }
  if (first_other != nullptr) {
    emit dataChanged(index_of(*first_other), index_of(*last_other).siblingAtColumn(1));
  }
}

bool SceneModel::update_entry(SceneEntry& now, SceneEntry& wanted) {
  const bool looks_other = now.name != wanted.name || now.detail != wanted.detail || now.help != wanted.help;
  now.name = wanted.name;
  now.detail = wanted.detail;
  now.help = wanted.help;
  now.path = wanted.path;
  now.mesh = wanted.mesh;
  now.faces = wanted.faces;
  now.observer = wanted.observer;
  update_children(now, std::move(wanted.children));
  return looks_other;
}

}  // namespace editor
