// A chart draws lines for documents.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/plot/svg.h"

namespace plot {

/// Returns the colour of a series, from a palette for the colour-blind (Okabe and Ito 2008).
std::string_view colour_of_series(std::size_t index);

struct Series {
  std::string name;  ///< empty: not in the legend
  std::vector<Point> points;
  std::string_view colour = {};  ///< empty: `colour_of_series` of its index
  std::string_view dashes = {};  ///< dash pattern, see `Stroke`
  bool has_marks = false;        ///< draw a dot at each point
  bool has_line = true;          ///< else it is a cloud of small dots, or only filled
  std::string_view fill = {};    ///< colour of the polygon through the points, under all lines; empty: none
};

struct Axis {
  std::string label;
  bool is_logarithmic = false;
  std::optional<double> minimum;  ///< absent: the least of the points
  std::optional<double> maximum;
  double step = 0;  ///< between ticks of a linear axis; 0: chosen automatically
};

/// The range of an axis: its own limits, or those of the points, rounded to powers of ten if logarithmic.
struct AxisEnds {
  double low = 0;
  double high = 1;
};
AxisEnds ends_of(const Axis& axis, const std::vector<Series>& series, double Point::*coordinate);

struct Rectangle {
  Point corner;  ///< upper left
  double width = 0;
  double height = 0;
};

struct Chart {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  /// Place each label at the right at the height of its line's last point if there is space.
  bool has_names_at_ends = false;
};

/// Returns the area between the axes of a chart at a place.
Rectangle plot_area(const Chart& chart, const Rectangle& place);

/// Draws axes with ticks, the lines clipped to the ranges, and a legend at the right if there are several. On
/// a logarithmic axis, values of 0 and less are far below its range. If its limits are no powers of ten, it
/// has ticks at 1, 2 and 5.
void draw(const Chart& chart, const Rectangle& place, Svg& svg);

/// Places labels one below the other, at least `distance` apart and within the limits, each as near as
/// possible to its desired position. The result is in the order of the wishes.
std::vector<double> spread_labels(const std::vector<double>& wishes, double distance, double from, double to);

/// A chart of radii over angles from the vertical, -90 to 90 degrees.
struct PolarChart {
  std::string title;
  std::string unit;
  std::string note;               ///< a line below the chart
  std::vector<Series> series;     ///< points of angle in degrees and radius
  std::vector<Series> fractions;  ///< the same, with radii as fractions of the outermost ring
  /// The radius limit; longer lines are clipped, with a note. Absent: all values fit.
  std::optional<double> maximum;
  bool is_logarithmic = false;  ///< radii span five powers of ten
};

/// The radial scale of a polar chart.
class PolarScale {
 public:
  explicit PolarScale(const PolarChart& chart);

  /// Returns round values, innermost first. The last is at least the largest value.
  const std::vector<double>& rings() const { return rings_; }
  /// Returns a value's radius as a fraction of the outermost ring's. Larger values are clipped.
  double fraction(double value) const;
  double outermost() const { return outermost_; }

 private:
  bool is_logarithmic_;
  double outermost_ = 1;
  std::vector<double> rings_;
};

void draw(const PolarChart& chart, const Rectangle& place, Svg& svg);

}  // namespace plot
