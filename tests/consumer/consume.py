#!/usr/bin/env python3
"""A program of somebody else's takes the library in, as the page of engine/library says, and draws what it should.
consume.py WAY SOURCE_FOLDER BUILD_FOLDER      WAY: find_package, pkg_config, add_subdirectory, fetch_content, shared or libcxx

In a folder of its own outside the project. What is installed is moved before it is used."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import zlib

COMPILERS = [name for name in ('g++', 'clang++') if shutil.which(name)]


def main(way, source, build):
    with tempfile.TemporaryDirectory() as folder:
        getattr(Consumer(source, os.path.abspath(build), folder), way)()


def run(*command, code=0, **variables):
    """The output of a command that ends with this code."""
    done = subprocess.run(command, env=dict(os.environ, **variables), text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    assert done.returncode == code, '%s: exit %d\n%s' % (' '.join(command), done.returncode, done.stdout)
    return done.stdout


class Consumer:
    def __init__(self, source, build, folder):
        self.source, self.build, self.folder = source, build, folder
        with open(source + '/engine/library/README.md') as page:
            self.snippets = re.findall(r'(?:^    .*\n)+', page.read(), re.M)
        with open(source + '/CMakeLists.txt') as file:
            self.version = re.search(r'^project\(oblong VERSION (\S+)', file.read(), re.M).group(1)
        self.project = folder + '/game'
        shutil.copytree(source + '/tests/consumer/program', self.project)

    # The ways

    def find_package(self):
        prefix = self.installed(self.build)
        for compiler in COMPILERS:
            self.demand_output(self.made_with_cmake('find_package(', compiler, prefix))
        self.demand_refusals(prefix)
        self.demand_first_program(prefix)

    def pkg_config(self):
        prefix = self.installed(self.build)
        for compiler in COMPILERS:
            self.demand_output(self.made_with_pkg_config(prefix, compiler))
            self.demand_whole_headers(prefix, compiler)
        # The static library goes into a shared object of which nothing is missing.
        command = self.snippet('pkg-config').replace(' -o game', ' -shared -fPIC -Wl,-z,defs -o plug.so')
        run('sh', '-e', '-c', 'cd "$1"\n' + command, 'sh', self.project, PKG_CONFIG_PATH=prefix + '/lib/pkgconfig')

    def add_subdirectory(self):
        os.symlink(self.source, self.project + '/oblong')
        for compiler in COMPILERS:
            game = self.made_with_cmake('add_subdirectory(', compiler)
            self.demand_output(game)
            self.demand_engine_alone(os.path.dirname(game))

    def fetch_content(self):
        """As a shared library; by one compiler, as shared() builds one by the other."""
        os.symlink(self.source, self.folder + '/oblong')
        self.demand_output(self.made_with_cmake('FetchContent_Declare(', COMPILERS[-1], '', '-DBUILD_SHARED_LIBS=ON'))

    def shared(self):
        prefix = self.built_and_installed('-D BUILD_SHARED_LIBS=ON')
        for compiler in COMPILERS:
            game = self.made_with_cmake('find_package(', compiler, prefix)
            self.demand_output(game)
            self.demand_shared(game)
            game = self.made_with_pkg_config(prefix, compiler)
            self.demand_output(game, LD_LIBRARY_PATH=prefix + '/lib')
            self.demand_shared(game)

    def libcxx(self):
        """By Clang with LLVM's C++ library, for which Debian's tinyobjloader is not compiled: it comes with the program."""
        compiler = 'clang++ -stdlib=libc++'
        if subprocess.run(compiler + ' -x c++ -include vector -fsyntax-only /dev/null', shell=True).returncode:
            print('not tried: needs the Debian packages clang libc++-dev libc++abi-dev')
            sys.exit(77)
        with open(self.project + '/tinyobj.cpp', 'w') as file:
            file.write('#define TINYOBJLOADER_IMPLEMENTATION\n#define TINYOBJLOADER_USE_DOUBLE\n#include <tiny_obj_loader.h>\n')
        prefix = self.built_and_installed('', CXX='clang++', CXXFLAGS='-stdlib=libc++')
        self.demand_output(self.made_with_pkg_config(prefix, compiler + ' tinyobj.cpp'))

    # Taking in

    def installed(self, build):
        """The prefix that the library was moved to."""
        run('cmake', '--install', build, '--component', 'development', '--prefix', self.folder + '/installed')
        return self.moved()

    def built_and_installed(self, options, **variables):
        """The same of another library, by the page's own commands."""
        commands = self.snippet('cmake --install').replace('PREFIX', self.folder + '/installed')
        commands = commands.replace('build/library', self.folder + '/library').replace(' -C ', ' %s -C ' % options)
        run('sh', '-e', '-c', 'cd "$1"\n' + commands, 'sh', self.source, CMAKE_GENERATOR='Ninja', **variables)
        return self.moved()

    def moved(self):
        os.rename(self.folder + '/installed', self.folder + '/moved')
        return self.folder + '/moved'

    def snippet(self, mark):
        """The page's only one with this in it."""
        found = [text for text in self.snippets if mark in text]
        assert len(found) == 1, 'the page has %d snippets with %s' % (len(found), mark)
        return re.sub(r'^    ', '', found[0], flags=re.M)

    def demand_first_program(self, prefix):
        """The page's whole program and its CMakeLists.txt, of the installed library."""
        project = self.folder + '/first'
        shutil.copytree(self.source + '/tests/consumer/first', project)
        with open(project + '/CMakeLists.txt', 'w') as file:
            file.write(self.snippet('project(game').replace('add_subdirectory(oblong)', 'find_package(Oblong REQUIRED)'))
        run('cmake', '-S', project, '-B', project + '/build', '-G', 'Ninja', '-DCMAKE_PREFIX_PATH=' + prefix)
        run('cmake', '--build', project + '/build')
        run(project + '/build/game', OBLONG_HEADLESS='2')

    def configure(self, snippet, compiler, prefix, *options, code=0):
        with open(self.project + '/snippet.cmake', 'w') as file:
            file.write(re.sub(r'^(cmake_minimum_required|project|add_executable).*\n', '', snippet, flags=re.M))
        build = '%s/%s' % (self.folder, compiler)
        shutil.rmtree(build, ignore_errors=True)
        said = run('cmake', '-S', self.project, '-B', build, '-G', 'Ninja', '-DCMAKE_CXX_COMPILER=' + compiler,
                   '-DCMAKE_PREFIX_PATH=' + prefix, '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON', *options, code=code)
        return said if code else build

    def made_with_cmake(self, mark, compiler, prefix='', *options):
        build = self.configure(self.snippet(mark), compiler, prefix, *options)
        run('cmake', '--build', build, '-j', str(os.cpu_count()))
        return build + '/game'

    def made_with_pkg_config(self, prefix, compiler):
        command = self.snippet('pkg-config')
        assert command.startswith('g++ ') and command.rstrip().endswith('-o game'), command
        run('sh', '-c', 'cd "$1" && rm -f game && ' + compiler + command[3:], 'sh', self.project,
            PKG_CONFIG_PATH=prefix + '/lib/pkgconfig')
        return self.project + '/game'

    # What is demanded

    def demand_output(self, game, **variables):
        """Without a display: the plasma by its formula, and the level's picture as the project's own program draws it."""
        files = ['%s/assets/%s' % (self.build, name) for name in ('demo.bsp', 'palette.lmp', 'models/lens.obj')]
        with open(self.folder + '/cameras.csv', 'w') as file:
            file.write('x,y,z,yaw,pitch\n0,40,70,92,-6\n')
        drawn = run(self.build + '/bin/oblong-render', files[0], '--cameras', self.folder + '/cameras.csv', '--json', '-')
        plasma = zlib.crc32(bytes(x * y >> 6 & 255 for y in range(200) for x in range(320)))
        level = json.loads(drawn)['frames'][0]['crc32']
        expected = '%s\nplasma %08x\nlevel %s\nmodel of 1 frame\n' % (self.version, plasma, level)
        said = run(game, *files, OBLONG_HEADLESS='2:%s/plasma.png' % self.folder, **variables)
        assert said == expected, said + 'expected:\n' + expected
        with open(self.folder + '/plasma.png', 'rb') as file:
            assert file.read(4) == b'\x89PNG'

    def demand_refusals(self, prefix):
        """A version that it is not, and components that are not there; found is one of an older patch."""
        package = 'find_package(Oblong %s REQUIRED)\n'
        self.configure(package % re.sub(r'\d+$', '0', self.version) + 'target_link_libraries(game oblong::oblong)\n', 'g++', prefix)
        major, minor, _ = map(int, self.version.split('.'))
        others = ['%d.%d' % (major, minor + 1), str(major + 1)] + ['%d.%d' % (major, minor - 1)] * (minor > 0)
        for asked, answer in [(other, 'version: ' + self.version) for other in others] + [
                              ('COMPONENTS tools', 'no component tools'), ('COMPONENTS hats', 'no component hats')]:
            said = self.configure(package % asked, 'g++', prefix, code=1)
            assert answer in ' '.join(said.split()), said
        run('cmake', '--install', self.build, '--component', 'game', '--prefix', prefix)
        build = self.configure(package % 'COMPONENTS tools' + 'add_custom_target(level ALL COMMAND oblong::oblong-map --version)\n',
                               'g++', prefix)
        run('cmake', '--build', build, '--target', 'level')

    def demand_whole_headers(self, prefix, compiler):
        """Each installed header compiles with all the others, and finds what it includes."""
        top = prefix + '/include/oblong'
        headers = sorted(os.path.relpath(os.path.join(at, name), top) for at, _, names in os.walk(top) for name in names)
        assert {'oblong.h', 'engine/frame/frame.h', 'engine/level/bsp_read.h'} <= set(headers), headers
        assert all(name.endswith('.h') for name in headers) and 'engine/platform/sdl/owned.h' not in headers, headers
        with open(self.folder + '/headers.cpp', 'w') as file:
            file.write(''.join('#include <%s>\n' % name for name in headers) + '#include <oblong/oblong.h>\n')
        run('sh', '-c', '"$@" $(pkg-config --cflags oblong)', 'sh', compiler, '-std=c++20', '-fsyntax-only', '-Wall', '-Wextra',
            '-Wconversion', '-Wsign-conversion', '-Werror', self.folder + '/headers.cpp', PKG_CONFIG_PATH=prefix + '/lib/pkgconfig')

    def demand_engine_alone(self, build):
        """Beneath another project nothing else is compiled, with optimisation, and no warning is an error."""
        with open(build + '/compile_commands.json') as file:
            commands = {entry['file']: entry['command'].split() for entry in json.load(file)}
        of_game = commands.pop(self.project + '/game.cpp')
        assert not {'-O2', '-ffp-contract=off'} & set(of_game), of_game
        assert len(commands) > 5, commands.keys()
        for file, command in commands.items():
            assert re.search(r'/oblong/engine/|/oblong/standard_headers\.cpp$|/oblong_standard_headers\.dir/', file), file
            assert '-O2' in command and '-Werror' not in command, command

    def demand_shared(self, game):
        needed = re.findall(r'\(NEEDED\).*\[(.*)\]', run('readelf', '-d', game))
        soname = 'liboblong.so.' + self.version.rsplit('.', 1)[0]
        assert soname in needed and not [name for name in needed if 'SDL' in name], needed


main(*sys.argv[1:])
