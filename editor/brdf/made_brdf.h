// From BRDFs as data to BRDFs that can be evaluated.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/reflectance/brdf.h"

namespace editor {

/// BRDFs that names can mean, outer ones first: what the terms of a `combine` are looked up in. Other
/// definitions may be among them.
using Definitions = std::vector<grf::Definition>;

/// Names of the BRDFs among them, the innermost of each name.
std::vector<QString> brdf_names(const Definitions& definitions);

/// The errors among what was reported.
std::vector<QString> error_messages(const grf::Diagnostics& diagnostics);

struct MadeBrdf {
  std::shared_ptr<const reflectance::Brdf> brdf;  ///< null after a mistake
  std::vector<QString> mistakes;                  ///< in the words of `grf::check` and of the renderer
};

/// Checks a BRDF and makes it. Reads the file of measured data, which takes up to a tenth of a second.
MadeBrdf made_brdf(const grf::BrdfModel& model, const Definitions& definitions);

/// Whether making it reads a file.
bool reads_data(const grf::BrdfModel& model, const Definitions& definitions);

/// What is wrong with a BRDF, as `grf::check` says it, without reading any file.
std::vector<QString> mistakes_of(const grf::BrdfModel& model, const Definitions& definitions);

}  // namespace editor
