// Compiles BRDFs from data to BRDFs that can be evaluated.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/reflectance/brdf.h"

namespace editor {

/// The definitions in scope, outer ones first, in which the terms of a `combine` are looked up. They need not
/// all be BRDFs.
using Definitions = std::vector<grf::Definition>;

/// The names of the BRDFs among the definitions, the innermost of each name.
std::vector<QString> brdf_names(const Definitions& definitions);

/// The error messages of the diagnostics.
std::vector<QString> error_messages(const grf::Diagnostics& diagnostics);

struct CompiledBrdf {
  std::shared_ptr<const reflectance::Brdf> brdf;  ///< null after an error
  std::vector<QString> errors;                    ///< messages of `grf::check` and of the renderer
};

/// Checks and compiles a BRDF. Measured data is read from its file, which takes up to a tenth of a second.
CompiledBrdf compile_brdf(const grf::BrdfModel& model, const Definitions& definitions);

/// Whether compiling the BRDF reads a file.
bool reads_data(const grf::BrdfModel& model, const Definitions& definitions);

/// The errors that `grf::check` reports for a BRDF, without reading any file.
std::vector<QString> errors_of(const grf::BrdfModel& model, const Definitions& definitions);

}  // namespace editor
