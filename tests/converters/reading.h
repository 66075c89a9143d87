// What the tests of readers have in common: files made of text, and a look at the scenes that they give.
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

/// A scene, or none, and what was said of it.
struct Reading {
  std::optional<grf::Scene> scene;
  std::vector<EmbeddedFile> files;
  grf::Diagnostics diagnostics;

  std::string text() const { return diagnostics.to_text(); }
};

Reading read_path(const std::string& path, const ReadOptions& options = {});

/// Reads a file of this name and content, which is alone in its folder.
Reading read_bytes(const std::string& name, std::string_view bytes);

/// The vertices of a unit square as OBJ.
inline const std::string SquareVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// Reads OBJ text from a file `model.obj`, with `model.mtl` beside it if there is text for one.
Reading read_obj_text(std::string_view obj, std::string_view mtl = {}, const ReadOptions& options = {});

/// The scene of GRF text that is right.
grf::Scene scene_of_grf(const std::string& text);

/// All meshes of a scene, in order.
std::vector<grf::Mesh> meshes_of(const grf::Scene& scene);

/// The mesh of a scene that was read and has no other one: a mesh without faces, and a failed test, if it is
/// not so.
grf::Mesh only_mesh(const Reading& reading);

/// All definitions of a scene, in order.
std::vector<grf::Definition> definitions_of(const grf::Scene& scene);

/// The text of the definition's BRDF, as GRF has it.
std::string brdf_text(const grf::Definition& definition);

/// The name of the definition that a face's BRDF refers to; empty if it has no BRDF.
std::string material_of(const grf::Mesh& mesh, std::size_t face);

}  // namespace convert
