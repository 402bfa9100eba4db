// SPDX-License-Identifier: Apache-2.0
#include "film.hpp"

#ifdef FAIRWAY_HAS_CAMERA
#include <stdexcept>

#include "fairway/io/film_file.hpp"
#include "fairway/physics/mujoco_camera.hpp"
#endif

namespace fairway::app {

#ifdef FAIRWAY_HAS_CAMERA

Expected<void> check_film() { return {}; }

Expected<std::string> run_film(const Scenario& scenario, const EpisodeResult& result) {
  constexpr std::size_t kMostFrames = 300;
  io::Film film{.width = 480, .height = 270, .interval = 0.1, .frames = {}};
  const std::size_t robots = scenario.robots.size();
  std::vector<Pose2> poses(robots);
  for (std::size_t i = 0; i < robots; ++i)
    poses[i] = scenario.robots[i].start;
  try {
    MujocoCamera camera(scenario, film.width, film.height);
    double next = 0.0;
    for (const TraceRow& row : result.trace.rows) {
      poses[row.robot] = row.pose;
      if (row.robot != 0 || row.time < next || film.frames.size() >= kMostFrames) continue;
      next = row.time + film.interval - 1e-9;
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
  return fail(
      "--film-dir: expected MuJoCo and OSMesa, found neither or one of them (this tool was built "
      "without libmujoco-dev, libqhull-dev or libosmesa6-dev)");
}

Expected<std::string> run_film(const Scenario& /*scenario*/, const EpisodeResult& /*result*/) {
  return tl::unexpected(check_film().error());
}

#endif

}  // namespace fairway::app
