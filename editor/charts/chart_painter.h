#pragma once

class QCustomPlot;

namespace plot {
struct Chart;
struct PolarChart;
}  // namespace plot

namespace editor {

// The same charts as in documents of `bpt`, in a plot whose axes can be read and looked at closely. Each
// clears the plot and draws it anew, in the colours of the plot's palette; the caller replots.

void draw(QCustomPlot& plot, const plot::Chart& chart);
void draw(QCustomPlot& plot, const plot::PolarChart& chart);

}  // namespace editor
