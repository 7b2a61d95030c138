"""The game for DOS does what the game does.

usage: play_under_dos.py integers|qemu|memory|dosbox|saves|sound SOURCE_DIR BUILD_DIR

integers: no room of the engine has a floating-point instruction; divisions and products of an i486 are those of here.
qemu: a 486 of 16 MB, started from the disk image: the walk's ticks and pictures have the hashes that they have here; what the
    VGA shows is the last picture; a walk begins by keys and turns by the mouse, also after a long title; the game ends.
memory: with 12 MB the walk and the gallery have enough, with 11 MB without sounds; less is refused.
dosbox: OBLONG.COM and its way back to DOS: the same hashes.
saves: a walk that was left in DOSBox goes on there where it was, as the game here reads its file; where DOS can't write, the
    game asks, and what was saved before stays.
sound: what QEMU's Sound Blaster plays of the walk is as loud, from moment to moment, as what the game plays here.
"""
import glob
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import wave

from emulators import DosBox, Qemu, count_in, different_pixels, expect, read_ppm, skip

TICKS = 300
# A processor of 31 million instructions a second, however busy the machine is.
WITH_CARD = ["-icount", "shift=5", "-device", "sb16,audiodev=card", "-audiodev", "none,id=card"]
WORDS = "captions=off report=1 view-size=100"  # a view that does not depend on the machine's time
ROWS = 120  # of the gallery, and some again
STILL, MOVED = 3_000, 20_000  # pixels of 64,000 that differ
# Rooms that have times and rates, which are doubles; the readers of files; the gallery's expected numbers.
WITH_FLOATS = {"programs", "gallery", "measure", "game_lab", "game_view", "game_simulation"}
FLOAT = re.compile(r"^\s*[0-9a-f]+:\t(?:[a-z]+ )*f[a-z]\w*", re.M)


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


def in_six_bits(picture):
    """As the VGA has its colours: how an emulator spreads them over 8 bits is its own."""
    return (*picture[:2], bytes(value >> 2 for value in picture[2]))


def check_qemu(build_dir):
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
            pc.press("esc")
            pc.wait_for("memory:")
    with tempfile.TemporaryDirectory() as folder, Qemu(with_arguments(image, WORDS), folder) as pc:
        start = begin(pc, "ret")
        pc.tell("mouse_move 150 0")
        turned = pc.picture_when(lambda p: different_pixels(p, start) > MOVED, "the mouse does not turn the view")
        pc.press("w", 800)
        pc.picture_when(lambda p: different_pixels(p, turned) > MOVED, "W does not walk")
        pc.press_in_turn("esc", "up", "ret", "down", "ret")  # Leave; Yes, if so much was walked that it asks
        pc.wait_for("memory:")
    check_gallery(image)


def check_gallery(image):
    """Its figures use instructions that a 486 lacks."""
    with tempfile.TemporaryDirectory() as folder, Qemu(with_arguments(image, WORDS), folder) as pc:
        pc.wait_for_pictures(3)
        pc.press_in_turn("down", "down", "down", "down", "down", "ret")
        for _ in range(3):
            pc.wait_for_pictures(1)
            pc.press_in_turn("pgdn")
        pc.press_in_turn("esc", "up", "ret")
        pc.wait_for("memory:")


def check_stack(said):
    used, size = map(int, re.search(r"stack: (\d+) of (\d+) KB", said).groups())
    expect(used <= size * 3 / 4, f"{used} KB of the stack's {size} are used, beyond which it would write over the heap")


def check_memory(build_dir):
    image = os.path.join(build_dir, "dos/oblong.img")
    check_title(image)
    check_walk(image, 12, has_sounds=True)
    check_walk(image, 11, has_sounds=False)
    check_all_rows(image)
    with tempfile.TemporaryDirectory() as folder, Qemu(with_arguments(image, ""), folder, memory_mb=8) as pc:
        pc.wait_for("too little memory")


def check_title(image):
    """After 250 pictures of the title, some 30 s of its record, there is memory for a walk, with all sounds. This 486 has
    chosen a smaller view by itself."""
    with tempfile.TemporaryDirectory() as folder, \
            Qemu(with_arguments(image, "captions=off report=1"), folder, *WITH_CARD) as pc:
        pc.wait_for_pictures(250)
        pc.press_in_turn("ret")
        pc.wait_for_pictures(10)
        width, height, data = pc.picture()
        corner = {data[3 * (y * width + x):][:3] for y in range(height - 20, height) for x in range(40)}
        expect(len(corner) == 1, "the view fills the screen of a 486 that needs 150 ms for it")
        pc.press_in_turn("esc", "up", "ret", "down", "ret")
        pc.wait_for("memory:")


def check_walk(image, memory_mb, has_sounds):
    """The record leads through all rooms."""
    words = WORDS + " replay=/assets/walk.demo"
    with tempfile.TemporaryDirectory() as folder, \
            Qemu(with_arguments(image, words), folder, *WITH_CARD, memory_mb=memory_mb) as pc:
        pc.wait_until(lambda said: count_in(said, "shown") >= 600 or "out of memory" in said, "the record does not go on")
        expect("out of memory" not in pc.said(), f"{memory_mb} MB are full before the record has led through all rooms")
        expect(("no sounds" not in pc.said()) == has_sounds, f"{memory_mb} MB, expected sounds: {has_sounds}")
        for key in ("f7", "f8", "4", "4"):  # what does not fit is off again
            pc.press_in_turn(key)
            pc.wait_for_pictures(3)
        expect("out of memory" not in pc.said(), f"{memory_mb} MB: the lab or the four aspects end the game")
        pc.press_in_turn("esc", "up", "ret")
        pc.wait_for("memory:")
        check_stack(pc.said())


def check_all_rows(image):
    """Of the gallery over the title, with sounds: a row that needs more memory says so."""
    card = [option for option in WITH_CARD if option not in ("-icount", "shift=5")]
    with tempfile.TemporaryDirectory() as folder, \
            Qemu(with_arguments(image, WORDS), folder, *card, memory_mb=12) as pc:
        pc.wait_for_pictures(3)
        pc.press_in_turn("down", "down", "down", "down", "down", "ret")
        for _ in range(ROWS):
            pc.wait_for_pictures(1)
            pc.press_in_turn("pgdn")
        expect("memory:" not in pc.said() and "oblong:" not in pc.said(), "a row of the gallery ends the game")
        pc.press_in_turn("esc", "up", "ret")
        pc.wait_for("memory:")
        check_stack(pc.said())


def resting(pc, what):
    """A picture as the one before it."""
    last = [pc.picture()]

    def rests(picture):
        before, last[0] = last[0], picture
        return different_pixels(picture, before) < STILL

    return pc.picture_when(rests, what)


def below_text(picture):
    """Without what the walk says in its first lines."""
    width, height, data = picture
    return width, height - 30, data[30 * width * 3:]


def begin(pc, enter):
    """From the title, by the menu's first row."""
    def has_colours(picture):
        return picture[:2] == (320, 200) and len({picture[2][i:i + 3] for i in range(0, len(picture[2]), 3)}) > 40

    title = pc.picture_when(has_colours, "no title is shown")
    pc.picture_when(lambda p: different_pixels(p, title) > MOVED, "behind the title nothing moves")
    pc.press_in_turn(enter)
    return resting(pc, "Enter does not begin a walk")


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
                expect("\tret" in listing, f"room {room}: no code in {name}")
                found = FLOAT.findall(listing)
                expect(not found or room in WITH_FLOATS, f"room {room}: {len(found)} instructions, as {found[:1]}")


def check_arithmetic(source, build_dir):
    """By a program for Linux of 32 bits."""
    program = os.path.join(build_dir, "dos/arithmetic")
    sources = [os.path.join(source, "tests/dos/driver/arithmetic.cpp"), os.path.join(source, "engine/view/projection.cpp"),
               *glob.glob(os.path.join(source, "engine/fixed/*.cpp"))]
    subprocess.run(["i686-linux-gnu-g++", "-std=c++20", "-O2", "-march=i486", "-static", "-I", source,
                    *sources, "-o", program], check=True)
    def output(*command):
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout

    here = output(os.path.join(build_dir, "bin/arithmetic_hash"))
    try:
        there = output(program)
    except OSError:  # a processor or a kernel without programs of 32 bits
        there = output("qemu-i386-static", program)
    expect(here == there, f"arithmetic: {there}, expected {here}")


def folder_with_game(build_dir):
    folder = tempfile.TemporaryDirectory()
    for name in ("OBLONG.COM", "OBLONG.SYS"):
        shutil.copy(os.path.join(build_dir, "dos", name), folder.name)
    return folder


def check_dosbox(build_dir):
    with folder_with_game(build_dir) as folder:
        expected = expected_hashes(build_dir, os.path.join(folder, "wanted.ppm"))
        with DosBox(folder, f"hashes={TICKS}", cycles=200000) as pc:
            check_hashes(hashes_in(pc.wait_for_end()), expected, "DOSBox")
        expect(os.path.exists(os.path.join(folder, "BACK.TXT")), "the game does not come back to DOS")


def saved_place(build_dir, kept):
    """The tick of the only walk in an OBLONG.SAV, and where the player is and looks then: as the game here reads it."""
    count, size = struct.unpack_from("<II", kept)
    expect(size == len(kept), f"OBLONG.SAV has {len(kept)} bytes, says {size}")
    entries = [struct.unpack_from("<56sII", kept, 64 + 64 * i) for i in range(count)]
    saves = [kept[offset:offset + size] for name, offset, size in entries if name.split(b"\0")[0].endswith(b".save")]
    expect(len(saves) == 1, f"{entries}, expected one walk")
    done = subprocess.run([os.path.join(build_dir, "bin/saved_place")], input=saves[0], check=True, capture_output=True)
    tick, *place = done.stdout.split()
    return int(tick), place


def leave(pc, *keys):
    pc.press_in_turn(*keys[:-1])
    pc.press(keys[-1])
    pc.wait_for_end()


def check_saves(build_dir):
    to_leave = ("Escape", "Up", "Return")
    words = WORDS
    with folder_with_game(build_dir) as folder:
        def kept():
            with open(os.path.join(folder, "OBLONG.SAV"), "rb") as file:
                return file.read()

        with DosBox(folder, words) as pc:
            start = begin(pc, "Return")
            pc.hold("w")
            pc.wait_for_pictures(20)  # some 4 s: shorter walks are not kept
            pc.picture_when(lambda p: different_pixels(p, start) > MOVED, "W does not walk")
            pc.let_go("w")
            left = resting(pc, "the walk does not stop")
            leave(pc, *to_leave)
        tick, place = saved_place(build_dir, kept())
        with DosBox(folder, words) as pc:
            shown = begin(pc, "Return")
            expect(different_pixels(*map(below_text, (shown, left))) < STILL, "Continue does not show where the walk was left")
            leave(pc, *to_leave)
        before = kept()
        later, same_place = saved_place(build_dir, before)
        expect(later > tick and same_place == place, f"{later} {same_place}, expected after {tick} {place}")
        os.mkdir(os.path.join(folder, "OBLONG.NEW"))
        with DosBox(folder, words) as pc:
            begin(pc, "Return")
            pc.press_in_turn(*to_leave, "Down")  # No, Yes: whether to leave all the same
            expect("memory:" not in pc.said(), "the game leaves though nothing could be saved")
            leave(pc, "Return")
        expect(kept() == before, "what was saved before is another now")


def loudness(path):
    """Of each tenth of a second of a recording of 8 bits."""
    with wave.open(path) as file:
        channels, window = file.getnchannels(), file.getframerate() // 10
        samples = file.readframes(file.getnframes())[::channels]
    return [math.sqrt(sum((sample - 128) ** 2 for sample in samples[at:at + window]) / window)
            for at in range(0, len(samples) - window, window)]


def means(list, count):
    """Of so many that follow each other: a sound begins with a picture, which may be late."""
    return [sum(list[at:at + count]) / count for at in range(len(list) - count + 1)]


def correlation(a, b):
    count = min(len(a), len(b))
    a, b = ([value - sum(list[:count]) / count for value in list[:count]] for list in (a, b))
    norm = math.sqrt(sum(x * x for x in a) * sum(y * y for y in b))
    return sum(x * y for x, y in zip(a, b)) / norm if norm > 0 else 0


def check_sound(build_dir):
    done = subprocess.run([os.path.join(build_dir, "bin/walk_sounds"), os.path.join(build_dir, "assets"), "1000"],
                          check=True, capture_output=True, text=True)
    expected = means([float(line) for line in done.stdout.split()], 3)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sound.wav")
        options = ["-icount", "shift=3", "-device", "sb16,audiodev=card", "-audiodev",
                   f"wav,id=card,path={path},out.frequency=11025,out.channels=2,out.format=u8"]
        image = os.path.join(build_dir, "dos/oblong.img")
        with Qemu(with_arguments(image, WORDS + " replay=/assets/walk.demo"), folder, *options) as pc:
            pc.wait_for_pictures(300)  # 15 s: where half of that ends, a sound's first tenths decide
            pc.tell("quit")  # which writes the recording's head
            pc.process.wait()
        found = means(loudness(path), 3)
    # The card plays from before the walk on: 0.97. Played backwards, it would be 0.64.
    best = max(correlation(found[start:], expected) for start in range(len(found) - 40))
    expect(best > 0.9, f"the card plays something else: a correlation of {best:.2f} in {found}, expected as {expected}")


def main():
    what, source, build_dir = sys.argv[1:]
    build(source)
    if what == "integers":
        check_integers(build_dir)
        check_arithmetic(source, build_dir)
    elif what == "qemu":
        check_qemu(build_dir)
    elif what == "memory":
        check_memory(build_dir)
    elif what == "dosbox":
        check_dosbox(build_dir)
    elif what == "saves":
        check_saves(build_dir)
    else:
        check_sound(build_dir)


if __name__ == "__main__":
    main()
