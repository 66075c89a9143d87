#pragma once

#include <QStyledItemDelegate>

namespace editor {

/// Draws the items of an icon list, each on a tile that contrasts with bright and dark pictures alike; the
/// tile of a selected item has a border in the accent colour, as large as the icon.
class PictureTiles : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  /// Returns a size as wide as the list's grid, if it has one, so that names have all of its width.
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  /// Condenses names with a word that is too wide for the tile, since smaller letters are hard to read.
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

/// The tile colour for a palette.
QColor tile_colour(const QPalette& palette);

}  // namespace editor
