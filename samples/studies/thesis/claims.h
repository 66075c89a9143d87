// The thesis' claims are checked against today's measurements.
#pragma once

#include <string>
#include <vector>

#include "samples/studies/markdown.h"
#include "samples/studies/thesis/printed.h"
#include "samples/studies/thesis/results.h"

namespace study {

std::vector<Verdict> cornell_claims(const Results& results, const PrintedTables& printed);
// The sphere, with the same scheme parameters for all BRDFs, and with adjusted ones.
std::vector<Verdict> constant_claims(const Results& results, const PrintedTables& printed);
std::vector<Verdict> adjusted_claims(const Results& results, const PrintedTables& printed);
std::vector<Verdict> dragon_claims(const Results& results);
std::vector<Verdict> pottery_claims(const Results& results, const PrintedTables& printed);
std::vector<Verdict> jug_claims(const Results& results, const PrintedTables& printed);
std::vector<Verdict> measured_claims(const Results& results, const PrintedTables& printed);
/// Checks the claim of figure 5.11.
std::vector<Verdict> lobe_claims();

/// Compares `path` with `warp` to the thesis' estimator with its method in one paragraph, with the rates of
/// convergence of both.
std::string changes(const Results& results, const std::string& scene, const PrintedTable& errors);

}  // namespace study
