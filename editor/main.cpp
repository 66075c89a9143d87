// wannabe: the scene editor, and its tools.
#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <iostream>
#include <memory>

#include "editor/appearance/theme.h"
#include "editor/view/scene_view.h"
#include "editor/window/file_actions.h"
#include "editor/window/main_window.h"
#include "editor/window/tools.h"

namespace {

constexpr int BadCommandLine = 2;

QString list_of_tools() {
  QStringList lines;
  for (const editor::Tool& tool : editor::tools())
    lines.append(QString("%1 (%2)").arg(tool.name, tool.about));
  return lines.join("; ");
}

int fail(const QString& message) {
  std::cerr << "wannabe: " << message.toStdString() << '\n';
  return BadCommandLine;
}

/// Closes the window once the scene is shown in full, and prints how long that took.
void tell_startup_time(editor::MainWindow& window, const QElapsedTimer& since) {
  auto* timer = new QTimer(&window);
  QObject::connect(timer, &QTimer::timeout, &window, [&window, since] {
    if (window.files().is_importing() || !window.view().is_full()) return;
    std::cout << since.elapsed() << " ms" << std::endl;
    QApplication::exit();
  });
  timer->start(0);
}

std::unique_ptr<QWidget> open_window(const QString& tool_name, const QStringList& files) {
  if (tool_name.isEmpty()) {
    auto window = std::make_unique<editor::MainWindow>();
    window->show();
    window->open(files);
    window->offer_lost_work();
    return window;
  }
  const std::vector<editor::Tool> tools = editor::tools();
  const auto tool =
      std::ranges::find_if(tools, [&](const editor::Tool& each) { return each.name == tool_name; });
  if (tool == tools.end()) return nullptr;
  std::unique_ptr<QWidget> window(tool->open(files));
  window->show();
  return window;
}

}  // namespace

int main(int argc, char** argv) {
  QElapsedTimer since;
  since.start();
  QApplication application(argc, argv);
  QApplication::setOrganizationName("granada");
  QApplication::setApplicationName("wannabe");
  QApplication::setApplicationVersion(GRANADA_VERSION);
  QApplication::setDesktopFileName("wannabe");

  QCommandLineParser parser;
  parser.setApplicationDescription("Edits GRF scenes with a BRDF per face.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("FILE", "A scene or a model to open; others are appended to it.", "[FILE...]");
  const QCommandLineOption tool("tool", "Opens a single tool instead: " + list_of_tools(), "NAME");
  const QCommandLineOption theme(
      "theme", "Uses the theme dark or light for this session; the default is the last one chosen.", "NAME");
  const QCommandLineOption startup("startup-time", "Prints the time until the window responds, and exits.");
  parser.addOptions({tool, theme, startup});
  if (!parser.parse(QApplication::arguments())) return fail(parser.errorText());
  if (parser.isSet("help")) parser.showHelp();
  if (parser.isSet("version")) parser.showVersion();
  const QString look =
      parser.isSet(theme) ? parser.value(theme) : QSettings().value("theme", "dark").toString();
  if (look != "dark" && look != "light") return fail("--theme must be dark or light, not " + look);
  editor::apply(look == "light" ? editor::Theme::Light : editor::Theme::Dark, application);

  const std::unique_ptr<QWidget> window = open_window(parser.value(tool), parser.positionalArguments());
  if (window == nullptr)
    return fail("unknown tool " + parser.value(tool) + "; the tools are " + list_of_tools());
  auto* main_window = qobject_cast<editor::MainWindow*>(window.get());
  if (main_window != nullptr && parser.isSet(startup)) tell_startup_time(*main_window, since);
  return QApplication::exec();
}
