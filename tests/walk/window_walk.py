#!/usr/bin/env python3
"""Starts the recorded walk from the title, in a window on an X server of its own.  window_walk.py BUILD RECORDED PICTURE

Return accepts the title's "Walk"; the walk is replayed at 16 times its speed until the picture stands still, which is
the page at the end; then the game is left. The game writes what it played to the file RECORDED; what the screen
showed last becomes PICTURE. Ends with 77 where a program that it needs is missing."""
import os
import shutil
import sys
import time

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'window'))
import look

LONGEST_WALK_S = 12000
STILL_S = 5  # nothing on the screen has changed for so long


def wait_until_still(display, seconds):
    last, still_since, begun = None, time.monotonic(), time.monotonic()
    while time.monotonic() - still_since < STILL_S:
        if time.monotonic() - begun > seconds:
            raise SystemExit('window_walk.py: the walk has not ended after %d s' % seconds)
        picture = display.output('import', '-window', 'root', '-depth', '8', 'ppm:-')
        if picture != last:
            last, still_since = picture, time.monotonic()
        time.sleep(0.3)


def walk(display, build, recorded, picture):
    game = look.Game(display, build + '/bin/oblong', '--title', '--replay', build + '/assets/walk.demo', '--record',
                     recorded, '--window', '640x480', '--game-speed', '1600', '--volume', '0')
    time.sleep(3)  # the title is there
    game.press('Return')
    wait_until_still(display, LONGEST_WALK_S)
    display.output('import', '-window', game.window, picture)
    game.press('Escape', 'Escape', 'Up', 'Return')  # the title; leave? yes
    return game.process.wait(timeout=200)


def main():
    missing = [name for name in look.NEEDED if not shutil.which(name)]
    if missing:
        print('window_walk.py: skipped, not installed: ' + ', '.join(missing))
        return 77
    display = look.Display()
    try:
        return walk(display, *sys.argv[1:])
    finally:
        display.end()


if __name__ == '__main__':
    sys.exit(main())
