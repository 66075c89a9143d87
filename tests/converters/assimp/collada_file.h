// COLLADA files made by tests: one square of the material `paint`, and a test's additions.
#pragma once

#include <string>

#include <fmt/format.h>

namespace convert {

struct ColladaParts {
  std::string asset;
  std::string technique = "<lambert><diffuse><color>0.5 0.25 0 1</color></diffuse></lambert>";
  std::string images;     ///< in the library of images, and parameters of the effect
  std::string libraries;  ///< further ones
  std::string primitives =
      "<polylist count='1' material='paint'><input semantic='VERTEX' source='#v' offset='0'/>"
      "<vcount>4</vcount><p>0 1 2 3</p></polylist>";
  std::string nodes;  ///< of the scene; `{}` in it stands for the square
};

inline std::string collada_file(const ColladaParts& parts) {
  const std::string square =
      "<instance_geometry url='#g'><bind_material><technique_common>"
      "<instance_material symbol='paint' target='#m'/></technique_common></bind_material>"
      "</instance_geometry>";
  std::string nodes = parts.nodes.empty() ? "<node name='Square'>{}</node>" : parts.nodes;
  for (std::size_t i = nodes.find("{}"); i != std::string::npos; i = nodes.find("{}", i + square.size())) {
    nodes.replace(i, 2, square);
  }
  return fmt::format(
      "<?xml version='1.0'?>\n<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
      "version='1.4.1'>\n"
      "<asset>{}</asset>\n"
      "<library_effects><effect id='e'><profile_COMMON>{}<technique sid='t'>{}</technique></profile_COMMON>"
      "</effect></library_effects>\n"
      "<library_materials><material id='m' name='Red paint'><instance_effect url='#e'/></material>"
      "</library_materials>\n"
      "<library_geometries><geometry id='g' name='Quad'><mesh><source id='p'>"
      "<float_array id='pa' count='12'>0 0 0 1 0 0 1 0 2 0 0 2</float_array><technique_common>"
      "<accessor source='#pa' count='4' stride='3'><param name='X' type='float'/><param name='Y' "
      "type='float'/>"
      "<param name='Z' type='float'/></accessor></technique_common></source><source id='t'>"
      "<float_array id='ta' count='8'>0 0 1 0 1 1 0 1</float_array><technique_common>"
      "<accessor source='#ta' count='4' stride='2'><param name='S' type='float'/><param name='T' "
      "type='float'/>"
      "</accessor></technique_common></source>"
      "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>{}</mesh></geometry>"
      "</library_geometries>\n{}"
      "<library_visual_scenes><visual_scene id='s'>{}</visual_scene></library_visual_scenes>\n"
      "<scene><instance_visual_scene url='#s'/></scene>\n</COLLADA>\n",
      parts.asset, parts.images, parts.technique, parts.primitives, parts.libraries, nodes);
}

}  // namespace convert
