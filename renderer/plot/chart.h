// Charts of lines, for documents.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/plot/svg.h"

namespace plot {

/// Colours that people who confuse red and green can tell apart (Okabe and Ito 2008).
std::string_view colour_of_series(std::size_t index);

struct Series {
  std::string name;  ///< empty: it is not among the names at the right
  std::vector<Point> points;
  std::string_view colour = {};  ///< empty: `colour_of_series` of its place
  std::string_view dashes = {};  ///< see `Stroke`
  bool has_marks = false;        ///< a dot at each point
};

struct Axis {
  std::string label;
  bool is_logarithmic = false;
  std::optional<double> minimum;  ///< absent: that of the points
  std::optional<double> maximum;
  double step = 0;  ///< between ticks of a linear axis; 0: whatever suits
};

/// The values at the ends of an axis: its own, or those of the points, at whole powers of ten if it is
/// logarithmic.
struct AxisEnds {
  double low = 0;
  double high = 1;
};
AxisEnds ends_of(const Axis& axis, const std::vector<Series>& series, double Point::*coordinate);

struct Place {
  Point corner;  ///< upper left
  double width = 0;
  double height = 0;
};

struct Chart {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  /// Each name at the right is as high as its line's last point, as far as there is place, and a thin stroke
  /// leads to it.
  bool has_names_at_ends = false;
};

/// Axes with their ticks, the lines as far as they are between the ends, and their names at the right, where
/// there are several. On a logarithmic axis 0 and less are far under its end. One whose ends were given as no
/// powers of ten has ticks at 1, 2 and 5.
void draw(const Chart& chart, const Place& place, Svg& svg);

/// Where names can stand one under the other, `distance` apart at least and between the ends, each as near as
/// can be to where it wants to be. In the order of the wishes.
std::vector<double> apart(const std::vector<double>& wishes, double distance, double from, double to);

/// Distances from a centre over angles from the vertical, -90 to 90 degrees.
struct PolarChart {
  std::string title;
  std::string unit;
  std::string note;            ///< a line under it
  std::vector<Series> series;  ///< points of angle in degrees and distance
  std::vector<Series> shares;  ///< the same, with shares of the outermost ring as distances
  /// As far as there are rings; longer ones are cut, and say so. Absent: all have place.
  std::optional<double> maximum;
  bool is_logarithmic = false;  ///< distances go over five powers of ten
};

/// Where the values of a polar chart stand.
class PolarScale {
 public:
  explicit PolarScale(const PolarChart& chart);

  /// Round values, the innermost first. The last is the highest value's or, of a linear scale, over it.
  const std::vector<double>& rings() const { return rings_; }
  /// A value's distance as a share of the outermost one's. Those beyond are cut.
  double share(double value) const;
  double outermost() const { return outermost_; }

 private:
  bool is_logarithmic_;
  double outermost_ = 1;
  std::vector<double> rings_;
};

void draw(const PolarChart& chart, const Place& place, Svg& svg);

}  // namespace plot
