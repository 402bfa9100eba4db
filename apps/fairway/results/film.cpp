// SPDX-License-Identifier: Apache-2.0
#include "results/film.hpp"

#ifdef FAIRWAY_HAS_CAMERA
#include <algorithm>
#include <stdexcept>

#include "fairway/io/drawing/film_file.hpp"
#include "fairway/simulation/physics/mujoco_camera.hpp"
#else
#include "cli/left_out.hpp"
#endif

namespace fairway::app {

#ifdef FAIRWAY_HAS_CAMERA

Expected<void> check_film() { return {}; }

Expected<std::string> run_film(const Scenario& scenario,
                               const EpisodeResult& result,
                               const FilmProgress& progress) {
  // Each picture takes some hundredths of a second, so long runs have fewer per second.
  constexpr double kMostFrames = 100.0;
  constexpr double kInterval = 0.2;  // [s]
  io::Film film{.width = 400,
                .height = 225,
                .interval = std::max(kInterval, result.time / kMostFrames),
                .frames = {}};
  const std::size_t robots = scenario.robots.size();
  std::vector<Pose2> poses(robots);
  for (std::size_t i = 0; i < robots; ++i)
    poses[i] = scenario.robots[i].start;
  try {
    MujocoCamera camera(scenario, film.width, film.height);
    double next = 0.0;
    for (const TraceRow& row : result.trace.rows) {
      poses[row.robot] = row.pose;
      const bool last = &row == &result.trace.rows.back();
      if (!last && (row.robot != 0 || row.time < next)) continue;
      next += film.interval;
      progress(row.time / std::max(result.time, kInterval));
      const CameraView view{.look_at = row.pose.position, .distance = 4.0};
      film.frames.push_back(camera.shot(poses, row.time, view).rgb);
    }
  } catch (const std::runtime_error& error) {
    return fail(std::string("--film-dir: expected a picture, found ") + error.what());
  }
  return io::film_gif(film);
}

#else

Expected<void> check_film() {
  return fail("--film-dir: expected MuJoCo with OSMesa, " +
              left_out("libmujoco-dev libqhull-dev libosmesa6-dev"));
}

Expected<std::string> run_film(const Scenario& /*scenario*/,
                               const EpisodeResult& /*result*/,
                               const FilmProgress& /*progress*/) {
  return tl::unexpected(check_film().error());
}

#endif

}  // namespace fairway::app
