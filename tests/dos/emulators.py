"""PCs for the tests of the game for DOS: QEMU and DOSBox, told what to do, looked at, and heard on the serial port."""
import contextlib
import os
import re
import shutil
import socket
import subprocess
import sys
import threading
import time

SILENCE_S = 1200  # for which the game may say nothing


def skip(what):
    print(f"skipped: {what} is not installed")
    sys.exit(77)


def expect(is_so, message):
    if not is_so:
        sys.exit(f"play_under_dos: {message}")


def read_ppm(path):
    """Width, height, and red, green, blue of each pixel."""
    with open(path, "rb") as file:
        data = file.read()
    head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", data)
    width, height = int(head[1]), int(head[2])
    return width, height, data[head.end():]


def halved(picture):
    """Of a picture whose pixels are two by two, which the VGA sends them as."""
    width, height, data = picture
    if width != 640:
        return picture
    rows = [data[y * width * 3:(y + 1) * width * 3] for y in range(0, height, 2)]
    small = b"".join(row[x:x + 3] for row in rows for x in range(0, width * 3, 6))
    return width // 2, height // 2, small


def different_pixels(a, b):
    expect(a[:2] == b[:2], f"{a[0]}x{a[1]} pixels, expected {b[0]}x{b[1]}")
    return sum(a[2][i:i + 3] != b[2][i:i + 3] for i in range(0, len(a[2]), 3))


def count_in(said, what):
    """How many pictures the game has shown, or keys it has taken (report=1)."""
    found = re.findall(rf"^{what} (\d+)\r?\n", said, re.M)
    return int(found[-1]) if found else 0


class Pc:
    """What both can; they offer `process`, said(), picture() and press()."""

    def wait_until(self, is_so, what):
        """However slow the machine is, as long as the game says something new now and then."""
        said, since = self.said(), time.monotonic()
        while not is_so(said):
            has_ended = self.process.poll() is not None
            time.sleep(0.1)
            last, said = said, self.said()
            expect("oblong: out of memory" not in said, f"{what}; the game said:\n{said[-2000:]}")
            if said != last:
                since = time.monotonic()
            elif not is_so(said):
                expect(not has_ended, f"{what}, and the emulator has ended; the game said:\n{said[-2000:]}")
                expect(time.monotonic() - since < SILENCE_S, f"{what}; the game said:\n{said[-2000:]}")

    def wait_for(self, text):
        self.wait_until(lambda said: text in said, f"the game does not say '{text}'")

    def wait_for_pictures(self, count):
        """Until so many more are shown, which are none in a menu where nothing moves."""
        wanted = count_in(self.said(), "shown") + count
        self.wait_until(lambda said: count_in(said, "shown") >= wanted, "no more pictures are shown")

    def picture_when(self, is_right, what):
        """One of the next 300 pictures that the game shows."""
        for _ in range(100):
            self.wait_for_pictures(3)
            picture = self.picture()
            if is_right(picture):
                return picture
        sys.exit(f"play_under_dos: {what}")

    def press_in_turn(self, *keys):
        """Until the game ends. Two at once would both go to the screen that the first one leaves."""
        for key in keys:
            wanted = count_in(self.said(), "pressed") + 1
            if "memory:" in self.said():
                return
            self.press(key)
            self.wait_until(lambda said: count_in(said, "pressed") >= wanted or "memory:" in said,
                            f"the key {key} is not taken")


class Qemu(Pc):
    """A 486 that is told what to do by QEMU's monitor."""

    def __init__(self, disk, folder, *options, memory_mb=16):
        if not shutil.which("qemu-system-i386"):
            skip("qemu-system-i386")
        self.folder, self.serial = folder, os.path.join(folder, "serial")
        image = os.path.join(folder, "disk.img")
        with open(image, "wb") as file:
            file.write(disk)
        self.process = subprocess.Popen(
            ["qemu-system-i386", "-cpu", "486", "-m", str(memory_mb), "-drive", f"file={image},format=raw", "-serial",
             f"file:{self.serial}", "-display", "none", "-no-reboot", "-monitor", "stdio", *options],
            stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()

    def tell(self, command):
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()

    def press(self, key, for_ms=100):
        self.tell(f"sendkey {key} {for_ms}")

    def said(self):
        if not os.path.exists(self.serial):
            return ""
        with open(self.serial, errors="replace") as file:
            return file.read()

    def picture(self):
        path = os.path.join(self.folder, "screen.ppm")
        if os.path.exists(path):
            os.remove(path)
        self.tell(f"screendump {path}")
        size = -1
        while not os.path.exists(path) or os.path.getsize(path) != size or size <= 0:
            size = os.path.getsize(path) if os.path.exists(path) else -1
            time.sleep(0.1)
        picture = read_ppm(path)
        return halved(picture) if len(picture[2]) == 3 * picture[0] * picture[1] else self.picture()


DOSBOX = """[sdl]
output=surface
[dosbox]
memsize=16
[cpu]
core=normal
cputype=486_slow
cycles=fixed {cycles}
[mixer]
nosound=true
[serial]
serial1=nullmodem server:127.0.0.1 port:{port} transparent:1
[autoexec]
mount c {folder}
c:
OBLONG.COM {words}
echo BACK > BACK.TXT
exit
"""


class DosBox(Pc):
    """OBLONG.COM, which a folder has as drive C:, on a screen of its own."""

    def __init__(self, folder, words, cycles=50000):
        for program in ("dosbox", "Xvfb", "xdotool", "import"):
            if not shutil.which(program):
                skip(program)
        self.folder, self.heard = folder, []
        with contextlib.ExitStack() as opened:
            self.environment = dict(os.environ, DISPLAY=self.open_screen(opened), HOME=folder, SDL_AUDIODRIVER="dummy")
            server = opened.enter_context(socket.create_server(("127.0.0.1", 0)))
            server.settimeout(1)
            config = os.path.join(folder, "dosbox.conf")
            with open(config, "w") as file:
                file.write(DOSBOX.format(cycles=cycles, port=server.getsockname()[1], folder=folder, words=words))
            connection = self.start(opened, config, server)
            self.listener = threading.Thread(target=self.listen, args=[connection], daemon=True)
            self.listener.start()
            self.opened = opened.pop_all()

    def open_screen(self, opened):
        """Its number, which Xvfb writes when it can be reached. Without -noreset it can't for a moment whenever the last
        program has left it."""
        read_end, write_end = os.pipe()
        screen = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-noreset", "-screen", "0", "640x400x24"],
                                  pass_fds=[write_end], stderr=subprocess.DEVNULL)
        opened.callback(end, screen)
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            return ":" + pipe.readline().strip()

    def start(self, opened, config, server):
        log = opened.enter_context(open(os.path.join(self.folder, "dosbox.log"), "w+"))
        self.process = subprocess.Popen(["dosbox", "-conf", config], stdout=log, stderr=log, env=self.environment)
        opened.callback(end, self.process)
        while self.process.poll() is None:
            with contextlib.suppress(TimeoutError):
                return server.accept()[0]
        log.seek(0)
        sys.exit(f"play_under_dos: DOSBox has ended without a word of the game: {log.read()}")

    def listen(self, connection):
        with connection, contextlib.suppress(ConnectionError):
            while data := connection.recv(4096):
                self.heard.append(data)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.opened.close()

    def said(self):
        return b"".join(self.heard).decode("latin1")

    def wait_for_end(self):
        """What the game has said, when it and DOSBox have ended, which may take as long as something comes now and then."""
        self.wait_until(lambda _: self.process.poll() is not None, "the game does not come back to DOS")
        self.listener.join()
        return self.said()

    def tell_keyboard(self, action, key):
        subprocess.run(["xdotool", action, key], env=self.environment, check=True)

    def hold(self, key):
        self.tell_keyboard("keydown", key)

    def let_go(self, key):
        self.tell_keyboard("keyup", key)

    def press(self, key):
        self.tell_keyboard("key", key)

    def picture(self):
        path = os.path.join(self.folder, "screen.ppm")
        subprocess.run(["import", "-window", "root", "-depth", "8", path], env=self.environment, check=True)
        return halved(read_ppm(path))


def end(process):
    process.kill()
    process.wait()
