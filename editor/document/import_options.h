// Options of an import, applied to a model that was read, so that a change of them needs no reading.
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "converters/mesh_operations/mesh_operations.h"
#include "grf/diagnostics.h"
#include "grf/model.h"

namespace editor {

struct LoadedScene;

/// Import options change a model after it was read, as those of `grfconvert` do.
struct ImportOptions {
  bool is_z_up = false;
  std::string unit = "m";  ///< of the file, one of convert::length_units(); a unit of the scene is a metre
  convert::MeshOperations operations;
  std::string brdf;            ///< for faces without one, as GRF text; empty: GRF's default
  std::vector<bool> left_out;  ///< of `imported_meshes`; empty: none

  /// Whether they change nothing.
  bool are_default() const;
};

/// A mesh of a model, each once.
struct ImportedMesh {
  QString name;
  std::size_t faces = 0;
};
std::vector<ImportedMesh> imported_meshes(const LoadedScene& loaded);

/// Reads the BRDF of an option; nothing if it is empty, or wrong, which is then an error.
std::optional<grf::BrdfModel> read_import_brdf(const std::string& text, grf::Diagnostics& diagnostics);

/// Applies the options to a model as it was read, in any thread. What that loses is among the model's losses.
std::shared_ptr<const LoadedScene> with_options(const LoadedScene& loaded, const ImportOptions& options);

/// The type of a model by which options are remembered: the extension of its name, in lower case.
QString import_type(const QString& file);

/// The remembered options for a type, in the settings. The objects to leave out are not remembered.
ImportOptions remembered_import_options(const QString& type);
void remember_import_options(const QString& type, const ImportOptions& options);

/// Whether the options are shown before a model of the type is imported; true until that is changed.
bool asks_for_import_options(const QString& type);
void set_asks_for_import_options(const QString& type, bool asks);

}  // namespace editor
