// A project as plain values, for tests that compare edits with a reference model: the contents of each file,
// with transforms multiplied out, names as written, and no sharing.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grf/scene.h"
#include "grf/scene_path.h"

namespace editor {

using Plain3 = std::array<float, 3>;

struct PlainCorner {
  Plain3 position = {};
  std::optional<Plain3> colour;
  std::optional<Plain3> irradiance;
  bool operator==(const PlainCorner&) const = default;
};

/// Attributes as text; the name of a definition follows an `@`.
struct PlainSurface {
  std::optional<std::string> colour;
  std::optional<std::string> brdf;
  std::optional<std::string> texture;  ///< absolute path
  std::optional<Plain3> emission;
  bool operator==(const PlainSurface&) const = default;
};

struct PlainFace {
  std::vector<PlainCorner> corners;
  PlainSurface surface;
  bool operator==(const PlainFace&) const = default;
};

struct PlainMesh {
  PlainSurface own;  ///< the mesh's own surface
  std::vector<PlainFace> faces;
  bool operator==(const PlainMesh&) const = default;
};

struct PlainObject {
  enum class Kind { Mesh, MeshLight, Light, Observers, Use, Include };
  Kind kind = Kind::Mesh;
  std::string name;  ///< of a mesh, or of the used one, or the absolute path of an included file
  float scale = 1;
  Plain3 offset = {};  ///< after the scale, in the coordinates of the file
  PlainMesh mesh;
  std::vector<Plain3> points;  ///< corner, edges and radiance of a light; observers
  bool operator==(const PlainObject&) const = default;
};

/// The body of a definition: a mesh, or a text.
struct PlainDefinition {
  bool is_mesh = false;
  std::string text;
  PlainMesh mesh;
  bool operator==(const PlainDefinition&) const = default;
};

struct PlainFile {
  std::map<std::string, PlainDefinition> definitions;
  std::vector<PlainObject> objects;
  bool operator==(const PlainFile&) const = default;
};

/// The project's own file, included files by their absolute paths, and its render options.
struct PlainProject {
  PlainFile main;
  std::map<std::string, PlainFile> files;
  int depth = 0;
  float background = 0;
  bool operator==(const PlainProject&) const = default;
};

/// The location of an object of a plain project in a scene.
struct PlainPlace {
  std::string file;  ///< empty for the project's own
  std::string name;  ///< of a definition; empty for an object
  std::size_t object = 0;
  grf::ScenePath path;
  float file_scale = 1;  ///< of the include that contains it

  bool is_definition() const { return !name.empty(); }
};

struct PlainReading {
  PlainProject project;  ///< without options
  std::vector<PlainPlace> places;
  bool has_one_text_per_file = true;
  bool has_one_meaning_per_name = true;  ///< in each file; otherwise definitions are missing in the project
};

/// Converts a scene; the path is that of its file.
PlainReading plain_reading(const grf::Scene& scene, const std::string& path);

/// Lists the differences of two projects; empty if they are equal.
std::string differences(const PlainProject& expected, const PlainProject& found);

}  // namespace editor
