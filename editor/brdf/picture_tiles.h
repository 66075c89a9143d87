#pragma once

#include <QStyledItemDelegate>

namespace editor {

/// Draws items of a list of pictures, each on a tile of its own that stands out from bright and from dark
/// pictures alike; the tile of a selected item has a border of the accent colour. It is as large as the icon.
class PictureTiles : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  /// As wide as the list's grid, if it has one: names have all of that.
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  /// Names with a word that is too wide for the tile have narrower letters: smaller ones are hard to read.
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

/// What is behind pictures where the palette is this one.
QColor tile_colour(const QPalette& palette);

}  // namespace editor
