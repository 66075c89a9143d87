#pragma once

#include <QPointer>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <optional>

#include "renderer/options/render_options.h"

class QComboBox;

namespace editor {

class ColourFields;
class Document;
class NumberBox;
class OpDocument;
class ScaledSlider;
class SkyDialog;

/// The environment maps that come with the program, in `share/granada/environments` beside its folder.
QStringList bundled_environments();

/// Sets the environment map of a scene to an image file, as an undo step; an empty path means none. With a
/// brightness, it has that one and is not rotated.
void set_environment(OpDocument& render_options, const QString& path, std::optional<double> brightness = {});

/// Edits the environment of a scene in its render options: a map with rotation and brightness, or a constant
/// background where there is none.
class EnvironmentForm : public QWidget {
  Q_OBJECT

 public:
  /// The document, whose render options are edited, outlives the form.
  explicit EnvironmentForm(Document& document, QWidget* parent = nullptr);

 private:
  using Edit = std::function<void(options::RenderOptions&)>;

  void add_rotation();
  void add_brightness();
  void choose(int index);
  void choose_file();
  void add_sky();
  void make_sky();
  QString sky_file();
  void change(const QString& title, const QString& key, const Edit& edit);
  void show_options();

  const Document& document_;
  OpDocument& render_options_;
  const QStringList bundled_ = bundled_environments();
  QComboBox* maps_;
  QPointer<SkyDialog> sky_;
  NumberBox* rotation_ = nullptr;
  ScaledSlider* rotation_slider_ = nullptr;
  NumberBox* brightness_ = nullptr;
  ColourFields* background_;
};

}  // namespace editor
