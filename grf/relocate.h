// Functions that move a scene's text to another folder, or merge the texts of several files into one.
#pragma once

#include <map>
#include <span>
#include <string>

#include "grf/scene.h"

namespace grf {

/// Rewrites relative file names (includes, textures, BRDFs and their data) from being relative to the file
/// `from` to being relative to the file `to`. Absolute names stay. Files that are keys of `moved` move to the
/// new folder themselves, under the names that are their values.
void relocate(Scene& scene, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved = {});
// These relocate parts of a scene that are in the file itself, not in an included one.
void relocate(std::span<Block> blocks, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved = {});
void relocate(std::span<Definition> definitions, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved = {});
void relocate(std::span<Surface> surfaces, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved = {});

/// Returns the scene with absolute file names in place of names relative to the file `from` or to those that
/// it includes. Includes are expanded, as in `flatten`.
Scene with_absolute_names(const Scene& scene, const std::string& from);

/// Flattens a scene into one file of the same `path`: expands includes, and writes BRDFs that had files of
/// their own inline. Comments are kept.
Scene flatten(const Scene& scene, const std::string& path);

}  // namespace grf
