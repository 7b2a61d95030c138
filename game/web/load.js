// Loads the program and its data, keeps what the player saves, and starts the game. SIZES: bytes of each file.
const SIZES = {/*@sizes@*/};
Page.lines = [];  // the program's last messages

// What pack.py wrote as text, 7 bits a letter.
const bytesOf = letters => {
  const bytes = new Uint8Array(letters.length * 7 >> 3);
  for (let at = 0, bits = 0, count = 0, size = 0; at < letters.length; ++at) {
    bits = bits << 7 | letters.charCodeAt(at) & 127;
    count += 7;
    if (count >= 8) bytes[size++] = bits >> (count -= 8);
  }
  return bytes;
};

// The bytes of a file, packed in this page or beside it. The bar shows the progress.
let loadedBytes = 0;
const allBytes = Object.values(SIZES).reduce((sum, size) => sum + size, 0);
const streamOf = async name => {
  const packed = document.getElementById(name);
  const response = packed ? new Response(bytesOf(packed.textContent)) : await fetch(name);
  if (!response.ok) throw new Error(name + ": " + response.status + " " + response.statusText);
  let stream = response.body;
  if (packed) stream = stream.pipeThrough(new DecompressionStream("gzip"));
  return stream.pipeThrough(new TransformStream({
    transform(bytes, to) {
      loadedBytes += bytes.length;
      document.querySelector("#bar div").style.width = 100 * loadedBytes / allBytes + "%";
      to.enqueue(bytes);
    },
  }));
};

// The data: the length of its list, the list as JSON, {name, size} each, and the files.
const unpack = bytes => {
  const length = new DataView(bytes.buffer).getUint32(0, true);
  let at = 4 + length;
  for (const {name, size} of JSON.parse(new TextDecoder().decode(bytes.subarray(4, at)))) {
    const path = "/assets/" + name;
    FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
    FS.writeFile(path, bytes.subarray(at, at += size));
  }
};

// Files below /save are written to the browser's database soon after a change. A page that is closed may not finish
// that, so the rest is kept in its local storage until the next start.
const RESCUED = "oblong:";
const storage = (() => {
  try {
    return localStorage;
  } catch (error) {
    return null;  // the browser stores nothing for this page
  }
})();
const readSaves = () => new Promise(resolve => {
  const done = error => {
    if (error) console.warn("no database: " + error);
    if (error && !storage) Page.warn("This browser does not store saved games for this page: they are lost when it is closed.");
    resolve(!error);
  };
  globalThis.indexedDB ? FS.syncfs(true, done) : done("this browser has none");
});
// Of two pages, each would remove from the database what the other one saved. A page that is left lets go soon.
const isAlone = () => new Promise(resolve => {
  const hold = () => new Promise(() => resolve(true));
  const wait = new AbortController();
  const refused = error => resolve(error.name !== "AbortError");
  setTimeout(() => wait.abort(), 2000);
  navigator.locks ? navigator.locks.request("saves of Oblong", {signal: wait.signal}, hold).catch(refused) : resolve(true);
});
const keepSaves = hasDatabase => {
  let isWriting = false, isDue = true;
  const changed = new Set();  // files that the database does not have yet
  const note = path => { changed.add(path); isDue = true; };
  for (const key of Object.keys(storage || {}).filter(key => key.startsWith(RESCUED))) {
    const path = key.slice(RESCUED.length);
    FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
    FS.writeFile(path, Uint8Array.from(atob(storage[key]), letter => letter.charCodeAt(0)));
    changed.add(path);
  }
  for (const change of ["close", "rename", "unlink"]) {
    const before = FS[change];
    FS[change] = function (what, ...more) {
      const path = typeof what === "string" ? what : what.path || "";
      const isRead = change === "close" && (what.flags & 3) === 0;
      if (path.startsWith("/save/") && !isRead) note(path);
      if (change === "rename" && path.startsWith("/save/")) note(more[0]);
      return before.call(FS, what, ...more);
    };
  }
  const write = () => {
    if (changed.size === 0 || isWriting || !isDue || !hasDatabase) return;
    isWriting = true;
    isDue = false;
    FS.syncfs(false, error => {
      isWriting = false;
      if (error) {  // tried again after the next change
        console.warn("not saved: " + error);
        return Page.warn("This browser stores no more for this page: what is saved now may be lost when it is closed.");
      }
      if (isDue) return;  // a file has changed again meanwhile
      for (const path of changed) if (storage) storage.removeItem(RESCUED + path);
      changed.clear();
    });
  };
  const rescue = () => {
    for (const path of storage ? changed : []) {
      try {
        if (FS.analyzePath(path).exists)
          storage[RESCUED + path] = btoa(Array.from(FS.readFile(path), byte => String.fromCharCode(byte)).join(""));
        else
          storage.removeItem(RESCUED + path);
      } catch (error) {
        console.warn("not kept: " + error);  // there is no room for it
      }
    }
  };
  setInterval(write, 500);
  document.addEventListener("visibilitychange", () => {
    if (!document.hidden || Page.hasEnded || !Page.whenHidden) return;
    Page.whenHidden();
    isDue = true;
    rescue();
    write();
  });
};

const said = document.getElementById("said"), front = document.getElementById("front");
// Shows a text over the picture until the next input, below others that are there.
Page.warn = text => {
  if (!said.textContent.includes(text)) said.textContent = `${said.textContent}\n${text}`.trim();
  said.className = "over";
  for (const event of ["keydown", "pointerdown"])
    addEventListener(event, () => { if (!Page.hasEnded) said.textContent = ""; }, {once: true});
};
Page.end = text => {
  Page.hasEnded = true;
  Page.closeSound();
  if (document.pointerLockElement) document.exitPointerLock();
  document.body.className = said.className = "";
  Page.canvas.hidden = front.hidden = true;
  said.textContent = [text, ...Page.lines, "Reload the page to play again."].filter(line => line).join("\n");
};

const fail = error => {
  Page.lines.push(String(error.message || error));
  Page.end("");
};

// A program with its own loop waits for each picture in page_wait(): the browser suspends it there, and resumes it.
const WAITS = /*@waits@*/;
const suspended = imports => {
  if (!WebAssembly.Suspending) throw new Error("This browser can't wait in the middle of a program (JSPI).");
  imports.env.page_wait = new WebAssembly.Suspending(imports.env.page_wait);
  return imports;
};
const entered = instance => {
  const main = WebAssembly.promising(instance.exports.main);
  return {exports: {...instance.exports, main: (...words) => { main(...words).then(() => isList || Page.end("The program has ended."), fail); }}};
};

// The front page, where the address asks for nothing else. Its button begins the walk, or goes on with it: that is the
// first row of the title behind it.
// Back, the browser's, leads to it again, and forward into the walk.
const PLAYED = "#play";
const leaveFront = () => {
  if (Page.hasEnded || front.hidden) return;
  if (location.hash !== PLAYED) location.hash = PLAYED;
  if (!Page.screen || Page.screen.shown === 0) return setTimeout(leaveFront, 50);
  front.hidden = true;
  Page.isCovered = false;
  Page.canvas.focus();
  Page.tap(Device.Key, KEYS.Enter);
};
const showFront = () => {
  const play = document.getElementById("play");
  front.hidden = false;
  Page.isCovered = true;
  play.focus();
  play.addEventListener("pointerdown", event => {
    Page.hasTouch = event.pointerType === "touch";
    document.body.classList.toggle("touched", Page.hasTouch);
  });
  play.addEventListener("click", () => {
    play.textContent = "Loading";
    leaveFront();
  }, {once: true});
};
// The page of the examples lists them.
const list = document.getElementById("list");
const isList = list !== null && location.search === "";
if (list) list.hidden = !isList;
Page.isCovered = isList;
if (isList) document.body.className = "";
if (location.search === "" && !WAITS) {
  showFront();
  addEventListener("popstate", () => location.hash === PLAYED ? leaveFront() : location.reload());
}
const whole = document.getElementById("whole");
whole.hidden = !document.fullscreenEnabled;
whole.addEventListener("click", () => document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen());

const data = streamOf("/*@program@*/.data").then(stream => new Response(stream).arrayBuffer());
const OWN = [/*@game@*/];
// From the address: oblong.html?--mode%20640x480, oblong.html?room=fog
const addressed = () => {
  try {
    const text = decodeURIComponent(location.search.slice(1)), [, room] = text.match(/^room=(.+)/) || [];
    return room ? ["--room", room] : text.split(" ").filter(word => word);
  } catch (error) {
    Page.warn("The address behind '?' is left out: " + error.message);
    return [];
  }
};
// The number of arguments without those of the address, which the program does not take; says so.
Page.withoutAddress = () => {
  Page.warn("The address behind '?' is left out. " + Page.lines.join("\n"));
  Page.lines = [];
  return 1 + OWN.length;
};
globalThis.Module = {
  arguments: [...OWN, ...addressed()],
  print: line => console.log(line),
  printErr: line => {
    console.warn(line);
    Page.lines = [...Page.lines, line].slice(-5);
  },
  instantiateWasm(imports, done) {
    streamOf("/*@program@*/.wasm")
      .then(stream => WebAssembly.instantiateStreaming(new Response(stream, {headers: {"Content-Type": "application/wasm"}}), WAITS ? suspended(imports) : imports))
      .then(made => done(WAITS ? entered(made.instance) : made.instance, made.module)).catch(fail);
    return {};
  },
  preRun: [() => {
    ENV.HOME = "/save";
    FS.mkdir("/save");
    FS.mount(IDBFS, {}, "/save");
    addRunDependency("data");
    const saves = isAlone().then(async alone => [alone, await readSaves()]);
    Promise.all([data, saves]).then(([bytes, [alone, hasDatabase]]) => {
      unpack(new Uint8Array(bytes));
      alone ? keepSaves(hasDatabase) : Page.warn("The game is open in another tab: what is saved in this one is lost when it is closed.");
      Page.start();
      removeRunDependency("data");
    }).catch(fail);
  }],
  onAbort: fail,
};
