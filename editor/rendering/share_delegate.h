#pragma once

#include <QStyledItemDelegate>

namespace editor {

/// Draws a fraction of an item's data as a bar beside its text; below 0 there is no bar. Items without one
/// are drawn as usual.
class ShareDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  static constexpr int FractionRole = Qt::UserRole + 1;

  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace editor
