#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "grf/exit_code.h"
#include "grf/short_lived_folder.h"
#include "renderer/command/render_arguments.h"

namespace command {

/// The command line of `bpt pack`.
struct PackArguments {
  std::string scene;  ///< an OP file, or a GRF scene
  OptionFlags flags;  ///< become options of the packed OP file
  std::string output;
  bool json = false;
};

/// Packs a scene with all files that it reads into a job file, and prints its name.
grf::ExitCode pack(const PackArguments& arguments);

/// Packs it likewise, and prints only errors of flags. The file may lack what a scene names in an unusual
/// way.
grf::ExitCode pack_scene(const std::string& scene, const OptionFlags& flags, const std::string& output,
                         grf::Diagnostics& diagnostics);

/// Whether a file is a job file, by its name.
bool is_job_file(const std::string& path);

/// A job file, unpacked into a temporary folder for as long as this lives.
class UnpackedJob {
 public:
  /// Unpacks a file and returns the path of its OP file; to be called once.
  std::optional<std::string> unpack(const std::string& path, grf::Diagnostics& diagnostics);

 private:
  std::optional<grf::ShortLivedFolder> folder_;
};

}  // namespace command
