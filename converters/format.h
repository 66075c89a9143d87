// The file formats that scenes come in and go out as. One table of them drives the command line, file
// dialogs, documents and tests.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "converters/material_rule.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"

namespace convert {

struct ReadOptions {
  /// What faces reflect that come without a material; empty: they get no BRDF, and GRF's default holds.
  std::optional<grf::BrdfModel> brdf;
};

/// A file that stood inside another one, such as an image in a GLB file.
struct EmbeddedFile {
  std::string name;  ///< of its own, without a folder: it is to be written beside the scene that names it
  std::string bytes;
};

/// What a file holds. The scene names other files from the folder of the file, and so the embedded ones, as
/// though they stood there already.
struct Import {
  grf::Scene scene;
  std::vector<EmbeddedFile> files;
};

/// What there is to know of one file format.
struct Format {
  std::string_view name;                     ///< as options say it: `obj`
  std::string_view title;                    ///< as people say it
  std::vector<std::string_view> extensions;  ///< in lower case, without the dot; the usual one first

  /// True if a file that begins with these bytes is of the format. Never true of two formats.
  bool (*sniff)(std::string_view first_bytes);

  /// What a file holds, or nothing after an error. Null: the format is not read.
  std::optional<Import> (*read)(const std::string& path, const ReadOptions& options,
                                grf::Diagnostics& diagnostics) = nullptr;

  /// Replaces the file, or leaves it as it was and says why. Null: the format is not written.
  bool (*write)(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) = nullptr;

  /// What is written holds the images of its faces: they need not stand beside it.
  bool embeds_images = false;

  std::string_view keeps;
  std::string_view loses;

  std::span<const MaterialRule> read_materials;     ///< what becomes of its materials
  std::span<const MaterialRule> written_materials;  ///< and of GRF's
};

/// All formats, in the order in which they are listed.
std::span<const Format> formats();

/// The format with a name, or null.
const Format* find_format(std::string_view name);

/// The first format that the extension of a file's name stands for, or null.
const Format* format_of_name(const std::string& path);

/// The format of a file that exists: by its content, or else by its name. Null after an error.
const Format* recognise(const std::string& path, grf::Diagnostics& diagnostics);

/// Reads a file of a format. Nothing is returned after an error.
std::optional<Import> read(const Format& format, const std::string& path, const ReadOptions& options,
                           grf::Diagnostics& diagnostics);

}  // namespace convert
