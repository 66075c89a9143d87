// Parsing of SVG pictures.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include "renderer/plot/svg.h"

namespace test {

using Element = boost::property_tree::ptree;

/// Returns the root of a picture's element tree. Throws if it is not XML.
inline Element svg_of(const std::string& text) {
  std::istringstream stream(text);
  Element document;
  read_xml(stream, document);
  return document.get_child("svg");
}

/// Returns all elements of that name, at any depth, in document order.
inline std::vector<Element> elements(const Element& within, const std::string& name) {
  std::vector<Element> found;
  for (const auto& [child_name, child] : within) {
    if (child_name == name) found.push_back(child);
    for (const Element& deeper : elements(child, name)) found.push_back(deeper);
  }
  return found;
}

inline std::vector<std::string> texts(const Element& svg) {
  std::vector<std::string> words;
  for (const Element& text : elements(svg, "text")) words.push_back(text.data());
  return words;
}

/// Returns the points of a polyline.
inline std::vector<plot::Point> points(const Element& polyline) {
  std::istringstream stream(polyline.get<std::string>("<xmlattr>.points"));
  std::vector<plot::Point> points;
  char comma = 0;
  for (plot::Point point; stream >> point.x >> comma >> point.y;) points.push_back(point);
  return points;
}

/// Returns the polylines other than the grid's.
inline std::vector<std::vector<plot::Point>> lines(const Element& svg) {
  std::vector<std::vector<plot::Point>> found;
  for (const Element& polyline : elements(svg, "polyline")) {
    if (polyline.get<std::string>("<xmlattr>.stroke") != "#ddd") found.push_back(points(polyline));
  }
  return found;
}

}  // namespace test
