#include "converters/vrml/report.h"

#include <fmt/format.h>

#include "converters/vrml/node_types.h"
#include "converters/wording.h"

namespace convert::vrml {
namespace {

/// The maximum number of generated faces: a few bytes of text can make any number.
constexpr std::size_t MostGeneratedFaces = 5'000'000;

}  // namespace

void Report::skip(const Node& node) {
  if (is_light(node.type)) return losses_.add(Loss::LightSource);
  if (is_camera(node.type)) return losses_.add(Loss::Camera);
  add(fmt::format("{} node was skipped", node.type), fmt::format("{} nodes were skipped", node.type),
      reason_for_skipping(node.type, node.source->version()));
}

void Report::add(std::string_view one, std::string_view many, std::string_view why, std::size_t count) {
  if (count == 0) return;
  auto line = lines_.find(one);
  if (line == lines_.end()) {
    line = lines_.emplace(one, Line{std::string(many), std::string(why)}).first;
  }
  line->second.count += count;
}

const Node* Report::node_of(const Node& node, std::string_view field, std::string_view type) {
  const NodeReader reader(node, diagnostics_);
  const Node* found = reader.node(field);
  if (found == nullptr || found->type == type) return found;
  if (found->is_known) {
    reader.error_at(
        field, fmt::format("found the node {} in the field '{}', expected {}", found->type, field, type));
  } else {
    skip(*found);
  }
  return nullptr;
}

bool Report::count_generated(const Node& node, std::size_t faces) {
  generated_faces_ += faces;
  if (generated_faces_ <= MostGeneratedFaces) return true;
  diagnostics_.error(node.location(),
                     fmt::format("with this {}, the solids of the file have more than {} faces", node.type,
                                 MostGeneratedFaces));
  return false;
}

void Report::finish(const grf::SourceLocation& location) const {
  losses_.report(location, diagnostics_);
  for (const auto& [one, line] : lines_) {
    diagnostics_.warning(location, fmt::format("{}: {}", counted(line.count, one, line.many), line.why));
  }
}

}  // namespace convert::vrml
