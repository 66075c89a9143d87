#include "converters/ply/read_ply.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "converters/ply/ply_elements.h"
#include "converters/ply/ply_header.h"
#include "converters/ply/ply_layout.h"
#include "converters/ply/ply_mesh.h"
#include "converters/ply/ply_values.h"
#include "converters/text_encoding.h"
#include "converters/wording.h"
#include "grf/text_file.h"

namespace convert {
namespace {

bool is_face_element(const PlyElement& element) {
  return element.name == "face" || element.name == "tristrips";
}

class PlyReader {
 public:
  PlyReader(const PlySource& source, const PlyHeader& header, const ReadOptions& options,
            grf::Diagnostics& diagnostics)
      : source_(source), header_(header), options_(options), diagnostics_(diagnostics) {}

  std::optional<grf::Scene> run();

 private:
  void reserve_memory(PlyMesh& mesh) const;
  bool check_elements();
  bool check_vertices(const PlyElement& vertices);
  void add_elements_left_out(PlyMesh& mesh);
  void warn_of_unread();
  bool check_rest(std::size_t end);

  bool fail(const grf::SourceLocation& location, const std::string& message) {
    diagnostics_.error(location, message);
    return false;
  }

  const PlySource& source_;
  const PlyHeader& header_;
  const ReadOptions& options_;
  grf::Diagnostics& diagnostics_;
};

std::optional<grf::Scene> PlyReader::run() {
  if (!check_elements()) return std::nullopt;
  PlyMesh mesh(header_, options_);
  reserve_memory(mesh);
  std::size_t end = 0;
  if (!read_ply_elements(source_, header_, mesh, end, diagnostics_)) return std::nullopt;
  if (mesh.face_count() == 0) {
    fail(source_.whole_file(),
         "no face of the file has three corners or more, and only faces can be imported");
    return std::nullopt;
  }
  if (!check_rest(end)) return std::nullopt;
  warn_of_unread();
  add_elements_left_out(mesh);
  return mesh.take(source_.whole_file(), diagnostics_);
}

// Reserves memory only for faces whose three corners fit in the rest of the file.
void PlyReader::reserve_memory(PlyMesh& mesh) const {
  const PlyElement* faces = header_.find("face");
  std::uint64_t triangles = 0;
  if (faces != nullptr && faces->count > 0) {
    const bool is_text = header_.encoding == PlyEncoding::Ascii;
    const std::size_t of_corner = is_text ? 2 : size_of(face_layout(*faces).corners->type);
    const std::uint64_t of_triangle = faces->fewest_bytes(header_.encoding) + 3 * of_corner;
    triangles = std::min<std::uint64_t>(faces->count, source_.bytes->size() / of_triangle);
  }
  mesh.reserve(header_.find("vertex")->count, triangles);
}

bool PlyReader::check_elements() {
  const PlyElement* vertices = header_.find("vertex");
  if (vertices == nullptr) return fail(source_.whole_file(), "the header names no element 'vertex'");
  const bool has_faces =
      std::any_of(header_.elements.begin(), header_.elements.end(),
                  [](const PlyElement& element) { return is_face_element(element) && element.count > 0; });
  if (!has_faces) {
    return fail(source_.whole_file(),
                fmt::format("the file is a cloud of {}: it has no faces, and only faces can be imported",
                            counted(vertices->count, "point", "points")));
  }
  for (const PlyElement& element : header_.elements) {
    if (!is_face_element(element) || element.count == 0 || face_layout(element).corners != nullptr) continue;
    return fail(element.location,
                fmt::format("elements '{}' have no list 'vertex_indices' of integers", element.name));
  }
  return check_vertices(*vertices);
}

bool PlyReader::check_vertices(const PlyElement& vertices) {
  const PlyLayout layout = vertex_layout(vertices);
  constexpr std::array<std::pair<PlySlot, char>, 3> Axes = {
      {{PlySlot::X, 'x'}, {PlySlot::Y, 'y'}, {PlySlot::Z, 'z'}}};
  for (const auto& [slot, name] : Axes) {
    if (!layout.has(slot)) {
      return fail(vertices.location, fmt::format("elements 'vertex' have no property '{}'", name));
    }
  }
  if (vertices.count < std::numeric_limits<std::uint32_t>::max()) return true;
  return fail(vertices.location, "there are more vertices than a mesh can have");
}

// Of several elements with one name the first is read; unknown properties are reported.
void PlyReader::warn_of_unread() {
  std::vector<std::string> names;
  for (const PlyElement& element : header_.elements) {
    const bool is_vertex = element.name == "vertex";
    if (element.count == 0 || (!is_vertex && !is_face_element(element))) continue;
    const PlyLayout layout = is_vertex ? vertex_layout(element) : face_layout(element);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (layout.meanings[i].slot || layout.meanings[i].list) continue;
      names.push_back(fmt::format("{} of {}", element.properties[i].name, element.name));
    }
  }
  if (names.empty()) return;
  diagnostics_.warning(source_.whole_file(),
                       fmt::format("{} not read: {}",
                                   counted(names.size(), "property was", "properties were"), listed(names)));
}

void PlyReader::add_elements_left_out(PlyMesh& mesh) {
  for (const PlyElement& element : header_.elements) {
    if (element.count == 0 || element.name == "vertex" || is_face_element(element)) continue;
    if (element.name == "edge") {
      mesh.add(Loss::Edge, element.count);
      continue;
    }
    diagnostics_.warning(element.location,
                         fmt::format("{} not read: '{}'",
                                     counted(element.count, "element was", "elements were"), element.name));
  }
}

// Trailing bytes other than a line end, which a program may add, show that the header is wrong and values
// were misread.
bool PlyReader::check_rest(std::size_t end) {
  const std::string_view rest = std::string_view(*source_.bytes).substr(end);
  if (is_padding(rest)) return true;
  return fail(source_.whole_file(),
              fmt::format("{} the last element: the header has a wrong count or property, or the file "
                          "was damaged",
                          counted(rest.size(), "byte follows", "bytes follow")));
}

/// Returns whether the elements of a binary file end at the end of the file.
bool fill_file(const PlySource& source, const PlyHeader& header) {
  grf::Diagnostics ignored_diagnostics;
  PlyValues values(source, header, ignored_diagnostics);
  for (const PlyElement& element : header.elements) {
    for (std::uint64_t i = 0; !element.properties.empty() && i < element.count; ++i) {
      values.begin(element, i);
      if (!values.skip_element()) return false;
    }
  }
  return values.bytes_left() == 0;
}

// After the header's last word, a carriage return and a line feed are ambiguous: both end the header, or the
// line feed is the first byte of the values. The wrong choice leaves a byte too few, or too many.
void find_body(const PlySource& source, PlyHeader& header) {
  const std::string_view bytes = *source.bytes;
  const std::string_view behind = bytes.substr(header.size - 1);
  const bool may_be_longer = behind.starts_with("\r\n");
  const bool may_be_shorter = header.size > 1 && bytes.substr(header.size - 2).starts_with("\r\n");
  if (header.encoding == PlyEncoding::Ascii || !(may_be_longer || may_be_shorter)) return;
  if (fill_file(source, header)) return;
  PlyHeader other = header;
  other.size = may_be_longer ? header.size + 1 : header.size - 1;
  if (fill_file(source, other)) header = std::move(other);
}

}  // namespace

std::optional<Import> read_ply(const std::string& path, const ReadOptions& options,
                               grf::Diagnostics& diagnostics) {
  PlySource source;
  source.bytes = grf::read_file(path, diagnostics);
  if (!source.bytes) return std::nullopt;
  source.file = std::make_shared<grf::SourceFile>(grf::SourceFile{path, {}, source.bytes});
  auto header = read_ply_header(source, diagnostics);
  if (!header) return std::nullopt;
  find_body(source, *header);
  auto scene = PlyReader(source, *header, options, diagnostics).run();
  if (!scene) return std::nullopt;
  return Import{std::move(*scene), {}};
}

}  // namespace convert
