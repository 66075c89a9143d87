#include "editor/brdf/picture_tiles.h"

#include <QApplication>
#include <QListView>
#include <QPainter>
#include <algorithm>

#include "editor/appearance/theme.h"

namespace editor {

QColor tile_colour(const QPalette& palette) {
  const Theme theme = theme_of(palette);
  return theme == Theme::Dark ? palette.color(QPalette::Button) : colours_of(theme).line;
}

void PictureTiles::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  const QStyle* style = item.widget == nullptr ? QApplication::style() : item.widget->style();
  const QRect place = style->subElementRect(QStyle::SE_ItemViewItemDecoration, &item, item.widget);
  const ThemeColours colours = colours_of(theme_of(item.palette));
  const bool is_selected = item.state.testFlag(QStyle::State_Selected);
  const qreal width = is_selected ? 2 : 1;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QColor tile = tile_colour(item.palette);
  const bool is_dark = theme_of(item.palette) == Theme::Dark;
  painter->setPen(QPen(is_selected ? colours.accent : is_dark ? colours.line : tile.darker(125), width));
  painter->setBrush(tile);
  painter->drawRoundedRect(QRectF(place).adjusted(width / 2, width / 2, -width / 2, -width / 2), 4, 4);
  painter->restore();
  QStyledItemDelegate::paint(painter, option, index);
}

QSize PictureTiles::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QSize size = QStyledItemDelegate::sizeHint(option, index);
  const auto* list = qobject_cast<const QListView*>(option.widget);
  if (list != nullptr && list->gridSize().isValid()) size.setWidth(list->gridSize().width());
  return size;
}

void PictureTiles::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const int width = option->rect.width() - Grid;
  const auto is_too_wide = [&](const QString& word) {
    return QFontMetrics(option->font).horizontalAdvance(word) > width;
  };
  const QStringList words = option->text.split(' ');
  for (int stretch = 95; stretch >= 80 && std::ranges::any_of(words, is_too_wide); stretch -= 5) {
    option->font.setStretch(stretch);
  }
  option->fontMetrics = QFontMetrics(option->font);
}

}  // namespace editor
