// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_scenario.hpp"

#include <memory>

#include "experiments/clocks.hpp"
#include "fairway/io/recording/recording.hpp"
#include "fairway/io/web_report/report.hpp"
#include "fairway/io/whole_file.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"
#include "results.hpp"
#include "simulation/callbacks.hpp"
#include "simulation/run_control.hpp"

namespace fairway::python {

namespace {

void check_scenario(const Scenario& scenario) {
  value_of(validate(scenario.settings));
  if (scenario.robots.empty()) throw py::value_error("robots: expected at least one, found none");
  if (scenario.engine != Engine::Unicycle)
    throw py::value_error("engine: expected unicycle, found mujoco, which only the tool has");
}

// Whether the answer of a callback lets the run continue: nothing, or what counts as true.
bool continues(const py::object& answer) {
  const int truth = answer.is_none() ? 1 : PyObject_IsTrue(answer.ptr());
  if (truth < 0) throw py::error_already_set();
  return truth != 0;
}

/// The outputs of a run: files are opened before it and completed after it.
class Outputs {
 public:
  Outputs(const std::optional<std::filesystem::path>& log,
          const std::optional<std::filesystem::path>& report) {
    if (log) {
      recording_ = value_of(io::RecordingFile::create(log->string()));
      observers_.add(recording_->observer());
    }
    if (report) {
      value_of(io::check_writable(report->string()));
      page_ = std::make_unique<io::Report>();
      path_ = report->string();
      observers_.add(page_->observer());
    }
  }
  [[nodiscard]] ObserverList& observers() noexcept { return observers_; }
  void close() {
    if (recording_) value_of(recording_->close());
    if (page_) value_of(io::write_file_atomically(path_, page_->page()));
  }

 private:
  std::unique_ptr<io::RecordingFile> recording_;
  std::unique_ptr<io::Report> page_;
  std::string path_;
  ObserverList observers_;
};

}  // namespace

EpisodeResult run_scenario(const Scenario& scenario,
                           const py::object& on_cycle,
                           const py::object& on_plan,
                           const py::object& on_step,
                           const py::object& play,
                           const std::optional<std::filesystem::path>& log,
                           const std::optional<std::filesystem::path>& report) {
  check_scenario(scenario);
  Callbacks callbacks(on_plan, on_step);
  Outputs outputs(log, report);
  outputs.observers().add(callbacks);
  const auto control = std::make_shared<RunControl>();
  EpisodeHooks hooks{.clock = thread_cpu_seconds,
                     .on_cycle =
                         [&](double time) {
                           bool more = true;
                           const bool fine = callbacks.run([&] {
                             if (!on_cycle.is_none()) more = continues(on_cycle(time));
                           });
                           return fine && more;
                         },
                     .observer = &outputs.observers()};
  if (!play.is_none()) {
    hooks.play = [&](EpisodeControl& run) {
      bool more = true;
      control->open(&run);
      const bool fine = callbacks.run([&] { more = continues(play(control)); });
      control->open(nullptr);
      return fine && more;
    };
  }
  EpisodeResult result = without_gil([&] {
    EpisodeResult made = run_episode(scenario, hooks);
    outputs.close();
    return made;
  });
  callbacks.rethrow();
  return result;
}

}  // namespace fairway::python
