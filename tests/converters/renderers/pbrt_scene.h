// A strict parser of the part of pbrt-v4's format that its documentation describes (pbrt.org/fileformat-v4),
// written apart from the writer.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/math.h"

namespace test {

/// A parameter: its type, such as `rgb`, and its values, of which one of the lists is used.
struct PbrtParameter {
  std::string type;
  std::vector<double> numbers;
  std::vector<std::string> strings;  ///< also of booleans
};
using PbrtParameters = std::map<std::string, PbrtParameter>;

/// An entity: a light, a material, a shape and so on.
struct PbrtEntity {
  std::string plugin;  ///< its type, such as `diffuse`
  PbrtParameters parameters;

  double number(const std::string& name) const { return parameters.at(name).numbers.at(0); }
  std::string string(const std::string& name) const { return parameters.at(name).strings.at(0); }
  grf::Vec3d rgb(const std::string& name) const {
    const std::vector<double>& values = parameters.at(name).numbers;
    return {values.at(0), values.at(1), values.at(2)};
  }
};

struct PbrtShape {
  PbrtEntity shape;
  std::string material;                ///< the name of a named one; else empty
  std::optional<PbrtEntity> own;       ///< a material without a name
  std::optional<PbrtEntity> emission;  ///< an area light
  std::string object;                  ///< the object that it is a part of; empty: of the scene
  grf::Matrix44d to_world;             ///< for row vectors
};

struct PbrtInstance {
  std::string object;
  grf::Matrix44d to_world;
};

struct PbrtScene {
  std::map<std::string, PbrtEntity> options;  ///< by directive: Film, Camera and so on
  grf::Matrix44d world_to_camera;             ///< for row vectors
  std::vector<PbrtEntity> lights;
  std::map<std::string, PbrtEntity> materials;
  std::map<std::string, PbrtEntity> textures;
  std::vector<PbrtShape> shapes;
  std::vector<PbrtInstance> instances;
};

/// Parses a scene. Throws std::runtime_error, with the line, for anything that pbrt's documentation does not
/// have: unknown directives, plugins, parameters or types, wrong numbers of values, colours out of range,
/// names that are not defined, and files that do not exist in the folder.
PbrtScene parse_pbrt(std::string_view text, const std::string& folder);

/// Returns where pbrt's camera sees a point, in pixels from the upper left corner.
grf::Vec2d pbrt_pixel(const PbrtScene& scene, const grf::Vec3d& point);

}  // namespace test
