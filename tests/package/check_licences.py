#!/usr/bin/env python3
"""What the programs are made of may be passed on under the MIT licence, and is named where that is due.
check_licences.py BUILD_FOLDER SOURCE_FOLDER

Each header that the sources include in <>, and each library that a program of BUILD_FOLDER/bin is linked with, belongs to a
library of LIBRARIES or to the system; each of LIBRARIES is named, with its licence, in the package's copyright file, and
in the game's credits."""
import glob
import os
import re
import subprocess
import sys

# Name; licence, as Debian calls it; its headers; what the dynamic linker calls it.
LIBRARIES = [
    ('SDL', 'Zlib', r'SDL\.h', r'libSDL2-2\.0\.so'),
    ('libpng', 'Libpng', r'png\.h', r'libpng16\.so'),
    ('zlib', 'Zlib', r'zlib\.h', r'libz\.so'),
    ('CLI11', 'BSD-3-clause', r'CLI/', None),
    ('JSON for Modern C++', 'Expat', r'nlohmann/', None),
    ('tinyobjloader', 'Expat', r'tiny_obj_loader\.h', r'libtinyobjloader(_double)?\.so'),
    ('stb', 'Expat', r'stb/', None),
]
# Not installed: they measure.
OF_BENCHMARKS = [('Google Benchmark', 'Apache-2.0', r'benchmark/', r'libbenchmark\.so')]
ALLOWED = {'Zlib', 'Libpng', 'BSD-3-clause', 'Expat', 'Apache-2.0'}
# The C and C++ libraries, whose licences except what is linked with them, and the processor's and the kernel's headers.
SYSTEM_HEADERS = r'oblong\.h|[a-z_0-9]+|[a-z]*intrin\.h|(sys|linux|asm)/.*|(unistd|fcntl|time|signal|poll|pthread|malloc|spawn|emscripten)\.h|std[a-z]+\.h'
SYSTEM_LIBRARIES = r'lib(c|m|gcc_s|stdc\+\+|c\+\+|asan|ubsan|pthread)\.so|ld-linux'


def main(build, source):
    for name, licence, _, _ in LIBRARIES + OF_BENCHMARKS:
        assert licence in ALLOWED, '%s has the licence %s' % (name, licence)
    used = owners(headers_of(source), 2, SYSTEM_HEADERS) | owners(linked(build), 3, SYSTEM_LIBRARIES)
    unused = {row[0] for row in LIBRARIES} - used
    assert not unused, 'of no use any more: %s' % sorted(unused)
    with open(source + '/assets/package/copyright') as file:
        stanzas = file.read().split('\n\n')
    given = [stanza for stanza in stanzas if stanza.startswith('License:')]
    for name, licence, _, _ in LIBRARIES:
        named = [s for s in stanzas if re.search(r'^Comment: %s(,|$)' % re.escape(name), s, re.M)]
        assert named, 'assets/package/copyright: %s is not named' % name
        assert 'License: %s' % licence in named[0], '%s: expected %s' % (named[0], licence)
        assert any(text.startswith('License: %s\n' % licence) for text in given), 'no text of %s' % licence
        credits = credits_of(source)
        assert re.search(r'\b%s(?!\w)' % re.escape(name), credits), 'the credits do not name %s' % name


def headers_of(source):
    """{header: a file that includes it}"""
    headers = {}
    for top in ('engine', 'game', 'tools'):
        for folder, _, names in os.walk(os.path.join(source, top)):
            for name in names:
                if name.endswith(('.h', '.cpp')):
                    with open(os.path.join(folder, name)) as file:
                        for header in re.findall(r'^\s*#\s*include\s*<([^>]+)>', file.read(), re.M):
                            headers[header] = os.path.join(folder, name)
    assert len(headers) > 30, 'the sources were not found'
    return headers


def linked(build):
    """{library: a program that is linked with it}"""
    libraries = {}
    programs = glob.glob(build + '/bin/oblong*')
    assert len(programs) > 5, 'the programs were not found'
    for program in programs:
        said = subprocess.run(['readelf', '-d', program], stdout=subprocess.PIPE, text=True, check=True).stdout
        for library in re.findall(r'\(NEEDED\).*\[(.*)\]', said):
            libraries[library] = program
    return libraries


def owners(found, column, system):
    names = set()
    for what, where in found.items():
        if re.fullmatch(system, what) or (column == 3 and re.match(system, what)):
            continue
        rows = [row for row in LIBRARIES + OF_BENCHMARKS if row[column] and re.match(row[column], what)]
        assert rows, '%s: %s is of no library whose licence is known to suit; see LIBRARIES' % (where, what)
        names.add(rows[0][0])
    return names


def credits_of(source):
    for path in glob.glob(source + '/game/**/*.cpp', recursive=True):
        with open(path) as file:
            text = file.read()
        if 'It stands on' in text:
            return ' '.join(re.findall(r'"([^"\n]*)"', text[text.index('It stands on') - 1:])).replace('  ', ' ')
    raise AssertionError('no credits in game/')


main(*sys.argv[1:])
