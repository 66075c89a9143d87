#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "editor/document/document.h"

namespace editor {

class BrdfEditor;

/// Lets an editor of BRDFs edit those of the selected faces. Of faces that share a definition by its name,
/// the definition is edited, and with it all faces that have it.
class BrdfLink : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  BrdfLink(Document& document, BrdfEditor& editor, QObject* parent);

 signals:
  void failed(const QString& message);

 private:
  /// A BRDF that is edited: a definition, or one that faces have for themselves.
  struct Subject {
    grf::BrdfModel model;
    std::optional<grf::ScenePath> definition;
    bool is_default = false;  ///< the faces have none

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
