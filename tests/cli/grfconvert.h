#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/paths.h"
#include "tests/support/run.h"

namespace test {

// Models of Debian's packages glmark2-data and assimp-testmodels.
inline const std::string Bunny = "/usr/share/glmark2/models/bunny.obj";
inline const std::string CubeWithMaterials = "/usr/share/assimp/models/OBJ/cube_usemtl.obj";
inline const std::string Malformed = "/usr/share/assimp/models/invalid/malformed.obj";

inline const std::string Triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

// The text of a mesh after its attributes, up to its end.
inline const std::string Faces =
    " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin faces (0, 1, 2) end faces end mesh";
inline const std::string FacesWithUv =
    " begin vertexs uv (0, 0) (0, 0, 0) uv (1, 0) (1, 0, 0) uv (0, 1) (0, 1, 0) end vertexs begin faces (0, "
    "1, 2) end faces "
    "end mesh";

// Sanitizers need more address space than any limit, so memory is not limited under them.
#ifdef GRANADA_HAS_SANITIZERS
constexpr bool LimitsMemory = false;
#else
constexpr bool LimitsMemory = true;
#endif

/// Makes findings of sanitizers in `grfconvert` crash it from now on, and limits its memory under them.
inline void crash_on_findings() {
  ::setenv("ASAN_OPTIONS", "abort_on_error=1:max_allocation_size_mb=4096:hard_rss_limit_mb=4096", 1);
  ::setenv("UBSAN_OPTIONS", "abort_on_error=1", 1);
}

inline Outcome grfconvert(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), GRANADA_BIN_DIR "/grfconvert");
  return run(arguments);
}

}  // namespace test
