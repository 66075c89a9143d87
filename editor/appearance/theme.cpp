#include "editor/appearance/theme.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QFocusFrame>
#include <QPainter>
#include <QPalette>
#include <QPointer>
#include <QProxyStyle>
#include <QStyleOption>
#include <array>

namespace editor {
namespace {

/// Extends Fusion by an accent line under checked buttons, which are otherwise only a little darker, by
/// elided text in combo boxes, and by a focus frame around lists and texts: Fusion marks only fields and
/// buttons.
class EditorStyle : public QProxyStyle {
 public:
  EditorStyle() : QProxyStyle("Fusion") {
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { mark_focus(now); });
  }
  ~EditorStyle() override { delete focus_mark_; }

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element != PE_PanelButtonTool || !option->state.testFlag(State_On)) return;
    constexpr int Width = Grid / 4;
    const QRect& button = option->rect;
    painter->fillRect(
        QRect(button.left() + Width, button.bottom() + 1 - Width, button.width() - 2 * Width, Width),
        option->palette.brush(QPalette::Highlight));
  }

  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override {
    const auto* list = qstyleoption_cast<const QStyleOptionComboBox*>(option);
    if (element == CE_FocusFrame) {
      return painter->fillRect(option->rect, option->palette.brush(QPalette::Highlight));
    }
    if (element != CE_ComboBoxLabel || list == nullptr) {
      return QProxyStyle::drawControl(element, option, painter, widget);
    }
    QStyleOptionComboBox elided = *list;
    const int icon = list->currentIcon.isNull() ? 0 : list->iconSize.width() + Grid / 2;
    const int width =
        subControlRect(CC_ComboBox, list, SC_ComboBoxEditField, widget).width() - icon - Grid / 4;
    elided.currentText = list->fontMetrics.elidedText(list->currentText, Qt::ElideRight, width);
    QProxyStyle::drawControl(element, &elided, painter, widget);
  }

  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    // Docks have no space around a list. The margins of list items stay.
    const bool is_of_mark = widget == nullptr || widget->inherits("QFocusFrame");
    if (is_of_mark && (metric == PM_FocusFrameHMargin || metric == PM_FocusFrameVMargin)) return 0;
    return QProxyStyle::pixelMetric(metric, option, widget);
  }

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    if (hint == SH_FocusFrame_AboveWidget) return 1;
    auto* mask = qstyleoption_cast<QStyleHintReturnMask*>(data);
    if (hint != SH_FocusFrame_Mask || mask == nullptr) {
      return QProxyStyle::styleHint(hint, option, widget, data);
    }
    mask->region = QRegion(option->rect) - option->rect.adjusted(1, 1, -1, -1);
    return 1;
  }

 private:
  void mark_focus(QWidget* now) {
    auto* area = qobject_cast<QAbstractScrollArea*>(now);
    if (area != nullptr && area->window()->windowType() == Qt::Popup) area = nullptr;
    if (focus_mark_ == nullptr && area != nullptr) focus_mark_ = new QFocusFrame;
    if (focus_mark_ != nullptr) focus_mark_->setWidget(area);
  }

  QPointer<QFocusFrame> focus_mark_;  // may be deleted by the window of its widget
};

QPalette palette_of(Theme theme) {
  const ThemeColours colours = colours_of(theme);
  const bool is_dark = theme == Theme::Dark;
  QPalette palette;
  palette.setColor(QPalette::Window, colours.window);
  palette.setColor(QPalette::WindowText, colours.text);
  palette.setColor(QPalette::Base, colours.base);
  palette.setColor(QPalette::AlternateBase, is_dark ? QColor(0x26, 0x28, 0x2c) : QColor(0xf3, 0xf4, 0xf6));
  palette.setColor(QPalette::Text, colours.text);
  palette.setColor(QPalette::PlaceholderText, colours.faint_text);
  palette.setColor(QPalette::Button, is_dark ? QColor(0x3a, 0x3d, 0x43) : QColor(0xe9, 0xeb, 0xee));
  palette.setColor(QPalette::ButtonText, colours.text);
  // Fusion draws its lines at bars and tabs in this role.
  palette.setColor(QPalette::Light, is_dark ? colours.line : QColor(0xff, 0xff, 0xff));
  palette.setColor(QPalette::BrightText, colours.error);
  palette.setColor(QPalette::ToolTipBase, is_dark ? QColor(0x45, 0x48, 0x4f) : QColor(0xff, 0xff, 0xff));
  palette.setColor(QPalette::ToolTipText, colours.text);
  palette.setColor(QPalette::Highlight, colours.accent);
  palette.setColor(QPalette::HighlightedText, Qt::black);
  palette.setColor(QPalette::Link, colours.accent);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, is_dark ? QColor(0x84, 0x88, 0x90) : QColor(0x8a, 0x8e, 0x96));
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, colours.line);
  return palette;
}

}  // namespace

ThemeColours colours_of(Theme theme) {
  if (theme == Theme::Dark) {
    return {.window = QColor(0x2d, 0x2f, 0x34),
            .base = QColor(0x1f, 0x21, 0x24),
            .text = QColor(0xe6, 0xe8, 0xeb),
            .faint_text = QColor(0xa3, 0xa8, 0xb0),
            .line = QColor(0x55, 0x59, 0x61),
            .accent = QColor(0xf0, 0x9a, 0x3e),
            .warning = QColor(0xf0, 0xc0, 0x4e),
            .error = QColor(0xff, 0x7a, 0x70)};
  }
  return {.window = QColor(0xf0, 0xf1, 0xf3),
          .base = QColor(0xff, 0xff, 0xff),
          .text = QColor(0x1d, 0x1f, 0x23),
          .faint_text = QColor(0x5d, 0x63, 0x6b),
          .line = QColor(0xb6, 0xba, 0xc1),
          .accent = QColor(0xe0, 0x7b, 0x12),
          .warning = QColor(0x8a, 0x62, 0x00),
          .error = QColor(0xb8, 0x24, 0x1a)};
}

QColor series_colour(Theme theme, int number) {
  // Vermilion, sky blue, bluish green, yellow, blue and reddish purple of Okabe and Ito; on white, yellow and
  // sky blue are darker.
  static constexpr std::array<QRgb, 6> Dark = {0xffe8762d, 0xff56b4e9, 0xff2bb58c,
                                               0xfff0e442, 0xff5c8fe0, 0xffcc79a7};
  static constexpr std::array<QRgb, 6> Light = {0xffd55e00, 0xff2b8cc4, 0xff008f68,
                                                0xffa08a00, 0xff0056a0, 0xffb0558a};
  const auto index = static_cast<std::size_t>(number) % Dark.size();
  return QColor::fromRgb(theme == Theme::Dark ? Dark[index] : Light[index]);
}

void apply(Theme theme, QApplication& application) {
  application.setStyle(new EditorStyle);
  application.setPalette(palette_of(theme));
}

Theme theme_of(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? Theme::Dark : Theme::Light;
}

}  // namespace editor
