// The tool `subdivision` shows a BRDF with its tree, and samples in the tree's cells.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/studies/drawn_samples.h"
#include "renderer/studies/goodness_of_fit.h"
#include "renderer/studies/study.h"
#include "renderer/studies/subdivision/settings.h"
#include "renderer/studies/subdivision/subdivision.h"

namespace studies {

/// A BRDF and the view from which it is sampled.
struct ViewedBrdf {
  grf::BrdfModel model;
  std::string identity;  ///< see `identity_of`
  reflectance::Brdf brdf;
  Angles view;
  reflectance::Vec3f u;
};

struct SampledPoint {
  reflectance::Vec3f direction;
  double pdf = 0;  ///< per solid angle; that of f cos / albedo for points of a file
  double f = 0;    ///< RGB mean, in 1/sr
};

/// Samples, without those of the specular part, and how many of them each cell of a tree has.
struct CellSamples {
  std::vector<SampledPoint> points;
  std::size_t rejected = 0;  ///< without a direction above the surface
  std::size_t specular = 0;
  std::vector<double> expected;  ///< number of samples per cell
  std::vector<double> counted;
  GoodnessOfFit fit;

  std::size_t count() const { return points.size() + rejected + specular; }
};

struct SubdivisionSubject {
  SubdivisionSettings settings;
  ViewedBrdf viewed;
  Subdivision tree;
  grf::PdfModel pdf;      ///< the state's, even if there is a file
  std::string file = {};  ///< name of the file that the samples are from; empty: they are drawn
  std::shared_ptr<const reflectance::Reflector> reflector =
      {};  ///< null if the pdf cannot sample a file's BRDF
  CellSamples samples = {};
  std::shared_ptr<StudyCache> cache = {};  ///< may be null

  bool is_file() const { return !file.empty(); }
};

/// Counts samples in the cells, against their pdf's integrals over the cells of the tree's grid.
CellSamples cell_samples(const DrawnSamples& drawn, const reflectance::Reflector& reflector,
                         const reflectance::Vec3f& u, const Subdivision& tree,
                         const std::vector<double>& integrals);

/// Makes the subject of a state that was checked. Returns nothing after an error.
std::optional<SubdivisionSubject> subdivision_subject(const ToolState& state, const StudyContext& context,
                                                      grf::Diagnostics& diagnostics);

}  // namespace studies
