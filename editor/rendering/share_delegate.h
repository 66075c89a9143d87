#pragma once

#include <QStyledItemDelegate>

namespace editor {

/// Draws a fraction of an item's data as a bar with its percentage. Without a fraction nothing is drawn;
/// below 0 there is no bar.
class ShareDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  static constexpr int FractionRole = Qt::UserRole + 1;

  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace editor
