// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/mujoco_camera.hpp"

#include <GL/osmesa.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <mujoco/mujoco.h>

#include "fairway/base/contract.hpp"
#include "fairway/simulation/physics/mujoco_loading.hpp"

namespace fairway {

namespace {

constexpr std::size_t kChannels = 3;
constexpr int kMostShapes = 20000;

std::size_t pixels(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

struct MujocoCamera::Scene {
  explicit Scene(const std::string& xml, int width, int height)
      : model(load_mujoco_model(xml)),
        data(mj_makeData(model)),
        // 24 bits of depth, 8 of stencil, no accumulation buffer.
        context(OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, nullptr)),
        screen(4 * pixels(width, height)) {
    mjv_defaultScene(&shapes);
    mjr_defaultContext(&renderer);
    mjv_defaultOption(&options);
    if (context == nullptr ||
        OSMesaMakeCurrent(context, screen.data(), GL_UNSIGNED_BYTE, width, height) == 0) {
      release();
      throw std::runtime_error("OSMesa: no off-screen context");
    }
    mjv_makeScene(model, &shapes, kMostShapes);
    // The processor draws: shadows and reflections would take most of its time.
    model->vis.quality.shadowsize = 0;
    shapes.flags[mjRND_SHADOW] = 0;
    shapes.flags[mjRND_REFLECTION] = 0;
    mjr_makeContext(model, &renderer, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &renderer);
  }
  ~Scene() {
    mjr_freeContext(&renderer);
    mjv_freeScene(&shapes);
    release();
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void release() {
    if (context != nullptr) OSMesaDestroyContext(context);
    mj_deleteData(data);
    mj_deleteModel(model);
  }

  mjModel* model;
  mjData* data;
  OSMesaContext context;
  std::vector<std::uint8_t> screen;
  mjvScene shapes{};
  mjvOption options{};
  mjrContext renderer{};
};

MujocoCamera::MujocoCamera(const Scenario& scenario,
                           int width,
                           int height,
                           const MujocoRobot& robot)
    : bodies_(scenario.bodies),
      width_(width),
      height_(height),
      scene_(std::make_unique<Scene>(mujoco_model(scenario, robot), width, height)) {
  FAIRWAY_EXPECTS(width >= 1 && width <= kMostWidth && height >= 1 && height <= kMostHeight);
}

MujocoCamera::~MujocoCamera() = default;

CameraImage MujocoCamera::shot(std::span<const Pose2> robots, double time, const CameraView& view) {
  mjModel* const model = scene_->model;
  mjData* const data = scene_->data;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const int body = mj_name2id(model, mjOBJ_BODY, ("robot" + std::to_string(i)).c_str());
    FAIRWAY_EXPECTS(body >= 0);
    // The first joint of a robot is the free one: position, then the turn about z as a quaternion.
    mjtNum* const q = data->qpos + model->jnt_qposadr[model->body_jntadr[body]];
    q[0] = robots[i].position.x();
    q[1] = robots[i].position.y();
    q[3] = std::cos(0.5 * robots[i].heading);
    q[4] = q[5] = 0.0;
    q[6] = std::sin(0.5 * robots[i].heading);
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Eigen::Vector2d position = bodies_[i].at(time).position;
    data->mocap_pos[3 * i] = position.x();
    data->mocap_pos[3 * i + 1] = position.y();
  }
  mj_forward(model, data);

  constexpr double kDegrees = 180.0 / std::numbers::pi;
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  camera.lookat[0] = view.look_at.x();
  camera.lookat[1] = view.look_at.y();
  camera.distance = view.distance;
  camera.azimuth = kDegrees * view.azimuth;
  camera.elevation = kDegrees * view.elevation;
  mjv_updateScene(model, data, &scene_->options, nullptr, &camera, mjCAT_ALL, &scene_->shapes);
  const mjrRect all{0, 0, width_, height_};
  mjr_render(all, &scene_->shapes, &scene_->renderer);
  std::vector<std::uint8_t> from_below(kChannels * pixels(width_, height_));
  mjr_readPixels(from_below.data(), nullptr, all, &scene_->renderer);

  CameraImage image{.width = width_, .height = height_, .rgb = {}};
  image.rgb.reserve(from_below.size());
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(kChannels) * width_;
  for (int y = height_ - 1; y >= 0; --y)
    image.rgb.insert(image.rgb.end(), from_below.begin() + y * row,
                     from_below.begin() + (y + 1) * row);
  return image;
}

}  // namespace fairway
