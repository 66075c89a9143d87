#pragma once

#include <QAbstractItemModel>
#include <QHash>
#include <QIcon>
#include <memory>

#include "editor/panels/scene_entries.h"

namespace editor {

/// A Qt item model of a document's scene: names in the first column, details in the second. Edits of the
/// scene insert, remove and change items; the others stay the same and stay expanded.
class SceneModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  explicit SceneModel(Document& document, QObject* parent = nullptr);
  ~SceneModel() override;

  const SceneEntry* entry(const QModelIndex& index) const;
  QModelIndex index_of(const SceneEntry& entry) const;
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
  QMimeData* mimeData(const QModelIndexList& indexes) const override;

 signals:
  /// Emitted when an item cannot be renamed.
  void problem_found(const QString& problem);

 private:
  void update_scene(const Change& change);
  void update_names(const Change& change);
  void update_selection();
  void update_children(SceneEntry& now, std::vector<std::unique_ptr<SceneEntry>> wanted);
  /// Returns whether the item itself must be redrawn.
  bool update_entry(SceneEntry& now, SceneEntry& wanted);

  Document& document_;
  std::unique_ptr<SceneEntry> root_;
  mutable QHash<int, QIcon> icons_;
};

}  // namespace editor
