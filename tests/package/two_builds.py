#!/usr/bin/env python3
"""Two `tools/build` in one folder at once: one waits for the other and says so, and both end well.  two_builds.py SOURCE_FOLDER

In a project of its own, of a single step that fails if it runs twice at a time."""
import os
import shutil
import subprocess
import sys
import tempfile

STEP = 'mkdir "$1/running" && sleep 1 && rmdir "$1/running"'


def main(source):
    with tempfile.TemporaryDirectory() as folder:
        os.makedirs(folder + '/tools/presets')
        shutil.copy(source + '/tools/build', folder + '/tools/build')
        open(folder + '/tools/install-packages', 'w').close()
        open(folder + '/tools/presets/release.cmake', 'w').close()
        with open(folder + '/CMakeLists.txt', 'w') as file:
            file.write('cmake_minimum_required(VERSION 3.20)\nproject(P NONE)\nadd_custom_target(step ALL VERBATIM COMMAND '
                       'sh -c [==[%s]==] - ${CMAKE_BINARY_DIR})\n' % STEP)
        builds = [subprocess.Popen([folder + '/tools/build'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                  for _ in range(3)]
        said = [build.communicate(timeout=600)[0] for build in builds]
    assert [build.returncode for build in builds] == [0, 0, 0], said
    waited = ['waiting for another tools/build in build (process ' in text for text in said]
    assert sum(waited) == 2, said


main(*sys.argv[1:])
