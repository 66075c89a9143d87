#include "editor/window/source_view.h"

#include <QApplication>
#include <QDesktopServices>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTest>
#include <QTextBlock>
#include <QTextLayout>
#include <QTimer>
#include <QToolButton>
#include <QUrl>
#include <ctime>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/appearance/theme.h"
#include "grf/read.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::HasSubstr;

/// Records what is opened on the desktop.
class Desktop : public QObject {
  Q_OBJECT

 public:
  Desktop() { QDesktopServices::setUrlHandler("file", this, "open"); }
  ~Desktop() override { QDesktopServices::unsetUrlHandler("file"); }
  Q_INVOKABLE void open(const QUrl& url) { opened.append(url); }

  QList<QUrl> opened;
};

double thread_seconds() {
  timespec time = {};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class SourceViewTest : public testing::Test {
 protected:
  void SetUp() override {
    view_.resize(720, 480);
    view_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_));
    view_.activateWindow();  // shortcuts are those of the active window
    ASSERT_TRUE(QTest::qWaitForWindowActive(&view_));
  }

  QString file(const std::string& name, const std::string& bytes) {
    return QString::fromStdString(folder_.add(name, bytes));
  }
  bool comes(const std::function<void()>& action) {
    QSignalSpy shown(&view_, &SourceView::shown);
    action();
    return shown.wait(20000);
  }
  bool shows(const QString& path, int line = 0, int column = 0) {
    return comes([&] { view_.show_file(path, line, column); });
  }
  std::string text() const { return view_.text()->toPlainText().toStdString(); }
  std::string selected() const { return view_.text()->textCursor().selectedText().toStdString(); }
  /// The texts of all visible labels.
  std::string labels() const {
    QString all;
    for (const QLabel* label : view_.findChildren<QLabel*>()) {
      if (label->isVisible()) all += label->text() + '\n';
    }
    return all.toStdString();
  }
  /// The format of a text in a line.
  QTextCharFormat format_of(int line, const QString& words) const {
    const QTextBlock block = view_.text()->document()->findBlockByNumber(line - 1);
    for (const QTextLayout::FormatRange& range : block.layout()->formats()) {
      if (block.text().mid(range.start, range.length) == words) return range.format;
    }
    return {};
  }
  /// The distance of the marked line from the middle of the text, in lines.
  double distance_from_middle() const {
    const QRect caret = view_.text()->cursorRect();
    return std::abs(caret.center().y() - view_.text()->viewport()->height() / 2.0) / caret.height();
  }

  test::TemporaryFolder folder_;
  SourceView view_;
};

TEST_F(SourceViewTest, SaysWhatToDoWhileThereIsNoFile) {
  EXPECT_THAT(labels(), HasSubstr("Select a message"));
  for (const QToolButton* button : view_.findChildren<QToolButton*>()) {
    EXPECT_FALSE(button->isEnabled());
    EXPECT_THAT(button->toolTip().toStdString(), HasSubstr("select a message"));
  }
  view_.show(grf::SourceLocation());
  view_.read_again();
  EXPECT_EQ(view_.path(), QString());
}

TEST_F(SourceViewTest, ShowsThePlaceOfAMessage) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) bytes += "// line\r\n";
  bytes += "begin mesh brdf wrad begin\n";
  const QString path = file("scene.grf", bytes + std::string(50, '\n'));
  grf::Diagnostics diagnostics;
  grf::read(path.toStdString(), diagnostics);
  ASSERT_TRUE(diagnostics.has_errors());
  const grf::SourceLocation location = diagnostics.entries().front().location;
  ASSERT_EQ(location.line, 301U);
  ASSERT_TRUE(comes([&] { view_.show(location); }));
  EXPECT_EQ(view_.path(), path);
  EXPECT_EQ(view_.text()->textCursor().blockNumber(), 300);
  EXPECT_LT(distance_from_middle(), 2);
  ASSERT_EQ(view_.text()->extraSelections().size(), 1);
  EXPECT_EQ(view_.text()->extraSelections()[0].cursor.blockNumber(), 300);
  EXPECT_TRUE(view_.text()->isReadOnly());
  EXPECT_EQ(text().find('\r'), std::string::npos);
}

TEST_F(SourceViewTest, SelectsTheWordAtTheColumn) {
  const QString path = file("scene.grf",
                            "\xEF\xBB\xBF"
                            "brdf ward sx=0.2\n/* \xF0\x9F\x8F\xAF */ wrong (1,2)\n");
  ASSERT_TRUE(shows(path, 1, 6));
  EXPECT_EQ(selected(), "ward");
  ASSERT_TRUE(shows(path, 2, 9));
  EXPECT_EQ(selected(), "wrong");
  ASSERT_TRUE(shows(path, 2, 15));
  EXPECT_EQ(selected(), "(");
  ASSERT_TRUE(shows(path, 2, 0));
  EXPECT_EQ(selected(), "");
  ASSERT_TRUE(shows(path, 2, 1000));
  EXPECT_TRUE(view_.text()->textCursor().atBlockEnd());
  ASSERT_TRUE(shows(path, 1000, 1));
  EXPECT_TRUE(view_.text()->extraSelections().empty()) << "the file has become shorter";
}

TEST_F(SourceViewTest, SetsKeywordsAndCommentsApart) {
  const QString path =
      file("scene.grf", "Begin mesh \"begin // mesh\" // end of mesh\n  brdf ward beginner=2\n");
  ASSERT_TRUE(shows(path));
  EXPECT_EQ(format_of(1, "Begin").fontWeight(), QFont::Bold);
  EXPECT_EQ(format_of(1, "mesh").fontWeight(), QFont::Bold);
  EXPECT_EQ(format_of(1, "// end of mesh").foreground().color(), colours_of(Theme::Dark).faint_text);
  EXPECT_EQ(format_of(2, "brdf").fontWeight(), QFont::Bold);
  EXPECT_EQ(view_.text()->document()->findBlockByNumber(1).layout()->formats().size(), 1);
  apply(Theme::Light, *qApp);
  EXPECT_TRUE(QTest::qWaitFor([&] {
    return format_of(1, "// end of mesh").foreground().color() == colours_of(Theme::Light).faint_text;
  }));
  apply(Theme::Dark, *qApp);
  ASSERT_TRUE(shows(file("scene.op", "BPT_Scene light.grf#1 # begin\n")));
  EXPECT_EQ(format_of(1, " # begin").foreground().color(), colours_of(Theme::Dark).faint_text);
  EXPECT_EQ(view_.text()->document()->firstBlock().layout()->formats().size(), 1);
}

TEST_F(SourceViewTest, ReadsTheFileAgain) {
  const QString path = file("scene.grf", "old\n");
  ASSERT_TRUE(shows(path, 1, 1));
  EXPECT_EQ(selected(), "old");
  file("scene.grf", "new\nmore\n");
  view_.setFocus();
  ASSERT_TRUE(comes([&] { QTest::keyClick(view_.text(), Qt::Key_F5); }));
  EXPECT_EQ(selected(), "new");
  EXPECT_EQ(text(), "new\nmore");
  QFile::remove(path);
  auto* again = view_.findChildren<QToolButton*>()[1];
  ASSERT_TRUE(comes([&] { QTest::mouseClick(again, Qt::LeftButton); }));
  EXPECT_THAT(labels(), HasSubstr("scene.grf: No such file"));
  ASSERT_TRUE(shows(QString::fromStdString(folder_.path())));
  EXPECT_THAT(labels(), HasSubstr("is not a file"));
}

TEST_F(SourceViewTest, OpensTheFileInAnotherProgram) {
  Desktop desktop;
  const QString path = file("scene.grf", "light\n");
  ASSERT_TRUE(shows(path));
  QTest::mouseClick(view_.findChildren<QToolButton*>()[0], Qt::LeftButton);
  EXPECT_EQ(desktop.opened, QList<QUrl>{QUrl::fromLocalFile(path)});
}

TEST_F(SourceViewTest, ShowsThePartOfALongFileThatMatters) {
  constexpr int Lines = 3'000'000;
  {
    std::ofstream stream(folder_.path("long.grf"));
    for (int i = 1; i <= Lines; ++i) stream << fmt::format("({}, 0.123456789, 0.123456789)\n", i);
  }
  const QString path = QString::fromStdString(folder_.path("long.grf"));
  // The window stays responsive. Its thread's own time is measured, since other programs may be busy.
  double begin = thread_seconds();
  double longest = 0;
  QTimer beat;
  beat.setInterval(0);
  QObject::connect(&beat, &QTimer::timeout, [&] {
    longest = std::max(longest, thread_seconds() - begin);
    begin = thread_seconds();
  });
  beat.start();
  ASSERT_TRUE(shows(path, 1'234'567, 2));
  EXPECT_LT(longest, 0.1);
  EXPECT_EQ(selected(), "1234567");
  EXPECT_EQ(view_.text()->blockCount(), ExcerptLines);
  EXPECT_LT(distance_from_middle(), 2);
  EXPECT_THAT(labels(), HasSubstr(QString("Lines %1 to %2 of %3: the file is too long")
                                      .arg(QLocale().toString(1'232'067), QLocale().toString(1'237'066),
                                           QLocale().toString(Lines))
                                      .toStdString()));
  ASSERT_TRUE(shows(path, Lines, 1));
  EXPECT_EQ(view_.text()->textCursor().blockNumber(), ExcerptLines - 1);
  ASSERT_TRUE(shows(path, 1, 1));
  EXPECT_EQ(view_.text()->textCursor().blockNumber(), 0);
  ASSERT_TRUE(shows(file("short.grf", "light\n"), 1, 1));
  EXPECT_THAT(labels(), testing::Not(HasSubstr("too long")));
}

TEST(SourceExcerpt, HasAPartOfALongLine) {
  const test::TemporaryFolder folder;
  std::string line = "wrong";
  for (int i = 0; i < 1'000'000; ++i) line += " \xC3\xA9";
  line += " here " + std::string(1'000'000, 'x');
  const QString path = QString::fromStdString(folder.add("wide.grf", "first\n" + line + "\nlast"));
  const SourceExcerpt begin = read_excerpt({path, 2, 1});
  ASSERT_EQ(begin.lines.size(), 3);
  EXPECT_TRUE(begin.lines[1].startsWith("wrong"));
  EXPECT_EQ(begin.lines[1].size(), ExcerptColumns + 1);
  EXPECT_EQ(begin.shortened, 1);
  EXPECT_EQ(begin.lines[2], "last");
  const SourceExcerpt middle = read_excerpt({path, 2, 2'000'007});
  EXPECT_EQ(middle.lines[1].mid(middle.position, 5), "here ");
  EXPECT_EQ(middle.lines[1].size(), ExcerptColumns + 2);
  EXPECT_LT(middle.position, ExcerptColumns);
}

TEST(SourceExcerpt, CountsLines) {
  const test::TemporaryFolder folder;
  const auto lines = [&](const std::string& bytes) {
    const SourceExcerpt excerpt = read_excerpt({QString::fromStdString(folder.add("a.grf", bytes)), 1, 1});
    EXPECT_EQ(excerpt.lines.size(), excerpt.line_count);
    EXPECT_TRUE(excerpt.is_whole());
    return excerpt.lines;
  };
  EXPECT_EQ(lines(""), QStringList());
  EXPECT_EQ(lines("a"), QStringList({"a"}));
  EXPECT_EQ(lines("a\r\n\nb\r\n"), QStringList({"a", "", "b"}));
  EXPECT_EQ(lines("a\rb\n"), QStringList({QString("a\uFFFDb")})) << "lines are those of messages";
  EXPECT_EQ(read_excerpt({"/dev/zero", 1, 1}).problem, "/dev/zero is not a file");
}

}  // namespace
}  // namespace editor

#include "source_view_test.moc"
