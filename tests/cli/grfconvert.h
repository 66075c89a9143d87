#pragma once

#include <string>
#include <vector>

#include "tests/support/run.h"

namespace test {

// Of Debian's packages glmark2-data and assimp-testmodels.
inline const std::string Bunny = "/usr/share/glmark2/models/bunny.obj";
inline const std::string CubeWithMaterials = "/usr/share/assimp/models/OBJ/cube_usemtl.obj";
inline const std::string Malformed = "/usr/share/assimp/models/invalid/malformed.obj";

inline const std::string Triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

// What stands in a mesh behind its attributes, up to its end.
inline const std::string Faces =
    " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin faces (0, 1, 2) end faces end mesh";
inline const std::string FacesWithUv =
    " begin vertexs uv (0, 0) (0, 0, 0) uv (1, 0) (1, 0, 0) uv (0, 1) (0, 1, 0) end vertexs begin faces (0, "
    "1, 2) end faces "
    "end mesh";

// Sanitizers need more address space than any limit, so that memory is not limited under them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool LimitsMemory = false;
#elif defined(__has_feature)
constexpr bool LimitsMemory = !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool LimitsMemory = true;
#endif

inline Outcome grfconvert(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), GRANADA_BIN_DIR "/grfconvert");
  return run(arguments);
}

}  // namespace test
