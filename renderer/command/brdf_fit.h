// `bpt brdf fit` finds the parameters of models that are nearest to data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grf/exit_code.h"

namespace command {

struct BrdfFitArguments {
  std::string data;  ///< a CSV, MERL or RGL file, or an instance; see reflectance::read_instance
  std::string targets;
  std::size_t lobes = 1;
  std::string metric = "cuberoot";
  std::vector<std::string> fixed;  ///< `NAME=VALUE` each
  std::size_t samples = 0;         ///< of a BRDF or a table; 0: 4000 pairs, or 20,000 cells
  std::string output;              ///< file of the best fit; empty: none
  std::string report;              ///< folder of the report; empty: none
  int threads = 0;                 ///< 0: one per core
  bool json = false;
};

/// Fits the targets to the data, and prints them by rank, with intervals of their parameters and warnings.
grf::ExitCode fit_brdfs(const BrdfFitArguments& arguments);

}  // namespace command
