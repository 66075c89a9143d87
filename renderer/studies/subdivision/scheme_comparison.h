#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/studies/subdivision/subject.h"

namespace studies {

/// A sampling scheme on the subject's BRDF and view.
struct ComparedScheme {
  std::string name;                ///< as in GRF
  std::string unsupported_reason;  ///< empty if it supports the BRDF
  std::shared_ptr<const reflectance::Reflector> reflector = {};
  CellSamples samples = {};
  WeightStatistics weights = {};
  std::vector<double> integrals = {};  ///< of the pdf, over the cells of the tree's grid
};

/// Samples the BRDF by six schemes: the subject's, `adaptive`, `factored`, `cascadeCDF`, `hemisphere` and
/// `own`. All have the same number of samples and the same seed.
std::vector<ComparedScheme> compared_schemes(const SubdivisionSubject& subject, const StudyContext& context);

/// Draws the pdfs with samples and statistics, six discs with common colours; 1040 by 620.
void draw_comparison(const SubdivisionSubject& subject, const std::vector<ComparedScheme>& schemes,
                     plot::Svg& svg);

/// Describes a direction on one of the discs; empty text beside them.
std::string described_scheme(const SubdivisionSubject& subject, const std::vector<ComparedScheme>& schemes,
                             const plot::Point& at);

}  // namespace studies
