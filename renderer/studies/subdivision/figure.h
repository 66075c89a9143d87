#pragma once

#include <string>
#include <string_view>

#include "renderer/studies/subdivision/subject.h"

namespace studies {

/// The left margin of the study's figures, and the colour of samples in them.
constexpr double FigureMargin = 20;
constexpr std::string_view SampleColour = "#d55e00";

/// Draws a tree in large, with samples, the lobe in 3D, and strata of random numbers; 1040 by 620.
void draw_subdivision(const SubdivisionSubject& subject, const StudyContext& context, plot::Svg& svg);

/// Describes the cell at a point of that figure; empty text beside the tree.
std::string described_cell(const SubdivisionSubject& subject, const plot::Point& at);

/// Draws the BRDF and its view at the top of a figure.
void draw_subdivision_header(const SubdivisionSubject& subject, const std::string& facts, plot::Svg& svg);

}  // namespace studies
