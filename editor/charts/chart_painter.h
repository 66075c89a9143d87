#pragma once

class QCustomPlot;

namespace plot {
struct Chart;
struct PolarChart;
}  // namespace plot

namespace editor {

// Draws the charts of `bpt`'s documents in an interactive plot with labelled axes. Each function clears the
// plot and draws it in the colours of the plot's palette; the caller replots.

void draw(QCustomPlot& plot, const plot::Chart& chart);
void draw(QCustomPlot& plot, const plot::PolarChart& chart);

}  // namespace editor
