#pragma once

#include <QAbstractItemModel>
#include <QHash>
#include <QIcon>
#include <memory>

#include "editor/panels/scene_entries.h"

namespace editor {

/// A Qt item model of a document's scene: names in the first column, details in the second, whether faces are
/// hidden and locked in the others. Edits of the scene insert, remove and change items; the others stay the
/// same and stay expanded.
class SceneModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { NameColumn, DetailColumn, VisibleColumn, LockedColumn, ColumnCount };

  explicit SceneModel(Document& document, QObject* parent = nullptr);
  ~SceneModel() override;

  const SceneEntry* entry(const QModelIndex& index) const;
  QModelIndex index_of(const SceneEntry& entry) const;
  /// Whether an edit is being followed: views may see items go that come again at other places.
  bool is_updating() const { return is_updating_; }
  /// The first item with selected faces, or an invalid index.
  QModelIndex first_with_selection() const;
  /// The item at a path, or an invalid index.
  QModelIndex index_at(grf::ScenePathView path) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QStringList mimeTypes() const override;
  /// BRDFs are dragged as such, objects and mesh definitions by their paths.
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction | Qt::CopyAction; }
  bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                       const QModelIndex& parent) const override;
  /// Moves objects to a place among others or into a transform; a definition gets an instance there.
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

 signals:
  /// Emitted when an item cannot be renamed or moved; empty once it could.
  void problem_found(const QString& problem);

 private:
  QVariant face_state(const SceneEntry& line, int column, int role) const;
  bool holds_objects(const SceneEntry& line) const;
  QIcon cached_icon(const QString& name) const;
  void update_scene(const Change& change);
  void update_names(const Change& change);
  void update_selection(SceneEntry& parent);
  void update_children(SceneEntry& now, std::vector<std::unique_ptr<SceneEntry>> wanted);
  /// Returns whether the item itself must be redrawn.
  bool update_entry(SceneEntry& now, SceneEntry& wanted);

  Document& document_;
  std::unique_ptr<SceneEntry> root_;
  bool is_updating_ = false;
  mutable QHash<QString, QIcon> icons_;
};

}  // namespace editor
