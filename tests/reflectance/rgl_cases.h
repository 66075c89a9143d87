// The files of tests/reflectance/rgl, which rgl_files.py makes of analytic BRDFs.
#pragma once

#include <string>

#include "tests/support/paths.h"

namespace test {

inline std::string rgl_path(const std::string& name) {
  return GRANADA_SOURCE_DIR "/tests/reflectance/rgl/" + name + ".bsdf";
}

}  // namespace test
