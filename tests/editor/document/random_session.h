// Random operations on a document share this session: the document, its model of plain values, the choices.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "tests/editor/document/modelled_document.h"
#include "tests/editor/document/plain_edits.h"
#include "tests/support/temporary_folder.h"

namespace editor {

struct RandomSession {
  RandomSession();

  std::size_t below(std::size_t count) { return random() % count; }
  bool one_in(std::size_t count) { return below(count) == 0; }
  float number() { return static_cast<float>(below(8)); }
  /// One of few colours, so that faces come to share them.
  grf::Colour colour() { return {float(below(2)), float(below(2)), float(below(2))}; }
  grf::Vec3d offset() { return {double(number()) * 2, double(number()) * 2, double(number()) * 2}; }
  QString key(const char* name) { return one_in(2) ? QString(name) : QString(); }

  template <class Condition>
  std::optional<PlainPlace> place(const Condition& condition) {
    std::vector<PlainPlace> found;
    const auto& places = modelled.places();
    std::copy_if(places.begin(), places.end(), std::back_inserter(found), condition);
    return found.empty() ? std::nullopt : std::optional(found[below(found.size())]);
  }
  std::optional<PlainPlace> object_of(const std::set<PlainObject::Kind>& kinds) {
    PlainProject project = modelled.state();
    return place([&](const PlainPlace& each) {
      return !each.is_definition() && kinds.contains(object_at(project, each).kind);
    });
  }
  std::optional<PlainPlace> movable_object() {
    using Kind = PlainObject::Kind;
    return object_of({Kind::Mesh, Kind::MeshLight, Kind::Light, Kind::Use, Kind::Include});
  }
  bool is_full() const { return modelled.places().size() > 40; }

  /// Applies the result of an edit.
  void replace(const QString& text, std::optional<grf::Scene> scene, PlainProject after,
               const QString& key = {});
  void expect_refused(const std::optional<grf::Scene>& scene, const std::string& what);

  const test::TemporaryFolder folder;
  const std::string main_file = folder.add("a/main.grf", "");
  const std::string part_file = folder.add("a/part.grf", "");
  ModelledDocument modelled;
  std::mt19937 random;
  grf::Diagnostics diagnostics;
  std::optional<grf::Scene> model;     ///< to merge into the scene
  std::optional<grf::Scene> snapshot;  ///< the scene that is baked
  int scenes_at_snapshot = 0;
};

/// What can be done in a session.
struct RandomOperation {
  const char* name;
  void (*run)(RandomSession& session);
};

/// Edits of what the selected faces have, and of their vertices.
std::vector<RandomOperation> face_operations();
/// Edits of objects, definitions and options.
std::vector<RandomOperation> object_operations();
/// Undo, redo, files, and late results.
std::vector<RandomOperation> file_operations();

/// The project's file, and contents of the included file: initially, and when other programs write it.
std::string main_text();
std::vector<std::string> part_texts();

Plain3 plain(const grf::Vec3d& value);
std::string colour_text(const grf::Colour& colour);

}  // namespace editor
