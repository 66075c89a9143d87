// Files of measured BRDFs that scripts make: those of tests/reflectance/rgl by rgl_files.py, of analytic
// BRDFs.
#pragma once

#include <string>

#include "tests/support/paths.h"

namespace test {

inline std::string rgl_path(const std::string& name) {
  return GRANADA_SOURCE_DIR "/tests/reflectance/rgl/" + name + ".bsdf";
}

/// The files of tests/reflectance/measured, which measured_files.py makes.
inline std::string measured_path(const std::string& name) {
  return GRANADA_SOURCE_DIR "/tests/reflectance/measured/" + name;
}

}  // namespace test
