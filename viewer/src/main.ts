// SPDX-License-Identifier: Apache-2.0
import { startLive } from './live';
import { element } from './page/dom';
import { startReplay } from './replay';

const packed = element('run').textContent?.trim() ?? '';

(packed ? startReplay(packed) : startLive()).catch((error: unknown) => {
  const notice = element('notice');
  notice.textContent = `This page cannot be shown: ${error instanceof Error ? error.message : error}`;
  notice.hidden = false;
});
