// Changes preferences through the dialog, and sees their effects in the window.
#include "editor/document/preferences.h"

#include <QComboBox>
#include <QDirIterator>
#include <QDockWidget>
#include <QFile>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTreeWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/appearance/theme.h"
#include "editor/controls/number_box.h"
#include "editor/document/import_options.h"
#include "editor/document/light_edits.h"
#include "editor/rendering/render_panel.h"
#include "editor/window/docks.h"
#include "editor/window/preferences_dialog.h"
#include "tests/editor/window/accessibility.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using test::Minute;

const std::string Triangle =
    "begin mesh \"tile\" begin vertexs (0,0,0) (1,0,0) (0,2,0) end vertexs begin faces (0,1,2) end faces end "
    "mesh\n";

class PreferencesInTheWindow : public Authoring {
 protected:
  ~PreferencesInTheWindow() override { apply(Theme::Dark, *qApp); }

  PreferencesDialog& dialog() {
    if (window_.findChild<PreferencesDialog*>() == nullptr) {
      QTest::keyClick(&window_, Qt::Key_Comma, Qt::ControlModifier);
    }
    return *window_.findChild<PreferencesDialog*>();
  }
  void show_page(int page) { dialog().findChild<QTabWidget*>()->setCurrentIndex(page); }

  /// Chooses an entry of a list by keyboard.
  void choose(const QString& name, int entry) {
    show_page(0);
    auto& list = test::named<QComboBox>(dialog(), name);
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Home);
    for (int i = 0; i < entry; ++i) QTest::keyClick(&list, Qt::Key_Down);
  }
  void type(NumberBox& box, const QString& text) {
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
  }
  void type(const QString& name, const QString& text) {
    show_page(1);
    type(test::named<NumberBox>(dialog(), name), text);
  }

  void open_triangle() { open(QString::fromStdString(folder_.add("tile.grf", Triangle))); }
  void edit(double height) { document().replace("Edit", add_observer(document().scene(), {0, height, 5})); }
};

TEST_F(PreferencesInTheWindow, ShowLengthsInAUnitAndKeepTheFileInMetres) {
  open_triangle();
  document().select_objects({document().objects().instances->front().path});
  Docks::show(window_.findChild<QDockWidget*>("object"));
  auto& position = test::named<NumberBox>(window_, "Position, x");
  EXPECT_EQ(position.full_text(), "0 m");
  type(position, "0.25");
  choose("Unit of length", 1);
  EXPECT_EQ(position.full_text(), "25 cm");
  type(position, "50");
  const auto x = [this] { return document().objects().mesh_bounds.min.x; };
  EXPECT_EQ(x(), 0.5);
  type(position, "2 in");
  EXPECT_NEAR(x(), 0.0508, 1e-8);
  choose("Unit of length", 2);
  EXPECT_EQ(position.full_text(), "50.8 mm");
  const auto labels = window_.findChild<QDockWidget*>("object")->findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(
      labels, [](const QLabel* label) { return label->text() == QString("1000 × 2000 × 0 mm"); }));
  choose("Unit of length", 3);
  EXPECT_EQ(position.full_text(), "2 in");
  EXPECT_EQ(Preferences::load().length_unit, "in");
}

TEST_F(PreferencesInTheWindow, TurnModelsToTheUpAxisUnlessTheirTypeHasItsOwn) {
  choose("Up axis of imports", 1);
  set_asks_for_import_options("obj", false);
  open(QString::fromStdString(folder_.add("a.obj", "v 0 0 0\nv 1 0 0\nv 0 0 2\nf 1 2 3\n")));
  EXPECT_NEAR(document().objects().mesh_bounds.size().y, 2, 1e-6) << "z became y";
  remember_import_options("obj", {});
  document().clear();  // an unsaved scene would be asked for
  open(QString::fromStdString(folder_.add("b.obj", "v 0 0 0\nv 1 0 0\nv 0 0 2\nf 1 2 3\n")));
  EXPECT_EQ(document().objects().mesh_bounds.size().y, 0) << "the type's own axis is y";
}

TEST_F(PreferencesInTheWindow, ChangeShortcutsButNotToThoseOfOthers) {
  show_page(2);
  auto& list = test::named<QTreeWidget>(dialog(), "Actions");
  const auto row = [&list](const QString& name) { return list.findItems(name, Qt::MatchExactly).value(0); };
  auto& keys = test::named<QKeySequenceEdit>(dialog(), "New shortcut");
  const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers) {
    keys.setFocus();
    QSignalSpy done(&keys, &QKeySequenceEdit::editingFinished);
    QTest::keyClick(&keys, key, modifiers);
    ASSERT_TRUE(!done.empty() || done.wait(Minute));
  };
  const QAction& images = test::action(window_, "Images");
  ASSERT_NE(row("Window > Images"), nullptr);
  list.setCurrentItem(row("Window > Images"));
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(images.shortcut(), QKeySequence("Ctrl+7")) << "Ctrl+S saves";
  const auto problems = dialog().findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(
      problems, [](const QLabel* label) { return label->isVisible() && label->text().contains("Save"); }));
  press(Qt::Key_F8, Qt::ControlModifier);
  EXPECT_EQ(images.shortcut(), QKeySequence("Ctrl+F8"));
  EXPECT_TRUE(images.toolTip().endsWith("(Ctrl+F8)"));
  EXPECT_EQ(row("Window > Images")->text(1), "Ctrl+F8");

  const MainWindow next(path("other sessions"));
  EXPECT_EQ(test::action(next, "Images").shortcut(), QKeySequence("Ctrl+F8")) << "it is remembered";
  test::action(window_, "Keyboard shortcuts").trigger();
  const auto listed = window_.findChild<QDialog*>("shortcuts")
                          ->findChild<QTreeWidget*>()
                          ->findItems("Ctrl+F8", Qt::MatchExactly | Qt::MatchRecursive);
  ASSERT_EQ(listed.size(), 1);
  EXPECT_EQ(listed.front()->text(1), "Images");

  window_.findChild<QDialog*>("shortcuts")->close();
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitFor([this] { return QApplication::activeWindow() == &window_; }, Minute));
  window_.view().setFocus();
  QTest::keyClick(&window_.view(), Qt::Key_F8, Qt::ControlModifier);
  EXPECT_TRUE(QTest::qWaitFor([this] { return !window_.view().isVisible(); }, 5000)) << "images are shown";
  for (QPushButton* button : dialog().findChildren<QPushButton*>()) {
    if (button->text().remove('&') == "Reset all") button->click();
  }
  EXPECT_EQ(images.shortcut(), QKeySequence("Ctrl+7"));
}

TEST_F(PreferencesInTheWindow, ChangeTheTheme) {
  choose("Theme", 1);
  EXPECT_TRUE(QTest::qWaitFor([this] { return theme_of(window_.palette()) == Theme::Light; }, 5000));
  EXPECT_EQ(Preferences::load().theme, "light");
}

TEST_F(PreferencesInTheWindow, LimitTheUndoSteps) {
  open_triangle();
  type("Undo steps", "2");
  open_triangle();  // the limit holds from the next scene on
  std::vector<std::uint64_t> revisions;
  for (int i = 0; i < 4; ++i) {
    edit(i);
    revisions.push_back(document().revision());
  }
  EXPECT_EQ(document().undo_stack().count(), 2);
  document().undo_stack().undo();
  EXPECT_EQ(document().revision(), revisions[2]);
  document().undo_stack().undo();
  EXPECT_EQ(document().revision(), revisions[1]);
  EXPECT_FALSE(document().undo_stack().canUndo());
  EXPECT_TRUE(document().is_modified()) << "two steps cannot be undone";
  document().undo_stack().redo();
  document().undo_stack().redo();
  EXPECT_EQ(document().revision(), revisions[3]);
}

TEST_F(PreferencesInTheWindow, LimitTheThreadsOfPreviewsAndRenders) {
  open_triangle();
  type("Threads", "1");
  QSignalSpy finished(&window_.render_panel().final_render(), &FinalRender::finished);
  window_.render_panel().render_action()->trigger();
  ASSERT_TRUE(finished.wait(Minute));
  // OpenEXR: the attribute's name, its type, the number of its letters and they themselves.
  const std::string attribute("BPT_Threads\0string\0\1\0\0\0001", 24);
  QFile image(path("tile.exr"));
  ASSERT_TRUE(image.open(QIODevice::ReadOnly));
  EXPECT_THAT(image.readAll().toStdString(), testing::HasSubstr(attribute));
}

TEST_F(PreferencesInTheWindow, DelayTheAutosave) {
  const auto is_autosaved = [this] {
    QDirIterator files(path("sessions"), {"*.grf"}, QDir::Files, QDirIterator::Subdirectories);
    return files.hasNext();
  };
  open_triangle();
  type("Autosave after", "30");
  edit(1);
  QTest::qWait(5000);  // the default is 3 s
  EXPECT_FALSE(is_autosaved());
  document().undo_stack().undo();
  type("Autosave after", "1");
  edit(2);
  EXPECT_TRUE(QTest::qWaitFor(is_autosaved, 20'000));
}

class PreferencesAccessibility : public Accessibility {};

TEST_F(PreferencesAccessibility, HasNamesTipsAndATabOrder) {
  const test::TemporaryFolder folder;
  MainWindow window(QString::fromStdString(folder.path("sessions")));
  window.show();
  test::action(window, "Preferences").trigger();
  auto& dialog = *window.findChild<PreferencesDialog*>();
  check_tabs(dialog);
}

}  // namespace
}  // namespace editor
