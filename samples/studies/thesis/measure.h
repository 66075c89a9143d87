// Runs `bpt`.
#pragma once

#include <string>
#include <vector>

#include "samples/studies/thesis/results.h"

namespace study {

/// The programs of this build.
class Programs {
 public:
  /// Their folder, and a file for what they say besides their output: warnings of BRDFs that are as
  /// published.
  Programs(std::string folder, std::string log) : folder_(std::move(folder)), log_(std::move(log)) {}

  /// What one prints. Throws if it fails.
  std::string run(const std::string& program, const std::vector<std::string>& arguments) const;

 private:
  std::string folder_, log_;
};

/// Writes the group's scene and options into the folder, and returns the path of the OP file.
std::string write_scene(const Group& group, const std::string& folder);

/// The rows of `bpt cost`.
std::vector<Row> measure(const Group& group, const Programs& programs, const std::string& folder);

/// Makes what scenes need and is too large to be kept: the dragon's mesh, and tables that stand in for
/// measured materials unless there is a folder with those of the MERL data base.
void prepare(const Choice& choice, const Programs& programs, const std::string& merl);

}  // namespace study
