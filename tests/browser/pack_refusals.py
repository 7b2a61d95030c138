#!/usr/bin/env python3
"""game/web/pack.py says what is missing, and who makes it, and packs what the game uses alone.      pack_refusals.py SOURCE_FOLDER"""
import json
import os
import re
import shutil
import struct
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

    # What the game uses goes into the page, and nothing else that stands in its folder or that links lead to.
    entities = b'{\n"classname" "worldspawn"\n"music" "music/a.mod"\n"model" "../secret"\n}\n{\n"model" "coin.obj"\n"map" "two"\n}\n'
    used = {'game.json': json.dumps({
                'title': 'A game', 'levels': ['one'], 'icon': 'icon.png', 'captions': {'sounds/b.wav': 'b'},
                'classes': {'c': {'is': 'item_lens', 'keys': {'model': 'models/lamp.mdl'}}}}),
            'maps/one.bsp': struct.pack('<III', 29, 12, len(entities)).decode() + entities.decode(), 'two.bsp': '', 'icon.png': 'i',
            'music/a.mod': 'm', 'models/coin.obj': 'mtllib the coin.mtl\nmtllib ../../secret', 'models/lamp.mdl': 'l',
            'models/the coin.mtl': 'map_Kd -s 2 2 tile.png\nmap_Kd /etc/hostname', 'models/tile.png': 't', 'sounds/b.wav': 'b',
            'sounds/door.flac': 'd', 'gfx/palette.lmp': 'p'}
    strangers = ['maps/one.map', 'maps/one-draft.bsp', 'models/coin.blend', '.git/config', 'game.json~', 'music/old.mod',
                 'models/.tile.png', 'sounds/unused.wav', 'tile.png']
    for name in list(used) + strangers:
        write('game/' + name, used.get(name, ''))
    for name in ('assets/sounds/door.flac', 'assets/sounds/step.flac', 'assets/demo.bsp', 'objects/oblong.js', 'secret'):
        write(name)
    os.symlink(folder + '/secret', folder + '/game/sounds/step.flac')
    names = [folder + name for name in ('/objects', '/assets', '/site', '/game')]
    said = subprocess.run([sys.executable, '-B', pack] + names, check=True, text=True, stdout=subprocess.PIPE).stdout
    left = re.search('^left out, as nothing names them: (.*)$', said, re.M).group(1).split(', ')
    assert set(left) == set(strangers) | {'sounds/step.flac'}, left
    with open(folder + '/site/oblong.data', 'rb') as file:
        packed = json.loads(file.read(struct.unpack('<I', file.read(4))[0]))
    packed = {each['name'][5:] for each in packed if each['name'].startswith('game/')}
    with open(folder + '/site/oblong.html') as file:
        assert '<button id="dials" style="visibility: hidden"' in file.read(), 'the button of a lab that the game has not'
    assert packed == set(used), (packed - set(used), set(used) - packed)

    shutil.rmtree(folder + '/site')
    for name, fault in (('icon', 'icon %s is'), ('levels', 'level one is')):
        outside = folder + '/secret' if name == 'icon' else ['one']
        write('game/game.json', json.dumps({'title': 'A game', 'levels': ['one'], name: outside}))
        if name == 'levels':
            os.remove(folder + '/game/maps/one.bsp')
            os.symlink(folder + '/secret', folder + '/game/maps/one.bsp')
        expect('/game/game.json: ValueError: ' + (fault % outside if name == 'icon' else fault) +
               ' no file below the folder, expected a game')
