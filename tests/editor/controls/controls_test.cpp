#include <QAction>
#include <QApplication>
#include <QColorDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "editor/controls/colour_button.h"
#include "editor/controls/counted.h"
#include "editor/controls/notice_bar.h"
#include "editor/controls/number_box.h"
#include "editor/controls/scaled_slider.h"
#include "editor/controls/search_terms.h"

namespace editor {
namespace {

double read(const char* text, const char* unit = "") {
  const Typed typed = value_of(QString::fromUtf8(text), units_like(unit));
  EXPECT_TRUE(typed.value) << text << ": " << typed.error.toStdString();
  return typed.value.value_or(std::nan(""));
}

TEST(Expression, TakesArithmetic) {
  EXPECT_DOUBLE_EQ(read("0.2*3"), 0.2 * 3);
  EXPECT_DOUBLE_EQ(read(" -1e-3 "), -1e-3);
  EXPECT_DOUBLE_EQ(read("sqrt(2)/pi"), std::sqrt(2) / std::numbers::pi);
  EXPECT_DOUBLE_EQ(read("2^10 - (3 + 4)"), 1017);
}

TEST(SearchTerms, HaveSynonymsFromOtherPrograms) {
  for (const auto& [query, text] :
       {std::pair("merge", "Append..."), std::pair("MERG", "Append..."),
        std::pair("glossy", "sx: the roughness along x"), std::pair("bounces", "BPT_Depth: depth"),
        std::pair("merge model", "Append a scene or a model"), std::pair("", "anything")}) {
    EXPECT_TRUE(matches_search(text, query)) << query;
  }
  for (const auto& [query, text] :
       {std::pair("merge", "Open..."), std::pair("me", "Append..."),
        std::pair("merge image", "Append a scene or a model"), std::pair("move", "Expand")}) {
    EXPECT_FALSE(matches_search(text, query)) << query;
  }
}

TEST(Counted, SaysHowMany) {
  EXPECT_EQ(counted(0, "1 face", "%1 faces"), "0 faces");
  EXPECT_EQ(counted(1, "1 face", "%1 faces"), "1 face");
  EXPECT_EQ(counted(9999, "1 face", "%1 faces"), "9999 faces");
  EXPECT_EQ(counted(1234567, "1 face", "%1 faces"), QString::fromUtf8("1\u00a0234\u00a0567 faces"));
}

TEST(Expression, TakesUnits) {
  EXPECT_DOUBLE_EQ(read("20deg", "rad"), std::numbers::pi / 9);
  EXPECT_DOUBLE_EQ(read("20\u00b0", "rad"), std::numbers::pi / 9);
  EXPECT_DOUBLE_EQ(read("0.5 rad + 90deg", "rad"), 0.5 + std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(read("0.5", "rad"), 0.5);
  EXPECT_DOUBLE_EQ(read("2kW", "W"), 2000);
  EXPECT_DOUBLE_EQ(read("0.4um", "nm"), 400);
  EXPECT_DOUBLE_EQ(read("3 cd", "cd"), 3);
}

TEST(Expression, SaysWhatIsWrong) {
  for (const char* text : {"", "  ", "2+", "abc", "3 deg", "1/0", "(1", "0,5", "1;2", "nan"}) {
    const Typed typed = value_of(text, {});
    EXPECT_FALSE(typed.value) << text;
    EXPECT_FALSE(typed.error.isEmpty()) << text;
  }
  EXPECT_TRUE(value_of("0,5", {}).error.contains("point"));
}

TEST(NumberBox, EmitsOnceWhatIsTyped) {
  NumberBox box;
  box.set_unit("rad");
  box.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&box));
  QSignalSpy edited(&box, &NumberBox::edited);
  box.selectAll();
  QTest::keyClicks(&box, "90deg");
  QTest::keyClick(&box, Qt::Key_Return);
  ASSERT_EQ(edited.count(), 1);
  EXPECT_DOUBLE_EQ(edited[0][0].toDouble(), std::numbers::pi / 2);
  EXPECT_EQ(box.text(), "1.570796 rad");
  QTest::keyClick(&box, Qt::Key_Return);
  EXPECT_EQ(edited.count(), 1);
}

TEST(NumberBox, TakesWhatIsTypedBeforeAShortcut) {
  QWidget window;
  NumberBox box(&window);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  box.setFocus();
  double value_then = 0;
  for (const QKeySequence& keys : {QKeySequence("Ctrl+S"), QKeySequence("F6"), QKeySequence("Alt+3")}) {
    auto* action = new QAction(&window);
    action->setShortcut(keys);
    QObject::connect(action, &QAction::triggered, &box, [&] { value_then = box.value(); });
    window.addAction(action);
  }
  QSignalSpy edited(&box, &NumberBox::edited);
  const auto type = [&box](const char* text, Qt::Key key, Qt::KeyboardModifiers modifiers) {
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, key, modifiers);
  };
  type("2*3", Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(value_then, 6);
  type("7", Qt::Key_F6, {});
  EXPECT_EQ(value_then, 7);
  type("8", Qt::Key_3, Qt::AltModifier);
  EXPECT_EQ(value_then, 8);
  EXPECT_EQ(edited.count(), 3);
}

TEST(NumberBox, KeepsWhatIsTypedWhileItsTextIsEdited) {
  NumberBox box;
  box.show();
  box.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&box));
  QSignalSpy edited(&box, &NumberBox::edited);
  box.selectAll();
  QTest::keyClicks(&box, "12");
  QTest::keyClick(&box, Qt::Key_Control, Qt::ControlModifier);
  for (const Qt::Key key : {Qt::Key_A, Qt::Key_C, Qt::Key_X, Qt::Key_V, Qt::Key_Z, Qt::Key_Y}) {
    QTest::keyClick(&box, key, Qt::ControlModifier);
  }
  QTest::keyClick(&box, Qt::Key_3);
  EXPECT_EQ(edited.count(), 0);
  QTest::keyClick(&box, Qt::Key_Return);
  EXPECT_EQ(edited.count(), 1);
}

TEST(NumberBox, KeepsAndExplainsWhatIsNoNumber) {
  NumberBox box;
  box.set_value(0.25);
  box.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&box));
  QSignalSpy edited(&box, &NumberBox::edited);
  QSignalSpy failed(&box, &NumberBox::failed);
  box.selectAll();
  QTest::keyClicks(&box, "2**");
  QTest::keyClick(&box, Qt::Key_Return);
  EXPECT_EQ(failed.count(), 1);
  EXPECT_EQ(edited.count(), 0);
  EXPECT_EQ(box.text(), "2**");
  EXPECT_FALSE(box.message().isEmpty());
  EXPECT_TRUE(box.toolTip().contains(box.message()));
  QTest::keyClick(&box, Qt::Key_Escape);
  EXPECT_EQ(box.text(), "0.25");
  EXPECT_TRUE(box.message().isEmpty());
}

TEST(NumberBox, StepsLiveAndFinishesOnce) {
  NumberBox box;
  box.set_range(0, 1);
  box.set_value(0.5);
  box.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&box));
  QSignalSpy changing(&box, &NumberBox::changing);
  QSignalSpy edited(&box, &NumberBox::edited);
  for (int i = 0; i < 3; ++i) QTest::keyClick(&box, Qt::Key_Up);
  EXPECT_EQ(changing.count(), 3);
  EXPECT_NEAR(box.value(), 0.53, 1e-12);
  ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() > 0; }));
  EXPECT_EQ(edited.count(), 1);
  for (int i = 0; i < 9; ++i) QTest::keyClick(&box, Qt::Key_PageUp);
  EXPECT_DOUBLE_EQ(box.value(), 1);
}

TEST(NumberBox, ShowsMixedValues) {
  NumberBox box;
  box.set_mixed();
  EXPECT_FALSE(box.has_value());
  EXPECT_EQ(box.text(), "");
  EXPECT_EQ(box.findChild<QLineEdit*>()->placeholderText(), "mixed");
  box.set_value(0);
  EXPECT_EQ(box.text(), "0");
}

TEST(NumberBox, KeepsTheTextOfAFile) {
  NumberBox box;
  box.set_whole(true);
  box.set_range(0, 4294967295.0);
  box.set_default("7");
  box.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&box));
  box.set_text("1e3");
  EXPECT_EQ(box.text(), "1e3");
  EXPECT_EQ(box.value(), 1000);
  QTest::keyClick(&box, Qt::Key_Up);
  EXPECT_EQ(box.text(), "1001");
  box.set_text("4294967294");
  QTest::keyClick(&box, Qt::Key_Up);
  QTest::keyClick(&box, Qt::Key_Up);
  EXPECT_EQ(box.text(), "4294967295");
  box.set_text("many");
  EXPECT_EQ(box.text(), "many");
  EXPECT_FALSE(box.has_value());
  QSignalSpy cleared(&box, &NumberBox::cleared);
  box.selectAll();
  QTest::keyClick(&box, Qt::Key_Delete);
  QTest::keyClick(&box, Qt::Key_Return);
  EXPECT_EQ(cleared.count(), 1);
  EXPECT_TRUE(box.message().isEmpty());
  QTest::keyClick(&box, Qt::Key_Up);
  EXPECT_EQ(box.text(), "8") << "from the default";
}

TEST(NumberBox, ShowsFewerDigitsWhereItIsNarrow) {
  QWidget window;
  auto* other = new QLineEdit(&window);
  auto* box = new NumberBox(&window);
  box->setGeometry(0, 40, 64, 24);
  box->set_value(0.5305165);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  QApplication::setActiveWindow(&window);  // there is no window manager that would
  other->setFocus();
  EXPECT_LT(box->text().size(), 9);
  EXPECT_TRUE(box->text().startsWith("0.53"));
  EXPECT_EQ(box->full_text(), "0.5305165");
  QSignalSpy edited(box, &NumberBox::edited);
  box->setFocus();
  EXPECT_EQ(box->text(), "0.5305165");
  other->setFocus();
  EXPECT_EQ(edited.count(), 0) << "nobody typed";
  EXPECT_EQ(box->value(), 0.5305165);
  box->resize(160, 24);
  EXPECT_EQ(box->text(), "0.5305165");
}

TEST(NumberBox, RefusesWhatIsOutOfRangeIfItIsStrict) {
  NumberBox box;
  box.set_unit("deg");
  box.set_range(0, 180);
  box.set_value(30);
  for (const bool is_strict : {true, false}) {
    box.set_strict(is_strict);
    QSignalSpy edited(&box, &NumberBox::edited);
    box.findChild<QLineEdit*>()->setText("200");
    box.commit();
    EXPECT_EQ(edited.count(), is_strict ? 0 : 1);
    EXPECT_EQ(box.message(), is_strict ? "Range: 0° to 180°." : "");
    EXPECT_EQ(box.value(), is_strict ? 30 : 200);
  }
}

TEST(NumberBox, GoesOnSteppingWhereItsNumberComesBackAsAFloat) {
  NumberBox box;
  box.set_range(0, 1);
  box.set_value(0.5);
  QObject::connect(&box, &NumberBox::changing,
                   [&box](double value) { box.set_value(static_cast<double>(static_cast<float>(value))); });
  QSignalSpy edited(&box, &NumberBox::edited);
  box.stepUp();
  ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() > 0; }));
  EXPECT_EQ(box.text(), "0.51");
}

TEST(ScaledSlider, GoesThroughItsRange) {
  for (const double minimum : {0.0, 1e-4, -10.0}) {
    for (const SliderScale scale : {SliderScale::Linear, SliderScale::Logarithmic}) {
      ScaledSlider slider;
      slider.set_range(minimum, 1e6, scale);
      for (const double number : {minimum, 1.0, 250.0, 1e6}) {
        slider.set_number(number);
        EXPECT_DOUBLE_EQ(slider.number(), number);
      }
      double before = -INFINITY;
      for (int position = 0; position <= slider.maximum(); position += 10) {
        slider.setValue(position);
        EXPECT_GE(slider.number(), before);
        before = slider.number();
      }
      EXPECT_DOUBLE_EQ(before, 1e6);
    }
  }
}

TEST(ScaledSlider, ReachesEachWholeNumberByKeys) {
  for (const SliderScale scale : {SliderScale::Linear, SliderScale::Logarithmic}) {
    ScaledSlider slider;
    slider.set_whole(true);
    slider.set_range(1, 12, scale);
    slider.set_number(1);
    // As the form does, which shows the number of the state.
    QObject::connect(&slider, &ScaledSlider::changing, &slider,
                     [&](double number) { slider.set_number(number); });
    for (int number = 2; number <= 12; ++number) {
      QTest::keyClick(&slider, Qt::Key_Right);
      EXPECT_EQ(slider.number(), number);
    }
    QTest::keyClick(&slider, Qt::Key_Right);
    EXPECT_EQ(slider.number(), 12);
    QTest::keyClick(&slider, Qt::Key_Left);
    EXPECT_EQ(slider.number(), 11);
  }
}

TEST(ScaledSlider, IsLiveWhileDraggedAndFinishesOnce) {
  ScaledSlider slider;
  slider.resize(200, 24);
  slider.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&slider));
  QSignalSpy changing(&slider, &ScaledSlider::changing);
  QSignalSpy edited(&slider, &ScaledSlider::edited);
  QTest::mousePress(&slider, Qt::LeftButton, {}, {40, 12});
  for (int x = 50; x <= 150; x += 10) QTest::mouseMove(&slider, {x, 12});
  EXPECT_GE(changing.count(), 8);
  EXPECT_EQ(edited.count(), 0);
  QTest::mouseRelease(&slider, Qt::LeftButton, {}, {150, 12});
  ASSERT_EQ(edited.count(), 1);
  EXPECT_NEAR(edited[0][0].toDouble(), 0.75, 0.05);
}

TEST(ColourButton, KeepsLinearValues) {
  for (const float value : {0.0F, 0.002F, 0.18F, 0.5F, 1.0F}) {
    const grf::Colour colour(value, 1 - value, 0.25F);
    const grf::Colour back = linear_colour(shown_colour(colour));
    EXPECT_TRUE(back.equalWithAbsError(colour, 1e-4F)) << value;
  }
  EXPECT_NEAR(shown_colour(grf::Colour(0.18F)).redF(), 0.4613F, 1e-3F);
}

TEST(ColourButton, ChoosesColoursBrighterThanScreensShow) {
  EXPECT_EQ(shown_colour({10, 5, 0}), shown_colour({1, 0.5F, 0}));
  ColourButton button;
  button.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&button));
  button.set_colour(grf::Colour(10, 5, 0));
  QTest::mouseClick(&button, Qt::LeftButton);
  auto* chooser = button.findChild<QColorDialog*>();
  ASSERT_NE(chooser, nullptr);
  QSignalSpy edited(&button, &ColourButton::edited);
  chooser->setCurrentColor(shown_colour({0, 1, 0}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return edited.count() > 0; }));
  EXPECT_TRUE(button.colour()->equalWithAbsError({0, 10, 0}, 1e-3F));
}

/// Returns the x coordinate of a character of a document, in pixels.
double place_of(const QTextDocument& document, qsizetype character) {
  const QTextBlock block = document.findBlock(static_cast<int>(character));
  const int in_block = static_cast<int>(character) - block.position();
  const QTextLine line = block.layout()->lineForTextPosition(in_block);
  return line.cursorToX(in_block);
}

TEST(NoticeBar, HasTheCaretUnderItsCharacterAndEscapesTheText) {
  NoticeBar notice;
  const QString text =
      "a.grf:3:9: error: <b> is no name\n  iiiiii <b> wide WWW\n         ^\nthe next message";
  notice.show_notice(NoticeBar::Kind::Error, text);
  EXPECT_EQ(notice.text(), text);
  QTextDocument shown;
  shown.setHtml(notice.findChild<QLabel*>()->text());
  shown.setTextWidth(1000);
  ASSERT_GT(shown.size().height(), 0);  // lays it out
  const QString plain = shown.toPlainText();
  EXPECT_EQ(plain, text);
  EXPECT_NEAR(place_of(shown, plain.indexOf('^')), place_of(shown, plain.lastIndexOf("<b>")), 0.5);
}

}  // namespace
}  // namespace editor
