// Tests of a farm on disks that are full, over a network that is slow and loses packets, and with machines
// that compute otherwise.
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/farm/farm.h"
#include "tests/farm/farm_processes.h"

namespace {

using test::Process;
using testing::HasSubstr;

class FarmFaults : public test::FarmOfSceneTest {
 protected:
  FarmFaults() : FarmOfSceneTest(200) {}

  void make_folder(const std::string& name) const { std::filesystem::create_directory(path(name)); }
};

/// A farm of which one process has a folder on a file system of its own, which is too small.
class FullDisk : public FarmFaults {
 protected:
  void SetUp() override {
    std::vector<std::string> probe = Alone;
    probe.emplace_back("/bin/true");
    if (test::run(probe).exit_code != 0) GTEST_SKIP() << "this system lets nobody have a name space";
  }

  /// Starts `bpt farm` with a folder on such a disk.
  Process start_with_small(const std::string& folder, const std::string& size,
                           const std::vector<std::string>& arguments) {
    make_folder(folder);
    std::vector<std::string> command = Alone;
    command.insert(command.end(),
                   {"/bin/sh", "-ec", "mount -t tmpfs -o size=" + size + " none \"$0\"; exec \"$@\"",
                    path(folder), Bpt, "farm"});
    command.insert(command.end(), arguments.begin(), arguments.end());
    return Process(command, path("small" + std::to_string(started_++)));
  }

  const std::vector<std::string> Alone = {"/usr/bin/unshare", "--user", "--map-root-user", "--mount"};
};

// The server takes the job, and hardly a part. Workers keep theirs until there is a server with room.
TEST_F(FullDisk, OfTheServerCostsTime) {
  Process server = start_with_small(
      "server", "120k",
      {"serve", "--port", std::to_string(port_), "--folder", path("server"), "--host", "127.0.0.1"});
  ASSERT_TRUE(server.wait_for("To render:")) << server.output();
  Process rendering = render(scene_);
  const Process worker = work();
  ASSERT_TRUE(worker.wait_for("joined")) << worker.output() << rendering.output();
  std::this_thread::sleep_for(std::chrono::seconds(3));
  EXPECT_FALSE(std::filesystem::exists(path("farm.pfm"))) << "the disk was not full";
  kill_server(server);
  const Process roomy = serve("roomy");
  expect_image(rendering);
}

TEST_F(FullDisk, OfAWorkerLeavesTheWorkToOthers) {
  const Process server = serve();
  Process rendering = render(scene_);
  const Process full =
      start_with_small("small", "4k", with_access({"work", "--threads", "1", "--cache", path("small")}));
  ASSERT_TRUE(full.wait_for("refused")) << full.output();
  EXPECT_THAT(full.output(), HasSubstr("No space left on device"));
  EXPECT_FALSE(has_parts(rendering, 1));
  const Process worker = work();
  expect_image(rendering);
}

// A limit of files' sizes is like a disk that is full, and its files stay for the next run.
TEST_F(FarmFaults, OfTheCoordinatorsDiskEndItWithAMessage) {
  const Process server = serve();
  const Process worker = work();
  std::vector<std::string> command = {"/bin/bash", "-c", "ulimit -f 100; exec \"$0\" farm \"$@\"", Bpt};
  const std::vector<std::string> arguments =
      with_access({"render", scene_, "-o", path("farm.pfm"), "--part-seconds", "0.02"});
  command.insert(command.end(), arguments.begin(), arguments.end());
  Process rendering(command, path("limited"));
  EXPECT_EQ(rendering.wait(), 1);
  EXPECT_THAT(rendering.output(), HasSubstr("farm.pfm.ledger: error: cannot write the ledger"));
  ASSERT_TRUE(std::filesystem::exists(path("farm.pfm.ledger")));
  Process resumed = render(scene_);
  expect_image(resumed);
}

TEST_F(FarmFaults, OfOtherInstructionSetsAreRefused) {
  const Process server = serve();
  Process rendering = render(scene_);
  farm::Access access;
  access.url = url_;
  std::string problem;
  const auto farm = farm::Farm::join(access, "test", problem);
  ASSERT_TRUE(farm) << problem;
  ASSERT_TRUE(test::wait_until([&] { return !farm->jobs().value_or(std::vector<farm::JobInfo>()).empty(); }));
  farm::JobInfo other = farm->jobs()->front();
  other.id = farm::new_identifier();
  other.created -= 1;  // the oldest job comes first
  other.instruction_set = "armv8-a";
  ASSERT_TRUE(farm->put_job(other));
  ASSERT_TRUE(farm->put_tasks(other.id, {{0, 0, {{{0, 0}, {1, 1}}}}}));
  const Process worker = work();
  EXPECT_TRUE(worker.wait_for("it needs the instruction set armv8-a, and this bpt uses x86-64-v3"))
      << worker.output();
  expect_image(rendering);
}

// 100 ms in each direction, and what TCP makes of 5 % of lost packets: the data wait for their repetition.
TEST_F(FarmFaults, OfTheNetworkCostTime) {
  const int port = test::bind_port(0).second;
  const Process network({GRANADA_SOURCE_DIR "/tests/farm/slow_network", std::to_string(port),
                         std::to_string(port_), "0.1", "0.05"},
                        path("network"));
  const Process server = serve();
  ASSERT_TRUE(network.wait_for("ready")) << network.output();
  const std::string slow = "nats://127.0.0.1:" + std::to_string(port);
  const Process worker = start({"work", "--threads", "1", "--cache", path("cache"), "--server", slow});
  Process rendering = start({"render", scene_, "-o", path("farm.pfm"), "--part-seconds", "0.1", "--lease",
                             "1", "--progress", "json", "--server", slow});
  expect_image(rendering);
  EXPECT_TRUE(network.has_printed("lost")) << "no packet was lost";
}

}  // namespace
