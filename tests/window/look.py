#!/usr/bin/env python3
"""Opens the game in a window on an X server of its own and measures what it shows.  look.py BUILD_FOLDER

A sphere straight ahead must be as wide as high on screen, to 1 %, at every size of window, when both halves of the
correction of aspect are on or both are off, and off by the pixel's shape when only one is; also on the whole screen.
Ends with 77 where a program that it needs is missing."""
import os
import shutil
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import sphere_level

SCREEN = (1920, 1200)
SIZES = [(1600, 1200), (1280, 960), (1920, 1080), (800, 600)]
NEEDED = ['Xvfb', 'xdotool', 'import']
ROUND = 0.01
BRIGHT = 60  # of 255: between the black room and the white sphere


class Display:
    """An X server without a screen; ends what it has started."""

    def __init__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(['Xvfb', '-displayfd', str(write), '-screen', '0', '%dx%dx24' % SCREEN,
                                        '-nolisten', 'tcp'], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        self.environment = dict(os.environ, DISPLAY=':' + number, SDL_AUDIODRIVER='dummy')
        self.environment.pop('WAYLAND_DISPLAY', None)
        self.environment.pop('SDL_VIDEODRIVER', None)
        self.started = []

    def start(self, *command):
        self.started.append(subprocess.Popen(command, env=self.environment))
        return self.started[-1]

    def output(self, *command):
        return subprocess.run(command, env=self.environment, check=True, stdout=subprocess.PIPE, timeout=60).stdout

    def end(self):
        for process in self.started + [self.server]:
            process.kill()
            process.wait()


class Picture:
    """The brightness of the screen's pixels."""

    def __init__(self, ppm):
        magic, size, depth, self.bytes = ppm.split(b'\n', 3)
        assert magic == b'P6' and depth == b'255'
        self.width, self.height = map(int, size.split())

    def is_bright(self, x, y):
        at = 3 * (y * self.width + x)
        return self.bytes[at + 1] > BRIGHT  # green stands for all three

    def run(self, x, y, step_x, step_y):
        """How many bright pixels lie on a line from (x, y), not counting the first."""
        length = 0
        while 0 <= x + step_x < self.width and 0 <= y + step_y < self.height and self.is_bright(x + step_x, y + step_y):
            x, y, length = x + step_x, y + step_y, length + 1
        return length

    def shape(self, x, y):
        """Width to height of the bright thing at (x, y)."""
        assert self.is_bright(x, y), 'nothing bright at %d, %d' % (x, y)
        width = 1 + self.run(x, y, 1, 0) + self.run(x, y, -1, 0)
        height = 1 + self.run(x, y, 0, 1) + self.run(x, y, 0, -1)
        return width / height


class Game:
    def __init__(self, display, *command):
        self.display = display
        self.process = display.start(*command)
        self.window = self.wait_for_window()
        self.tool('windowfocus', self.window)
        time.sleep(3)  # the first message goes away

    def tool(self, *words):
        return self.display.output('xdotool', *words).decode()

    def wait_for_window(self):
        for _ in range(100):
            time.sleep(0.2)
            found = subprocess.run(['xdotool', 'search', '--onlyvisible', '--name', 'Oblong'],
                                   env=self.display.environment, stdout=subprocess.PIPE).stdout.split()
            if found:
                return found[0].decode()
        raise SystemExit('look.py: no window after 20 s')

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

    def shape(self, size):
        return self.look().shape(size[0] // 2, size[1] // 2)


class Report:
    def __init__(self):
        self.failures = 0

    def expect(self, what, value, wanted, tolerance):
        is_right = abs(value / wanted - 1) <= tolerance
        self.failures += not is_right
        print('%s %-44s %.4f, expected %.4f +- %.0f %%' % ('  ' if is_right else '! ', what, value, wanted,
                                                         tolerance * 100))


def check_sizes(game, report):
    for size in SIZES:
        game.resize(size)
        report.expect('%dx%d, both halves corrected' % size, game.shape(size), 1, ROUND)


def check_keys(game, report):
    size = SIZES[0]
    game.resize(size)
    game.press('F2')
    report.expect('F2: the projection takes pixels for square', game.shape(size), 5 / 6, 0.02)
    game.press('F3')
    report.expect('F2 and F3: so does the display', game.shape(size), 1, ROUND)
    game.press('F2')
    report.expect('F3: only the display does', game.shape(size), 6 / 5, 0.02)
    game.press('F3', 'F3')
    report.expect('neither', game.shape(size), 1, ROUND)
    for mode in ('rows', 'even', 'nearest', 'stretch', 'sharp'):
        game.press('F5')
        report.expect('F5: ' + mode, game.shape(size), 1, ROUND)


def check_fullscreen(game, report):
    game.press('alt+Return')
    report.expect('Alt+Enter: the whole screen', game.shape(SCREEN), 1, ROUND)
    picture = game.look()
    right, left = (picture.run(SCREEN[0] // 2, SCREEN[1] // 2, step, 0) for step in (1, -1))
    report.expect('in its middle', right / left, 1, ROUND)
    game.press('alt+Return')


def check_leaving(game, report):
    game.press('Escape')
    for _ in range(50):
        if game.process.poll() is not None:
            break
        time.sleep(0.1)
    report.expect('Esc leaves with 0 (1 more here)', 1 + (1 if game.process.poll() is None else game.process.returncode),
                  1, 0)


def main():
    missing = [program for program in NEEDED if shutil.which(program) is None]
    if missing:
        print('missing: ' + ' '.join(missing))
        return 77
    build = sys.argv[1]
    report = Report()
    with tempfile.TemporaryDirectory() as folder:
        palette = build + '/assets/palette.lmp'
        level = sphere_level.build(build + '/bin', palette, folder)
        display = Display()
        try:
            game = Game(display, build + '/bin/oblong', level, '--palette', palette, '--window', '%dx%d' % SIZES[0])
            check_sizes(game, report)
            check_keys(game, report)
            check_fullscreen(game, report)
            check_leaving(game, report)
        finally:
            display.end()
    return 1 if report.failures else 0


if __name__ == '__main__':
    sys.exit(main())
