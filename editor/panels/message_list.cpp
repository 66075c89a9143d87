#include "editor/panels/message_list.h"

#include <QAbstractScrollArea>
#include <QFileInfo>
#include <QFontDatabase>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"

namespace editor {
namespace {

constexpr int IconSize = 2 * Grid;
constexpr int Left = Grid + IconSize + Grid;  // of the text

/// How a severity is told: its icon has the same name.
struct SeverityStyle {
  const char* name;
  QColor ThemeColours::*colour;
};

SeverityStyle style_of(grf::Severity severity) {
  if (severity == grf::Severity::Error) return {"error", &ThemeColours::error};
  if (severity == grf::Severity::Warning) return {"warning", &ThemeColours::warning};
  return {"note", &ThemeColours::faint_text};
}

QFont fixed_font(const QFont& like) {
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  font.setPointSizeF(like.pointSizeF());
  return font;
}

/// The layout of a message.
struct Layout {
  QRect place;
  QRect text;
  QRect excerpt;  // two lines: the source, and the mark
  int height = 0;
};

Layout layout_of(const grf::Diagnostic& message, const QStyleOptionViewItem& option, int width) {
  const QFontMetrics metrics(option.font);
  const QFontMetrics fixed(fixed_font(option.font));
  const int right = width - Grid;
  Layout layout;
  const QString place = place_text(message.location);
  int y = Grid / 2;
  if (!place.isEmpty()) {
    layout.place = QRect(Left, y, right - Left, metrics.height());
    y += metrics.height();
  }
  const QString text = QString::fromStdString(message.message);
  layout.text = metrics.boundingRect(QRect(Left, y, right - Left, 1 << 16), Qt::TextWordWrap, text);
  layout.text.setWidth(right - Left);
  y += layout.text.height();
  if (!message.excerpt.empty()) {
    y += Grid / 4;
    layout.excerpt = QRect(Left, y, right - Left, 2 * fixed.height());
    y += layout.excerpt.height();
  }
  layout.height = std::max(y, IconSize + Grid) + Grid / 2;
  return layout;
}

int width_of(const QStyleOptionViewItem& option) {
  const auto* view = qobject_cast<const QAbstractScrollArea*>(option.widget);
  return view == nullptr ? option.rect.width() : view->viewport()->width();
}

const grf::Diagnostic& message_of(const QModelIndex& index) {
  return static_cast<const MessageModel*>(index.model())->message(index.row());
}

void draw_severity(QPainter& painter, grf::Severity severity, const ThemeColours& colours) {
  const SeverityStyle style = style_of(severity);
  const qreal ratio = painter.device()->devicePixelRatioF();
  QPixmap pixmap(QSize(IconSize, IconSize) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter drawing(&pixmap);
  icon(style.name).paint(&drawing, QRect(0, 0, IconSize, IconSize));
  drawing.setCompositionMode(QPainter::CompositionMode_SourceIn);
  drawing.fillRect(QRect(0, 0, IconSize, IconSize), colours.*style.colour);
  drawing.end();
  painter.drawPixmap(QPoint(Grid, Grid / 2), pixmap);
}

void draw_excerpt(QPainter& painter, const QRect& place, const grf::Diagnostic& message,
                  const ThemeColours& colours) {
  const int height = place.height() / 2;
  const QRect line(place.topLeft(), QSize(place.width(), height));
  const QString text = QString::fromStdString(message.excerpt).replace('\t', ' ');
  painter.setPen(colours.faint_text);
  painter.drawText(line, Qt::AlignLeft | Qt::TextSingleLine, text);
  painter.setPen(colours.*style_of(message.severity).colour);
  const auto before = static_cast<qsizetype>(std::max(message.excerpt_column, 1U)) - 1;
  painter.drawText(line.translated(0, height), Qt::AlignLeft, QString(before, ' ') + "^");
}

}  // namespace

QString place_text(const grf::SourceLocation& location) {
  if (!location.file) return {};
  QString text = QFileInfo(QString::fromStdString(location.file->path)).fileName();
  if (location.line > 0) text += QString(":%1:%2").arg(location.line).arg(location.column);
  return text;
}

void MessageModel::show_messages(std::vector<grf::Diagnostic> messages) {
  beginResetModel();
  messages_ = std::move(messages);
  endResetModel();
}

int MessageModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(messages_.size());
}

QVariant MessageModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const grf::Diagnostic& each = message(index.row());
  const QString text = QString::fromStdString(each.message);
  const QString place = place_text(each.location);
  if (role == Qt::DisplayRole) return place.isEmpty() ? text : place + ": " + text;
  if (role == Qt::AccessibleTextRole)
    return QString("%1: %2: %3").arg(tr(style_of(each.severity).name), place, text);
  if (role != Qt::ToolTipRole || !each.location.file) return {};
  return tr("%1\nDouble-click to go to the line and select its faces")
      .arg(QString::fromStdString(each.location.file->path));
}

void MessageDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  const grf::Diagnostic& message = message_of(index);
  const ThemeColours colours = colours_of(theme_of(option.palette));
  const Layout layout = layout_of(message, option, option.rect.width());
  painter->save();
  painter->translate(option.rect.topLeft());
  if (option.state.testFlag(QStyle::State_Selected)) {
    QColor background = colours.accent;
    background.setAlphaF(0.25F);  // all text colours stay readable on it
    painter->fillRect(QRect(QPoint(), option.rect.size()), background);
  }
  draw_severity(*painter, message.severity, colours);
  painter->setFont(option.font);
  painter->setPen(colours.faint_text);
  painter->drawText(layout.place, Qt::AlignLeft, place_text(message.location));
  painter->setPen(colours.text);
  painter->drawText(layout.text, Qt::TextWordWrap, QString::fromStdString(message.message));
  if (!message.excerpt.empty()) {
    painter->setFont(fixed_font(option.font));
    draw_excerpt(*painter, layout.excerpt, message, colours);
  }
  painter->restore();
}

QSize MessageDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const int width = width_of(option);
  return {width, layout_of(message_of(index), option, width).height};
}

}  // namespace editor
