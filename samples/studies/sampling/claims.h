// The verdicts on the thesis' claims and on the targets.
#pragma once

#include <string>
#include <vector>

#include "samples/studies/markdown.h"
#include "samples/studies/sampling/measure.h"

namespace study {

std::vector<Verdict> build_claims(const Results& results);
std::vector<Verdict> tree_claims(const Results& results);
std::vector<Verdict> memory_claims(const Results& results);
std::vector<Verdict> factor_claims(const Results& results);
std::vector<Verdict> error_claims(const Results& results, Light light);
std::vector<Verdict> targets(const Results& results);

/// Explains why targets do not hold, as far as the figures tell.
std::string limits(const Results& results);

}  // namespace study
