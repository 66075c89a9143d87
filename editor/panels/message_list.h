#pragma once

#include <QAbstractListModel>
#include <QStyledItemDelegate>
#include <vector>

#include "grf/diagnostics.h"

namespace editor {

/// A list model of diagnostics.
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

/// Draws a diagnostic: severity, location, message, and the source line with a caret under the location, in a
/// fixed-width font.
class MessageDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

/// Formats a location as `file:line:column`, as far as it is known; the file without its folder.
QString place_text(const grf::SourceLocation& location);

}  // namespace editor
