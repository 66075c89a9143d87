// Latency of edits of a large scene: how long the editor's window is busy, how long until the view draws it,
// how much memory undo steps take, and how long opening a scene takes.
#include <QApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>
#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>
#include <malloc.h>

#include "editor/brdf/brdf_editor.h"
#include "editor/document/object_edits.h"
#include "editor/panels/message_panel.h"
#include "editor/window/file_actions.h"
#include "grf/read.h"
#include "grf/write.h"
#include "tests/editor/own_application.h"
#include "tests/editor/window/window_driver.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

using test::Minute;

/// The number of repetitions of an action.
constexpr int Tries = 7;

double milliseconds(const QElapsedTimer& clock) { return static_cast<double>(clock.nsecsElapsed()) * 1e-6; }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Bytes that are allocated and not freed.
double allocated() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

grf::Shared<grf::Mesh> knot(const std::string& folder, int faces) {
  const QString file = QString::fromStdString(folder + "/knot.grf");
  QProcess::execute(GRANADA_BIN_DIR "/make_shape", {"knot", QString::number(faces), file});
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(file.toStdString(), diagnostics);
  return std::get<grf::Shared<grf::Mesh>>(scene->contents.blocks.front().content);
}

/// Translated to its own position on a grid.
grf::Block at_place(int number, grf::Block block) {
  const auto place = grf::Vec3f(static_cast<float>(number % 40), 0, static_cast<float>(number / 40)) * 3.0F;
  grf::Transform transform;
  transform.steps.push_back({grf::TransformStep::Kind::Translation, place});
  transform.body.blocks.push_back(std::move(block));
  grf::Block moved;
  moved.content = std::move(transform);
  return moved;
}

grf::Scene one_mesh(const std::string& folder) {
  grf::Scene scene;
  scene.contents.blocks.emplace_back().content = knot(folder, 1'000'000);
  return scene;
}

grf::Scene instances(const std::string& folder) {
  grf::DefinitionScope scope;
  grf::Definition& definition = scope.definitions.emplace_back();
  definition.name = "knot";
  definition.body = knot(folder, 35'000);
  for (int i = 0; i < 1'000; ++i) {
    grf::Block use;
    use.content = grf::Use{{"knot", {}}};
    scope.body.blocks.push_back(at_place(i, std::move(use)));
  }
  grf::Scene scene;
  scene.contents.blocks.emplace_back().content = std::move(scope);
  return scene;
}

grf::Scene meshes(const std::string& folder) {
  const grf::Shared<grf::Mesh> shape = knot(folder, 500);
  grf::Scene scene;
  for (int i = 0; i < 2'000; ++i) {
    // Each has its own vertices, as in a file.
    grf::Mesh mesh = *shape;
    mesh.name = "knot" + std::to_string(i);
    mesh.geometry = grf::SharedGeometry(grf::Geometry(*mesh.geometry));
    grf::Block block;
    block.content = grf::Shared<grf::Mesh>(std::move(mesh));
    scene.contents.blocks.push_back(at_place(i, std::move(block)));
  }
  return scene;
}

struct Case {
  const char* name;
  grf::Scene (*make)(const std::string& folder);
};
constexpr Case Cases[] = {{"1 mesh of 1,000,000 faces", one_mesh},
                          {"1,000 instances of 35,000 faces", instances},
                          {"2,000 meshes of 500 faces", meshes}};

/// A window with a scene.
class Stage {
 public:
  explicit Stage(const Case& scene) : window_(QString::fromStdString(folder_.path("sessions"))) {
    QSettings().clear();
    grf::Diagnostics diagnostics;
    grf::write(scene.make(folder_.path("")), file_.toStdString(), diagnostics);
    window_.show();
    window_.activateWindow();
    if (!QTest::qWaitForWindowActive(&window_)) std::cerr << "the window does not come up\n";
    settle();
  }

  MainWindow& window() { return window_; }
  Document& document() { return window_.document(); }

  void settle() {
    const bool is_settled = QTest::qWaitFor(
        [this] { return window_.view().is_full() && window_.message_panel().check().is_up_to_date(); },
        10 * Minute);
    if (!is_settled) std::cerr << "the window does not come to rest\n";
  }

  void open() {
    QSignalSpy replaced(&document(), &Document::scene_replaced);
    window_.files().open(file_);
    if (replaced.empty()) replaced.wait(10 * Minute);
  }

  void select_one() {
    FaceSelection one(document().objects());
    one.set({0, 0});
    document().select(std::move(one));
  }

  test::Watchdog& watchdog() { return watchdog_; }

 private:
  test::TemporaryFolder folder_;
  const QString file_ = QString::fromStdString(folder_.path("scene.grf"));
  MainWindow window_;
  test::Watchdog watchdog_;
};

void report(benchmark::State& state, const test::Watchdog::Block& longest) {
  state.counters["longest_block_ms"] = static_cast<double>(longest.milliseconds);
  state.counters["block_cpu_ms"] = longest.processor_milliseconds;
}

/// Times an action: the action itself, with all that its signals do and leave to the next turn of the event
/// loop, in which the view hands the frame to its thread; and the longest time for which the window did not
/// respond until all had settled.
void time(
    benchmark::State& state, Stage& stage, const std::function<void()>& action,
    const std::function<void()>& before = [] {}) {
  std::vector<double> busy;
  std::vector<double> used;
  test::Watchdog::Block longest;
  for (auto _ : state) {  // NOLINT(clang-analyzer-deadcode.DeadStores): Google Benchmark's way
    before();
    stage.settle();
    stage.watchdog().longest();
    QElapsedTimer clock;
    clock.start();
    const double used_before = test::processor_time();
    action();
    used.push_back(test::processor_time() - used_before);
    const double of_action = milliseconds(clock);
    QCoreApplication::sendPostedEvents();
    busy.push_back(milliseconds(clock));
    state.SetIterationTime(of_action * 1e-3);
    stage.settle();
    const test::Watchdog::Block block = stage.watchdog().longest();
    longest.milliseconds = std::max(longest.milliseconds, block.milliseconds);
    longest.processor_milliseconds = std::max(longest.processor_milliseconds, block.processor_milliseconds);
  }
  state.counters["action_cpu_ms"] = median(used);
  state.counters["to_frame_ms"] = median(busy);
  state.counters["worst_ms"] = *std::max_element(busy.begin(), busy.end());
  report(state, longest);
}

void tick(benchmark::State& state, Stage& stage) {
  stage.select_one();
  stage.settle();
  std::vector<grf::BrdfModel> models(1);
  models[0].keyword = "ward";
  float roughness = 0.5F;
  const auto move_slider = [&] {
    models[0].arguments = {grf::Argument{"sx", grf::Value(roughness -= 0.001F), {}}};
    emit stage.window().brdf_editor().changing(models);
  };
  move_slider();
  time(state, stage, move_slider);
  emit stage.window().brdf_editor().edited(models);
}

void select(benchmark::State& state, Stage& stage) {
  std::uint32_t face = 0;
  time(state, stage, [&] {
    FaceSelection one(stage.document().objects());
    one.set({0, face = (face + 1) % 100});
    stage.document().select(std::move(one));
  });
}

/// A stroke of the brush across the view; its faces are found in the view's thread.
void paint(benchmark::State& state, Stage& stage) {
  SceneView& view = stage.window().view();
  test::action(stage.window(), "Brush").trigger();
  time(
      state, stage,
      [&] {
        test::drag(view, view.rect().center() - QPoint(200, 0), view.rect().center() + QPoint(200, 0));
        if (!QTest::qWaitFor([&] { return !view.is_selecting(); }, 10 * Minute))
          state.SkipWithError("the stroke selects nothing");
      },
      [&] { test::action(stage.window(), "None").trigger(); });
  test::action(stage.window(), "Brush").trigger();
}

/// A click that selects a face loop, and growing it.
void select_loop(benchmark::State& state, Stage& stage) {
  const QPoint middle = stage.window().view().rect().center();
  time(state, stage, [&] {
    stage.window().view().click(middle, Qt::AltModifier);
    test::action(stage.window(), "Grow").trigger();
  });
}

void rename(benchmark::State& state, Stage& stage) {
  int number = 0;
  const grf::ScenePath path = stage.document().objects().meshes[0].path;
  time(state, stage, [&] {
    grf::Diagnostics diagnostics;
    auto scene =
        rename_object(stage.document().scene(), path, "name" + std::to_string(++number), diagnostics);
    if (scene) stage.document().replace("Rename", std::move(*scene));
  });
}

void edit(Document& document, int number) {
  SurfaceEdit edit;
  edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(static_cast<float>(number) / 1000.0F));
  document.edit_surfaces("Colour", edit);
}

void undo(benchmark::State& state, Stage& stage) {
  stage.select_one();
  int number = 0;
  time(
      state, stage, [&] { stage.document().undo_stack().undo(); }, [&] { edit(stage.document(), ++number); });
}

void redo(benchmark::State& state, Stage& stage) {
  stage.select_one();
  edit(stage.document(), 999);
  time(
      state, stage, [&] { stage.document().undo_stack().redo(); },
      [&] { stage.document().undo_stack().undo(); });
}

/// The memory of 100 undo steps that change surfaces, in percent of the scene's: measured on a document
/// without a window, whose other allocations come and go. Each step edits the same face or the next one.
void remember(benchmark::State& state, const grf::Scene& scene, double scene_bytes, bool moves_on) {
  for (auto _ : state) {  // NOLINT(clang-analyzer-deadcode.DeadStores): Google Benchmark's way
    Document document;
    document.take(scene, {}, {});
    const auto edit_next = [&](std::uint32_t number) {
      FaceSelection one(document.objects());
      one.set({0, moves_on ? number : 0});
      document.select(std::move(one));
      edit(document, static_cast<int>(number));
    };
    QElapsedTimer clock;
    clock.start();
    for (std::uint32_t i = 0; i < 100; ++i) edit_next(i);
    state.SetIterationTime(milliseconds(clock) * 1e-3);
    const double with_steps = allocated();
    document.undo_stack().clear();
    const double of_steps = with_steps - allocated();
    state.counters["bytes_per_step"] = of_steps / 100;
    state.counters["percent_of_scene"] = 100 * of_steps / scene_bytes;
    state.counters["scene_MB"] = scene_bytes * 1e-6;
  }
}

/// The time from the command to the first picture with the whole scene.
void open(benchmark::State& state, Stage& stage) {
  stage.document().clear();
  for (auto _ : state) {  // NOLINT(clang-analyzer-deadcode.DeadStores): Google Benchmark's way
    stage.watchdog().longest();
    QElapsedTimer clock;
    clock.start();
    stage.open();
    const double read = milliseconds(clock);
    const bool is_shown = QTest::qWaitFor([&] { return stage.window().view().is_full(); }, 10 * Minute);
    if (!is_shown) state.SkipWithError("the scene is not shown");
    state.SetIterationTime(milliseconds(clock) * 1e-3);
    state.counters["read_ms"] = read;
    stage.settle();
    report(state, stage.watchdog().longest());
  }
}

/// The current stage of the scene: one at a time.
class Theatre {
 public:
  void close() {
    stage_.reset();
    scene_ = nullptr;
  }
  Stage& stage_of(const Case& scene) {
    if (scene_ != &scene) {
      close();
      stage_ = std::make_unique<Stage>(scene);
      scene_ = &scene;
      stage_->open();
      stage_->settle();
    }
    return *stage_;
  }

 private:
  const Case* scene_ = nullptr;
  std::unique_ptr<Stage> stage_;
};

void add(const Case& scene, const char* name, int tries,
         const std::function<void(benchmark::State&)>& action) {
  benchmark::RegisterBenchmark((std::string(scene.name) + "/" + name).c_str(), action)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(tries);
}

void add_all(const Case& scene, Theatre& theatre) {
  using Action = void (*)(benchmark::State&, Stage&);
  const auto on_stage = [&](Action action) {
    return [&, action](benchmark::State& state) { action(state, theatre.stage_of(scene)); };
  };
  add(scene, "open", 1, on_stage(open));
  add(scene, "slider", Tries, on_stage(tick));
  add(scene, "select", Tries, on_stage(select));
  add(scene, "paint", Tries, on_stage(paint));
  add(scene, "loop", Tries, on_stage(select_loop));
  add(scene, "rename", Tries, on_stage(rename));
  add(scene, "undo", Tries, on_stage(undo));
  add(scene, "redo", Tries, on_stage(redo));
  for (const bool moves_on : {false, true}) {
    const auto measure = [&, moves_on](benchmark::State& state) {
      theatre.close();
      const double before = allocated();
      const test::TemporaryFolder folder;
      const grf::Scene made = scene.make(folder.path(""));
      remember(state, made, allocated() - before, moves_on);
    };
    add(scene, moves_on ? "100 steps of different faces" : "100 steps", 1, measure);
  }
}

}  // namespace
}  // namespace editor

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  test::OwnScreen screen;
  const auto application = test::application_on(screen, {1920, 1200}, argc, argv);
  if (application == nullptr) return EXIT_FAILURE;
  editor::Theatre theatre;
  for (const editor::Case& scene : editor::Cases) editor::add_all(scene, theatre);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
