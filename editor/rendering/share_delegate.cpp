#include "editor/rendering/share_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QStyle>
#include <QWidget>
#include <algorithm>

#include "editor/appearance/theme.h"

namespace editor {

void ShareDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  const QVariant fraction = index.data(FractionRole);
  if (!fraction.isValid()) return QStyledItemDelegate::paint(painter, option, index);
  QStyleOptionViewItem plain = option;
  initStyleOption(&plain, index);
  const QString text = plain.text;
  plain.text.clear();
  const QWidget* widget = option.widget;
  (widget != nullptr ? widget->style() : QApplication::style())
      ->drawControl(QStyle::CE_ItemViewItem, &plain, painter, widget);
  const Theme theme = theme_of(option.palette);
  const ThemeColours colours = colours_of(theme);
  const int text_width = option.fontMetrics.horizontalAdvance(QStringLiteral("-100 %"));
  QRect bar = option.rect.adjusted(text_width + Grid, 3 * Grid / 4, -Grid, -3 * Grid / 4);
  painter->save();
  painter->setPen(colours.text);
  painter->drawText(option.rect.adjusted(0, 0, text_width - option.rect.width(), 0),
                    Qt::AlignRight | Qt::AlignVCenter, text);
  QColor ground = colours.line;
  ground.setAlphaF(0.35F);
  painter->fillRect(bar, ground);
  bar.setWidth(static_cast<int>(bar.width() * std::clamp(fraction.toDouble(), 0.0, 1.0)));
  painter->fillRect(bar, series_colour(theme, index.column() == 1 ? 1 : 2));
  painter->restore();
}

QSize ShareDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  return QStyledItemDelegate::sizeHint(option, index).expandedTo({0, 3 * Grid});
}

}  // namespace editor
