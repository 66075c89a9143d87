#include "renderer/farm/records.h"

#include <gtest/gtest.h>

namespace {

using farm::job_info_of;
using farm::task_of;

std::string digits(char digit) { return std::string(64, digit); }

/// A job's record as the format is documented, made by hand.
std::string job_json(const std::string& id, const std::string& bytes, const std::string& content) {
  return R"({"id":")" + id + R"(","name":"a.op","host":"h","created":5,"content":")" + content +
         R"(","bytes":)" + bytes + R"(,"version":"0.1","instruction_set":"x86-64-v3","options":")" +
         digits('1') + R"(","files":")" + digits('2') + R"(","program":")" + digits('3') +
         R"(","probe":{"first_sample":0,"end_sample":2,"first_tile":1,"end_tile":3,"index":4,"count":5},)" +
         R"("probe_digest":")" + digits('4') + R"(","lease_seconds":20.0})";
}

TEST(Records, OfJobsAreRead) {
  const auto job = job_info_of(job_json("0123456789abcdef", "77", digits('a')));
  ASSERT_TRUE(job);
  EXPECT_EQ(job->id, "0123456789abcdef");
  EXPECT_EQ(job->name, "a.op");
  EXPECT_EQ(job->bytes, 77U);
  EXPECT_EQ(job->content[31], 0xAA);
  EXPECT_EQ(job->fingerprint, (transport::Fingerprint{*transport::digest_of_hex(digits('1')),
                                                      *transport::digest_of_hex(digits('2')),
                                                      *transport::digest_of_hex(digits('3'))}));
  EXPECT_EQ(job->probe, (transport::ImagePart{0, 2, 1, 3, 4, 5}));
  EXPECT_EQ(job->probe_digest[0], 0x44);
  EXPECT_EQ(job->lease_seconds, 20);
  const auto again = job_info_of(json_of(*job));
  ASSERT_TRUE(again);
  EXPECT_EQ(json_of(*again), json_of(*job));
}

TEST(Records, OfTasksAreRead) {
  const auto task =
      task_of(R"({"number":7,"first_tile":5,"is_pilot":true,"samples":[[0,16,1,17],[2,18,3,19]]})");
  ASSERT_TRUE(task);
  EXPECT_EQ(task->number, 7);
  EXPECT_EQ(task->first_tile, 5);
  EXPECT_TRUE(task->is_pilot);
  ASSERT_EQ(task->samples.size(), 2U);
  EXPECT_EQ(task->samples[0].end, (transport::FilmTile::Counts{16, 17}));
  EXPECT_EQ(task->samples[1].first, (transport::FilmTile::Counts{2, 3}));
  const farm::StageTasks stage{64, 3, {*task, *task}};
  const auto again = farm::stage_tasks_of(json_of(stage));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->end, 64);
  EXPECT_EQ(again->image_begin, 3);
  ASSERT_EQ(again->tasks.size(), 2U);
  EXPECT_EQ(json_of(again->tasks[1]), json_of(*task));
}

// Identifiers and digests become names of files and subjects.
TEST(Records, WithNamesThatLeadElsewhereAreRefused) {
  for (const char* id : {"../../etc/passwd", "0123456789ABCDEF", "0123456789abcde", "0123456789abcde.", ""}) {
    EXPECT_FALSE(job_info_of(job_json(id, "77", digits('a')))) << id;
  }
  EXPECT_FALSE(job_info_of(job_json("0123456789abcdef", "77", "/" + digits('a').substr(1))));
}

TEST(Records, WithValuesOutOfTheirRangesAreRefused) {
  for (const char* bytes : {"0", "-1", "1e99", "17179869185", "\"77\"", "null", "[]"}) {
    EXPECT_FALSE(job_info_of(job_json("0123456789abcdef", bytes, digits('a')))) << bytes;
  }
  const auto task = [](const std::string& number, const std::string& tile, const std::string& samples) {
    return task_of(R"({"number":)" + number + R"(,"first_tile":)" + tile + R"(,"is_pilot":false,"samples":)" +
                   samples + "}");
  };
  EXPECT_TRUE(task("3", "0", "[[0,2,0,1]]"));
  EXPECT_TRUE(task("3", "0", "[[2,2,1,1]]")) << "a tile without samples";
  EXPECT_FALSE(task("-3", "0", "[[0,2,0,1]]"));
  EXPECT_FALSE(task("3000000000", "0", "[[0,2,0,1]]"));
  EXPECT_FALSE(task("3", "-1", "[[0,2,0,1]]"));
  EXPECT_FALSE(task("3", "2147483647", "[[0,2,0,1],[0,2,0,1]]")) << "the last tile has a number, too";
  EXPECT_FALSE(task("3", "0", "[[2,1,0,1]]"));
  EXPECT_FALSE(task("3", "0", "[[0,1,2,1]]"));
  EXPECT_FALSE(task("3", "0", "[[-1,2,0,1]]"));
  EXPECT_FALSE(task("3", "0", "[[0,3000000000,0,1]]"));
  EXPECT_FALSE(task("3", "0", "[[0,2,0]]"));
  EXPECT_FALSE(task("3", "0", "[]"));
  EXPECT_FALSE(task("3", "0", "5"));
  EXPECT_FALSE(task_of(R"({"number":3,"first_tile":0,"samples":[[0,2,0,1]]})"));
  for (const char* nonsense : {"", "{", "null", "3", "[]", "{}", "\xFF\xFE"}) {
    EXPECT_FALSE(task_of(nonsense)) << nonsense;
    EXPECT_FALSE(farm::stage_tasks_of(nonsense)) << nonsense;
    EXPECT_FALSE(job_info_of(nonsense)) << nonsense;
    EXPECT_FALSE(farm::progress_of(nonsense)) << nonsense;
    EXPECT_FALSE(farm::worker_info_of(nonsense)) << nonsense;
  }
}

TEST(Records, OfProgressKeepWhatIsUnknown) {
  const auto known = farm::progress_of(json_of(farm::Progress{40, 3, 2, 0.25, 12.5, 99}));
  ASSERT_TRUE(known);
  EXPECT_EQ(known->parts, 40);
  EXPECT_EQ(known->parts_done, 3);
  EXPECT_EQ(known->workers, 2);
  EXPECT_EQ(known->error, 0.25);
  EXPECT_EQ(known->seconds_left, 12.5);
  const auto unknown = farm::progress_of(json_of(farm::Progress{}));
  ASSERT_TRUE(unknown);
  EXPECT_FALSE(unknown->error || unknown->seconds_left);
}

TEST(Records, OfWorkersAreRead) {
  const farm::WorkerInfo worker{"0123456789abcdef", "host", 4, "0.1", "", "no \"reason\"\xFF"};
  const auto read = farm::worker_info_of(json_of(worker));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->threads, 4);
  EXPECT_EQ(read->refused, "no \"reason\"\xEF\xBF\xBD") << "what is no UTF-8 is replaced";
}

TEST(Records, HaveNewIdentifiers) {
  const std::string one = farm::new_identifier();
  EXPECT_TRUE(farm::is_identifier(one));
  EXPECT_NE(one, farm::new_identifier());
}

}  // namespace
