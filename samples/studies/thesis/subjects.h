// The subjects are the test scenes of the thesis, with its BRDFs and with its and our techniques.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace study {

/// The effort of a run: quick or full.
struct Effort {
  bool is_quick = false;

  /// The scale of image width and height in a quick run.
  double scale() const { return is_quick ? 0.6 : 1; }
};

/// A part of a scene with its own BRDF and scheme, which the part names `material` and `scheme`. If the text
/// of the BRDF is empty, it has neither.
struct ScenePart {
  std::string part;  ///< path of a GRF file
  std::string brdf;  ///< GRF text
};

/// A technique to sample directions. Names are keys of the tables:
///   uniform                      cosine-weighted: the thesis calls it uniform, which it is on the unit disc
///   sphere, hemisphere           cosine lobes with an exponent of 50 for all BRDFs
///   sphere-best, hemisphere-best cosine lobes with the exponent that fits the BRDF best, or the thesis' own
///   factored, factored-best, factored-fine
///                                the same parameters for all; those of table 5.6; 32x16 and 64x32 cells
///   cascade, compressed          tables of the half vector, the second simplified by Douglas-Peucker
///   reject                       the thesis' method, with 60 quadtrees
///   warp                         ours, `adaptive`
///   own                          the BRDF's own sampler
/// The suffix `-ris` adds resampled importance sampling.
struct Line {
  std::string technique;
  std::string pdf;  ///< GRF text; empty: each part has its own, in `Group::schemes`
};

/// A group of lines that one run of `bpt cost` measures, interleaved.
struct Group {
  std::string scene;
  std::string brdf;  ///< name of the BRDF
  std::string file;  ///< name of the OP and GRF files, without extension
  std::vector<ScenePart> parts;
  std::vector<std::string> schemes;  ///< per part, for a line without `pdf`
  std::string options;               ///< lines of the OP file, besides the scene
  std::vector<Line> lines;
  std::string integrator;  ///< naive or path
  std::vector<int> samples;
  int reference_samples = 0;
};

/// A measured material of tables 5.19 and 5.20, with the BRDF whose table stands in for it.
struct Material {
  std::string name;
  std::string brdf;
};

const std::vector<Material>& materials();

/// Names of scenes, in the order of the report.
inline constexpr std::string_view SceneNames[] = {"cornell_box", "glossy_sphere", "dragon",
                                                  "pottery",     "jug",           "measured"};

/// The chosen scenes and BRDFs, and the paths of their files.
struct Choice {
  std::vector<std::string> scenes, brdfs;  ///< empty: all
  Effort effort;
  std::string folder;                       ///< folder of the scenes' parts
  std::string data;                         ///< folder of measured materials and the dragon
  std::map<std::string, double> exponents;  ///< of adjusted lobes, per BRDF

  bool has_scene(std::string_view name) const;
  bool has_brdf(std::string_view name) const;
};

std::vector<Group> groups(const Choice& choice);

/// Returns the GRF text of a group's scene.
std::string scene_text(const Group& group);

}  // namespace study
