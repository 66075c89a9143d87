#include "editor/window/welcome_controller.h"

#include <QAction>

#include "editor/controls/actions.h"
#include "editor/document/preferences.h"
#include "editor/window/file_actions.h"
#include "editor/window/lesson_guide.h"
#include "editor/window/main_window.h"
#include "editor/window/pages.h"
#include "editor/window/sample_scenes.h"
#include "editor/window/welcome_page.h"

namespace editor {

WelcomeController::WelcomeController(MainWindow& window, Pages& pages, const QString& samples)
    : QObject(&window),
      window_(window),
      pages_(pages),
      samples_(samples),
      action_(new_action(window, {tr("&Welcome"), {}, {}, tr("Recent files, sample scenes and lessons")},
                         [this] { show_page(); })) {
  connect(&window.document(), &Document::scene_replaced, this, [this] {
    close_page();
    begin_lesson();
  });
}

void WelcomeController::show_page() {
  if (!page_) {
    page_ = new WelcomePage(sample_scenes(samples_), lessons(), &pages_);
    page_->set_shown_at_start(Preferences::load().shows_welcome);
    connect(page_, &WelcomePage::new_requested, &window_.files(), &FileActions::start_new);
    connect(page_, &WelcomePage::open_requested, &window_.files(), &FileActions::ask_and_open);
    connect(page_, &WelcomePage::file_chosen, this,
            [this](const QString& file) { window_.files().open(file); });
    connect(page_, &WelcomePage::lesson_chosen, this, &WelcomeController::start_lesson);
    connect(page_, &WelcomePage::shown_at_start_changed, this, [](bool is_shown) {
      Preferences preferences = Preferences::load();
      preferences.shows_welcome = is_shown;
      preferences.store();
    });
  }
  page_->show_recent(recent_files());
  pages_.show_page(*page_, tr("Welcome"), tr("Recent files, sample scenes and lessons"));
}

void WelcomeController::close_page() {
  if (page_ && pages_.indexOf(page_) >= 0) pages_.removeTab(pages_.indexOf(page_));
}

void WelcomeController::start_lesson(int lesson) {
  next_ = lessons().at(static_cast<std::size_t>(lesson));
  if (next_->needs_scene && window_.document().objects().meshes.empty()) {
    const std::vector<SampleScene> samples = sample_scenes(samples_);
    // Without samples, the lesson is about what the user opens meanwhile.
    if (!samples.empty()) return window_.files().open(samples.front().file);
  }
  close_page();
  begin_lesson();
}

void WelcomeController::begin_lesson() {
  if (!next_) return;
  window_.show_scene();
  if (guide_ == nullptr) guide_ = new LessonGuide(window_);
  guide_->start(*next_);
  next_.reset();
}

}  // namespace editor
