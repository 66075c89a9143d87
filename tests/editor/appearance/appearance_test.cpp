#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFontMetrics>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QPalette>
#include <QTest>
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"

namespace editor {
namespace {

double luminance(const QColor& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

/// The contrast ratio of WCAG 2.
double contrast(const QColor& a, const QColor& b) {
  const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
  return (lighter + 0.05) / (darker + 0.05);
}

TEST(Theme, TextCanBeRead) {
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    const ThemeColours colours = colours_of(theme);
    for (const QColor& behind : {colours.base, colours.window}) {
      EXPECT_GE(contrast(colours.text, behind), 7);
      EXPECT_GE(contrast(colours.faint_text, behind), 4.5);
      EXPECT_GE(contrast(colours.error, behind), 4.5);
      EXPECT_GE(contrast(colours.warning, behind), 4.5);
    }
    for (int i = 0; i < 6; ++i) EXPECT_GE(contrast(series_colour(theme, i), colours.base), 3);
  }
}

TEST(Theme, IsThatOfThePalette) {
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    apply(theme, *qApp);
    EXPECT_EQ(theme_of(QApplication::palette()), theme);
  }
}

TEST(Theme, EndsTextThatDoesNotFitInAListWithAnEllipsis) {
  apply(Theme::Dark, *qApp);
  const auto picture_with = [](const QString& text) {
    QComboBox list;
    list.addItem(text);
    list.resize(120, 26);
    return list.grab().toImage();
  };
  const QString text = "measured \"a_long_name.binary\"";
  const QImage picture = picture_with(text);
  bool is_elided = false;
  for (int length = 1; QFontMetrics(qApp->font()).horizontalAdvance(text.left(length) + u'…') < 100;
       ++length) {
    is_elided = is_elided || picture_with(text.left(length) + u'…') == picture;
  }
  EXPECT_TRUE(is_elided);
}

TEST(Theme, MarksTheListThatHasTheFocus) {
  apply(Theme::Dark, *qApp);
  QWidget window;
  auto* list = new QListWidget(&window);
  auto* other = new QLineEdit(&window);
  list->setGeometry(10, 10, 100, 60);
  list->setFrameShape(QFrame::NoFrame);
  other->setGeometry(10, 80, 100, 24);
  other->setFocus();
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  const auto edge = [&] { return window.grab().toImage().pixelColor(list->pos() + QPoint(50, 0)); };
  EXPECT_EQ(edge(), colours_of(Theme::Dark).base);
  list->setFocus();
  EXPECT_EQ(edge(), colours_of(Theme::Dark).accent);
  apply(Theme::Dark, *qApp);  // a new style, which marks the focus from the next change on
  other->setFocus();
  EXPECT_EQ(edge(), colours_of(Theme::Dark).base);
  list->setFocus();
  EXPECT_EQ(edge(), colours_of(Theme::Dark).accent);
}

bool has_pixel(const QPixmap& pixmap, const QColor& colour) {
  const QImage image = pixmap.toImage();
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixelColor(x, y) == colour) return true;
    }
  }
  return false;
}

TEST(Icons, AreDrawnInTheColourOfText) {
  icon("open");  // the first request registers the resources
  const QStringList names = QDir(":/icons").entryList();
  EXPECT_FALSE(names.isEmpty());
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    apply(theme, *qApp);
    const QPalette palette = QApplication::palette();
    for (const QString& name : names) {
      const QIcon drawing = icon(QString(name).remove(".svg"));
      EXPECT_TRUE(has_pixel(drawing.pixmap(48), palette.color(QPalette::ButtonText))) << name.toStdString();
      EXPECT_TRUE(
          has_pixel(drawing.pixmap({48, 48}, QIcon::Selected), palette.color(QPalette::HighlightedText)))
          << name.toStdString();
      EXPECT_TRUE(has_pixel(drawing.pixmap({48, 48}, QIcon::Disabled),
                            palette.color(QPalette::Disabled, QPalette::ButtonText)))
          << name.toStdString();
    }
  }
}

}  // namespace
}  // namespace editor
