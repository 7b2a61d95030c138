#!/usr/bin/env python3
"""Makes the page of what was built.      pack.py BUILD ASSETS SITE [GAME | --examples | --program NAME]
SITE gets index.html with oblong.wasm and oblong.data, for a server, and oblong.html: all of it in one file.
With a game's folder, that of a game.json, it is the page of that game, under its title and icon; with --examples, in
its place, examples.html alone, of engine/examples; with --program, NAME.html of that program, with all of ASSETS."""
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
EXAMPLES = 'Programs of a screen each on the engine of Oblong, with their source.'
# Of the site, whose pages stand beside each other.
LINKS = '<nav><a href="accuracy.html">What accuracy costs</a> &middot; <a href="examples.html">Examples</a></nav>'
MUSEUM = 'A museum to walk through, drawn as in 1996. Turn its dials, and see what accuracy costs.'


def read(*path):
    with open(os.path.join(*path), 'rb') as file:
        return file.read()


def write(content, *path):
    with open(os.path.join(*path), 'wb') as file:
        file.write(content)


def files_below(top):
    return sorted(os.path.relpath(os.path.join(folder, name), top) for folder, _, found in os.walk(top) for name in found)


def file_below(top, name):
    """The path of a regular file that others name below a folder; None if there is none, or if the name leads out."""
    path = os.path.join(top, name)
    is_below = not os.path.isabs(name) and '..' not in name.split('/') and \
        os.path.realpath(path).startswith(os.path.join(os.path.realpath(top), ''))
    return path if is_below and os.path.isfile(path) else None


def entity_values(level):
    """The keys and values of a level's entities: the first part of its file."""
    at, size = struct.unpack_from('<II', level.ljust(12, b'\0'), 4)
    return re.findall(r'"([^"\n]*)"\s*"([^"\n]*)"', level[at:at + size].decode('utf-8', 'replace'))


def names_in(name, content):
    """What a file may name, as paths below the game's folder, as its readers look for it."""
    folder, kind = os.path.dirname(name), os.path.splitext(name)[1].lower()
    if kind in ('.obj', '.mtl'):
        for line in content.decode('utf-8', 'replace').replace('\\', '/').splitlines():
            words = line.split()
            if words and words[0] in ('mtllib', 'map_Kd'):  # of one or several words, behind options
                ends = [line.split(None, at)[at].strip() for at in range(1, len(words))]
                yield from (os.path.normpath(os.path.join(folder, each)) for each in words[1:] + ends if '..' not in each)
        return
    if kind == '.json':
        definition = json.loads(content)
        values = [(key, value) for key, value in definition.items() if isinstance(value, str)]
        values += [('noise', name) for name in definition.get('captions', {})]
        values += [pair for its_class in definition.get('classes', {}).values() for pair in its_class.get('keys', {}).items()]
        yield from ('maps/%s.bsp' % level for level in definition['levels'])
        yield from ('%s.bsp' % level for level in definition['levels'])
    else:
        values = entity_values(content) if kind == '.bsp' else []
    for key, value in values:
        if key == 'map':
            yield from ('maps/%s.bsp' % value, '%s.bsp' % value)
        if key in ('model', 'noise', 'music', 'palette', 'demo', 'icon'):
            last = os.path.basename(value)
            places = [value, last, 'progs/' + last, 'models/' + last] if key == 'model' else [value]
            yield from (os.path.normpath(os.path.join(place, each)) for place in ('', 'maps') for each in places
                        if '..' not in each and not os.path.isabs(each))


def used_files(game, museum):
    """What the game needs: what stands for the museum's files, what it looks for itself, and what these name in turn."""
    looked = {'game.json', 'gfx/palette.lmp', 'maps/palette.lmp', 'maps/gfx/palette.lmp'}
    looked |= {name for name in museum if name.startswith(('models/', 'sounds/')) and not name.endswith('.mtl')}
    looked |= {name for name in os.listdir(game) if re.fullmatch(r'pak\d+\.pak', name.lower())}
    used, due = {}, sorted(looked)
    while due:
        name = due.pop()
        path = file_below(game, name)
        if path is None or name in used:
            continue
        used[name] = read(path)
        due += names_in(name, used[name])
    return sorted(used.items())


def museum_files(assets):
    return [name for name in files_below(assets) if re.fullmatch(PLAYED, name)]


def packed_data(assets, game):
    files = [(name, read(assets, name)) for name in museum_files(assets)]
    if game:
        files += [('game/' + name, content) for name, content in used_files(game, museum_files(assets))]
    return packed_files(files)


def packed_files(files):
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
        if not file_below(game, 'game.json'):
            raise ValueError('no file below the folder')
        definition = json.loads(read(game, 'game.json'))
        title, levels, icon = str(definition['title']), list(definition['levels']), definition.get('icon')
        if icon and not file_below(game, icon):
            raise ValueError('icon %s is no file below the folder' % icon)
        picture = icon and read(game, icon)
        for level in levels:
            if not any(file_below(game, place + level + '.bsp') for place in ('maps/', '')):
                need('oblong-map makes of its source', game, 'maps', '%s.bsp' % level)
                raise ValueError('level %s is no file below the folder' % level)
        list(names_in('game.json', read(game, 'game.json')))
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        sys.exit('pack.py: %s: %s: %s, expected a game' % (os.path.join(game, 'game.json'), type(error).__name__, error))
    if icon:
        kind = mimetypes.guess_type(icon)[0]
        page = page.replace('href="data:,"', 'href="data:%s;base64,%s"' % (kind, base64.b64encode(picture).decode()))
    return as_page_of(html.escape(title), 'A game made with Oblong.', page, 'lab' in definition.get('shows', []))


def as_page_of(title, about, page, has_lab=False):
    """The page under another title, without the museum's picture, and without the lab's button if there is no lab."""
    if not has_lab:
        page = page.replace('<button id="dials"', '<button id="dials" style="visibility: hidden"')
    page = re.sub('<meta property="og:image.*\n', '', page).replace(' url("/*@card@*/") center / cover', '')
    page = page.replace('>Oblong<', '>%s<' % title).replace('content="Oblong"', 'content="%s"' % title)
    return page.replace('/*@about@*/', about)


def example_list():
    """Of all examples: picture, name, line and source, from their page."""
    examples = os.path.join(HERE, '../../engine/examples')
    items = ''
    for picture, name, text in re.findall(r'^\| <img src="(\w+\.png)".* \| \[(\w+)\]\(\w+\.cpp\) \| (.*) \|$',
                                          read(examples, 'README.md').decode(), re.M):
        items += ('<li><a href="?%s%%20/assets"><img src="data:image/png;base64,%s" alt=""><h2>%s</h2></a><p>%s</p>'
                  '<details><summary>Source</summary><pre tabindex="0">%s</pre></details></li>\n'
                  % (name, base64.b64encode(read(examples, picture)).decode(), name, html.escape(text),
                     html.escape(read(examples, name + '.cpp').decode())))
    return '<main id="list" hidden>\n<h1>Examples</h1>\n<p>%s</p>\n<ul>\n%s</ul>\n</main>\n' % (EXAMPLES, items)


def main(build, assets, site, game=None, named=None):
    page = read(HERE, 'index.html').decode()
    program = 'oblong'
    if game in ('--examples', '--program'):
        program, game = named or 'examples', None
        page = as_page_of(named or 'Examples', 'A program on the engine of Oblong.' if named else EXAMPLES, page)
        if not named:
            page = page.replace('<div id="said"', example_list() + '<div id="said"')
    if game:
        page = under_own_name(page, game)
    need('tools/build --web makes', build, program + '.wasm')
    if not named:
        need('tools/build --web makes', assets, 'demo.bsp')
    if game:
        left = sorted(set(files_below(game)) - {name for name, _ in used_files(game, museum_files(assets))})
        print('left out, as nothing names them: ' + ', '.join(left) if left else 'nothing is left out')
    data = packed_files([(name, read(assets, name)) for name in files_below(assets)]) if named else packed_data(assets, game)
    files = {program + '.wasm': read(build, program + '.wasm'), program + '.data': data}
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
    icon = read(HERE, '../../assets/package/icons/oblong-64.png')
    page = page.replace('href="data:,"', 'href="data:image/png;base64,%s"' % base64.b64encode(icon).decode())
    card = read(HERE, '../../assets/card.png')
    page = page.replace('/*@about@*/', MUSEUM).replace('/*@address@*/', os.environ.get('OBLONG_ADDRESS', '.').rstrip('/'))
    alone = page.replace('/*@card@*/', 'data:image/png;base64,' + base64.b64encode(card).decode())
    alone = alone.replace('<!--@links@-->\n', '')
    write(alone.replace('<!--@files@-->', inlined).encode(), site, program + '.html')
    if program == 'oblong':
        for name, content in {**files, 'card.png': card}.items():
            write(content, site, name)
        page = page if game else page.replace('<!--@links@-->', LINKS)
        write(page.replace('/*@card@*/', 'card.png').encode(), site, 'index.html')
    total = sum(map(len, packed.values())) + len(gzip.compress(alone.encode(), 9))
    print('packed: program %d, data %d, all %d bytes' % (*map(len, packed.values()), total))


if not 4 <= len(sys.argv) <= (6 if '--program' in sys.argv else 5):
    sys.exit(__doc__)
main(*sys.argv[1:])
