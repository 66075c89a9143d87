// `bpt farm` renders on many machines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/exit_code.h"
#include "renderer/command/render_arguments.h"
#include "renderer/farm/farm.h"

namespace command {

/// How a command reaches the farm's server. Empty: not given.
struct FarmArguments {
  std::string server = "nats://127.0.0.1:4222";
  std::string token_file;
  std::string tls_authority;
  std::string tls_certificate;
  std::string tls_key;
  bool json = false;
};

/// The command line of `bpt farm serve`.
struct FarmServeArguments {
  std::string folder = "farm";  ///< of what the server keeps
  std::string host;             ///< to listen on; empty: all, if there is access control, else this machine
  int port = 4222;
  FarmArguments access;
};

/// The command line of `bpt farm work`.
struct FarmWorkArguments {
  int threads = 0;           ///< 0: one per core
  std::string cache_folder;  ///< empty: the user's
  double cache_gigabytes = 10;
  FarmArguments access;
};

/// The command line of `bpt farm render`.
struct FarmRenderArguments {
  std::string scene;  ///< an OP file, a GRF scene, or a job file
  OptionFlags flags;
  std::vector<std::string> outputs;  ///< images, one per file type
  double part_seconds = 2;
  double lease_seconds = 20;
  std::string progress = "bar";  ///< or `json`, or `none`
  FarmArguments access;
};

/// Connects to the farm's server; prints why not.
std::optional<farm::Farm> join_farm(const FarmArguments& arguments, const std::string& name);

/// Starts the farm's server and prints what to type on other machines, until a signal; or joins one that
/// runs.
grf::ExitCode farm_serve(const FarmServeArguments& arguments);

/// Works for the farm until a signal.
grf::ExitCode farm_work(const FarmWorkArguments& arguments);

/// Renders a scene on the farm, writes the image, and prints a summary. A signal leaves the work resumable.
grf::ExitCode farm_render(const FarmRenderArguments& arguments);

/// Prints the farm's jobs.
grf::ExitCode farm_list(const FarmArguments& arguments);

/// Prints the farm's jobs and workers.
grf::ExitCode farm_status(const FarmArguments& arguments);

/// Stops a job, whose coordinator keeps what is there.
grf::ExitCode farm_stop(const std::string& job, const FarmArguments& arguments);

}  // namespace command
