#pragma once

#include <QToolButton>
#include <optional>
#include <vector>

#include "grf/catalogue.h"

class QActionGroup;

namespace editor {

/// A button whose menu chooses the image that varies a parameter over faces, and its channel.
class MapButton : public QToolButton {
  Q_OBJECT

 public:
  explicit MapButton(const grf::ParameterInfo& parameter, QWidget* parent);

  /// Shows the images of the edited models; `mixed` where they differ.
  void show_maps(const std::vector<std::optional<grf::ParameterMap>>& maps);

  /// Takes an image file that was chosen or dropped, with the channel shown or else that of the parameter.
  void take(const QString& file);

 signals:
  /// Emitted with the image as chosen, by its full path; nothing removes it.
  void edited(const std::optional<grf::ParameterMap>& map);

 protected:
  void nextCheckState() override {}  ///< Does nothing: it is checked while there is an image.

 private:
  void add_channel(grf::ImageChannel channel, const QString& title);
  void choose();

  std::optional<grf::ParameterMap> map_;  ///< common to the models
  grf::ImageChannel usual_channel_;
  QString name_;
  QActionGroup* channels_;
  QAction* remove_ = nullptr;
};

}  // namespace editor
