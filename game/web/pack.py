#!/usr/bin/env python3
"""Makes the page of what was built.      pack.py BUILD ASSETS SITE [GAME]
SITE gets index.html with oblong.wasm and oblong.data, for a server, and oblong.html: all of it in one file.
With a game's folder, that of a game.json, it is the page of that game, under its title and icon; with --examples, in
its place, examples.html alone, of engine/examples."""
import base64
import gzip
import html
import json
import mimetypes
import os
import re
import struct
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
# The played part of the built game's data, without level sources and lists for tools.
PLAYED = r'(demo\.bsp|walk\.demo|game\.json|palette\.lmp|(models|music|sounds)/.*)'


def read(*path):
    with open(os.path.join(*path), 'rb') as file:
        return file.read()


def write(content, *path):
    with open(os.path.join(*path), 'wb') as file:
        file.write(content)


def files_below(top):
    return sorted(os.path.relpath(os.path.join(folder, name), top) for folder, _, found in os.walk(top) for name in found)


def packed_data(assets, game):
    files = [(name, read(assets, name)) for name in files_below(assets) if re.fullmatch(PLAYED, name)]
    if game:
        files += [('game/' + name, read(game, name)) for name in files_below(game) if not name.endswith('.map')]
    names = json.dumps([{'name': name, 'size': len(content)} for name, content in files]).encode()
    return struct.pack('<I', len(names)) + names + b''.join(content for _, content in files)


# The letters of 0 to 127: ASCII, but for those that a page does not keep or takes for a tag, which are 128 further on.
LETTERS = [chr(bits + 128 if chr(bits) in '\0\r<' else bits) for bits in range(128)]


def as_letters(content):
    """Bytes as text for a page in UTF-8, 7 bits a letter: a seventh longer, where base64 is a third longer."""
    bits = bin(int.from_bytes(b'\1' + content, 'big'))[3:]
    return ''.join(LETTERS[int(bits[at:at + 7].ljust(7, '0'), 2)] for at in range(0, len(bits), 7))


def need(maker, *path):
    file = os.path.join(*path)
    if not os.path.isfile(file):
        sys.exit('pack.py: there is no %s, expected what %s' % (file, maker))


def under_own_name(page, game):
    """The page with a game's title and icon. What else is wrong with the game it says itself."""
    try:
        definition = json.loads(read(game, 'game.json'))
        title, levels, icon = str(definition['title']), list(definition['levels']), definition.get('icon')
        picture = icon and read(game, icon)
    except (OSError, ValueError, KeyError, TypeError) as error:
        sys.exit('pack.py: %s: %s: %s, expected a game' % (os.path.join(game, 'game.json'), type(error).__name__, error))
    for level in levels:
        need('oblong-map makes of its source', game, 'maps', '%s.bsp' % level)
    if icon:
        kind = mimetypes.guess_type(icon)[0]
        page = page.replace('href="data:,"', 'href="data:%s;base64,%s"' % (kind, base64.b64encode(picture).decode()))
    return page.replace('<title>Oblong<', '<title>%s<' % html.escape(title))


def main(build, assets, site, game=None):
    page = read(HERE, 'index.html').decode()
    program = 'oblong'
    if game == '--examples':
        program, game = 'examples', None
        page = page.replace('<title>Oblong<', '<title>Examples<')
    if game:
        page = under_own_name(page, game)
    need('tools/build --web makes', build, program + '.wasm')
    need('tools/build --web makes', assets, 'demo.bsp')
    files = {program + '.wasm': read(build, program + '.wasm'), program + '.data': packed_data(assets, game)}
    sizes = ', '.join('"%s": %d' % (name, len(content)) for name, content in files.items())
    for name in ('page.js', 'screen.js', 'pads.js', 'touch.js', 'sound.js'):
        page = page.replace('//@%s@' % name, read(HERE, '../../engine/platform/web', name).decode())
    for name, script in {'load.js': read(HERE, 'load.js'), 'oblong.js': read(build, program + '.js')}.items():
        page = page.replace('//@%s@' % name, script.decode())
    page = page.replace('/*@program@*/', program).replace('/*@waits@*/', 'false' if program == 'oblong' else 'true')
    page = page.replace('/*@sizes@*/', sizes).replace('/*@game@*/', '"--game", "/assets/game", ' if game else '')
    packed = {name: gzip.compress(content, 9, mtime=0) for name, content in files.items()}
    inlined = ''.join('<script type="text/plain" id="%s">%s</script>\n' % (name, as_letters(content))
                      for name, content in packed.items())
    os.makedirs(site, exist_ok=True)
    write(page.replace('<!--@files@-->', inlined).encode(), site, program + '.html')
    if program == 'oblong':
        for name, content in files.items():
            write(content, site, name)
        write(page.encode(), site, 'index.html')
    total = sum(map(len, packed.values())) + len(gzip.compress(page.encode(), 9))
    print('packed: program %d, data %d, all %d bytes' % (*map(len, packed.values()), total))


if not 4 <= len(sys.argv) <= 5:
    sys.exit(__doc__)
main(*sys.argv[1:])
