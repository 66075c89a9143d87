// wannabe: the scene editor, and its tools.
#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <iostream>
#include <memory>

#include "editor/appearance/theme.h"
#include "editor/appearance/translation.h"
#include "editor/document/preferences.h"
#include "editor/jobs/job.h"
#include "editor/tools/scene_reading.h"
#include "editor/tools/tool_window.h"
#include "editor/view/scene_view.h"
#include "editor/window/file_actions.h"
#include "editor/window/main_window.h"
#include "editor/window/tools.h"
#include "editor/window/welcome_controller.h"
#include "grf/exit_code.h"
#include "grf/keywords.h"
#include "grf/text_file.h"
#include "renderer/studies/study.h"

namespace {

QString list_of_tools() {
  QStringList lines;
  for (const editor::Tool& tool : editor::tools())
    lines.append(QString("%1 (%2)").arg(tool.name, tool.about));
  return lines.join("; ");
}

int fail(const QString& message) {
  std::cerr << "wannabe: " << message.toStdString() << '\n';
  return static_cast<int>(grf::ExitCode::BadCommandLine);
}

/// Whether a window shows what it was opened with; a study may still be refined.
bool is_shown(QWidget& window) {
  if (auto* main_window = qobject_cast<editor::MainWindow*>(&window))
    return !main_window->files().is_importing() &&
           (main_window->view().is_full() || !main_window->view().isVisible());
  if (const auto* study = qobject_cast<editor::ToolWindow*>(&window)) return study->has_picture();
  return window.isVisible();
}

/// Closes the window once it shows that, and prints how long that took, to some milliseconds.
void tell_startup_time(QWidget& window, const QElapsedTimer& since) {
  auto* timer = new QTimer(&window);
  QObject::connect(timer, &QTimer::timeout, &window, [&window, since] {
    if (!is_shown(window)) return;
    std::cout << since.elapsed() << " ms" << std::endl;
    QApplication::exit();
  });
  // A timer without a pause would take a core from the threads whose time it measures.
  timer->start(5);
}

/// Makes the figure of a tool's state without a window.
int make_figure(const QString& state_file, const QString& tool_name, const QStringList& files,
                const QString& output) {
  grf::Diagnostics diagnostics;
  const auto report = [&] {
    std::cerr << diagnostics.to_text();
    return static_cast<int>(diagnostics.has_errors() ? grf::ExitCode::BadInput : grf::ExitCode::Done);
  };
  std::optional<studies::ToolState> state;
  if (state_file.isEmpty()) {
    if (const auto tool = studies::study_tool(tool_name.toStdString())) state = tool->initial;
    if (!state) return fail(QString("there are no figures of a tool called '%1'").arg(tool_name));
  } else {
    const auto text = grf::read_file(state_file.toStdString(), diagnostics);
    if (text) state = studies::read_state(*text, state_file.toStdString(), diagnostics);
    if (!state) return report();
    if (!tool_name.isEmpty() && !grf::same_keyword(tool_name.toStdString(), state->settings.keyword))
      return fail(QString("the state %1 is of the tool %2")
                      .arg(state_file, QString::fromStdString(state->settings.keyword)));
  }
  if (const auto tool = studies::study_tool(state->settings.keyword)) {
    std::vector<std::string> paths;
    for (const QString& file : files) paths.push_back(file.toStdString());
    open_files(*tool, paths, *state, diagnostics);
  }
  const auto study = study_of(*state, {plot::Paper::White, {}, {}, {}, editor::read_any_scene}, diagnostics);
  if (!study || !write_picture(study->figure, output.toStdString(), diagnostics)) return report();
  std::cout << study->summary << '\n';
  return report();
}

std::unique_ptr<QWidget> open_window(const QString& tool_name, QStringList files, const QString& state_file) {
  if (tool_name.isEmpty()) {
    auto window = std::make_unique<editor::MainWindow>();
    window->show();
    window->open(files);
    if (files.isEmpty() && editor::Preferences::load().shows_welcome) window->welcome().show_page();
    window->offer_lost_work();
    return window;
  }
  const std::vector<editor::Tool> tools = editor::tools();
  const auto tool =
      std::ranges::find_if(tools, [&](const editor::Tool& each) { return each.name == tool_name; });
  if (tool == tools.end()) return nullptr;
  if (!state_file.isEmpty()) files.prepend(state_file);
  std::unique_ptr<QWidget> window(tool->open(files));
  window->show();
  return window;
}

}  // namespace

int main(int argc, char** argv) {
  QElapsedTimer since;
  since.start();
  // A figure is made without a window, and so without a display.
  const auto asks_for_figure = [](const char* argument) {
    return QByteArray(argument) == "-o" || QByteArray(argument).startsWith("--output");
  };
  const bool has_window = std::none_of(argv, argv + argc, asks_for_figure);
  const std::unique_ptr<QCoreApplication> application(has_window ? new QApplication(argc, argv)
                                                                 : new QCoreApplication(argc, argv));
  QCoreApplication::setOrganizationName("granada");
  QCoreApplication::setApplicationName("wannabe");
  QCoreApplication::setApplicationVersion(GRANADA_VERSION);
  if (has_window) QGuiApplication::setDesktopFileName("wannabe");
  editor::leave_threads_to_painting();

  QCommandLineParser parser;
  parser.setApplicationDescription("Edits GRF scenes with a BRDF per face.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("FILE", "A scene or a model to open; others are appended to it.", "[FILE...]");
  const QCommandLineOption tool("tool", "Opens a single tool instead: " + list_of_tools(), "NAME");
  const QCommandLineOption state("state", "Opens the tool with these settings, as saved by it.", "FILE");
  const QCommandLineOption output({"o", "output"}, "Makes the tool's figure without a window.",
                                  "FILE.svg|png|pdf");
  const QCommandLineOption theme(
      "theme", "Uses the theme dark or light for this session; the default is the last one chosen.", "NAME");
  const QCommandLineOption startup("startup-time", "Prints the time until the window shows all, and exits.");
  parser.addOptions({tool, state, output, theme, startup});
  if (!parser.parse(QCoreApplication::arguments())) return fail(parser.errorText());
  if (parser.isSet("help")) parser.showHelp();
  if (parser.isSet("version")) parser.showVersion();
  if (parser.isSet(output))
    return make_figure(parser.value(state), parser.value(tool), parser.positionalArguments(),
                       parser.value(output));
  const editor::Preferences preferences = editor::Preferences::load();
  editor::install_translation(*application, preferences.language);
  const QString look = parser.isSet(theme) ? parser.value(theme) : preferences.theme;
  if (look != "dark" && look != "light") return fail("--theme must be dark or light, not " + look);
  editor::apply(look == "light" ? editor::Theme::Light : editor::Theme::Dark, *qApp);

  const std::unique_ptr<QWidget> window =
      open_window(parser.value(tool), parser.positionalArguments(), parser.value(state));
  if (window == nullptr)
    return fail("unknown tool " + parser.value(tool) + "; the tools are " + list_of_tools());
  if (parser.isSet(startup)) tell_startup_time(*window, since);
  return QApplication::exec();
}
