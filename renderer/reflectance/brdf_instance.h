// The text of an instance becomes a BRDF or a sampling scheme that can be evaluated and sampled.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/reflectance/reflector.h"

namespace reflectance {

/// Checks a BRDF and makes it ready for evaluation; returns nothing after an error. The terms of a `combine`
/// are looked up in the definitions. Images that vary parameters are left out, with a warning.
std::optional<Brdf> make_brdf(const grf::BrdfModel& model, grf::Diagnostics& diagnostics,
                              std::span<const grf::Definition> definitions = {});

/// Makes the sampling scheme of a `pdf`, without its tables; returns nothing after an error in it, or if it
/// does not support the BRDF.
std::optional<Scheme> make_scheme(const grf::PdfModel& model, const Brdf& brdf,
                                  const std::string& brdf_keyword, grf::Diagnostics& diagnostics);

/// Reads a BRDF from a text such as `ward sx=0.2`, from the file of that name (text, or measured data, of RGL
/// or with an ending of `measured_formats`), or, if the text is `scene.grf:NAME`, from the first definition
/// of that name in a scene; with its own sampler. Returns nothing after an error.
std::optional<Reflector> read_instance(const std::string& instance, grf::Diagnostics& diagnostics);

/// A BRDF with a sampling scheme.
struct SampledInstance {
  grf::BrdfModel model;
  Reflector reflector;
  double build_seconds = 0;  ///< build time of the scheme's tables
};

/// Reads a BRDF likewise, and a sampling scheme from a text such as `hemisphere exp=20`. Returns nothing
/// after an error in either, or if the scheme does not support the BRDF.
std::optional<SampledInstance> read_sampled_instance(const std::string& instance, const std::string& pdf,
                                                     grf::Diagnostics& diagnostics);

/// Builds the tables of a scheme for a BRDF, and measures how long that takes.
SampledInstance sampled_instance(const grf::BrdfModel& model, const Brdf& brdf, const Scheme& scheme);

}  // namespace reflectance
