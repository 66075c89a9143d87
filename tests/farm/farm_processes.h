// Processes of a farm on this machine: its server, workers and coordinators, which tests start and kill.
#pragma once

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/transport/digest.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace test {

inline std::string bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns the SHA-256 digest of a file.
inline std::string digest_of_file(const std::string& path) {
  return transport::hex(transport::digest_of(bytes_of_file(path)));
}

/// Waits until a condition holds, for a time that a loaded machine may take.
inline bool wait_until(const std::function<bool()>& condition) {
  constexpr std::chrono::milliseconds Step{20};
  constexpr int Steps = 6000;
  for (int i = 0; i < Steps; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(Step);
  }
  return false;
}

/// A program that runs beside the test, which kills it at the end. What it prints goes to a file.
class Process {
 public:
  Process(const std::vector<std::string>& command, std::string output) : output_(std::move(output)) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int failure = ::posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) throw std::system_error(failure, std::generic_category(), command[0]);
  }
  Process(Process&& other) noexcept
      : process_(std::exchange(other.process_, 0)), output_(std::move(other.output_)) {}
  Process& operator=(Process&& other) noexcept {
    std::swap(process_, other.process_);
    std::swap(output_, other.output_);
    return *this;
  }
  ~Process() {
    if (process_ == 0) return;
    send(SIGCONT);
    send(SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }

  void send(int signal) const { ::kill(process_, signal); }
  std::string output() const { return bytes_of_file(output_); }
  bool has_printed(const std::string& text) const { return output().find(text) != std::string::npos; }
  bool wait_for(const std::string& text) const {
    return wait_until([&] { return has_printed(text); });
  }

  /// Returns the exit code once the program has ended, minus the signal that killed it.
  int wait() {
    int status = 0;
    const bool has_ended = wait_until([&] { return ::waitpid(process_, &status, WNOHANG) == process_; });
    EXPECT_TRUE(has_ended) << output();
    if (!has_ended) return -1;
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  void kill_and_wait() {
    send(SIGKILL);
    wait();
  }

 private:
  pid_t process_ = 0;
  std::string output_;
};

/// Returns whether nobody listens on a port of this machine, and the port, which is a free one for 0.
inline std::pair<bool, int> bind_port(int port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  socklen_t size = sizeof(address);
  const bool is_free = ::bind(socket, reinterpret_cast<sockaddr*>(&address), size) == 0;
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  ::close(socket);
  return {is_free, ntohs(address.sin_port)};
}

/// A farm on a port of its own, and a scene whose picture has 64x64 pixels.
class FarmTest : public testing::Test {
 protected:
  static constexpr const char* Bpt = GRANADA_BIN_DIR "/bpt";

  TemporaryFolder folder_;
  const int port_ = bind_port(0).second;
  const std::string url_ = "nats://127.0.0.1:" + std::to_string(port_);
  std::string token_file_;  ///< empty: none
  int started_ = 0;

  std::string path(const std::string& name) const { return folder_.path(name); }

  std::string scene(int samples, const std::string& options = "") const {
    folder_.add("scene.grf",
                "begin mesh brdf diffuse kd=0.6\n"
                "begin vertexs (-2,0,-2) (2,0,-2) (2,0,2) (-2,0,2) (-1,0,0) (1,0,0) (0,2,0) end vertexs\n"
                "begin faces (0,3,2,1) (4,5,6) end faces end mesh\n"
                "light begin (-1,3,-1) (2,0,0) (0,0,2) end\n");
    return folder_.add("scene.op", "BPT_Scene scene.grf\nBPT_Image_Resolution 64 64\nBPT_Samples " +
                                       std::to_string(samples) + "\n" + options);
  }

  /// Renders the picture by one process, and returns the digest of its pixels: the reference of all others.
  std::string digest_of_one_process(const std::string& scene) const {
    const Outcome outcome = run({Bpt, "render", scene, "-o", path("one.pfm")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return digest_of_file(path("one.pfm"));
  }

  Process start(std::vector<std::string> arguments, const std::string& program = Bpt) {
    arguments.insert(arguments.begin(), {program, "farm"});
    return Process(arguments, path("output" + std::to_string(started_++)));
  }
  std::vector<std::string> with_access(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--server", url_});
    if (!token_file_.empty()) arguments.insert(arguments.end(), {"--token-file", token_file_});
    return arguments;
  }
  Process serve(const std::string& folder = "server") {
    std::vector<std::string> arguments = {
        "serve", "--port", std::to_string(port_), "--folder", path(folder), "--host", "127.0.0.1"};
    if (!token_file_.empty()) arguments.insert(arguments.end(), {"--token-file", token_file_});
    Process server = start(arguments);
    EXPECT_TRUE(server.wait_for("To render:")) << server.output();
    return server;
  }
  /// Kills a server, with the nats-server that is its child.
  void kill_server(Process& server) const {
    server.kill_and_wait();
    EXPECT_TRUE(wait_until([&] { return bind_port(port_).first; }));
  }
  Process work(const std::string& program = Bpt) {
    return start(with_access({"work", "--threads", "1", "--cache", path("cache")}), program);
  }
  Process render(const std::string& scene, const std::string& output = "farm.pfm") {
    return start(with_access({"render", scene, "-o", path(output), "--part-seconds", "0.02", "--lease", "1",
                              "--progress", "json"}));
  }
  /// Runs one of the other commands.
  Outcome farm(const std::vector<std::string>& arguments) const {
    std::vector<std::string> words = with_access(arguments);
    words.insert(words.begin(), {Bpt, "farm"});
    return run(words);
  }
  /// Waits for a render to end, whose image then has this digest.
  void expect_image(Process& render, const std::string& digest,
                    const std::string& output = "farm.pfm") const {
    EXPECT_EQ(render.wait(), 0) << render.output();
    EXPECT_EQ(digest_of_file(path(output)), digest);
    EXPECT_FALSE(std::filesystem::exists(path(output + ".ledger")));
  }
  static bool has_parts(const Process& render, int count) {
    const std::string output = render.output();
    const std::size_t last = output.rfind("\"parts_done\":");
    return last != std::string::npos && std::stoi(output.substr(last + 13)) >= count;
  }
};

/// A farm with a scene of so many samples, and the digest of its image by one process.
class FarmOfSceneTest : public FarmTest {
 protected:
  explicit FarmOfSceneTest(int samples) : scene_(scene(samples)), expected_(digest_of_one_process(scene_)) {}

  void expect_image(Process& render, const std::string& output = "farm.pfm") const {
    FarmTest::expect_image(render, expected_, output);
  }

  const std::string scene_;
  const std::string expected_;
};

}  // namespace test
