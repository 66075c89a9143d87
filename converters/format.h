// The file formats for import and export. One table of them drives the command line, file dialogs, documents
// and tests.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "converters/material_rule.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "renderer/options/render_options.h"

namespace convert {

/// What a reader is told besides the name of the file.
struct ReadOptions {
  /// The BRDF for faces without a material; empty: they get no BRDF, and GRF's default holds.
  std::optional<grf::BrdfModel> brdf;
  /// The name of the variant of a glTF file's materials; empty: the default materials. An error for files of
  /// other formats.
  std::string variant = {};
};

/// A file embedded in another one, such as an image in a GLB file.
struct EmbeddedFile {
  std::string name;  ///< without a folder: it is to be written beside the scene that names it
  std::string bytes;
};

/// The result of an import. File names in the scene, also those of embedded files, are relative to the folder
/// of the imported file.
struct Import {
  grf::Scene scene;
  std::vector<EmbeddedFile> files;
  bool is_grf = false;  ///< whether the scene is exactly one of GRF, also if it was embedded in another file
  std::vector<options::NamedCamera> cameras =
      {};  ///< of the file, in the scene's world, with different names
};

/// Options of writing, for formats that take them.
struct WriteOptions {
  /// The path of an OP file, for formats with a view: its camera, film and environment map are written;
  /// empty: a default view.
  std::string op_file;
};

/// The descriptor of a file format.
struct Format {
  std::string_view name;                     ///< name for options: `obj`
  std::string_view title;                    ///< name for people
  std::vector<std::string_view> extensions;  ///< in lower case, without the dot; the usual one first
  bool has_variants = false;                 ///< whether files can have variants of their materials

  /// Returns whether a file that begins with these bytes is of the format. At most one format returns true.
  bool (*sniff)(std::string_view first_bytes);

  /// Reads a file; returns nothing after an error. Null: the format is not read.
  std::optional<Import> (*read)(const std::string& path, const ReadOptions& options,
                                grf::Diagnostics& diagnostics) = nullptr;

  /// Writes a file, or leaves it unchanged and reports why. Null: the format is not written.
  bool (*write)(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) = nullptr;

  /// Writes a file likewise, with options. Null: the format takes none.
  bool (*write_view)(const grf::Scene& scene, const std::string& path, const WriteOptions& options,
                     grf::Diagnostics& diagnostics) = nullptr;

  /// Whether written files embed the images of their textures.
  bool embeds_images = false;

  std::string_view keeps;
  std::string_view loses;

  std::span<const MaterialRule> read_materials;     ///< conversion of its materials to GRF
  std::span<const MaterialRule> written_materials;  ///< conversion of GRF's materials to it
};

/// Returns all formats, in the order in which they are listed.
std::span<const Format> formats();

/// Finds a format by name, or returns null.
const Format* find_format(std::string_view name);

/// Finds the first format with the extension of a file's name, or returns null.
const Format* format_of_name(const std::string& path);
/// Finds the first format with that extension that is read, or else one that is only written, or returns
/// null.
const Format* read_format_of_name(const std::string& path);

/// Detects the format of an existing file: by its content, or else by its name. Null after an error.
const Format* recognise(const std::string& path, grf::Diagnostics& diagnostics);

/// Reads a file of a format; returns nothing after an error.
std::optional<Import> read(const Format& format, const std::string& path, const ReadOptions& options,
                           grf::Diagnostics& diagnostics);

}  // namespace convert
