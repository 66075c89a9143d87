// What the figures say of the thesis' claims.
#pragma once

#include <string>
#include <vector>

#include "samples/studies/markdown.h"
#include "samples/studies/thesis/printed.h"
#include "samples/studies/thesis/results.h"

namespace study {

std::vector<Verdict> cornell_claims(const Results& results, const Printed& printed);
/// Of the sphere with the same parameters for all BRDFs, and with adjusted ones.
std::vector<Verdict> constant_claims(const Results& results, const Printed& printed);
std::vector<Verdict> adjusted_claims(const Results& results, const Printed& printed);
std::vector<Verdict> dragon_claims(const Results& results);
std::vector<Verdict> pottery_claims(const Results& results, const Printed& printed);
std::vector<Verdict> jug_claims(const Results& results, const Printed& printed);
std::vector<Verdict> measured_claims(const Results& results, const Printed& printed);
/// Of figure 5.11.
std::vector<Verdict> lobe_claims();

/// What `path` with `warp` gives beside the thesis' estimator with its method, in one paragraph; and how the
/// errors fall, there and here.
std::string changes(const Results& results, const std::string& scene, const PrintedTable& errors);

}  // namespace study
