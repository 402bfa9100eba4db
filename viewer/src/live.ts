// SPDX-License-Identifier: Apache-2.0
export async function startLive(): Promise<void> {
  throw new Error('no run');
}
