// SPDX-License-Identifier: Apache-2.0
// What only the playground has: files by drag and drop, and links that hold a scenario.
(() => {
  const picker = document.getElementById('map-files');
  const bytes = async (file) => new Uint8Array(await file.arrayBuffer());

  const begin = async (named) => {
    // The page asks before its run is lost.
    if (await window.fairway.mayBegin('The new scenario')) playground.begin(named);
  };

  const drop = async (files) => {
    const zip = files.find((file) => /\.zip$/i.test(file.name));
    if (zip) return begin(Object.entries(await playground.unzip(await bytes(zip))));
    const texts = await Promise.all(files.filter((file) => /\.ya?ml$/i.test(file.name)).map((file) => file.text()));
    if (texts.some((text) => /^robots:/m.test(text))) {
      const named = await Promise.all(files.map(async (file) => [file.name, await bytes(file)]));
      return begin(named);
    }
    const list = new DataTransfer();
    for (const file of files) list.items.add(file);
    picker.files = list.files;
    picker.dispatchEvent(new Event('change'));
    return undefined;
  };

  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    const files = [...event.dataTransfer?.files ?? []];
    if (files.length > 0) drop(files).catch((error) => playground.notice(`The files cannot be used: ${error.message}`));
  });

  const button = Object.assign(document.createElement('button'), { type: 'button', id: 'link', textContent: 'Link' });
  button.addEventListener('click', async () => {
    history.replaceState(null, '', await playground.link());
    const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    playground.notice(copied ? 'The link is copied' : 'The link is in the address bar');
  });
  const row = document.createElement('tr');
  const [left, right] = [document.createElement('td'), document.createElement('td')];
  left.append(button);
  right.textContent = 'Map, robots, people and settings in the address of this page';
  row.append(left, right);
  document.querySelector('#saves table, #saves').append(row);
})();
