// Writing a scene as GRF text: one style, deterministic bytes, the fewest digits that read back.
#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace grf {

/// The text of a scene's own file. Included files are named in it, not written out.
std::string to_text(const Scene& scene);

/// An instance as it stands after the word `brdf` or `pdf`, or in a file of its own.
std::string to_text(const BrdfModel& brdf);
std::string to_text(const PdfModel& pdf);

/// The double with the fewest digits that is this float, for formats that know doubles alone: 0.1F gives 0.1.
double shortest(float value);

/// Replaces the file, and the included files that do not hold their contents, since these or the files have
/// changed since they were read (each with a note that names it). A file that cannot be written stays as it
/// was, and the diagnostics say why.
///
/// Text that no file can hold is written in the nearest way: line ends in comments and names as spaces, and
/// the typographic quotes of a name that has plain ones too as plain ones.
bool write(const Scene& scene, const std::string& path, Diagnostics& diagnostics);

}  // namespace grf
