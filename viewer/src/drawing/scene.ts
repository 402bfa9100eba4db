// SPDX-License-Identifier: Apache-2.0
import type { RobotFrame } from '../data/frame';
import type { Point } from '../data/geometry';
import { type Moment, gridAt } from '../data/moment';
import type { Run } from '../data/run';
import { drawBelieved, drawBody, drawRobot } from './bodies';
import type { Camera } from './camera';
import type { Layers } from './layers';
import { drawNames, drawScaleBar } from './lettering';
import { MapLayer } from './map_layer';
import { Pen } from './pen';
import { drawCorridor, drawLimit, drawPrediction, drawWay } from './plan';
import { drawReasons } from './reasons';
import { SeenMap, drawScan } from './seen';
import { type Theme, robotColor } from './theme';
import { Trails } from './trails';
import { drawZones } from './zones';

/** Draws a moment of a run, from the lowest layer to the highest. */
export class Scene {
  private readonly map = new MapLayer((theme) => [theme.free, theme.occupied, theme.unknown]);
  private readonly walls = new MapLayer((theme) => [`${theme.occupied}00`, `${theme.occupied}a0`, `${theme.occupied}00`]);
  private readonly seen = new SeenMap();
  private readonly trails = new Trails();

  /** What the true map contains at a point, as last drawn; empty outside. */
  cellName(p: Point): string {
    return ['free', 'obstacle', 'unknown'][this.map.cellAt(p) ?? -1] ?? '';
  }

  /** @param selected the robot whose corridor is shown. */
  draw(
    context: CanvasRenderingContext2D, camera: Camera, theme: Theme, layers: Layers, run: Run,
    moment: Moment, selected: number,
  ): void {
    const pen = new Pen(context, camera, theme);
    const { robots } = moment.frame;
    const chosen = robots[selected] ?? null;
    // The estimates of a robot with a lidar are drawn around its true pose.
    const asBelieved = (robot: RobotFrame, draw: () => void): void => pen.within(robot.belief, draw);
    context.fillStyle = theme.outside;
    context.fillRect(0, 0, camera.width, camera.height);
    const grid = gridAt(run, 0, moment.time);
    if (grid) this.map.draw(context, camera, grid, moment.time, theme);
    if (layers.zones) drawZones(pen, run.zonesAt(moment.time));
    if (layers.seen) this.seen.draw(pen, run, moment, chosen);
    if (chosen && layers.corridor) asBelieved(chosen, () => drawCorridor(pen, chosen));
    // A corridor of a robot with a lidar may cross walls that it has not seen yet.
    if (grid && run.lidar) this.walls.draw(context, camera, grid, moment.time, theme);
    if (layers.trail) {
      const colors = robots.map((_, i) => robotColor(i, theme));
      this.trails.draw(context, camera, run, moment.index, colors);
      // From the last frame to the displayed position of the robot.
      moment.poses.forEach((pose, i) => {
        pen.trace([robots[i]!, pose]);
        pen.stroke(colors[i]!, 2.25, 0.9);
      });
    }
    robots.forEach((robot, i) => asBelieved(robot, () => drawWay(pen, robot, i, i === selected, layers.path)));
    for (const body of moment.bodies) drawBody(pen, body, layers.velocity);
    robots.forEach((robot, i) => asBelieved(robot, () => {
      if (i === selected && layers.scan) drawScan(pen, robot);
      if (i === selected) robot.cycle?.believed.forEach((body) => drawBelieved(pen, body));
      if (layers.prediction && !robot.absent) drawPrediction(pen, robot, i, run.radius);
    }));
    moment.poses.forEach((pose, i) => drawRobot(pen, pose, robots[i]!, i, run, i === selected));
    if (layers.names && robots.length > 1) drawNames(pen, moment.poses, robots, run, selected);
    if (chosen && layers.limit) asBelieved(chosen, () => drawLimit(pen, chosen));
    if (layers.reasons) drawReasons(pen, run, moment, selected);
    drawScaleBar(pen);
  }
}
