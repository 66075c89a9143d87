// A document beside a reference model of plain values: the expected scene, options, undo stack and files.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/document/document.h"
#include "tests/editor/document/plain_project.h"

namespace editor {

class ModelledDocument {
 public:
  ModelledDocument();

  Document& document() { return document_; }
  const grf::Scene& scene() const { return document_.scene(); }
  const FaceSelection& selection() const { return document_.selection(); }
  /// The expected project.
  const PlainProject& state() const { return state_; }
  /// The paths of objects in the scene, as of the last check.
  const std::vector<PlainPlace>& places() const { return places_; }
  const std::string& path() const { return path_; }
  /// The number of scenes that were opened.
  int scenes() const { return scenes_; }

  /// Writes a file as another program does.
  void write(const std::string& path, const std::string& text);
  /// The files that can be opened: those that were written, and whose names are valid.
  std::vector<std::string> paths() const;
  void open(const std::string& path);
  void save(const std::string& path);

  // Each edits the document; `after` is the expected result.

  void replace(const QString& text, grf::Scene scene, PlainProject after, const QString& key = {});
  void edit_surfaces(const QString& text, const SurfaceEdit& edit, PlainProject after, const QString& key);
  void merge(const QString& text, const grf::Scene& scene, const std::string& path, PlainProject after);
  void set_depth(int depth, const QString& key);
  void finish_gesture();
  void undo();
  void redo();

  /// Records a problem that a caller has found.
  void fail(const std::string& problem) {
    if (problem_.empty()) problem_ = problem;
  }
  /// Compares the document with the model. Returns the first difference, or an empty text.
  std::string check();

 private:
  struct Step {
    QString text;
    QString key;
    bool is_of_scene = true;
    int gesture = 0;
    FaceSelection selection;  // before
    PlainProject after;
  };

  void push(const QString& text, const QString& key, bool is_of_scene, PlainProject after);
  const PlainProject& state_at(std::size_t step) const { return step == 0 ? first_ : steps_[step - 1].after; }
  PlainProject on_disk(const std::string& path) const;
  void check_disk();
  void check_grammar_of_2008(const grf::Scene& scene);
  void check_stack();
  void check_selection();

  Document document_;
  SceneObjects seen_;  // by who follows `changed`
  std::string problem_;
  std::vector<PlainPlace> places_;

  PlainProject first_;
  PlainProject state_;
  std::vector<Step> steps_;
  FaceSelection selection_before_;  // the edit that is being made
  std::size_t index_ = 0;
  std::optional<std::size_t> clean_ = 0;
  int scene_gesture_ = 0;
  int options_gesture_ = 0;
  bool has_sky_ = false;
  bool are_options_edited_ = false;
  bool have_options_file_ = false;
  std::string path_;
  int scenes_ = 0;
  std::map<std::string, PlainFile> disk_;
  std::map<std::string, std::pair<int, float>> options_on_disk_;
};

}  // namespace editor
