// SPDX-License-Identifier: Apache-2.0
import { make } from './dom';

/** Asks before something is lost. @return whether the user agrees. */
export function confirmed(question: string, action: string): Promise<boolean> {
  document.getElementById('confirm')?.remove();
  const text = make('p', { id: 'confirm-text' }, question);
  const dialog = make('dialog', { id: 'confirm', 'aria-labelledby': text.id },
    make('form', { method: 'dialog' }, text,
      make('button', { id: 'confirm-cancel', value: 'cancel' }, 'Cancel'),
      make('button', { id: 'confirm-ok', class: 'primary', value: 'ok' }, action)));
  document.body.append(dialog);
  dialog.showModal();
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => {
      dialog.remove();
      resolve(dialog.returnValue === 'ok');
    }, { once: true });
  });
}
