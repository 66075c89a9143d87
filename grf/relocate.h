// Moving a scene's text to another folder, or the texts of several files into one.
#pragma once

#include <map>
#include <span>
#include <string>

#include "grf/scene.h"

namespace grf {

/// Names files as they have to be named from the file `to`, where the scene named them from the file `from`:
/// includes, textures, BRDFs and their data. Names that are absolute stay as they are. The files that are
/// keys of `moved` go to the new folder themselves, and get the names that are their values.
void relocate(Scene& scene, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved = {});
// These relocate parts of a scene, which stand in the file itself and not in one that it includes.
void relocate(std::span<Block> blocks, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved = {});
void relocate(std::span<Definition> definitions, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved = {});
void relocate(std::span<Surface> surfaces, const std::string& from, const std::string& to,
              const std::map<std::string, std::string>& moved = {});

/// Names files by absolute paths, where the scene named them from the file `from` or from those that it
/// includes. What was included becomes part of the scene, as in `flatten`.
Scene with_absolute_names(const Scene& scene, const std::string& from);

/// The scene as one file, called `path` as the scene was: blocks of included files stand in the place of the
/// include, BRDFs that had files of their own are written out. Comments stay where they were.
Scene flatten(const Scene& scene, const std::string& path);

}  // namespace grf
