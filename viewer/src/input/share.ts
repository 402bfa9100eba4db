// SPDX-License-Identifier: Apache-2.0
import { element } from '../page/dom';
import type { Legend } from '../view/legend';
import type { Viewer } from '../view/viewer';

/** The view in the address of the page: time, robot, camera and layers. */
export function shareLink(viewer: Viewer): string {
  const { camera, layers } = viewer;
  const shown = Object.entries(layers).filter(([, on]) => on).map(([name]) => name);
  const view = [camera.x, camera.y, camera.scale].map((n) => +n.toFixed(2)).join();
  const url = new URL(location.href);
  url.hash = `t=${viewer.time.toFixed(2)}&robot=${viewer.selected + 1}&view=${view}&layers=${shown.join()}`;
  return url.href;
}

/** Shows what the address asks for. @return the time, if there is one. */
export function openLink(viewer: Viewer, legend: Legend): number | null {
  const asked = new URLSearchParams(location.hash.slice(1));
  const robot = Number(asked.get('robot')) - 1;
  if (viewer.run && robot >= 0 && robot < viewer.run.begin.robots.length) viewer.select(robot);
  const view = asked.get('view')?.split(',').map(Number);
  if (view?.length === 3 && view.every(Number.isFinite) && view[2]! > 0) viewer.camera.look(view[0]!, view[1]!, view[2]!);
  const layers = asked.get('layers');
  if (layers !== null) legend.use(layers.split(','));
  const time = asked.get('t');
  return time !== null && Number.isFinite(Number(time)) ? Number(time) : null;
}

/** Connects the button that copies the link. */
export function connectShare(viewer: Viewer): void {
  element('share').addEventListener('click', () => {
    const link = shareLink(viewer);
    history.replaceState(null, '', link);
    const copied = navigator.clipboard?.writeText(link) ?? Promise.reject(new Error('no clipboard'));
    copied.then(() => viewer.say('Link copied: time, robot, view and layers.'),
      () => viewer.say('The link is in the address bar: time, robot, view and layers.'));
  });
}
