#include <QElapsedTimer>
#include <QImage>
#include <QPainter>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/jobs/job_list.h"

namespace editor {
namespace {

constexpr int Timeout = 20'000;

class Jobs : public testing::Test {
 protected:
  /// A job that runs until `Job::end`.
  void add(const QString& title, const QString& queue) {
    jobs_.add({title, queue, [this, title](Job&) { begun_.push_back(title.toStdString()); }, {}, "Stop"});
  }
  bool are_ended() {
    return QTest::qWaitFor([this] { return jobs_.jobs().empty(); }, Timeout);
  }

  JobList jobs_;
  std::vector<std::string> begun_;
};

TEST_F(Jobs, OfOneQueueRunOneAfterAnother) {
  add("a", "one");
  add("b", "one");
  add("c", "other");
  EXPECT_THAT(begun_, testing::ElementsAre("a", "c"));
  EXPECT_EQ(jobs_.jobs()[1]->state(), Job::State::Waiting);
  jobs_.jobs()[0]->end();
  EXPECT_THAT(begun_, testing::ElementsAre("a", "c", "b"));
  EXPECT_EQ(jobs_.jobs().size(), 2U);
}

TEST_F(Jobs, ThatWaitCanBeRemoved) {
  for (const char* title : {"a", "b", "c"}) add(title, "one");
  jobs_.jobs()[1]->cancel();
  jobs_.jobs()[0]->end();
  EXPECT_THAT(begun_, testing::ElementsAre("a", "c"));
}

TEST_F(Jobs, BringTheResultOfAThreadToThisOne) {
  const QThread* worker = nullptr;
  int result = 0;
  jobs_.add({"Add",
             "one",
             [&](Job& job) {
               job.run(
                   [&worker] {
                     worker = QThread::currentThread();
                     return 6 * 7;
                   },
                   [&](int sum) {
                     EXPECT_EQ(QThread::currentThread(), jobs_.thread());
                     result = sum;
                   });
             },
             {},
             {}});
  EXPECT_EQ(result, 0);
  ASSERT_TRUE(are_ended());
  EXPECT_EQ(result, 42);
  EXPECT_NE(worker, QThread::currentThread());
}

TEST_F(Jobs, DropTheResultOfWorkThatWasCancelled) {
  bool is_taken = false;
  jobs_.add({"Add",
             "one",
             [&](Job& job) {
               job.run(
                   [] {
                     QThread::msleep(20);
                     return 1;
                   },
                   [&](int) { is_taken = true; });
             },
             {},
             "Stop"});
  jobs_.jobs()[0]->cancel();
  EXPECT_TRUE(jobs_.jobs().empty());
  QTest::qWait(100);
  EXPECT_FALSE(is_taken);
}

TEST_F(Jobs, CannotBeCancelledWithoutSayingWhatThatDoes) {
  jobs_.add({"Save", "one", [](Job&) {}, {}, {}});
  jobs_.jobs()[0]->cancel();
  EXPECT_EQ(jobs_.jobs().size(), 1U);
}

TEST_F(Jobs, SayWhyTheyFailed) {
  QSignalSpy failed(&jobs_, &JobList::failed);
  jobs_.add({"Add",
             "one",
             [](Job& job) { job.run([]() -> int { throw std::runtime_error("disk full"); }, [](int) {}); },
             {},
             {}});
  ASSERT_TRUE(are_ended());
  ASSERT_EQ(failed.size(), 1);
  EXPECT_EQ(failed[0][0].toString(), "Add: disk full");
}

/// Qt draws a smoothly scaled image in several threads of the application's pool, and waits for them.
TEST_F(Jobs, LeaveThreadsToPainting) {
  const int count = 2 * QThread::idealThreadCount();
  QSemaphore held;
  std::atomic<int> running = 0;
  for (int i = 0; i < count; ++i) {
    jobs_.add({"Wait", QString::number(i), [&](Job& job) {
                 job.run(
                     [&] {
                       ++running;
                       return held.tryAcquire(1, Timeout);
                     },
                     [](bool) {});
               }});
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return running == count; }, Timeout / 10));
  QImage image(1500, 1500, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::white);
  QImage canvas(1000, 1000, QImage::Format_ARGB32_Premultiplied);
  QElapsedTimer clock;
  clock.start();
  QPainter painter(&canvas);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(canvas.rect(), image);
  EXPECT_LT(clock.elapsed(), Timeout / 2);
  held.release(count);
  EXPECT_TRUE(are_ended());
}

}  // namespace
}  // namespace editor
