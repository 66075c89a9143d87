// What is rendered: the test scenes of the thesis, with its BRDFs and techniques and ours.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace study {

/// How long it may take.
struct Effort {
  bool is_quick = false;

  /// The share of pixels along an edge that a quick run keeps.
  double scale() const { return is_quick ? 0.6 : 1; }
};

/// A part of a scene with a BRDF and a scheme of its own, which the part calls `material` and `scheme`;
/// without one if the text of the BRDF is empty.
struct Piece {
  std::string part;  ///< path of a GRF file
  std::string brdf;  ///< GRF text
};

/// One way to draw directions. Names are keys of the tables:
///   uniform                      by the cosine: the thesis calls it uniform, which it is on the unit disc
///   sphere, hemisphere           cosine lobes with an exponent of 50 for all
///   sphere-best, hemisphere-best those of the exponents that come nearest to the BRDF, or the thesis names
///   factored, factored-best, factored-fine
///                                the same parameters for all; those of table 5.6; 32x16 and 64x32 cells
///   cascade, compressed          tables of the half vector, the second after Douglas and Peucker
///   reject                       the thesis' own method, with 60 trees
///   warp                         ours, `adaptive`
///   own                          the BRDF's own sampler
/// and with `-ris` resampled importance sampling is done besides.
struct Line {
  std::string technique;
  std::string pdf;  ///< GRF text; empty: each piece has its own, in `Group::schemes`
};

/// What one run of `bpt cost` measures, interleaved.
struct Group {
  std::string scene;
  std::string brdf;  ///< its name
  std::string file;  ///< the name of its OP and GRF files, without an ending
  std::vector<Piece> pieces;
  std::vector<std::string> schemes;  ///< of the pieces, for a line without `pdf`
  std::string options;               ///< of the OP file, besides its scene
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

/// What there is to choose from, and what was chosen.
struct Choice {
  std::vector<std::string> scenes, brdfs;  ///< empty: all
  Effort effort;
  std::string folder;                       ///< of the scenes' parts
  std::string data;                         ///< of measured materials
  std::map<std::string, double> exponents;  ///< of adjusted lobes, by BRDF

  bool has_scene(std::string_view name) const;
  bool has_brdf(std::string_view name) const;
};

std::vector<Group> groups(const Choice& choice);

/// The GRF text of a group's scene.
std::string scene_text(const Group& group);

}  // namespace study
