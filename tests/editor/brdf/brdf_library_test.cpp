#include "editor/brdf/brdf_library.h"

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <gmock/gmock.h>

#include "editor/appearance/theme.h"
#include "editor/brdf/picture_tiles.h"
#include "editor/document/brdf_mime.h"
#include "grf/read.h"
#include "renderer/reflectance/presets.h"
#include "tests/editor/brdf/brdf_of.h"

namespace editor {
namespace {

QToolButton* button_of(const QWidget& widget, const QString& name) {
  for (QToolButton* button : widget.findChildren<QToolButton*>()) {
    if (button->accessibleName() == name) return button;
  }
  return nullptr;
}

int row_of(const LibraryList& list, const QString& name) {
  for (std::size_t i = 0; i < list.entries().size(); ++i) {
    if (list.entries()[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

TEST(LibraryFolder, KeepsBrdfsAsGrfText) {
  const QTemporaryDir home;
  const LibraryFolder folder(home.filePath("brdfs"));
  const grf::BrdfModel ward = brdf_model("ward sx=0.1 kd=(0.1, 0.2, 0.3)");
  EXPECT_EQ(folder.add("red", ward), "");
  EXPECT_EQ(folder.free_name("red"), "red 2");
  EXPECT_EQ(folder.free_name("a/b"), "a-b");
  std::vector<QString> problems;
  ASSERT_EQ(folder.files(problems).size(), 1U);
  EXPECT_EQ(folder.files(problems)[0].brdf, ward);
  EXPECT_EQ(folder.rename("red", "blue"), "");
  EXPECT_EQ(folder.files(problems)[0].name, "blue");
  EXPECT_NE(folder.rename("none", "other"), "");
  QFile bad(home.filePath("brdfs/bad.brdf"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("ward sx=");
  bad.close();
  EXPECT_EQ(folder.files(problems).size(), 1U);
  EXPECT_EQ(problems.size(), 1U);
  grf::BrdfModel sum;
  sum.keyword = "combine";
  sum.terms = {{1, {"clay", {}}}};
  EXPECT_NE(folder.add("sum", sum), "");
}

TEST(BrdfLibrary, ShowsPresetsWithPictures) {
  BrdfLibrary library;
  library.resize(360, 400);
  library.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&library));
  std::size_t presets = 0;
  for (const auto& table : reflectance::preset_tables()) presets += table.presets.size();
  EXPECT_GE(library.list().entries().size(), presets);
  const int ward = row_of(library.list(), "ward");
  ASSERT_GE(ward, 0);
  library.list().scrollToItem(library.list().item(ward));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !library.is_busy(); }, 60000));
  const QImage picture = library.list().item(ward)->icon().pixmap(64).toImage();
  EXPECT_GT(qAlpha(picture.pixel(picture.width() / 2, picture.height() / 2)), 0);
}

/// The colour in the middle of an entry's picture, after it was made.
QColor middle_of(BrdfLibrary& library, const QString& name) {
  const int row = row_of(library.list(), name);
  if (row < 0 || !QTest::qWaitFor([&] { return !library.is_busy(); }, 60000)) return {};
  const QImage picture = library.list().item(row)->icon().pixmap(64).toImage();
  return picture.pixelColor(picture.width() / 2, picture.height() / 2);
}

TEST(BrdfLibrary, MakesPicturesOfWhatIsInSight) {
  BrdfLibrary library;
  library.resize(360, 400);
  library.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&library));
  const int last = library.list().count() - 1;
  const QString name = library.list().entries()[static_cast<std::size_t>(last)].name;
  EXPECT_EQ(middle_of(library, name).alpha(), 0) << "below what is shown";
  EXPECT_GT(middle_of(library, library.list().entries()[0].name).alpha(), 0);
  library.list().scrollToBottom();
  EXPECT_TRUE(QTest::qWaitFor([&] { return middle_of(library, name).alpha() > 0; }, 60000));
}

TEST(BrdfLibrary, PicturesFollowTheBrdfsThatTheyCombine) {
  BrdfLibrary library;
  library.resize(360, 400);
  library.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&library));
  grf::BrdfModel whole;
  whole.keyword = "combine";
  whole.terms = {{1, {"part", {}}}};
  const auto define = [&](const char* part) {
    library.set_definitions({{"part", brdf_model(part), {}, {}}, {"whole", whole, {}, {}}});
  };
  define("diffuse kd=(0.8, 0, 0)");
  EXPECT_TRUE(QTest::qWaitFor([&] { return middle_of(library, "whole").red() > 0; }, 60000));
  EXPECT_EQ(middle_of(library, "whole").blue(), 0);
  define("diffuse kd=(0, 0, 0.8)");
  EXPECT_TRUE(QTest::qWaitFor([&] { return middle_of(library, "whole").blue() > 0; }, 60000));
  EXPECT_EQ(middle_of(library, "whole").red(), 0);
}

TEST(BrdfLibrary, PicturesStandOutFromTheirTiles) {
  BrdfLibrary library;
  library.set_definitions({{"white", brdf_model("diffuse kd=1"), {}, {}}});
  library.resize(360, 400);
  library.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&library));
  LibraryList& list = library.list();
  const int row = row_of(list, "white");
  list.setCurrentRow(row);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !library.is_busy(); }, 60000));
  const QIcon icon = list.item(row)->icon();
  EXPECT_EQ(icon.pixmap(64, QIcon::Selected).toImage(), icon.pixmap(64).toImage()) << "no colour of others";
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    apply(theme, *qApp);
    const QColor tile = tile_colour(library.palette());
    EXPECT_GT(std::abs(tile.lightness() - library.palette().color(QPalette::Base).lightness()), 20);
    const auto at = [&](int x, int y) {
      const QImage shown = list.viewport()->grab().toImage();
      const QRect item = list.visualItemRect(list.item(row));
      return shown.pixelColor(item.center().x() + x, item.top() + 34 + y);
    };
    EXPECT_TRUE(QTest::qWaitFor([&] { return at(-28, -28) == tile; }));
    EXPECT_GT(at(0, -10).lightness(), tile.lightness() + 20);
    EXPECT_LT(at(0, -10).lightness(), 250) << "no more than white";
  }
}

TEST(BrdfLibrary, IsSearched) {
  BrdfLibrary library;
  auto* search = library.findChild<QLineEdit*>();
  library.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&library));
  QTest::keyClicks(search, "copp");
  int shown = 0;
  for (int i = 0; i < library.list().count(); ++i) shown += library.list().item(i)->isHidden() ? 0 : 1;
  EXPECT_EQ(shown, 3);
  EXPECT_FALSE(library.list().item(row_of(library.list(), "copper"))->isHidden());
  EXPECT_FALSE(library.list().item(row_of(library.list(), "polished copper"))->isHidden());
  EXPECT_FALSE(library.list().item(row_of(library.list(), "lacquered copper"))->isHidden());
}

TEST(BrdfLibrary, KeepsRenamesAndRemoves) {
  const QTemporaryDir home;
  BrdfLibrary library;
  library.set_folder(home.filePath("mine"));
  library.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&library));
  auto* add = button_of(library, "Save the BRDF to the library");
  EXPECT_FALSE(add->isEnabled());
  EXPECT_FALSE(add->toolTip().isEmpty());
  library.set_current(brdf_model("oren s=0.4"));
  QTest::mouseClick(add, Qt::LeftButton);
  EXPECT_TRUE(QFile::exists(home.filePath("mine/oren.brdf")));
  ASSERT_EQ(library.list().current_entry()->name, "oren");
  library.list().currentItem()->setText("terracotta");
  ASSERT_TRUE(QTest::qWaitFor([&] { return row_of(library.list(), "terracotta") >= 0; }));
  EXPECT_TRUE(QFile::exists(home.filePath("mine/terracotta.brdf")));
  library.list().setCurrentRow(row_of(library.list(), "terracotta"));
  QTest::mouseClick(button_of(library, "Remove"), Qt::LeftButton);
  EXPECT_EQ(row_of(library.list(), "terracotta"), -1);
  EXPECT_FALSE(QFile::exists(home.filePath("mine/terracotta.brdf")));
}

TEST(BrdfLibrary, OpensTheFolderThatWasSetBefore) {
  QSettings().clear();
  QTemporaryDir home;
  const LibraryFolder folder(home.filePath("mine"));
  ASSERT_EQ(folder.add("terracotta", brdf_model("oren s=0.4")), "");
  EXPECT_EQ(row_of(BrdfLibrary().list(), "terracotta"), -1);
  BrdfLibrary().set_folder(folder.path());
  BrdfLibrary library;
  EXPECT_GE(row_of(library.list(), "terracotta"), 0);
  ASSERT_EQ(folder.add("sand", brdf_model("oren s=0.3")), "");
  EXPECT_TRUE(QTest::qWaitFor([&] { return row_of(library.list(), "sand") >= 0; })) << "it is watched";
  QSettings().clear();
}

TEST(BrdfLibrary, HasNoFolderWhereThatOfBeforeIsGone) {
  QSettings().clear();
  QTemporaryDir home;
  BrdfLibrary().set_folder(home.path());
  ASSERT_TRUE(home.remove());
  BrdfLibrary library;
  library.set_current(brdf_model("oren s=0.4"));
  const auto* add = button_of(library, "Save the BRDF to the library");
  EXPECT_FALSE(add->isEnabled());
  EXPECT_EQ(add->toolTip(), "Choose a folder for the library first");
  for (const QLabel* label : library.findChildren<QLabel*>()) EXPECT_EQ(label->text(), "");
  EXPECT_FALSE(library.list().entries().empty()) << "presets";
  QSettings().clear();
}

TEST(BrdfLibrary, SharesDefinitionsByName) {
  BrdfLibrary library;
  library.set_definitions({{"red-paint", brdf_model("ward kd=(0.8, 0.1, 0.1)"), {}, {}}});
  const int row = row_of(library.list(), "red-paint");
  ASSERT_GE(row, 0);
  const std::unique_ptr<QMimeData> mime(library.list().mimeData({library.list().item(row)}));
  EXPECT_EQ(mime->data(BrdfNameMimeType), "red-paint");
  grf::Diagnostics diagnostics;
  EXPECT_EQ(brdf_of(*mime, reflectance::brdf_infos(), diagnostics), brdf_model("ward kd=(0.8, 0.1, 0.1)"));
}

}  // namespace
}  // namespace editor
