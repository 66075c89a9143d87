#pragma once

#include "renderer/command/brdf_fit.h"

namespace CLI {
class App;
}

namespace command {

/// Adds `fit` with its options to the command line of `bpt brdf`.
void add_fit(CLI::App& brdf, BrdfFitArguments& arguments);

}  // namespace command
