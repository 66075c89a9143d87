#pragma once

#include <QAbstractListModel>
#include <QStyledItemDelegate>
#include <vector>

#include "grf/diagnostics.h"

namespace editor {

/// Diagnostics as a list.
class MessageModel : public QAbstractListModel {
  Q_OBJECT

 public:
  using QAbstractListModel::QAbstractListModel;

  void show_messages(std::vector<grf::Diagnostic> messages);
  const grf::Diagnostic& message(int row) const { return messages_[static_cast<std::size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<grf::Diagnostic> messages_;
};

/// Draws a diagnostic: its severity, its place, what is wrong, and the line of the file with a mark under the
/// place, in a fixed font.
class MessageDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

/// `file:line:column`, as far as it is known; the file without its folder.
QString place_text(const grf::SourceLocation& location);

}  // namespace editor
