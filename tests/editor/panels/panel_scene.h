#pragma once

#include <string>

namespace editor {

/// Two sides of a box with texture coordinates, and a mesh that is used twice; named BRDFs.
inline const std::string PanelScene = R"(def gold = brdf ward sx=0.2
def dull = brdf diffuse kd=0.3
def red = rgb (1, 0, 0)
def tile = begin mesh
  brdf dull
  begin vertexs
    (0, 0, 0) (1, 0, 0) (0, 1, 0)
  end vertexs
  begin faces
    (0, 1, 2)
  end faces
end mesh
begin
  use tile
  transform translation (5, 0, 0) begin
    use tile
  end
  begin mesh "sides"
    begin vertexs
      uv (0, 0) (0, 0, 0)
      uv (1, 0) (2, 0, 0)
      uv (1, 1) (2, 1, 0)
      uv (0, 1) (0, 1, 0)
      uv (0, 0) (0, 0, 1)
      uv (1, 0) (2, 0, 1)
    end vertexs
    begin faces
      brdf diffuse kd=0.8
      (0, 1, 2, 3)
      brdf gold
      (1, 0, 4, 5)
    end faces
  end mesh
  light begin rgb (1, 1, 1) (0, 3, 0) (1, 0, 0) (0, 0, 1) end
end
)";

}  // namespace editor
