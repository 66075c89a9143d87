// Scenes are exported for the tests of what renderers get, and their files read again.
#pragma once

#include <string>
#include <vector>

#include "grf/mesh.h"
#include "renderer/image/image.h"
#include "tests/converters/renderers/mitsuba_scene.h"
#include "tests/converters/renderers/pbrt_scene.h"
#include "tests/support/temporary_folder.h"

namespace convert {

/// A scene that was exported for both renderers.
class ExportedScene {
 public:
  /// Exports GRF text; the OP text may be empty. Fails the test if that fails.
  explicit ExportedScene(const std::string& grf, const std::string& op = {});

  /// Exports a scene likewise, with files beside it, by name.
  ExportedScene(const std::string& grf, const std::string& op, const test::TemporaryFolder& files);

  const test::PbrtScene& pbrt() const { return pbrt_; }
  const test::MitsubaElement& mitsuba() const { return mitsuba_; }
  const std::string& pbrt_warnings() const { return pbrt_warnings_; }
  const std::string& mitsuba_warnings() const { return mitsuba_warnings_; }

  /// Reads a mesh, an image or a text that a scene names.
  grf::Mesh mesh(const std::string& name) const;
  image::Image image(const std::string& name) const;
  std::string path(const std::string& name) const { return folder_.path(name); }

  /// The meshes of all shapes that are no parts of instanced objects.
  std::vector<grf::Mesh> pbrt_meshes() const;
  std::vector<grf::Mesh> mitsuba_meshes() const;

 private:
  void write(const std::string& grf, const std::string& op, const std::string& folder);

  test::TemporaryFolder folder_;
  test::PbrtScene pbrt_;
  test::MitsubaElement mitsuba_;
  std::string pbrt_warnings_;
  std::string mitsuba_warnings_;
};

/// A mesh of a cube from (-1, -1, -1) to (1, 1, 1), its faces with these words before each of them.
std::string cube(const std::string& attributes = {}, const std::vector<std::string>& of_faces = {});

/// Returns the volume inside of the faces, negative if they are inside out.
double signed_volume(const grf::Mesh& mesh);

}  // namespace convert
