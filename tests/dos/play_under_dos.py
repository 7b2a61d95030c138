"""The game for DOS does what the game does.

usage: play_under_dos.py integers|qemu|dosbox SOURCE_DIR BUILD_DIR

integers: no room of the engine has a floating-point instruction; divisions and products of an i486 are those of here.
qemu: a 486 of 16 MB, started from the disk image: the walk's ticks and pictures have the hashes that they have here; what the
    VGA shows is the last picture; a walk begins by keys and turns by the mouse; the game ends.
dosbox: OBLONG.COM and its way back to DOS: the same hashes.
"""
import contextlib
import glob
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time

TICKS = 300
STILL, MOVED = 3_000, 20_000  # pixels of 64,000 that differ
SILENCE_S = 1200  # for which the game may say nothing
# Rooms that have times and rates, which are doubles; the readers of files; the gallery's expected numbers.
WITH_FLOATS = {"files", "gallery", "measure", "game_lab", "game_view", "game_simulation"}
FLOAT = re.compile(r"^\s*[0-9a-f]+:\t(?:[a-z]+ )*f[a-z]\w*", re.M)


def skip(what):
    print(f"skipped: {what} is not installed")
    sys.exit(77)


def expect(is_so, message):
    if not is_so:
        sys.exit(f"play_under_dos: {message}")


def build(source):
    if not shutil.which("i686-linux-gnu-g++"):
        skip("i686-linux-gnu-g++")
    subprocess.run([os.path.join(source, "game/dos/build"), "--rest"], check=True, stdout=subprocess.DEVNULL)


def expected_hashes(build_dir, picture):
    done = subprocess.run([os.path.join(build_dir, "bin/walk_hashes"), os.path.join(build_dir, "assets"), str(TICKS), picture],
                          check=True, capture_output=True, text=True)
    return done.stdout.splitlines()


def hashes_in(text):
    return [line.strip() for line in text.splitlines() if line.startswith("tick ")]


def check_hashes(found, expected, where):
    for mine, theirs in zip(expected, found):
        expect(mine == theirs, f"{where}: {theirs}, expected {mine}")
    expect(len(found) == len(expected), f"{where}: {len(found)} ticks, expected {len(expected)}")


def with_arguments(image, words):
    """The disk image with words of a command line written into it."""
    with open(image, "rb") as file:
        disk = bytearray(file.read())
    at = disk.index(b"ARGUMENTS:") + len(b"ARGUMENTS:")
    disk[at:at + len(words) + 1] = words.encode() + b"\r"
    return disk


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


class Qemu:
    """A 486 that is told what to do by QEMU's monitor."""

    def __init__(self, disk, folder):
        self.folder, self.serial = folder, os.path.join(folder, "serial")
        image = os.path.join(folder, "disk.img")
        with open(image, "wb") as file:
            file.write(disk)
        self.process = subprocess.Popen(
            ["qemu-system-i386", "-cpu", "486", "-m", "16", "-drive", f"file={image},format=raw", "-serial",
             f"file:{self.serial}", "-display", "none", "-no-reboot", "-monitor", "stdio"],
            stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()

    def tell(self, command):
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()

    def said(self):
        if not os.path.exists(self.serial):
            return ""
        with open(self.serial, errors="replace") as file:
            return file.read()

    def wait_until(self, is_so, what):
        """However slow the machine is, as long as the game says something new now and then."""
        said, since = self.said(), time.monotonic()
        while not is_so(said):
            expect(self.process.poll() is None, "QEMU has ended")
            expect(time.monotonic() - since < SILENCE_S, f"{what}; the game said:\n{said[-2000:]}")
            time.sleep(0.1)
            last, said = said, self.said()
            if said != last:
                since = time.monotonic()

    def wait_for(self, text):
        self.wait_until(lambda said: text in said, f"the game does not say '{text}'")

    def wait_for_pictures(self, count):
        """Until so many more are shown (report=1): what was pressed before them has been read."""
        wanted = shown_in(self.said()) + count
        self.wait_until(lambda said: shown_in(said) >= wanted, "no more pictures are shown")

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

    def picture_when(self, is_right, what):
        """One of the next 300 pictures that the game shows."""
        for _ in range(100):
            self.wait_for_pictures(3)
            picture = self.picture()
            if is_right(picture):
                return picture
        sys.exit(f"play_under_dos: {what}")


def shown_in(said):
    """How many pictures the game has shown."""
    found = re.findall(r"^shown (\d+)\r?\n", said, re.M)
    return int(found[-1]) if found else 0


def in_six_bits(picture):
    """As the VGA has its colours: how an emulator spreads them over 8 bits is its own."""
    return (*picture[:2], bytes(value >> 2 for value in picture[2]))


def different_pixels(a, b):
    expect(a[:2] == b[:2], f"{a[0]}x{a[1]} pixels, expected {b[0]}x{b[1]}")
    return sum(a[2][i:i + 3] != b[2][i:i + 3] for i in range(0, len(a[2]), 3))


def check_qemu(source, build_dir):
    if not shutil.which("qemu-system-i386"):
        skip("qemu-system-i386")
    image = os.path.join(build_dir, "dos/oblong.img")
    with tempfile.TemporaryDirectory() as folder:
        wanted = os.path.join(folder, "wanted.ppm")
        expected = expected_hashes(build_dir, wanted)
        with Qemu(with_arguments(image, f"hashes={TICKS} hold=1"), folder) as pc:
            pc.wait_for("us each")
            check_hashes(hashes_in(pc.said()), expected, "QEMU")
            shown = pc.picture()
            wrong = different_pixels(in_six_bits(shown), in_six_bits(read_ppm(wanted)))
            expect(wrong == 0, f"{wrong} pixels on the screen differ")
            pc.tell("sendkey esc")
            pc.wait_for("memory:")
    with tempfile.TemporaryDirectory() as folder, Qemu(with_arguments(image, "captions=off report=1"), folder) as pc:
        play_in(pc)


def play_in(pc):
    """From the title by keys: a walk, a turn by the mouse, the menu, and out."""
    def has_colours(picture):
        return picture[:2] == (320, 200) and len({picture[2][i:i + 3] for i in range(0, len(picture[2]), 3)}) > 40

    last = [pc.picture_when(has_colours, "no title is shown")]

    def rests(picture):
        before, last[0] = last[0], picture
        return different_pixels(picture, before) < STILL

    pc.picture_when(lambda p: different_pixels(p, last[0]) > MOVED, "behind the title nothing moves")
    pc.tell("sendkey ret")
    start = pc.picture_when(rests, "Enter does not begin a walk")
    pc.tell("mouse_move 150 0")
    turned = pc.picture_when(lambda p: different_pixels(p, start) > MOVED, "the mouse does not turn the view")
    pc.tell("sendkey w 800")
    pc.picture_when(lambda p: different_pixels(p, turned) > MOVED, "W does not walk")
    for key in ("esc", "up", "ret", "down"):  # Leave, Yes
        pc.tell(f"sendkey {key}")
        pc.wait_for_pictures(3)  # two keys at once would both go to the screen that the first one leaves
    pc.tell("sendkey ret")
    pc.wait_for("memory:")


def check_integers(build_dir):
    objects = os.path.join(build_dir, "dos/objects/CMakeFiles")
    rooms = [name[4:-4] for name in os.listdir(objects) if name.startswith("dos_")]
    expect(len(rooms) > 20, f"{len(rooms)} rooms")
    for room in rooms:
        for folder, _, names in os.walk(os.path.join(objects, f"dos_{room}.dir")):
            for name in names:
                if not name.endswith(".o"):
                    continue
                listing = subprocess.run(["i686-linux-gnu-objdump", "-d", "--no-show-raw-insn", os.path.join(folder, name)],
                                         check=True, capture_output=True, text=True).stdout
                found = FLOAT.findall(listing)
                expect(not found or room in WITH_FLOATS, f"room {room}: {len(found)} instructions, as {found[:1]}")


def check_arithmetic(source, build_dir):
    """By a program for Linux of 32 bits."""
    program = os.path.join(build_dir, "dos/arithmetic")
    sources = [os.path.join(source, "tests/dos/driver/arithmetic.cpp"), os.path.join(source, "engine/view/projection.cpp"),
               *glob.glob(os.path.join(source, "engine/fixed/*.cpp"))]
    subprocess.run(["i686-linux-gnu-g++", "-std=c++20", "-O2", "-march=i486", "-static", "-I", source,
                    *sources, "-o", program], check=True)
    here, there = (subprocess.run([path], check=True, capture_output=True, text=True).stdout
                   for path in (os.path.join(build_dir, "bin/arithmetic_hash"), program))
    expect(here == there, f"arithmetic: {there}, expected {here}")


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


def check_dosbox(build_dir):
    for program in ("dosbox", "Xvfb"):
        if not shutil.which(program):
            skip(program)
    with tempfile.TemporaryDirectory() as folder:
        expected = expected_hashes(build_dir, os.path.join(folder, "wanted.ppm"))
        for name in ("OBLONG.COM", "OBLONG.SYS"):
            shutil.copy(os.path.join(build_dir, "dos", name), folder)
        with socket.create_server(("127.0.0.1", 0)) as server:
            server.settimeout(1)
            config = os.path.join(folder, "dosbox.conf")
            with open(config, "w") as file:
                file.write(DOSBOX.format(cycles=200000, port=server.getsockname()[1], folder=folder, words=f"hashes={TICKS}"))
            for _ in range(5):  # on a busy machine SDL sometimes does not reach the display
                said, log = run_dosbox(config, folder, server)
                if said:
                    break
            expect(said, f"DOSBox has ended without a word of the game: {log}")
        check_hashes(hashes_in(said), expected, "DOSBox")
        expect(os.path.exists(os.path.join(folder, "BACK.TXT")), "the game does not come back to DOS")


def run_dosbox(config, home, server):
    """What the game says on the serial port until DOSBox ends, and what DOSBox says."""
    read_end, write_end = os.pipe()
    screen = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", "800x600x24"], pass_fds=[write_end],
                              stderr=subprocess.DEVNULL)
    os.close(write_end)
    try:
        with os.fdopen(read_end) as pipe:
            display = ":" + pipe.readline().strip()
        with open(os.path.join(home, "dosbox.log"), "w+") as log:
            dosbox = subprocess.Popen(["dosbox", "-conf", config], stdout=log, stderr=log,
                                      env=dict(os.environ, DISPLAY=display, HOME=home, SDL_AUDIODRIVER="dummy"))
            try:
                said = listen(server, dosbox)
            finally:
                dosbox.kill()
                dosbox.wait()
            log.seek(0)
            return said, log.read()
    finally:
        screen.kill()
        screen.wait()


def listen(server, dosbox):
    """What comes until DOSBox ends, which may take as long as something comes now and then."""
    connection = None
    while connection is None and dosbox.poll() is None:
        with contextlib.suppress(TimeoutError):
            connection, _ = server.accept()
    if connection is None:
        return ""
    said = []
    connection.settimeout(SILENCE_S)
    while data := connection.recv(4096):
        said.append(data)
    dosbox.wait(timeout=SILENCE_S)
    return b"".join(said).decode("latin1")


def main():
    what, source, build_dir = sys.argv[1:]
    build(source)
    if what == "integers":
        check_integers(build_dir)
        check_arithmetic(source, build_dir)
    elif what == "qemu":
        check_qemu(source, build_dir)
    else:
        check_dosbox(build_dir)


if __name__ == "__main__":
    main()
