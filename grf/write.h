// Functions that write a scene as GRF text: one style, deterministic bytes, shortest round-trip numbers.
#pragma once

#include <string>

#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace grf {

/// Returns the text of a scene's own file. Included files are only named in it.
std::string to_text(const Scene& scene);

/// Returns the text of an instance as written after the keyword `brdf` or `pdf`, or in a file of its own.
std::string to_text(const BrdfModel& brdf);
std::string to_text(const PdfModel& pdf);

/// Returns the text of a surface's attributes: a line each, as at the beginning of a mesh.
std::string to_text(const Surface& surface);

/// Returns the text of the attribute, with its keyword.
std::string to_text(const Opacity& opacity);

/// Replaces typographic quotes by plain ones in a text that has both, as writing does: a string stands
/// between quotes of one kind, and cannot have both. Readers of other formats name meshes by it, so that a
/// scene is read back as it was.
std::string with_one_kind_of_quotes(std::string text);

/// Returns the double with the fewest digits that rounds to a float, for formats that only have doubles: 0.1F
/// gives 0.1.
double shortest(float value);

/// Writes a scene: replaces its file, and the included files that differ from their contents because either
/// has changed since it was read (each with a note that names it). A file that cannot be written stays
/// unchanged, and the diagnostics say why. Text that the format cannot express is replaced: line ends in
/// comments and names by spaces, and typographic quotes in a name that has plain ones too by plain ones.
bool write(const Scene& scene, const std::string& path, Diagnostics& diagnostics);

}  // namespace grf
