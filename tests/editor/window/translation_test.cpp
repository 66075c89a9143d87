// The main window in Spanish.
#include "editor/appearance/translation.h"

#include <QMenu>
#include <QMenuBar>
#include <QTranslator>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/preferences.h"
#include "editor/window/preferences_dialog.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

/// The Spanish translation while it lives.
class SpanishTexts {
 protected:
  SpanishTexts() { EXPECT_TRUE(install_translation(*qApp, "es")); }
  ~SpanishTexts() {
    for (QTranslator* translator : qApp->findChildren<QTranslator*>()) delete translator;
  }
};

class SpanishWindow : private SpanishTexts, public Authoring {};
class EnglishWindow : public Authoring {};

std::string plain(const QAction& action) { return action.text().remove('&').toStdString(); }

/// Two entries of a menu must not have one mnemonic: the second could not be reached by it.
void expect_free_mnemonics(const QList<QAction*>& actions, const std::string& menu) {
  std::map<QString, std::string> owners;
  for (const QAction* action : actions) {
    if (action->menu() != nullptr) expect_free_mnemonics(action->menu()->actions(), plain(*action));
    const QString key = QKeySequence::mnemonic(action->text()).toString();
    if (key.isEmpty()) continue;
    const auto [owner, is_free] = owners.emplace(key, plain(*action));
    EXPECT_TRUE(is_free) << menu << ": " << key.toStdString() << " of " << owner->second << " and "
                         << plain(*action);
  }
}

TEST_F(SpanishWindow, HasMenusAndDocksInSpanish) {
  std::vector<std::string> menus;
  for (const QAction* menu : window_.menuBar()->actions()) {
    if (menu->isVisible()) menus.push_back(plain(*menu));
  }
  EXPECT_THAT(menus, testing::IsSupersetOf({"Archivo", "Edición", "Selección", "Ver", "Objeto", "Escena",
                                            "Render", "Ventana", "Herramientas", "Ayuda"}));
  EXPECT_EQ(test::action(window_, "Deshacer").statusTip(), "Deshace el último cambio");
  EXPECT_EQ(test::action(window_, "Vista previa").shortcut(), QKeySequence("F5"));
  EXPECT_NO_THROW(test::action(window_, "Alámbrico")) << "a display mode";
}

TEST_F(SpanishWindow, HasFreeMnemonics) {
  window_.image_browser();  // which fills the menu of images
  expect_free_mnemonics(window_.menuBar()->actions(), "menus");
}

TEST_F(EnglishWindow, HasFreeMnemonics) {
  window_.image_browser();
  expect_free_mnemonics(window_.menuBar()->actions(), "menus");
}

TEST_F(SpanishWindow, OpensMenusByTheirMnemonics) {
  QTest::keyClick(&window_, Qt::Key_A, Qt::AltModifier);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_NE(menu, nullptr);
  EXPECT_EQ(plain(*menu->menuAction()), "Archivo");
  menu->close();
}

TEST(Languages, FollowTheSystemUnlessChosen) {
  QSettings().clear();
  EXPECT_EQ(Preferences::load().language, "");
  EXPECT_FALSE(install_translation(*qApp, "en")) << "English texts are those of the sources";
  EXPECT_FALSE(install_translation(*qApp, "fi"));
}

}  // namespace
}  // namespace editor
