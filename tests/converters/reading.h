// Helpers of the tests of readers: files made of text, and access to the scenes that they give.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/format.h"
#include "grf/diagnostics.h"
#include "grf/scene.h"
#include "tests/support/temporary_folder.h"

namespace convert {

/// The result of reading a file: a scene, or none, and its diagnostics.
struct Reading {
  std::optional<grf::Scene> scene;
  std::vector<EmbeddedFile> files;
  std::vector<options::NamedCamera> cameras;
  grf::Diagnostics diagnostics;

  std::string text() const { return diagnostics.to_text(); }
};

Reading read_path(const std::string& path, const ReadOptions& options = {});

/// Reads a file of this name and content, the only one in its folder.
Reading read_bytes(const std::string& name, std::string_view bytes);

/// The vertices of a unit square as OBJ.
inline const std::string SquareVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// Reads OBJ text from a file `model.obj`, with `model.mtl` beside it if there is text for one.
Reading read_obj_text(std::string_view obj, std::string_view mtl = {}, const ReadOptions& options = {});

/// Parses valid GRF text.
grf::Scene scene_of_grf(const std::string& text);

/// Returns all meshes of a scene, in order.
std::vector<grf::Mesh> meshes_of(const grf::Scene& scene);

/// Returns the only mesh of a scene that was read; otherwise fails the test and returns a mesh without
/// faces.
grf::Mesh only_mesh(const Reading& reading);

/// Returns all definitions of a scene, in order.
std::vector<grf::Definition> definitions_of(const grf::Scene& scene);

/// Returns the GRF text of the definition's BRDF.
std::string brdf_text(const grf::Definition& definition);

/// Returns the name of the definition that a face's BRDF refers to; empty if it has no BRDF.
std::string material_of(const grf::Mesh& mesh, std::size_t face);

}  // namespace convert
