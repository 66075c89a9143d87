#pragma once

#include <QDialog>

#include "editor/jobs/background_job.h"
#include "renderer/sky/sky_map.h"

class QDateEdit;
class QFormLayout;
class QLabel;
class QPushButton;
class QTimeEdit;

namespace editor {

class NumberBox;
struct NumberInfo;

/// Asks for a place, a time and the air there, and shows the sky that they have. It writes the map of that
/// sky to a file in the background, and is closed then. The place is remembered.
class SkyDialog : public QDialog {
  Q_OBJECT

 public:
  explicit SkyDialog(QWidget* parent = nullptr);

  /// Sets the file that the map is written to.
  void set_file(const QString& file) { file_ = file; }
  sky::SkySettings settings() const;

 signals:
  /// Emitted to get a file by `set_file`, once there is a sky to write; without one, the dialog stays.
  void file_wanted();
  /// Emitted once the map is written, with the brightness that suits it.
  void made(const QString& file, double brightness);

 private:
  /// A small map for the picture, or why there is none.
  struct Preview {
    sky::SkyMap map;
    std::string problem;
  };
  /// A written map, or an error message.
  struct Written {
    double brightness = 1;
    std::string problem;
  };

  NumberBox* add_number(QFormLayout& form, const QString& label, const NumberInfo& info, double value);
  void add_time(QFormLayout& form);
  void add_buttons(QFormLayout& form);
  void load_place();
  void save_place() const;
  void update_picture();
  void show_preview(const Preview& preview);
  void write();

  NumberBox* latitude_ = nullptr;
  NumberBox* longitude_ = nullptr;
  QDateEdit* date_ = nullptr;
  QTimeEdit* time_ = nullptr;
  NumberBox* utc_offset_ = nullptr;
  NumberBox* turbidity_ = nullptr;
  NumberBox* north_ = nullptr;
  QLabel* picture_;
  QLabel* summary_;
  QPushButton* accept_ = nullptr;
  QString file_;
  BackgroundJob<Preview> previewing_{this};
  BackgroundJob<Written> writing_{this};
};

}  // namespace editor
