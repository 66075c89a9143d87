#include "editor/appearance/icons.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

/// Registers the resources of the static library. The macro must be in no namespace.
static void need_resources() { Q_INIT_RESOURCE(icons); }

namespace editor {
namespace {

/// Renders SVG on demand at each size, so that icons are sharp on all screens, and follow the theme.
class Engine : public QIconEngine {
 public:
  explicit Engine(QByteArray svg) : svg_(std::move(svg)) {}

  void paint(QPainter* painter, const QRect& rectangle, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
    const QColor colour = QApplication::palette().color(group, role);
    QByteArray coloured = svg_;
    coloured.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer(coloured).render(painter, rectangle);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new Engine(svg_); }

 private:
  QByteArray svg_;
};

}  // namespace

QIcon icon(const QString& name) {
  need_resources();
  QFile file(":/icons/" + name + ".svg");
  const bool is_there = file.open(QIODevice::ReadOnly);
  Q_ASSERT_X(is_there, "icon", qPrintable(name));
  return is_there ? QIcon(new Engine(file.readAll())) : QIcon();
}

}  // namespace editor
