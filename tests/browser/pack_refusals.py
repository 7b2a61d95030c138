#!/usr/bin/env python3
"""game/web/pack.py says what is missing, and who makes it.      pack_refusals.py SOURCE_FOLDER"""
import os
import subprocess
import sys
import tempfile

pack = sys.argv[1] + '/game/web/pack.py'
with tempfile.TemporaryDirectory() as folder:
    def write(name, text=''):
        os.makedirs(os.path.dirname(folder + '/' + name), exist_ok=True)
        with open(folder + '/' + name, 'w') as file:
            file.write(text)

    def expect(said):
        names = [folder + name for name in ('/objects', '/assets', '/site', '/game')]
        done = subprocess.run([sys.executable, '-B', pack] + names, text=True, capture_output=True)
        expected = 'pack.py: ' + said.replace('/', folder + '/', 1) + '\n'
        assert done.returncode == 1 and done.stderr == expected, done.stdout + done.stderr + 'expected:\n' + expected
        assert not os.path.exists(folder + '/site'), 'a page without what is missing'

    write('game/game.json', '{"title": "A game", "levels": ["one"]}')
    expect('there is no /game/maps/one.bsp, expected what oblong-map makes of its source')
    write('game/maps/one.bsp')
    expect('there is no /objects/oblong.wasm, expected what tools/build --web makes')
    write('objects/oblong.wasm')
    expect('there is no /assets/demo.bsp, expected what tools/build --web makes')
