// Opens the page that pack.py made of game/example, as a file, in headless Chromium: it is that game's, and is played.
//   node play_game.cjs SITE GAME SCRATCH      SITE: the page's folder; GAME: the game's; SCRATCH: for pictures to look at
"use strict";
const assert = require("assert"), fs = require("fs"), path = require("path"), {run} = require("./chromium.cjs");

const [site, game, scratch] = process.argv.slice(2);

run(async open => {
  for (const wrong of ["%", "%E4", "--nonsense", "a%20b%20c", "--help"]) {
    const said = await open("file://" + path.resolve(site, "oblong.html") + "?" + wrong);
    await said.expect("document.title.startsWith('Three Rooms')", "the game's title, after a wrong address");
    await said.shows();
    await said.expect("document.getElementById('said').textContent.includes('is left out')", "what is wrong with the address");
    await said.page.close();
  }
  const tab = await open("file://" + path.resolve(site, "oblong.html"));
  await tab.expect("document.title.startsWith('Three Rooms')", "the game's title");
  const [kind, bytes] = (await tab.evaluate("document.querySelector('link[rel=icon]').href")).split(",");
  assert.strictEqual(kind, "data:image/png;base64", "the icon");
  assert.ok(Buffer.from(bytes, "base64").equals(fs.readFileSync(path.join(game, "icon.png"))), "another icon than the game's");
  await tab.shows();
  await tab.shot(path.join(scratch, "game-title.png"));
  // Questions before the first walk are answered as they stand.
  for (let i = 0; i < 6 && !await tab.evaluate("Page.isCaptured"); ++i) await tab.press("Enter");
  await tab.until("Page.isCaptured", "a walk by Enter");
  // Ahead, always jumping: a coin, a door that opens slowly, and the room's end lie in a row.
  for (const room of ["first", "second"]) {
    await tab.until(`Page.isCaptured && document.title === 'Three Rooms - ${room}'`, `a walk in the ${room} room`);
    await tab.shot(path.join(scratch, `game-${room}.png`));
    for (const key of ["KeyW", "Space"]) await tab.down(key);
    await tab.until("!Page.isCaptured", `the end of the ${room} room`);
    await tab.shot(path.join(scratch, `game-${room}-end.png`));
    for (const key of ["KeyW", "Space"]) await tab.up(key);
    await tab.press("Enter");
  }
  await tab.until("Page.isCaptured && document.title === 'Three Rooms - third'", "the last room");
  assert.deepStrictEqual(tab.said, [], "on the console");
});
