// A wall that fills the view, what is around it, and a lamp over it.
#pragma once

#include <string>

#include "tests/plan/plan_helpers.h"

namespace test {

/// Upright, at the centre of the view, facing the eye.
inline const std::string Place = "(-1,-1,0)(1,-1,0)(1,1,0)(-1,1,0)";
inline const std::string Floor = "(-1,-1,2)(1,-1,2)(1,-1,0)(-1,-1,0)";
/// Below the wall and out of view, facing the wall's front.
inline const std::string OutOfView = "(-1,-8,9)(1,-8,9)(1,-8,1)(-1,-8,1)";
inline const std::string Lamp = "light begin rgb (2,3,4) (-1,2,0.5) (2,0,0) (0,0,2) end\n";

inline std::string wall(const std::string& attributes) { return test::quad(attributes, Place); }

inline PlannedRender depth(int depth) {
  PlannedRender setup;
  setup.depth = depth;
  return setup;
}

}  // namespace test
