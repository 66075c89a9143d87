// Measurements are made by running `bpt`.
#pragma once

#include <string>
#include <vector>

#include "samples/studies/thesis/results.h"

namespace study {

/// Runs the programs of this build.
class Programs {
 public:
  /// `folder` has the programs; `log` collects their standard error: warnings about BRDFs that are as
  /// published.
  Programs(std::string folder, std::string log) : folder_(std::move(folder)), log_(std::move(log)) {}

  /// Runs a program and returns its standard output. Throws if it fails.
  std::string run(const std::string& program, const std::vector<std::string>& arguments) const;

 private:
  std::string folder_, log_;
};

/// Writes the group's scene and options into the folder, and returns the path of the OP file.
std::string write_scene(const Group& group, const std::string& folder);

/// Runs `bpt cost` and returns its rows.
std::vector<Row> measure(const Group& group, const Programs& programs, const std::string& folder);

/// Generates the files of scenes that are too large for the repository: the dragon's mesh, and tables that
/// stand in for measured materials unless `merl` is a folder with those of the MERL data base.
void prepare(const Choice& choice, const Programs& programs, const std::string& merl);

}  // namespace study
