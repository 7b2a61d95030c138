#!/usr/bin/env python3
"""Opens the game in a window on an X server of its own and measures what it shows.  look.py BUILD_FOLDER

The demo level's sphere, straight ahead, must be as wide as high on screen, to 1 %, at every size of window, when both
halves of the correction of aspect are on or both are off, and off by the pixel's shape when only one is; also on the
whole screen, with the look of a tube, and in the picture of all four combinations. While the lab is open, arrow keys do
not turn the view. The window's title is the level's name, whatever its letters.
Ends with 77 where a program that it needs is missing."""
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import demo_sphere

SCREEN = (1920, 1200)
SIZES = [(800, 600), (640, 480), (1920, 1080), (1600, 1200)]
LARGE = SIZES[-1]  # one of the game's pixels is five of the screen's wide and six high
NEEDED = ['Xvfb', 'xdotool', 'import']
ROUND = 0.01
FIELD_OF_VIEW = '40'  # degrees: the sphere then takes two thirds of the height


class Display:
    """An X server without a screen; ends what it has started. It does not start anew when its last client goes, as a
    game that starts then finds no display."""

    def __init__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(['Xvfb', '-displayfd', str(write), '-screen', '0', '%dx%dx24' % SCREEN,
                                        '-nolisten', 'tcp', '-noreset'], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        self.environment = dict(os.environ, DISPLAY=':' + number, SDL_AUDIODRIVER='dummy', LC_ALL='C.UTF-8')
        self.environment.pop('WAYLAND_DISPLAY', None)
        self.environment.pop('SDL_VIDEODRIVER', None)
        self.started = []

    def start(self, *command):
        self.started.append(subprocess.Popen(command, env=self.environment))
        return self.started[-1]

    def output(self, *command):
        return subprocess.run(command, env=self.environment, check=True, stdout=subprocess.PIPE, timeout=600).stdout

    def end(self):
        for process in self.started + [self.server]:
            process.kill()
            process.wait()


def table(is_so):
    """For bytes.translate: 1 for the values of a channel of which `is_so` holds."""
    return bytes(is_so(value) for value in range(256))


class Picture:
    """Which of the screen's pixels show the sphere, counted by row and by column."""

    def __init__(self, ppm):
        magic, size, depth, pixels = ppm.split(b'\n', 3)
        assert magic == b'P6' and depth == b'255'
        width, height = map(int, size.split())
        # Half-way to the glow's colour, (240, 72, 184), from all that it can be mixed with at the outline.
        tables = [table(lambda red: red > 135), table(lambda green: green < 128), table(lambda blue: blue > 90)]
        channels = [int.from_bytes(pixels[i::3].translate(tables[i]), 'big') for i in range(3)]
        mask = (channels[0] & channels[1] & channels[2]).to_bytes(width * height, 'big')
        self.rows = [mask[y * width:(y + 1) * width].count(1) for y in range(height)]
        self.columns = [mask[x::width].count(1) for x in range(width)]

    def shows_sphere(self):
        return sum(self.columns) > 1000

    def shape(self):
        """Width to height, by how far the pixels spread about their middle: each counts, not only the outermost. 0
        without a sphere: a busy machine may not have drawn it yet."""
        return spread(self.columns) / spread(self.rows) if self.shows_sphere() else 0

    def middle_x(self):
        """In pixels from the left border of the screen."""
        return mean(self.columns) + 0.5 if self.shows_sphere() else 0


def mean(counts):
    return sum(at * count for at, count in enumerate(counts)) / sum(counts)


def spread(counts):
    """The standard deviation, as for whole areas: a row of pixels is not a line but one pixel high."""
    middle = mean(counts)
    return math.sqrt(sum((at - middle) ** 2 * count for at, count in enumerate(counts)) / sum(counts) + 1 / 12)


class Game:
    def __init__(self, display, *command):
        self.display = display
        self.process = display.start(*command)
        self.window = self.focus_window()

    def tool(self, *words):
        return self.display.output('xdotool', *words).decode()

    def focus_window(self):
        """Waits for the game's window. One that is found may be that of the game before, and go before it has the focus."""
        for _ in range(1000):
            time.sleep(0.2)
            if self.process.poll() is not None:
                raise SystemExit('look.py: the game ended with %d before it had a window' % self.process.returncode)
            found = subprocess.run(['xdotool', 'search', '--onlyvisible', '--class', 'oblong'],
                                   env=self.display.environment, stdout=subprocess.PIPE).stdout.split()
            if found and subprocess.run(['xdotool', 'windowfocus', found[0]], env=self.display.environment).returncode == 0:
                return found[0].decode()
        raise SystemExit('look.py: no window after 200 s')

    def resize(self, size):
        self.tool('windowsize', self.window, str(size[0]), str(size[1]))
        self.tool('windowmove', self.window, '0', '0')
        time.sleep(1)

    def press(self, *keys):
        for key in keys:
            self.tool('key', key)
            time.sleep(0.3)
        time.sleep(0.5)

    def look(self):
        return Picture(self.display.output('import', '-window', 'root', '-depth', '8', 'ppm:-'))

    def look_at(self, x, y, size):
        """A part of the screen."""
        part = '%dx%d+%d+%d' % (size + (x, y))
        return Picture(self.display.output('import', '-window', 'root', '-crop', part, '-depth', '8', 'ppm:-'))

    def shape(self):
        return self.look().shape()

    def press_leave(self):
        """The menu, and its last row."""
        self.press('Escape', 'Up', 'Return')

    def leave(self):
        self.press_leave()
        self.process.wait(timeout=100)


class Report:
    def __init__(self):
        self.failures = 0

    def expect(self, what, measure, wanted, tolerance):
        """A value, or what measures one: again and again for two minutes, as a busy machine may show it late."""
        is_called = callable(measure)
        begun = time.monotonic()
        while True:
            value = measure() if is_called else measure
            is_right = abs(value / wanted - 1) <= tolerance
            if is_right or not is_called or time.monotonic() - begun > 120:
                break
            time.sleep(0.5)
        self.failures += not is_right
        print('%s %-44s %.4f, expected %.4f +- %.1f %%' % ('  ' if is_right else '! ', what, value, wanted,
                                                         tolerance * 100))


def check_title(game, report):
    def is_right():
        return int(game.tool('getwindowname', game.window) == 'Oblong - sphère — 2\n')

    report.expect('the title has a dash and an accent (1 if so)', is_right, 1, 0)


def check_sizes(game, report):
    for size in SIZES:
        game.resize(size)
        report.expect('%dx%d, both halves corrected' % size, game.shape, 1, ROUND)


def check_keys(game, report):
    size = SIZES[0]
    game.resize(size)
    game.press('F2')
    report.expect('F2: the projection takes pixels for square', game.shape, 5 / 6, ROUND)
    game.press('F3')
    report.expect('F2 and F3: so does the display', game.shape, 1, ROUND)
    game.press('F2')
    report.expect('F3: only the display does', game.shape, 6 / 5, ROUND)
    game.press('F3')
    report.expect('neither', game.shape, 1, ROUND)
    game.resize(LARGE)
    for mode in ('rows', 'even', 'nearest', 'sharp'):
        game.press('F5')
        report.expect('F5: ' + mode, game.shape, 1, ROUND)


def check_tube(game, report):
    """Rows get darker borders, and a glow around them: the sphere stays round, and is as before when it is off."""
    game.resize(SIZES[0])
    plain = game.look()
    game.press('c')
    report.expect('C: is another picture (1 if so)', lambda: int(game.look().rows != plain.rows), 1, 0)
    report.expect('C: a tube', game.shape, 1, ROUND)
    game.press('c')
    time.sleep(3)  # its message goes away
    report.expect('C again: as before (1 if so)', lambda: int(game.look().rows == plain.rows), 1, 0)


def check_fullscreen(game, report):
    game.press('alt+Return')
    report.expect('Alt+Enter: the whole screen', game.shape, 1, ROUND)
    report.expect('in its middle', lambda: game.look().middle_x(), SCREEN[0] / 2, 0.002)
    game.press('alt+Return')


def check_four_aspects(game, report):
    """Their pictures are small, and captions are on them: a sphere may lack a row."""
    game.resize(LARGE)
    game.press('4')
    half = (LARGE[0] // 2, LARGE[1] // 2)
    for column, row, wanted in [(0, 0, 1), (1, 0, 5 / 6), (0, 1, 6 / 5), (1, 1, 1)]:
        report.expect('4: column %d, row %d of four' % (column + 1, row + 1),
                      lambda: game.look_at(column * half[0], row * half[1], half).shape(), wanted, 2 * ROUND)
    game.press('4')


def check_arrows(start, report):
    """By the upper half, which the lab leaves open; its message covers little of the sphere."""
    game = start()
    time.sleep(3)  # the first message goes away
    game.resize(SIZES[0])
    upper = (SIZES[0][0], SIZES[0][1] * 45 // 100)
    report.expect('before F7: the sphere (1 if so)', lambda: int(game.look_at(0, 0, upper).shows_sphere()), 1, 0)
    before = game.look_at(0, 0, upper).middle_x()
    game.press('F7', 'Right', 'Left')
    report.expect('F7: arrows do not turn the view', game.look_at(0, 0, upper).middle_x(), before, ROUND)
    game.press('F7')
    game.tool('keydown', 'Right')
    time.sleep(0.1)
    game.tool('keyup', 'Right')
    time.sleep(0.5)

    def has_turned():
        after = game.look_at(0, 0, upper)
        return int(not after.shows_sphere() or after.middle_x() < before - 20)

    report.expect('F7 again: they do (1 if so)', has_turned, 1, 0)
    game.leave()


def check_options(start, report):
    for options, wanted in [(['--aspect-projection', 'square'], 5 / 6), (['--aspect-display', 'square'], 6 / 5),
                            (['--aspect-projection', 'square', '--aspect-display', 'square'], 1)]:
        game = start(*options)
        game.resize(SIZES[0])
        report.expect(' '.join(options), game.shape, wanted, ROUND)
        game.leave()


def check_leaving(game, report):
    game.press('Escape')
    report.expect('Esc alone leaves nothing (1 if so)', int(game.process.poll() is None), 1, 0)
    game.press('Escape')
    game.press_leave()
    for _ in range(1000):
        if game.process.poll() is not None:
            break
        time.sleep(0.1)
    report.expect('the menu leaves with 0 (1 more here)', 1 + (1 if game.process.poll() is None else game.process.returncode),
                  1, 0)


def main():
    missing = [program for program in NEEDED if shutil.which(program) is None]
    if missing:
        print('missing: ' + ' '.join(missing))
        return 77
    build = sys.argv[1]
    report = Report()
    with tempfile.TemporaryDirectory() as folder:
        level = folder + '/sphère — 2.bsp'
        os.rename(demo_sphere.build(build, folder), level)
        display = Display()
        display.environment['XDG_DATA_HOME'] = folder
        try:
            def start(*options):
                config = os.path.join(folder, '%d.cfg' % len(display.started))  # each starts with the usual options
                return Game(display, 'env', 'LC_ALL=C', build + '/bin/oblong', level, '--palette', build + '/assets/palette.lmp',
                            '--fov', FIELD_OF_VIEW, '--config', config, '--window', '%dx%d' % SIZES[0],
                            '--flashes', 'off', *options)  # else the sphere's colour takes turns with others
            game = start()
            check_title(game, report)
            check_sizes(game, report)
            check_keys(game, report)
            check_tube(game, report)
            check_four_aspects(game, report)
            check_fullscreen(game, report)
            check_leaving(game, report)
            check_options(start, report)
            check_arrows(start, report)
        finally:
            display.end()
    return 1 if report.failures else 0


if __name__ == '__main__':
    sys.exit(main())
