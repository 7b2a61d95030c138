#!/usr/bin/env python3
"""Installs the game into a temporary root and checks what is there.  check_installed.py BUILD_FOLDER VERSION

Each file is one that a user needs, and none is missing; the programs run from there, in a folder of someone else's; each
manual page parses and names each option of its program's --help; menu entry and metadata are valid."""
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAMS = ['oblong', 'oblong-accuracy', 'oblong-gallery', 'oblong-map', 'oblong-probe', 'oblong-render',
            'oblong-texture']
NEEDED = (['bin/' + name for name in PROGRAMS]
          + ['share/man/man%d/%s.%d' % (6 if name == 'oblong' else 1, name, 6 if name == 'oblong' else 1)
             for name in PROGRAMS]
          + ['share/icons/hicolor/%dx%d/apps/oblong.png' % (size, size) for size in (16, 32, 48, 64, 128, 256)]
          + ['share/icons/hicolor/scalable/apps/oblong.svg', 'share/applications/oblong.desktop',
             'share/metainfo/org.oblong_game.oblong.metainfo.xml', 'share/doc/oblong/copyright',
             'share/doc/oblong/changelog', 'share/oblong/demo.bsp', 'share/oblong/palette.lmp',
             'share/oblong/demo.map', 'share/oblong/demo.wad', 'share/oblong/walk.demo'])


def main(build, version):
    with tempfile.TemporaryDirectory() as folder:
        install(build, folder)
        prefix = folder + '/usr'
        check_files(prefix)
        home = folder + '/home'
        os.mkdir(home)
        check_programs(prefix, home, version)
        for page in glob.glob(prefix + '/share/man/man*/*'):
            check_manual_page(prefix, page)
        check_menu_entry(prefix)
        check_metadata(prefix)
        check_missing_files(prefix, home)


def install(build, folder):
    subprocess.run(['cmake', '--install', build, '--prefix', '/usr', '--component', 'game'],
                   env=dict(os.environ, DESTDIR=folder), check=True, stdout=subprocess.DEVNULL)


def files_in(folder):
    return {os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names}


def check_files(prefix):
    files = files_in(prefix)
    missing = set(NEEDED) - files
    assert not missing, 'not installed: %s' % sorted(missing)
    # Every level there is one that players may choose.
    surplus = {name for name in files - set(NEEDED) if not name.startswith('share/oblong/') or name.endswith('.bsp')}
    assert not surplus, 'installed, but of no use to a player: %s' % sorted(surplus)
    tests = [name for name in files if re.search(r'test|CMake|\.cmake$|\.(cpp|h|o|a)$', name)]
    assert not tests, 'installed, but of no use to a player: %s' % tests


def run(prefix, home, *command):
    """The program's exit code, output and errors, with an empty home and nothing of the build in its environment."""
    environment = {'HOME': home, 'PATH': os.environ['PATH']}
    return subprocess.run([prefix + '/bin/' + command[0], *command[1:]], cwd=home, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=600)


def check_programs(prefix, home, version):
    for name in PROGRAMS:
        said = run(prefix, home, name, '--version')
        assert (said.returncode, said.stdout) == (0, '%s %s\n' % (name, version)), said
    played = run(prefix, home, 'oblong', '--headless', '2', '--out', 'pictures')
    assert (played.returncode, played.stderr) == (0, ''), played
    assert files_in(home) == {'pictures/00000.png', 'pictures/00001.png'}, files_in(home)
    shown = run(prefix, home, 'oblong', '--gallery', '--headless', '2', '--out', 'gallery')
    assert (shown.returncode, shown.stderr) == (0, '') and 'gallery/00001.png' in files_in(home), shown
    shutil.rmtree(home + '/gallery')
    with open(home + '/cameras.csv', 'w') as file:
        file.write('x,y,z,yaw,pitch\n0,40,70,92,-6\n')
    drawn = run(prefix, home, 'oblong-render', prefix + '/share/oblong/demo.bsp', '--cameras', 'cameras.csv', '--json', '-')
    assert drawn.returncode == 0 and '"crc32"' in drawn.stdout, drawn


def options_of(prefix, name):
    """Each option that --help lists, of subcommands too."""
    def listed(*command):
        said = run(prefix, '/', name, *command, '--help')
        assert said.returncode == 0, said
        return said.stdout
    text = listed()
    subcommands = re.findall(r'^  (\w+) ', text.split('Subcommands:')[1], re.M) if 'Subcommands:' in text else []
    text += ''.join(listed(command) for command in subcommands)
    return {option for line in re.findall(r'^  (-\S+)', text, re.M) for option in line.split(',')}


def check_manual_page(prefix, page):
    name = os.path.basename(page).rsplit('.', 1)[0]
    with open(page) as file:
        text = re.sub(r'\\f[BIPR]', '', file.read())
    missing = {option for option in options_of(prefix, name)
               if not re.search(r'(?<![\w-])' + re.escape(option) + r'(?![\w-])', text.replace('\\-', '-'))}
    assert not missing, '%s does not name %s' % (page, sorted(missing))
    assert '@' not in text, '%s: a mark is left' % page
    if shutil.which('groff'):
        said = subprocess.run(['groff', '-man', '-Tutf8', '-ww', '-z', page], stderr=subprocess.PIPE, text=True)
        wrong = [line for line in said.stderr.splitlines() if 'adjust' not in line]
        assert said.returncode == 0 and not wrong, wrong


def check_menu_entry(prefix):
    entry = prefix + '/share/applications/oblong.desktop'
    with open(entry) as file:
        values = dict(line.rstrip('\n').split('=', 1) for line in file if '=' in line)
    program, *options = values['Exec'].split()
    assert os.path.exists(prefix + '/bin/' + program), values['Exec']
    unknown = set(options) - {'%f'} - options_of(prefix, program)
    assert not unknown, 'the menu entry passes %s' % unknown
    assert glob.glob('%s/share/icons/hicolor/*/apps/%s.png' % (prefix, values['Icon'])), values['Icon']
    if shutil.which('desktop-file-validate'):
        said = subprocess.run(['desktop-file-validate', entry], stdout=subprocess.PIPE, text=True)
        assert (said.returncode, said.stdout) == (0, ''), said.stdout


def check_metadata(prefix):
    if not shutil.which('appstreamcli'):
        return
    said = subprocess.run(['appstreamcli', 'validate', '--no-net', *glob.glob(prefix + '/share/metainfo/*')],
                          stdout=subprocess.PIPE, text=True)
    assert said.returncode == 0, said.stdout


def check_missing_files(prefix, home):
    """Without its files the game says what it looked for, and where."""
    os.rename(prefix + '/share/oblong', prefix + '/share/elsewhere')
    said = run(prefix, home, 'oblong', '--headless', '1', '--out', 'none')
    assert said.returncode == 1, said
    assert said.stderr.startswith('oblong: %s/share/oblong: palette.lmp: ' % prefix), said.stderr
    assert said.stderr.count('\n') == 1 and 'expected' in said.stderr, said.stderr


main(*sys.argv[1:])
