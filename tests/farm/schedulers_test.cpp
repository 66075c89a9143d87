// Tests of parts by other schedulers, as FARM.md and samples/farm have them: their images are those of one
// process.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/farm/farm_processes.h"

namespace {

namespace fs = std::filesystem;
using test::digest_of_file;
using test::Outcome;
using test::Process;

/// An image in parts, which are files of a folder.
class Schedulers : public test::FarmOfSceneTest {
 protected:
  Schedulers() : FarmOfSceneTest(8) {}

  const std::string image_ = path("image.pfm");

  Outcome run_in_folder(const std::string& command) const {
    return test::run({"/bin/bash", "-c", fmt::format("cd '{}' && {}", path(""), command)});
  }
};

TEST_F(Schedulers, HaveTheImageByMake) {
  const std::string make =
      fmt::format("make -j 2 -f {}/samples/farm/Makefile BPT={} SCENE={} IMAGE={} PARTS=5",
                  GRANADA_SOURCE_DIR, Bpt, scene_, image_);
  const Outcome made = run_in_folder(make);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(digest_of_file(image_), expected_);
  // As after an interruption: what is there is not rendered again.
  fs::remove(image_);
  fs::remove(path("parts/3.part"));
  const auto kept = fs::last_write_time(path("parts/2.part"));
  EXPECT_EQ(run_in_folder(make).exit_code, 0);
  EXPECT_EQ(digest_of_file(image_), expected_);
  EXPECT_EQ(fs::last_write_time(path("parts/2.part")), kept);
}

TEST_F(Schedulers, HaveTheImageByGnuParallel) {
  const Outcome outcome = run_in_folder(fmt::format(
      "seq 4 | parallel --will-cite {0} render {1} --part {{}}/4 -o {{}}.part && {0} merge *.part -o {2}",
      Bpt, scene_, image_));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(digest_of_file(image_), expected_);
}

TEST_F(Schedulers, ConvertManyFilesByGnuParallel) {
  for (int i = 0; i < 4; ++i) fs::copy_file(path("scene.grf"), path(fmt::format("copy{}.grf", i)));
  const Outcome outcome = run_in_folder(
      fmt::format("parallel --will-cite {}/grfconvert {{}} -o {{.}}.ply ::: copy*.grf", GRANADA_BIN_DIR));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (int i = 0; i < 4; ++i) EXPECT_GT(fs::file_size(path(fmt::format("copy{}.ply", i))), 100U);
}

/// A controller and a node of Slurm on this machine, with a configuration of their own.
class SlurmTest : public Schedulers {
 protected:
  void SetUp() override {
    for (const char* folder : {"state", "spool"}) fs::create_directory(path(folder));
    folder_.add("munge.key", std::string(1024, 'k'));
    fs::permissions(path("munge.key"), fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_EQ(::setenv("SLURM_CONF", path("slurm.conf").c_str(), 1), 0);
    ASSERT_EQ(::setenv("BPT", Bpt, 1), 0);
    folder_.add("slurm.conf", configuration());
    processes_.emplace_back(
        std::vector<std::string>{"/usr/sbin/munged", "--foreground", "--force",
                                 "--key-file=" + path("munge.key"), "--socket=" + path("munge.socket"),
                                 "--pid-file=" + path("munge.pid"), "--log-file=" + path("munge.log"),
                                 "--seed-file=" + path("munge.seed")},
        path("munged.output"));
    ASSERT_TRUE(test::wait_until([&] { return fs::exists(path("munge.socket")); }))
        << processes_.back().output();
    for (const char* program : {"slurmctld", "slurmd"}) {
      processes_.emplace_back(
          std::vector<std::string>{std::string("/usr/sbin/") + program, "-D", "-f", path("slurm.conf")},
          path(std::string(program) + ".output"));
    }
    const auto is_ready = [&] { return run_in_folder("sinfo --noheader --format %T").out == "idle\n"; };
    ASSERT_TRUE(test::wait_until(is_ready)) << processes_[1].output() << processes_[2].output();
  }

  std::string configuration() const {
    const std::string host = run_in_folder("hostname -s").out;
    const std::string user = run_in_folder("id --user --name").out;
    const auto line = [](const std::string& text) { return text.substr(0, text.find('\n')); };
    return fmt::format(
        "ClusterName=test\nSlurmctldHost={0}(127.0.0.1)\nSlurmctldPort={1}\nSlurmdPort={2}\n"
        "SlurmUser={3}\nSlurmdUser={3}\nAuthType=auth/munge\nAuthInfo=socket={4}/munge.socket\n"
        "CryptoType=crypto/munge\nStateSaveLocation={4}/state\nSlurmdSpoolDir={4}/spool\n"
        "SlurmctldPidFile={4}/slurmctld.pid\nSlurmdPidFile={4}/slurmd.pid\nProctrackType=proctrack/pgid\n"
        "TaskPlugin=task/none\nJobAcctGatherType=jobacct_gather/none\nMpiDefault=none\nSwitchType=switch/"
        "none\n"
        "SelectType=select/cons_tres\nSelectTypeParameters=CR_Core\nReturnToService=2\n"
        "NodeName={0} NodeAddr=127.0.0.1 CPUs=2\nPartitionName=all Nodes={0} Default=YES State=UP\n",
        line(host), test::bind_port(0).second, test::bind_port(0).second, line(user),
        fs::path(path("x")).parent_path().string());
  }

  std::vector<Process> processes_;
};

TEST_F(SlurmTest, HasTheImageOfAnArrayAndItsMerge) {
  const Outcome submitted =
      run_in_folder(fmt::format("{}/samples/farm/slurm_array {} {} 4", GRANADA_SOURCE_DIR, scene_, image_));
  ASSERT_EQ(submitted.exit_code, 0) << submitted.err;
  const std::string merge = submitted.out.substr(0, submitted.out.find('\n'));
  const auto has_ended = [&] { return run_in_folder("squeue --noheader --jobs " + merge).out.empty(); };
  ASSERT_TRUE(test::wait_until(has_ended)) << run_in_folder("squeue").out;
  ASSERT_TRUE(fs::exists(image_)) << run_in_folder("cat parts/*.log").out;
  EXPECT_EQ(digest_of_file(image_), expected_);
}

}  // namespace
