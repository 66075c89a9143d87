#include "editor/programs/child_process.h"

#include <QElapsedTimer>
#include <QTest>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace editor {
namespace {

using Cause = ChildEnd::Cause;

/// Collects the output and the exit of a child.
class Heard {
 public:
  explicit Heard(ChildProcess& child) {
    QObject::connect(&child, &ChildProcess::wrote, &child,
                     [this](const QByteArray& line) { written.push_back(line); });
    QObject::connect(&child, &ChildProcess::logged, &child,
                     [this](const QByteArray& line) { logged.push_back(line); });
    QObject::connect(&child, &ChildProcess::ended, &child,
                     [this](const ChildEnd& end) { ends.push_back(end); });
  }

  bool wait_for_end() {
    return QTest::qWaitFor([this] { return !ends.empty(); }, 20'000);
  }
  bool wait_for_line() {
    return QTest::qWaitFor([this] { return !written.empty(); }, 20'000);
  }

  std::vector<QByteArray> written;
  std::vector<QByteArray> logged;
  std::vector<ChildEnd> ends;
};

void start_shell(ChildProcess& child, const QString& script) { child.start("/bin/sh", {"-c", script}); }

TEST(ChildProcess, IsHeardLineByLineToItsLastByte) {
  ChildProcess child;
  Heard heard(child);
  start_shell(child, "echo one; echo problem >&2; printf 'two\\nthree'; printf last >&2; exit 7");
  ASSERT_TRUE(heard.wait_for_end());
  EXPECT_EQ(heard.written, (std::vector<QByteArray>{"one\n", "two\n", "three"}));
  EXPECT_EQ(heard.logged, (std::vector<QByteArray>{"problem\n", "last"}));
  ASSERT_EQ(heard.ends.size(), 1U);
  EXPECT_EQ(heard.ends[0].cause, Cause::Returned);
  EXPECT_EQ(heard.ends[0].code, 7);
  EXPECT_FALSE(child.is_running());
}

TEST(ChildProcess, SaysWhyItIsNotStarted) {
  ChildProcess child;
  Heard heard(child);
  child.start("/no/such/program", {});
  ASSERT_TRUE(heard.wait_for_end());
  ASSERT_EQ(heard.ends.size(), 1U);
  EXPECT_EQ(heard.ends[0].cause, Cause::NotStarted);
  EXPECT_FALSE(heard.ends[0].why.isEmpty());
}

TEST(ChildProcess, TellsACrashFromAnEndThatWasAskedFor) {
  ChildProcess child;
  Heard heard(child);
  start_shell(child, "kill -SEGV $$");
  ASSERT_TRUE(heard.wait_for_end());
  EXPECT_EQ(heard.ends[0].cause, Cause::Crashed);
  heard.ends.clear();
  start_shell(child, "echo ready; exec sleep 60");
  ASSERT_TRUE(heard.wait_for_line());
  child.cancel();
  ASSERT_TRUE(heard.wait_for_end());
  EXPECT_EQ(heard.ends[0].cause, Cause::Cancelled);
}

TEST(ChildProcess, IsCancelledEvenWhileItIsBeingStarted) {
  ChildProcess child;
  Heard heard(child);
  start_shell(child, "exec sleep 60");
  child.cancel();
  ASSERT_TRUE(heard.wait_for_end());
  EXPECT_EQ(heard.ends[0].cause, Cause::Cancelled);
}

TEST(ChildProcess, ReturnsByItselfWhereItUnderstandsTheRequest) {
  ChildProcess child;
  Heard heard(child);
  start_shell(child, "trap 'echo kept; exit 3' INT; echo ready; while :; do sleep 0.05; done");
  ASSERT_TRUE(heard.wait_for_line());
  child.interrupt();
  ASSERT_TRUE(heard.wait_for_end());
  EXPECT_EQ(heard.written.back(), "kept\n");
  EXPECT_EQ(heard.ends[0].cause, Cause::Returned);
  EXPECT_EQ(heard.ends[0].code, 3);
}

TEST(ChildProcess, IsEndedAfterItsTimeout) {
  ChildProcess child({.terminate_timeout = 200});
  Heard heard(child);
  start_shell(child, "trap '' TERM; echo ready; while :; do sleep 0.05; done");
  ASSERT_TRUE(heard.wait_for_line());
  QElapsedTimer timer;
  timer.start();
  child.cancel();
  ASSERT_TRUE(heard.wait_for_end());
  EXPECT_EQ(heard.ends[0].cause, Cause::Cancelled);
  EXPECT_GE(timer.elapsed(), 150);
}

TEST(ChildProcess, IsSilentWhereItIsKilledOrDestroyed) {
  int ends = 0;
  {
    ChildProcess child;
    QObject::connect(&child, &ChildProcess::ended, &child, [&ends] { ++ends; });
    start_shell(child, "exec sleep 60");
    child.kill();
    EXPECT_FALSE(child.is_running());
    start_shell(child, "exec sleep 60");
  }
  QTest::qWait(50);
  EXPECT_EQ(ends, 0);
}

TEST(ChildProcess, LeavesTheProcessorToTheWindowAndNoCoreDumps) {
  ChildProcess child({.niceness = 5});
  Heard heard(child);
  start_shell(child, "nice; ulimit -c");
  ASSERT_TRUE(heard.wait_for_end());
  const int own = getpriority(PRIO_PROCESS, 0);
  ASSERT_EQ(heard.written.size(), 2U);
  EXPECT_EQ(heard.written[0].trimmed().toInt(), std::min(own + 5, 19));
  EXPECT_EQ(heard.written[1], "0\n");
}

}  // namespace
}  // namespace editor
