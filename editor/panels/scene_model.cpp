#include "editor/panels/scene_model.h"

#include <QFont>
#include <QMimeData>
#include <algorithm>
#include <iterator>
#include <utility>

#include "editor/appearance/icons.h"
#include "editor/document/brdf_mime.h"
#include "editor/document/object_edits.h"
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
  connect(&document_, &Document::selection_changed, this, &SceneModel::update_selection);
  update_selection();
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

int SceneModel::columnCount(const QModelIndex&) const { return 2; }

QVariant SceneModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const SceneEntry& line = *entry(index);
  if (role == Qt::ToolTipRole) return line.help;
  if (role == Qt::FontRole && line.has_selection) {
    QFont font;
    font.setBold(true);
    return font;
  }
  if (index.column() == 1) {
    if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return role == Qt::DisplayRole ? line.detail : QVariant();
  }
  if (role == Qt::DisplayRole || role == Qt::EditRole) return line.name;
  if (role != Qt::DecorationRole || line.kind == SceneEntry::Kind::Group) return {};
  const int kind = static_cast<int>(line.kind);
  if (!icons_.contains(kind)) icons_.insert(kind, icon(icon_of(line.kind)));
  return icons_.value(kind);
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
  if (line.kind == SceneEntry::Kind::Brdf) flags |= Qt::ItemIsDragEnabled;
  return flags;
}

QStringList SceneModel::mimeTypes() const { return {BrdfMimeType, BrdfNameMimeType}; }

QMimeData* SceneModel::mimeData(const QModelIndexList& indexes) const {
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
  update_children(*root_, std::move(entries_of(document_)->children));
  update_selection();
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

void SceneModel::update_selection() {
  const FaceSelection& selection = document_.selection();
  for_each_entry(*root_, [&](SceneEntry& line) {
    const bool has = line.mesh && *line.mesh < selection.mesh_count() && selection.count(*line.mesh) > 0;
    if (std::exchange(line.has_selection, has) != has) {
      const QModelIndex index = index_of(line);
      emit dataChanged(index, index.siblingAtColumn(1), {Qt::FontRole});
    }
    return true;
  });
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
  now.observer = wanted.observer;
  update_children(now, std::move(wanted.children));
  return looks_other;
}

}  // namespace editor
