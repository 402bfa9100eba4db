// SPDX-License-Identifier: Apache-2.0
import { windowCorners } from '../data/belief';
import type { Body, Goal, RobotFrame } from '../data/frame';
import { type Point, type Pose, placed, placedPose } from '../data/geometry';
import { type Moment, gridAt } from '../data/moment';
import type { Run } from '../data/run';
import type { Camera } from './camera';
import { MapLayer } from './map_layer';
import { type Theme, robotColor } from './theme';
import { Trails } from './trails';

/** What can be shown or hidden. */
export const layerNames = {
  path: 'Path',
  corridor: 'Corridor',
  prediction: 'Prediction',
  trail: 'Way driven',
  limit: 'What limits',
  velocity: 'Velocities',
  seen: 'Map it has seen',
  scan: 'Lidar',
  names: 'Names',
} as const;
export type Layer = keyof typeof layerNames;
export type Layers = Record<Layer, boolean>;

const TAU = 2 * Math.PI;
const LABEL = '600 12px system-ui, sans-serif';
const LEAST_ROBOT = 5; // radius of a robot that is far away [pixels]

function corners(pose: Pose, length: number, width: number): Point[] {
  const [c, s] = [Math.cos(pose.heading), Math.sin(pose.heading)];
  return [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([u, v]) => ({
    x: pose.x + (c * u! * length - s * v! * width) / 2,
    y: pose.y + (s * u! * length + c * v! * width) / 2,
  }));
}

/** Draws a moment of a run. */
export class Scene {
  private readonly map = new MapLayer((theme) => [theme.free, theme.occupied, theme.unknown]);
  private readonly seen = new MapLayer((theme) => [`${theme.believed}00`, `${theme.believed}cc`, `${theme.ink}18`]);
  private readonly fog = new MapLayer((theme) => ['#00000000', theme.fog, theme.fog]);
  private readonly trails = new Trails();
  private belief: Pose | null = null; // of the robot that is being drawn
  private context!: CanvasRenderingContext2D;
  private camera!: Camera;
  private theme!: Theme;
  private layers!: Layers;

  /** @param selected the robot whose corridor is shown. */
  draw(
    context: CanvasRenderingContext2D, camera: Camera, theme: Theme, layers: Layers, run: Run,
    moment: Moment, selected: number,
  ): void {
    Object.assign(this, { context, camera, theme, layers });
    context.fillStyle = theme.outside;
    context.fillRect(0, 0, camera.width, camera.height);
    const grid = gridAt(run, 0, moment.time);
    if (grid) this.map.draw(context, camera, grid, moment.time, theme);
    const { robots } = moment.frame;
    if (layers.seen) this.seenMap(run, moment, robots[selected] ?? null);
    robots.forEach((robot, i) => {
      if (i === selected) this.asBelieved(robot, () => this.corridor(robot));
    });
    if (layers.trail) {
      const colors = robots.map((_, i) => robotColor(i, theme));
      this.trails.draw(context, camera, run, moment.index, colors);
      // From the last frame to where the robot is shown now.
      moment.poses.forEach((pose, i) => {
        this.trace([robots[i]!, pose]);
        this.stroke(colors[i]!, 2.25, 0.9);
      });
    }
    robots.forEach((robot, i) => this.asBelieved(robot, () => this.way(robot, i, i === selected)));
    for (const body of moment.bodies) this.body(body, theme.body);
    robots.forEach((robot, i) => this.asBelieved(robot, () => {
      if (i === selected && layers.scan) this.scan(robot);
      if (i === selected) robot.cycle?.believed.forEach((body) => this.believed(body));
      if (layers.prediction) this.prediction(robot, i, run.radius);
    }));
    moment.poses.forEach((pose, i) => this.robot(pose, robots[i]!, i, run, i === selected));
    if (layers.names && robots.length > 1) this.names(moment.poses, run, selected);
    if (layers.limit) {
      robots.forEach((robot, i) => {
        if (i === selected) this.asBelieved(robot, () => this.limit(robot));
      });
    }
    this.scaleBar();
  }

  private pixels(metres: number): number {
    return metres * this.camera.scale;
  }

  // What a robot with a lidar believes is drawn around where it truly is.
  private asBelieved(robot: RobotFrame, draw: () => void): void {
    this.belief = robot.belief;
    draw();
    this.belief = null;
  }

  private at(p: Point): Point {
    return this.camera.toScreen(this.belief ? placed(this.belief, p) : p);
  }

  // What a robot drives on: the map as it knows it, or what its lidar has seen.
  private seenMap(run: Run, { time }: Moment, robot: RobotFrame | null): void {
    const { context, camera, theme } = this;
    if (!robot || robot.slots.known === 0) return;
    const known = gridAt(run, robot.slots.known, time);
    if (!known) return;
    if (robot.slots.occupied === 0 || !robot.belief) return this.seen.draw(context, camera, known, time, theme);
    const occupied = gridAt(run, robot.slots.occupied, time);
    // Outside the window it has seen nothing, or forgotten it.
    context.beginPath();
    context.rect(0, 0, camera.width, camera.height);
    windowCorners(known.frame, robot.belief).forEach((p, i) => {
      const at = camera.toScreen(p);
      if (i === 0) context.moveTo(at.x, at.y);
      else context.lineTo(at.x, at.y);
    });
    context.closePath();
    context.fillStyle = theme.fog;
    context.fill('evenodd');
    const origin = placedPose(robot.belief, known.frame.origin);
    this.fog.draw(context, camera, known, time, theme, origin);
    if (occupied) this.seen.draw(context, camera, occupied, time, theme, placedPose(robot.belief, occupied.frame.origin));
  }

  private scan({ scan }: RobotFrame): void {
    const { context } = this;
    if (!scan) return;
    context.fillStyle = this.theme.scan;
    for (let i = 0; i < scan.points.length; i += 2) {
      const at = this.at({ x: scan.points[i]!, y: scan.points[i + 1]! });
      context.fillRect(at.x - 1.25, at.y - 1.25, 2.5, 2.5);
    }
  }

  private trace(points: readonly Point[], close = false): void {
    this.context.beginPath();
    points.forEach((p, i) => {
      const at = this.at(p);
      if (i === 0) this.context.moveTo(at.x, at.y);
      else this.context.lineTo(at.x, at.y);
    });
    if (close) this.context.closePath();
  }

  private stroke(color: string, width: number, alpha = 1, dash: number[] = []): void {
    const { context } = this;
    context.save();
    context.strokeStyle = color;
    context.lineWidth = width;
    context.globalAlpha = alpha;
    context.lineJoin = 'round';
    context.lineCap = 'round';
    context.setLineDash(dash);
    context.stroke();
    context.restore();
  }

  private fill(color: string, alpha = 1): void {
    const { context } = this;
    context.save();
    context.fillStyle = color;
    context.globalAlpha = alpha;
    context.fill();
    context.restore();
  }

  private disc(center: Point, radius: number): void {
    const at = this.at(center);
    this.context.beginPath();
    this.context.arc(at.x, at.y, Math.max(this.pixels(radius), 0.5), 0, TAU);
  }

  private corridor(robot: RobotFrame): void {
    const { plan, cycle } = robot;
    if (!this.layers.corridor || !plan) return;
    plan.rectangles.forEach((corners, i) => {
      const current = cycle !== null && i === cycle.rectangle && plan.usable;
      this.trace(corners, true);
      this.fill(this.theme.corridor, current ? 0.26 : 0.1);
      this.stroke(current ? this.theme.current : this.theme.corridor, current ? 2 : 1,
        current ? 1 : 0.55);
    });
  }

  private way(robot: RobotFrame, index: number, selected: boolean): void {
    const { plan } = robot;
    if (!plan) return;
    if (this.layers.path && plan.path.length > 1) {
      this.trace(plan.path);
      this.stroke(this.theme.path, selected ? 1.75 : 1, selected ? 0.95 : 0.4, [7, 5]);
    }
    this.goal(robot.goal ?? plan.goal, robotColor(index, this.theme), plan.usable);
  }

  private goal(goal: Goal, color: string, usable: boolean): void {
    const radius = Math.max(6 / this.camera.scale, 0.14);
    this.disc(goal, radius);
    this.fill(this.theme.halo, 0.85);
    this.stroke(color, 2, 1, usable ? [] : [3, 3]);
    this.disc(goal, radius / 3);
    this.fill(color);
    if (goal.heading === null) return;
    this.arrow(goal, goal.heading, 2.4 * radius, color);
  }

  private arrow(from: Point, heading: number, length: number, color: string): void {
    const ahead = (distance: number, turn = 0): Point => ({
      x: from.x + distance * Math.cos(heading + turn),
      y: from.y + distance * Math.sin(heading + turn),
    });
    this.trace([from, ahead(length)]);
    this.stroke(color, 2);
    this.trace([ahead(0.72 * length, 0.28), ahead(1.08 * length), ahead(0.72 * length, -0.28)], true);
    this.fill(color);
  }

  private prediction(robot: RobotFrame, index: number, radius: number): void {
    const points = robot.cycle?.prediction ?? [];
    if (points.length < 2) return;
    const color = this.theme.prediction;
    const last = points.at(-1)!;
    this.disc(last, radius);
    this.stroke(robotColor(index, this.theme), 1, 0.5, [3, 3]);
    this.trace(points);
    this.stroke(this.theme.halo, 4, 0.6);
    this.trace(points);
    this.stroke(color, 2);
    for (const p of points.slice(1)) {
      this.disc(p, 2 / this.camera.scale);
      this.fill(color);
    }
  }

  private body(body: Body, color: string): void {
    this.disc(body, body.radius);
    this.fill(color, 0.85);
    this.stroke(this.theme.halo, 1.25, 0.9);
    const speed = Math.hypot(body.vx, body.vy);
    if (!this.layers.velocity || speed < 0.05) return;
    // Where it will be in a second.
    this.trace([body, { x: body.x + body.vx, y: body.y + body.vy }]);
    this.stroke(color, 2, 0.9);
    this.disc({ x: body.x + body.vx, y: body.y + body.vy }, body.radius);
    this.stroke(color, 1.25, 0.6, [3, 3]);
  }

  private believed(body: Body): void {
    this.disc(body, body.radius);
    this.stroke(this.theme.believed, 2, 0.9, [2, 3]);
  }

  private robot(pose: Pose, robot: RobotFrame, index: number, run: Run, selected: boolean): void {
    // On a large map it is drawn larger than it is, so that it is seen.
    const radius = Math.max(run.radius, LEAST_ROBOT / this.camera.scale);
    const color = robotColor(index, this.theme);
    const fill = robot.collided ? this.theme.limit : color;
    const { length, width, discs } = run.body;
    if (discs.length > 0 && radius === run.radius) {
      this.disc(pose, radius);
      this.stroke(fill, 1, 0.6);
      this.discs(pose, discs);
    } else if (length > 0 && radius === run.radius) {
      // The disc that corridors keep free, and the true body in it.
      this.disc(pose, radius);
      this.stroke(fill, 1, 0.6);
      this.trace(corners(pose, length, width), true);
    } else {
      this.disc(pose, radius);
    }
    this.fill(fill);
    this.stroke(this.theme.halo, 1.5);
    const ahead = (distance: number, turn: number): Point => ({
      x: pose.x + distance * Math.cos(pose.heading + turn),
      y: pose.y + distance * Math.sin(pose.heading + turn),
    });
    const size = discs.length > 0 ? Math.min(...discs.map((d) => d.radius))
      : length > 0 ? Math.min(length, width) / 2 : radius;
    const arrow = Math.max(size, LEAST_ROBOT / this.camera.scale);
    this.trace([ahead(0.82 * arrow, 0), ahead(0.66 * arrow, 2.4), ahead(0.25 * arrow, Math.PI),
      ahead(0.66 * arrow, -2.4)], true);
    this.fill(this.theme.halo, 0.95);
    if (selected && run.begin.robots.length > 1) {
      this.disc(pose, radius + 4 / this.camera.scale);
      this.stroke(color, 1.5, 0.9);
    }
  }

  // One outline of several discs.
  private discs(pose: Pose, discs: (Point & { radius: number })[]): void {
    this.context.beginPath();
    for (const disc of discs) {
      const at = this.at(placed(pose, disc));
      const radius = this.pixels(disc.radius);
      this.context.moveTo(at.x + radius, at.y);
      this.context.arc(at.x, at.y, radius, 0, TAU);
    }
  }

  // Where names would cover each other, the chosen robot's comes first, then those of low numbers.
  private names(poses: Pose[], run: Run, selected: number): void {
    const { context, camera } = this;
    const taken: { x: number; y: number; half: number }[] = [];
    const order = [selected, ...poses.keys()].filter((i, at) => at === 0 || i !== selected);
    context.font = LABEL;
    for (const i of order) {
      const pose = poses[i];
      if (!pose) continue;
      const name = run.begin.robots[i]!.name;
      const p = camera.toScreen(pose);
      const spot = { x: p.x, y: p.y - Math.max(this.pixels(run.radius), LEAST_ROBOT) - 9, half: context.measureText(name).width / 2 + 3 };
      const covered = taken.some((t) => Math.abs(t.x - spot.x) < t.half + spot.half && Math.abs(t.y - spot.y) < 15);
      if (covered) continue;
      taken.push(spot);
      this.label(name, spot.x, spot.y);
    }
  }

  private limit(robot: RobotFrame): void {
    const mark = robot.cycle?.mark;
    if (!mark) return;
    if (mark.shape === 'side') {
      this.trace([mark.a, mark.b]);
      this.stroke(this.theme.halo, 7, 0.7);
      this.trace([mark.a, mark.b]);
      this.stroke(this.theme.limit, 3.5);
    } else {
      this.disc(mark.a, mark.radius);
      this.fill(this.theme.limit, 0.12);
      this.stroke(this.theme.limit, 2.5);
    }
  }

  private label(text: string, x: number, y: number): void {
    const { context, theme } = this;
    context.font = LABEL;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.lineWidth = 3;
    context.strokeStyle = theme.halo;
    context.strokeText(text, x, y);
    context.fillStyle = theme.ink;
    context.fillText(text, x, y);
  }

  private scaleBar(): void {
    const { context, camera, theme } = this;
    const lengths = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];
    const metres = lengths.filter((m) => this.pixels(m) <= 130).at(-1) ?? 0.1;
    const [x, y] = [16, camera.height - 16];
    context.fillStyle = theme.outside;
    context.globalAlpha = 0.75;
    context.fillRect(x - 8, y - 22, this.pixels(metres) + 16, 32);
    context.globalAlpha = 1;
    context.beginPath();
    context.moveTo(x, y - 4);
    context.lineTo(x, y);
    context.lineTo(x + this.pixels(metres), y);
    context.lineTo(x + this.pixels(metres), y - 4);
    context.strokeStyle = theme.ink;
    context.lineWidth = 1.5;
    context.stroke();
    context.font = '12px system-ui, sans-serif';
    context.textAlign = 'left';
    context.textBaseline = 'bottom';
    context.fillStyle = theme.ink;
    context.fillText(`${metres} m`, x + 3, y - 3);
  }
}
