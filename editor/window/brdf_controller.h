#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "editor/document/document.h"

namespace editor {

class BrdfEditor;

/// Connects a BRDF editor to the BRDFs of the selected faces. If faces share a named definition, the
/// definition is edited, and with it all faces that use it.
class BrdfController : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  BrdfController(Document& document, BrdfEditor& editor, QObject* parent);

  /// The BRDF of the selected faces, independent of other files; nothing if they have several.
  std::optional<grf::BrdfModel> common_brdf() const;
  /// The BRDFs that are defined where all selected faces are, independent of other files.
  std::vector<grf::Definition> common_brdf_definitions() const;
  /// Assigns a BRDF to the selected faces, as one undo step.
  void assign(const grf::BrdfModel& brdf);

 signals:
  void failed(const QString& message);

 private:
  /// The edited BRDF: a definition, or an inline one.
  struct Subject {
    grf::BrdfModel model;
    std::optional<grf::ScenePath> definition;
    bool is_default = false;  ///< whether the faces have no BRDF

    bool operator==(const Subject&) const = default;
  };

  void show_selection();
  std::vector<Subject> subjects_of_selection() const;
  void change(const std::vector<grf::BrdfModel>& models);
  void change_definitions(const SurfaceEdits& edits, const std::vector<grf::BrdfModel>& models);
  SurfaceEdit edit_of(const grf::Surface& surface, const std::vector<grf::BrdfModel>& models) const;
  void finish(const std::vector<grf::BrdfModel>& models);
  void share(const QString& name);

  Document& document_;
  BrdfEditor& editor_;
  std::vector<Subject> subjects_;
  bool is_changing_ = false;  // by this link itself
};

}  // namespace editor
