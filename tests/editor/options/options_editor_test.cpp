// Tests of the render options by a sample's file, the keyboard, and what is saved.
#include "editor/options/options_editor.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include "editor/options/op_text_view.h"
#include "editor/options/option_field.h"
#include "editor/options/option_row.h"
#include "editor/options/options_form.h"
#include "renderer/options/op_file.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

const options::OptionInfo& option(const char* key) { return *options::find_option(key); }

class Editor : public testing::Test {
 protected:
  Editor() {
    editor_.resize(1120, 800);
    editor_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&editor_));
    QApplication::setActiveWindow(&editor_);  // there is no window manager that would
  }

  void open(const std::string& text) {
    ASSERT_TRUE(editor_.open(QString::fromStdString(folder_.add("test.op", text))));
  }

  std::string text() { return editor_.document().op_text().text(); }
  OptionField& field(const char* key) { return editor_.form().row_of(option(key))->field(); }
  QWidget* focus(const char* key) {
    editor_.form().go_to(option(key));
    return QApplication::focusWidget();
  }
  void type(const char* key, const QString& words) {
    QWidget* control = focus(key);
    QTest::keyClick(control, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(control, words);
    QTest::keyClick(control, Qt::Key_Return);
  }
  void choose(const char* key, const QString& word) {
    auto* list = field(key).findChild<QComboBox*>();
    QTest::keyClicks(list, word);
    QTest::keyClick(list, Qt::Key_Return);
  }
  QString message(int row) { return editor_.messages().item(row)->text(); }

  test::TemporaryFolder folder_;
  OptionsEditor editor_;
};

TEST_F(Editor, EditsASampleAndKeepsTheRest) {
  const std::string sample = test::bytes_of(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.op");
  open(sample);
  QWidget* depth = focus("BPT_Depth");
  QTest::keyClick(depth, Qt::Key_Up);
  QTest::keyClick(depth, Qt::Key_Up);
  std::string expected = sample;
  expected.replace(expected.find("BPT_Depth             8"), 23, "BPT_Depth             10");
  EXPECT_EQ(text(), expected);

  EXPECT_FALSE(field("BPT_QT_avgnmax").isEnabled());
  choose("BPT_Pdf_Name", "Disk");
  EXPECT_TRUE(field("BPT_QT_avgnmax").isEnabled());
  EXPECT_FALSE(field("BPT_Pdf_Factors_JK").isEnabled());
  EXPECT_TRUE(field("BPT_Pdf_Factors_JK").toolTip().contains("the scheme 'adaptive' does not use it"));
  type("BPT_QT_avgnmax", "1.7");
  expected += "BPT_Pdf_Name          Disk\nBPT_QT_avgnmax        1.7\n";
  EXPECT_EQ(text(), expected);

  ASSERT_TRUE(editor_.save());
  EXPECT_EQ(test::bytes_of(folder_.path("test.op")), expected);
  grf::Diagnostics diagnostics;
  const auto read = options::read_op_file(folder_.path("test.op"), diagnostics);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->depth, 10);
  EXPECT_EQ(read->mean_tries, 1.7F);
  EXPECT_EQ(*read, *editor_.document().render_options());
}

TEST_F(Editor, UndoesAllAndRedoesAll) {
  const std::string before = "Scene a.grf # the scene\nDepth 7 # deep\n";
  open(before);
  type("BPT_Depth", "12");
  choose("BPT_Integrator", "naive");
  type("BPT_Viewer", "3");
  const std::string after = text();
  QUndoStack& stack = editor_.document().undo_stack();
  EXPECT_EQ(stack.count(), 3) << "typing two digits is one step";
  EXPECT_NE(after.find("BPT_Viewer 3 0 0"), std::string::npos) << after;
  while (stack.canUndo()) stack.undo();
  EXPECT_EQ(text(), before);
  EXPECT_TRUE(stack.isClean());
  while (stack.canRedo()) stack.redo();
  EXPECT_EQ(text(), after);
}

TEST_F(Editor, NumbersTakeArithmeticAndSavingTakesWhatIsTyped) {
  open("Scene a.grf\nBPT_Seed 4294967295\n");
  type("BPT_Depth", "2*3");
  EXPECT_EQ(text(), "Scene a.grf\nBPT_Seed 4294967295\nBPT_Depth 6\n");
  QWidget* control = focus("BPT_Depth");
  QTest::keyClick(control, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(control, "9");
  ASSERT_TRUE(editor_.save());
  EXPECT_EQ(test::bytes_of(folder_.path("test.op")), "Scene a.grf\nBPT_Seed 4294967295\nBPT_Depth 9\n");
  QTest::keyClick(control, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(control, Qt::Key_Delete);
  QTest::keyClick(control, Qt::Key_Return);
  EXPECT_EQ(text(), "Scene a.grf\nBPT_Seed 4294967295\n");
}

TEST_F(Editor, TextAndFormAreOne) {
  open("Scene a.grf\r\n# mine\r\n");
  auto* view = editor_.findChild<OpTextView*>();
  view->moveCursor(QTextCursor::End);
  QTest::keyClicks(view, "Depth 3");
  EXPECT_EQ(text(), "Scene a.grf\r\n# mine\r\nDepth 3");
  EXPECT_EQ(editor_.document().render_options()->depth, 3);
  type("BPT_Seed", "9");
  EXPECT_EQ(view->toPlainText(), "Scene a.grf\n# mine\nDepth 3\nBPT_Seed 9");
}

TEST_F(Editor, MessagesAreThoseOfBptAndLeadToControls) {
  open("Scene a.grf\nDepth -1\nBPT_Dept 4\n");
  EXPECT_EQ(editor_.document().render_options(), std::nullopt);
  EXPECT_EQ(message(0), "Line 2: BPT_Depth: found '-1', expected a whole number from 0 to 2147483647");
  EXPECT_EQ(message(1), "Line 3: unknown option 'BPT_Dept': did you mean 'BPT_Depth'?");
  const auto click = [&](int row) {
    QListWidget& list = editor_.messages();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(row)).center());
  };
  click(0);
  EXPECT_TRUE(field("BPT_Depth").isAncestorOf(QApplication::focusWidget()));
  click(1);
  auto* view = editor_.findChild<OpTextView*>();
  EXPECT_EQ(QApplication::focusWidget(), view);
  EXPECT_EQ(view->textCursor().blockNumber(), 2);
  open("Depth 4\n");
  EXPECT_TRUE(message(0).startsWith("no scene is given"));
  click(0);
  EXPECT_TRUE(field("BPT_Scene").isAncestorOf(QApplication::focusWidget()));
  open("Scene a.grf\nQT_avgnmax 3\n");
  EXPECT_TRUE(message(0).startsWith("Line 2: BPT_QT_avgnmax has no effect"));
}

TEST_F(Editor, SearchFindsByMeaning) {
  editor_.form().search()->setFocus();
  QTest::keyClicks(editor_.form().search(), "scattering");
  EXPECT_FALSE(editor_.form().row_of(option("BPT_Depth"))->isHidden());
  EXPECT_TRUE(editor_.form().row_of(option("BPT_Seed"))->isHidden());
  editor_.form().go_to(option("BPT_Seed"));
  EXPECT_FALSE(editor_.form().row_of(option("BPT_Seed"))->isHidden());
  editor_.form().search()->setText("spp");  // a synonym
  EXPECT_FALSE(editor_.form().row_of(option("BPT_Samples"))->isHidden());
  EXPECT_TRUE(editor_.form().row_of(option("BPT_Seed"))->isHidden());
}

TEST_F(Editor, TellsOptionsThatAreRight) {
  open("Scene a.grf\n");
  EXPECT_EQ(editor_.document().valid_options().depth, options::RenderOptions().depth);
  editor_.document().set_plain_text("Scene a.grf\nDepth x\n");
  EXPECT_FALSE(editor_.document().render_options());
  EXPECT_EQ(editor_.document().valid_options().depth, options::RenderOptions().depth);
  type("BPT_Depth", "2");
  ASSERT_TRUE(editor_.document().render_options());
  EXPECT_EQ(editor_.document().valid_options().depth, 2);
  type("BPT_Depth", "5");
  EXPECT_EQ(text(), "Scene a.grf\n") << "its default";
}

// Each kind of value has a reachable control with an accessible name.
TEST_F(Editor, EveryOptionHasAControl) {
  for (const options::OptionInfo& info : options::option_table()) {
    const OptionRow* row = editor_.form().row_of(info);
    ASSERT_NE(row, nullptr) << info.key;
    QWidget* control = const_cast<OptionRow*>(row)->field().focusProxy();
    ASSERT_NE(control, nullptr) << info.key;
    EXPECT_TRUE(control->accessibleName().contains(QString::fromUtf8(info.key.data()))) << info.key;
    EXPECT_FALSE(legal_values(info).isEmpty()) << info.key;
  }
}

}  // namespace
}  // namespace editor
