#include "renderer/command/image_description.h"

#include <cstring>
#include <span>

#include <nlohmann/json.hpp>

namespace command {
namespace {

using image::ImageAttribute;
using image::ImageLayer;
using nlohmann::json;

json json_of(const ImageAttribute& attribute) {
  json result = {{"name", attribute.name}};
  if (const auto* text = std::get_if<std::string>(&attribute.value)) result["text"] = *text;
  if (const auto* number = std::get_if<float>(&attribute.value)) result["number"] = *number;
  if (const auto* vector = std::get_if<grf::Vec3f>(&attribute.value)) {
    result["vector"] = {vector->x, vector->y, vector->z};
  }
  if (const auto* matrix = std::get_if<Imath::M44f>(&attribute.value)) {
    result["matrix"] = std::vector<float>(&matrix->x[0][0], &matrix->x[0][0] + 16);
  }
  return result;
}

ImageAttribute attribute_of(const json& object) {
  ImageAttribute attribute{object.at("name"), std::string()};
  if (object.contains("text")) attribute.value = object.at("text").get<std::string>();
  if (object.contains("number")) attribute.value = object.at("number").get<float>();
  if (object.contains("vector")) {
    const auto values = object.at("vector").get<std::array<float, 3>>();
    attribute.value = grf::Vec3f(values[0], values[1], values[2]);
  }
  if (object.contains("matrix")) {
    const auto values = object.at("matrix").get<std::array<float, 16>>();
    Imath::M44f matrix;
    std::memcpy(&matrix.x[0][0], values.data(), sizeof(values));
    attribute.value = matrix;
  }
  return attribute;
}

}  // namespace

// A line of JSON, which ends by a line feed, and the values of the features.
std::string bytes_of(const ImageDescription& description) {
  json object = {{"exposure", description.exposure},
                 {"screen_width", description.screen_width},
                 {"layers", description.layers},
                 {"attributes", json::array()},
                 {"features", json::array()}};
  for (const ImageAttribute& attribute : description.attributes) {
    object["attributes"].push_back(json_of(attribute));
  }
  for (const ImageLayer& layer : description.features) {
    object["features"].push_back({{"name", layer.name}, {"channels", layer.channels}});
  }
  // Names of files are bytes, and not always UTF-8.
  std::string bytes = object.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
  for (const ImageLayer& layer : description.features) {
    const auto values = std::as_bytes(std::span(layer.values));
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size());
  }
  return bytes;
}

std::optional<ImageDescription> image_description_of(std::string_view bytes, std::size_t pixels) try {
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const json object = json::parse(bytes.substr(0, end));
  bytes.remove_prefix(end + 1);
  ImageDescription description;
  description.exposure = object.at("exposure");
  description.screen_width = object.at("screen_width");
  description.layers = object.at("layers").get<std::vector<std::string>>();
  for (const json& attribute : object.at("attributes"))
    description.attributes.push_back(attribute_of(attribute));
  for (const json& feature : object.at("features")) {
    ImageLayer layer{feature.at("name"), feature.at("channels"), {}};
    const std::size_t count = layer.channel_count() * pixels;
    if (bytes.size() / sizeof(float) < count) return std::nullopt;
    layer.values.resize(count);
    std::memcpy(layer.values.data(), bytes.data(), count * sizeof(float));
    bytes.remove_prefix(count * sizeof(float));
    description.features.push_back(std::move(layer));
  }
  return bytes.empty() ? std::optional(std::move(description)) : std::nullopt;
} catch (const json::exception&) {
  return std::nullopt;
}

}  // namespace command
