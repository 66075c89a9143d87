// Tests of the live farm: its picture is that of one process, to the last bit, whatever fails.
#include <random>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "renderer/farm/farm.h"
#include "renderer/farm/opened_job.h"
#include "tests/farm/farm_processes.h"
#include "tests/support/thoroughness.h"

namespace {

using nlohmann::json;
using test::bytes_of_file;
using test::digest_of_file;
using test::Outcome;
using test::Process;
using testing::HasSubstr;

class Farm : public test::FarmOfSceneTest {
 protected:
  Farm() : FarmOfSceneTest(200) {}
};

TEST_F(Farm, HasTheImageOfOneProcessByAnyNumberOfWorkers) {
  const Process server = serve();
  std::vector<Process> workers;
  for (const int count : {1, 2, 3, 7}) {
    while (std::cmp_less(workers.size(), count)) workers.push_back(work());
    Process rendering = render(scene_, std::to_string(count) + ".pfm");
    expect_image(rendering, std::to_string(count) + ".pfm");
    EXPECT_TRUE(has_parts(rendering, 10)) << "it has parts to share: " << rendering.output();
  }
  const Outcome list = farm({"list", "--json"});
  EXPECT_EQ(json::parse(list.out)["jobs"], json::array()) << "nothing stays behind";
}

TEST_F(Farm, GoesOnWhenWorkersAreKilled) {
  const Process server = serve();
  std::mt19937 random(7);
  const int kills = test::tries_all() ? 50 : 4;
  for (int killed = 0; killed < kills;) {
    Process rendering = render(scene_);
    const Process steady = work();
    for (int i = 0; i < 2 && killed < kills; ++i, ++killed) {
      Process worker = work();
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 700));
      worker.kill_and_wait();
    }
    expect_image(rendering);
  }
}

TEST_F(Farm, OutlivesItsServer) {
  std::optional<Process> server = serve();
  Process rendering = render(scene_);
  const Process worker = work();
  ASSERT_TRUE(test::wait_until([&] { return has_parts(rendering, 2); })) << rendering.output();
  kill_server(*server);
  server.emplace(serve());
  ASSERT_TRUE(test::wait_until([&] { return has_parts(rendering, 8); })) << rendering.output();
  kill_server(*server);
  server.emplace(serve("empty"));  // all that it kept is lost
  expect_image(rendering);
}

TEST_F(Farm, RendersAFrameOfAnAnimation) {
  const std::string animation = scene(16, "BPT_Frames 3\n");
  const test::Outcome one = test::run({Bpt, "render", animation, "--frame", "2", "-o", path("turn.pfm")});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  const test::Process server = serve();
  const test::Process worker = work();
  const test::Outcome whole = farm({"render", animation, "-o", path("all.pfm")});
  EXPECT_EQ(whole.exit_code, 1);
  EXPECT_THAT(whole.err, testing::HasSubstr("give each frame on its own (BPT_Frame)"));
  const test::Outcome frame = farm({"render", animation, "--frame", "2", "-o", path("frame.pfm")});
  EXPECT_EQ(frame.exit_code, 0) << frame.err;
  EXPECT_EQ(test::digest_of_file(path("frame.pfm")), test::digest_of_file(path("turn_0002.pfm")));
}

// The image takes seconds: a busy machine notices late that it has begun.
class FarmOfALongImage : public test::FarmOfSceneTest {
 protected:
  FarmOfALongImage() : FarmOfSceneTest(2000) {}
};

TEST_F(FarmOfALongImage, TakesPartsOfWorkersThatComeBackLate) {
  const Process server = serve();
  Process rendering = render(scene_);
  const Process sleeper = work();
  ASSERT_TRUE(test::wait_until([&] { return has_parts(rendering, 1); })) << rendering.output();
  sleeper.send(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));  // beyond the lease
  const Process other = work();
  ASSERT_TRUE(other.wait_for("joined")) << other.output();
  sleeper.send(SIGCONT);
  expect_image(rendering);
}

TEST_F(FarmOfALongImage, ResumesFromTheLedgerOfACoordinatorThatWasKilled) {
  const Process server = serve();
  Process rendering = render(scene_);
  const Process worker = work();
  ASSERT_TRUE(test::wait_until([&] { return has_parts(rendering, 4); })) << rendering.output();
  worker.send(SIGSTOP);  // so that the image is not done before the rest
  Process second = render(scene_);
  EXPECT_EQ(second.wait(), 1);
  EXPECT_THAT(second.output(), HasSubstr("another process has the ledger open"));
  rendering.kill_and_wait();
  ASSERT_TRUE(std::filesystem::exists(path("farm.pfm.ledger")));
  const std::string other = folder_.add("other.op", bytes_of_file(scene_) + "BPT_Depth 1\n");
  Process refused = render(other);
  EXPECT_EQ(refused.wait(), 1);
  EXPECT_THAT(refused.output(), HasSubstr("the ledger belongs to another scene, or other options"));
  Process interrupted = render(scene_);
  ASSERT_TRUE(test::wait_until([&] { return has_parts(interrupted, 4); })) << "as in the ledger";
  interrupted.send(SIGINT);
  const int code = interrupted.wait();
  EXPECT_TRUE(code == 130 || code == 0) << interrupted.output();
  if (code == 0) return;  // it was done before the signal
  EXPECT_THAT(interrupted.output(), HasSubstr("the same command resumes the work"));
  worker.send(SIGCONT);
  Process resumed = render(scene_);
  expect_image(resumed);
}

TEST_F(Farm, TakesWorkersThatComeLate) {
  const Process server = serve();
  Process rendering = render(scene_);
  ASSERT_TRUE(test::wait_until([&] { return has_parts(rendering, 0); })) << rendering.output();
  const Outcome list = farm({"list", "--json"});
  const json jobs = json::parse(list.out)["jobs"];
  ASSERT_EQ(jobs.size(), 1U) << list.err;
  EXPECT_EQ(jobs[0]["scene"], "scene.op");
  const Process worker = work();
  expect_image(rendering);
}

TEST_F(Farm, EndsAJobThatIsStopped) {
  const Process server = serve();
  Process rendering = render(scene_);
  ASSERT_TRUE(test::wait_until([&] { return has_parts(rendering, 0); })) << rendering.output();
  const std::string id = json::parse(farm({"list", "--json"}).out)["jobs"][0]["id"];
  EXPECT_EQ(farm({"stop", "no-such-job"}).exit_code, 1);
  EXPECT_EQ(json::parse(farm({"stop", id, "--json"}).out)["stopped"], id);
  EXPECT_EQ(rendering.wait(), 1);
  EXPECT_THAT(rendering.output(), HasSubstr("the job was stopped"));
  Process resumed = render(scene_);
  const Process worker = work();
  expect_image(resumed);
}

TEST_F(Farm, RefusesThoseWithoutTheToken) {
  token_file_ = folder_.add("token", "a secret \n");
  const Process server = serve();
  const std::string right = std::exchange(token_file_, folder_.add("wrong", "another\n"));
  for (const std::string& file : {token_file_, std::string()}) {
    token_file_ = file;
    Process refused = work();
    EXPECT_EQ(refused.wait(), 1);
    EXPECT_THAT(refused.output(), HasSubstr("the token is missing or wrong"));
  }
  token_file_ = right;
  Process rendering = render(scene_);
  const Process worker = work();
  expect_image(rendering);
  const Outcome open = test::run({Bpt, "farm", "serve", "--folder", path("open"), "--host", "0.0.0.0"});
  EXPECT_EQ(open.exit_code, 2);
  EXPECT_THAT(open.err, HasSubstr("without --token-file or --tls-ca"));
  EXPECT_FALSE(std::filesystem::exists(path("open")));
}

// The authority's certificate is that of the server and of its clients, too.
TEST_F(Farm, AsksForCertificates) {
  const std::string key = path("key.pem");
  const std::string certificate = path("certificate.pem");
  const Outcome made =
      test::run({"/usr/bin/openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", key, "-out",
                 certificate, "-days", "2", "-subj", "/CN=farm", "-addext", "subjectAltName=IP:127.0.0.1"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::vector<std::string> own = {"--tls-ca", certificate, "--tls-cert", certificate, "--tls-key", key};
  std::vector<std::string> serve = {"serve",  "--port",   std::to_string(port_), "--folder", path("server"),
                                    "--host", "127.0.0.1"};
  serve.insert(serve.end(), own.begin(), own.end());
  const Process server = start(serve);
  ASSERT_TRUE(server.wait_for("To render:")) << server.output();
  const std::string url = "tls://127.0.0.1:" + std::to_string(port_);
  std::vector<std::string> status = {Bpt, "farm", "status", "--server", url};
  const auto answers = [&] { return test::run(status).exit_code == 0; };
  EXPECT_EQ(farm({"status"}).exit_code, 1) << "it is not encrypted";
  EXPECT_FALSE(answers()) << "it does not know the authority";
  status.insert(status.end(), {"--tls-ca", certificate});
  EXPECT_FALSE(answers()) << "it has no certificate";
  status.insert(status.end(), own.begin() + 2, own.end());
  EXPECT_TRUE(test::wait_until(answers));
}

TEST_F(Farm, RefusesWorkersOfAnotherBuild) {
  const Process server = serve();
  Process rendering = render(scene_);
  std::filesystem::copy_file(Bpt, path("bpt"));
  std::ofstream(path("bpt"), std::ios::app) << "another build";
  const Process refused = work(path("bpt"));
  ASSERT_TRUE(refused.wait_for("it needs the build")) << refused.output();
  EXPECT_FALSE(has_parts(rendering, 1));
  const auto shows_reason = [&] {
    const json workers = json::parse(farm({"status", "--json"}).out)["workers"];
    return workers.size() == 1 && workers[0]["refused"].get<std::string>().starts_with("it needs the build");
  };
  EXPECT_TRUE(test::wait_until(shows_reason));
  const Process worker = work();
  expect_image(rendering);
}

/// A worker that the test plays itself, with the farm's functions.
class Impostor {
 public:
  Impostor(const std::string& url, const std::string& folder) {
    farm::Access access;
    access.url = url;
    std::string problem;
    farm_ = farm::Farm::join(access, "test", problem);
    EXPECT_TRUE(farm_) << problem;
    test::wait_until([&] { return !farm_->jobs().value_or(std::vector<farm::JobInfo>()).empty(); });
    job_ = farm_->jobs()->front();
    const std::string path = folder + "/impostor.grfjob";
    std::ofstream(path, std::ios::binary) << farm_->content(job_.content, job_.bytes).value();
    grf::Diagnostics diagnostics;
    opened_ = farm::open_job(path, diagnostics);
    EXPECT_TRUE(opened_) << diagnostics.to_text();
  }

  farm::Task next_task() const {
    const auto tasks = farm_->tasks(job_.id);  // messages are acknowledged while it is there
    const auto messages = tasks->fetch(1, std::chrono::seconds(10));
    EXPECT_EQ(messages.size(), 1U);
    messages.at(0).acknowledge();
    return farm::task_of(messages.at(0).data()).value();
  }
  transport::SamplePart part_of(const farm::Task& task) {
    auto part = renders_.run(*opened_, task).value();
    part.fingerprint = job_.fingerprint;  // the test is another program than bpt
    return part;
  }
  void send(const std::string& worker, const farm::Task& task, const std::string& bytes) const {
    EXPECT_TRUE(farm_->put_result(job_.id, {worker, task.number, bytes}));
  }

 private:
  std::optional<farm::Farm> farm_;
  farm::JobInfo job_;
  std::unique_ptr<farm::OpenedJob> opened_;
  farm::RunningRenders renders_;
};

TEST_F(Farm, DropsWorkersThatSendNonsense) {
  const Process server = serve();
  Process rendering = render(scene_);
  Impostor impostor(url_, path(""));
  const farm::Task task = impostor.next_task();
  const std::string right = bytes_of(impostor.part_of(task));
  std::string altered = right;
  altered[altered.size() / 2] = static_cast<char>(altered[altered.size() / 2] ^ 1);
  farm::Task other = task;
  other.first_tile += 1;
  const std::vector<std::pair<std::string, std::string>> nonsense = {
      {"00000000000000a0", ""},
      {"00000000000000a1", "nonsense"},
      {"00000000000000a2", altered},
      {"00000000000000a3", right.substr(0, right.size() / 2)},
      {"00000000000000a4", bytes_of(impostor.part_of(other))}};
  for (const auto& [worker, bytes] : nonsense) {
    impostor.send(worker, task, bytes);
    EXPECT_TRUE(rendering.wait_for("worker " + worker + " was dropped")) << rendering.output();
  }
  impostor.send("00000000000000a5", {1 << 30, task.first_tile, task.samples}, right);  // no such task
  EXPECT_TRUE(rendering.wait_for("worker 00000000000000a5 was dropped")) << rendering.output();
  EXPECT_FALSE(has_parts(rendering, 1));
  const Process worker = work();
  expect_image(rendering);
}

// A part with wrong values is well-formed: it is found when another worker brings the same part.
TEST_F(Farm, DropsWorkersWhoseValuesAreWrong) {
  const Process server = serve();
  Process rendering = render(scene_);
  Impostor impostor(url_, path(""));
  const farm::Task first = impostor.next_task();
  const farm::Task second = impostor.next_task();
  transport::SamplePart wrong = impostor.part_of(first);
  for (transport::PartTile& tile : wrong.tiles) {
    if (!tile.is_empty()) tile.pixels[0][0].add(transport::Rgb(1));
  }
  impostor.send("00000000000000b0", first, bytes_of(wrong));
  impostor.send("00000000000000b0", second, bytes_of(impostor.part_of(second)));
  ASSERT_TRUE(test::wait_until([&] { return has_parts(rendering, 2); })) << rendering.output();
  impostor.send("00000000000000b1", first, bytes_of(impostor.part_of(first)));
  EXPECT_TRUE(rendering.wait_for("worker 00000000000000b0 was dropped")) << rendering.output();
  EXPECT_FALSE(rendering.has_printed("00000000000000b1 was dropped"));
  const Process worker = work();
  expect_image(rendering);
}

/// An image whose samples follow from those before, so that it has stages.
class StagedFarm : public test::FarmTest {};

class StagedFarmOf : public StagedFarm, public testing::WithParamInterface<std::pair<int, const char*>> {};

TEST_P(StagedFarmOf, HasTheImageOfOneProcess) {
  const auto& [samples, options] = GetParam();
  const std::string scene = this->scene(samples, options);
  const std::string expected = digest_of_one_process(scene);
  const Process server = serve();
  const std::vector<Process> workers = [&] {
    std::vector<Process> two;
    two.push_back(work());
    two.push_back(work());
    return two;
  }();
  Process rendering = render(scene);
  expect_image(rendering, expected);
}

INSTANTIATE_TEST_SUITE_P(All, StagedFarmOf,
                         testing::Values(std::pair(100, "BPT_Adaptive true\n"),
                                         std::pair(32, "BPT_Adaptive true\n"),
                                         std::pair(21, "BPT_Adaptive true\n"),
                                         std::pair(4096, "BPT_TargetError 0.04\n"),
                                         std::pair(9, "BPT_TargetError 0.0001\n"),
                                         std::pair(4096, "BPT_TargetError 0.04\nBPT_Adaptive true\n"),
                                         std::pair(4096, "BPT_TargetError 0.5\nBPT_Adaptive true\n")));

TEST_F(StagedFarm, EndsAtItsTargetError) {
  const std::string scene = this->scene(100'000, "BPT_TargetError 0.05\n");
  const Process server = serve();
  const Process worker = work();
  const Outcome outcome = farm({"render", scene, "-o", path("farm.pfm"), "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json summary = json::parse(outcome.out);
  EXPECT_LE(summary["estimated_error"].get<double>(), 0.05);
  EXPECT_LT(summary["samples"].get<double>(), 100'000);
}

TEST_F(StagedFarm, ResumesInALaterStage) {
  const std::string scene = this->scene(1500, "BPT_Adaptive true\n");
  const std::string expected = digest_of_one_process(scene);
  const Process server = serve();
  Process rendering = render(scene);
  std::optional<Process> worker = work();
  // The pilot's 32 samples of 1500 are few parts.
  const auto is_beyond_pilot = [&] {
    const std::string output = rendering.output();
    const std::size_t last = output.rfind("\"parts\":");
    return last != std::string::npos && std::stoi(output.substr(last + 8)) > 40 && has_parts(rendering, 20);
  };
  ASSERT_TRUE(test::wait_until(is_beyond_pilot)) << rendering.output();
  worker->kill_and_wait();
  rendering.kill_and_wait();
  ASSERT_TRUE(std::filesystem::exists(path("farm.pfm.ledger")));
  worker = work();
  Process resumed = render(scene);
  expect_image(resumed, expected);
}

// Where the samples of an adaptive image go follows from its pilot: with a wrong one, all of them are wrong.
TEST_F(StagedFarm, StartsOverIfThePilotWasWrong) {
  const std::string scene = this->scene(64, "BPT_Adaptive true\n");
  const std::string expected = digest_of_one_process(scene);
  const Process server = serve();
  Process rendering = render(scene);
  Impostor impostor(url_, path(""));
  const farm::Task first = impostor.next_task();
  transport::SamplePart wrong = impostor.part_of(first);
  const std::string right = bytes_of(wrong);
  wrong.tiles[static_cast<std::size_t>(first.first_tile)].spreads[0] += 1;
  impostor.send("00000000000000c0", first, bytes_of(wrong));
  for (farm::Task task = impostor.next_task(); task.is_pilot; task = impostor.next_task()) {
    impostor.send("00000000000000c1", task, bytes_of(impostor.part_of(task)));
  }
  impostor.send("00000000000000c1", first, right);
  EXPECT_TRUE(rendering.wait_for("worker 00000000000000c0 was dropped")) << rendering.output();
  const Process worker = work();
  expect_image(rendering, expected);
}

}  // namespace
