#pragma once

#include <span>
#include <string>

#include "renderer/plot/fit_file.h"
#include "renderer/reflectance/reflector.h"
#include "renderer/studies/angles.h"

namespace studies {

/// Returns a path that a file names, relative to that file's folder, as it is written in another file.
std::string renamed(const std::string& path, const grf::SourceLocation& named_at, const std::string& in_file);

/// Makes a FIT file of the samples that are not specular; `path` is where it will be written, which paths of
/// data files are relative to. The values are means of f over RGB, to lie on the BRDF's plot.
plot::FitFile fit_of(const grf::BrdfModel& model, const reflectance::Reflector& reflector, const Angles& view,
                     std::span<const reflectance::ScatterSample> samples, const std::string& path);

}  // namespace studies
