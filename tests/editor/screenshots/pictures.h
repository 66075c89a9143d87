// The pictures that make_screenshots makes.
#pragma once

#include <QPixmap>
#include <QString>
#include <functional>
#include <vector>

namespace screenshots {

/// A picture of the manual.
struct Picture {
  QString name;
  std::function<QPixmap()> make;
};

std::vector<Picture> manual_pictures();

using Take = std::function<void(const QString& name, const QPixmap& picture)>;

/// Pictures for a review, which share a window.
struct ReviewGroup {
  QString name;
  std::function<void(const Take& take)> make;
};

/// All docks, pages, windows and display modes, with their empty states and the keyboard focus.
std::vector<ReviewGroup> review_groups();

/// The render options of a sample.
QPixmap option_window();
/// The GRF viewer with a sample.
QPixmap viewer_window();
/// The window of a study tool with the state of a file.
QPixmap study_window(const QString& state_file);
/// The list of shortcuts.
QPixmap shortcut_list();
/// Two renders, compared with a wipe.
QPixmap compared_images();

}  // namespace screenshots
