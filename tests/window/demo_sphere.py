"""The demo level with the player before its sphere, which glows in a colour that nothing else there has."""
import os
import re
import struct
import subprocess
import zlib

GLOW = (240, 72, 184)  # of the palette's colours that no light changes
SPHERE = (-112, 352, 128)  # its centre
DISTANCE = 300
EYE_ABOVE_FEET, ORIGIN_ABOVE_FEET = 46, 24


def build(build_folder, folder):
    """Compiles it into `folder`; the path of its BSP."""
    with open(os.path.join(os.path.dirname(__file__), '../../assets/demo.map')) as file:
        text = file.read()
    with open(folder + '/sphere.map', 'w') as file:
        file.write(with_player_before_it(with_glowing_sphere(without_palette_cycles(text))))
    write_png(folder + '/glow.png', GLOW)
    programs, assets = build_folder + '/bin', build_folder + '/assets'
    subprocess.run([programs + '/oblong-texture', 'pack', folder + '/glow.png', '-o', folder + '/glow.wad',
                    '--glow', 'glow', '--palette', assets + '/palette.lmp'], check=True)
    subprocess.run([programs + '/oblong-map', folder + '/sphere.map', '-o', folder + '/sphere.bsp', '--fast',
                    '--wad', assets + '/demo.wad', '--wad', folder + '/glow.wad'],
                   check=True, stdout=subprocess.DEVNULL)
    return folder + '/sphere.bsp'


def without_palette_cycles(text):
    """The glow would take turns with its neighbours."""
    return re.sub(r'"palette_cycle\d*" "[^"]*"\n', '', text)


def with_glowing_sphere(text):
    """The sphere is the one brush with facets of red plaster."""
    brushes = text.split('{\n')
    spheres = [i for i, brush in enumerate(brushes) if ' plaster_red ' in brush]
    assert len(spheres) == 1, 'expected one sphere of red plaster, found %d' % len(spheres)
    brushes[spheres[0]] = brushes[spheres[0]].replace(' plaster_red ', ' glow ').replace(' plaster_ivory ', ' glow ')
    return '{\n'.join(brushes)


def with_player_before_it(text):
    """Moves the start onto a block south of the sphere, the eye as high as its centre."""
    x, y, eye_z = SPHERE[0], SPHERE[1] - DISTANCE, SPHERE[2]
    feet_z = eye_z - EYE_ABOVE_FEET
    lines = text.split('\n')
    start = lines.index('"classname" "info_player_start"')
    origin = next(i for i in range(start, len(lines)) if lines[i].startswith('"origin"'))
    lines[origin] = '"origin" "%d %d %d"' % (x, y, feet_z + ORIGIN_ABOVE_FEET)
    first_brush = lines.index('// brush 0')  # of the first layer, which is part of the world
    lines.insert(first_brush, block((x - 20, y - 20, feet_z - 8), (x + 20, y + 20, feet_z)))
    return '\n'.join(lines)


def block(low, high):
    """A box as a brush: a point of each face and two more, clockwise seen from outside."""
    (x, y, z), (far_x, far_y, far_z) = low, high
    faces = [((x, y, z), (0, 1, 0), (0, 0, 1)), ((far_x, y, z), (0, 0, 1), (0, 1, 0)),
             ((x, y, z), (0, 0, 1), (1, 0, 0)), ((x, far_y, z), (1, 0, 0), (0, 0, 1)),
             ((x, y, z), (1, 0, 0), (0, 1, 0)), ((x, y, far_z), (0, 1, 0), (1, 0, 0))]
    lines = []
    for corner, u, v in faces:
        points = [corner] + [tuple(c + d for c, d in zip(corner, step)) for step in (u, v)]
        lines.append(' '.join('( %d %d %d )' % point for point in points) + ' stone_wall 0 0 0 1 1')
    return '{\n' + '\n'.join(lines) + '\n}'


def write_png(path, colour, side=64):
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    rows = (b'\0' + bytes(colour) * side) * side
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', side, side, 8, 2, 0, 0, 0))
                   + chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))
