// Texts about noise: names of its parts and of changes, and advice.
#pragma once

#include <QString>

#include "editor/rendering/noise_results.h"

namespace editor {

/// The name of a lamp, of light of some bounces, or of a BRDF with its scheme.
QString name_of(const NoiseShareRow& row);
/// Names a change: `Split count: 4 instead of 2`, `Sampled by own instead of diffuse: ward sx=0.1`.
QString name_of(const NoiseTrial& change);
/// Says what a change that was tried does, with its intervals.
QString sentence_of(const NoiseTrial& change);
/// Says whether it pays, in a word or two; empty if it was not tried.
QString verdict_of(const NoiseTrial& change);
/// Says which parts make most of the noise, and which change that was tried is best.
QString advice_of(const NoiseResult& result);

}  // namespace editor
