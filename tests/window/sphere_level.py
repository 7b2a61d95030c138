"""A level with one white sphere in a black room, straight ahead of the player's eye: look.py measures it on screen."""
import math
import struct
import subprocess
import zlib

EYE_Z = 46  # of a player who stands on z = 0
DISTANCE, RADIUS = 160, 72  # below the messages at the top in every shape


def write_png(path, colour, side=64):
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    rows = (b'\0' + bytes(colour) * side) * side
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', side, side, 8, 2, 0, 0, 0))
                   + chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))


def plane(point, normal, texture):
    """A line of a brush: three points clockwise seen from where the normal points."""
    axis = min(range(3), key=lambda i: abs(normal[i]))
    other = [0.0, 0.0, 0.0]
    other[axis] = 1.0
    u = cross(normal, other)
    v = cross(normal, u)
    points = [point, add(point, v, 64), add(point, u, 64)]
    return ' '.join('( %.6f %.6f %.6f )' % tuple(p) for p in points) + ' %s 0 0 0 1 1' % texture


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(point, direction, times):
    return [p + d * times for p, d in zip(point, direction)]


def box(low, high, texture):
    lines = []
    for axis in range(3):
        for corner, sign in ((low, -1.0), (high, 1.0)):
            normal = [0.0, 0.0, 0.0]
            normal[axis] = sign
            lines.append(plane([float(c) for c in corner], normal, texture))
    return '{\n' + '\n'.join(lines) + '\n}\n'


def sphere(centre, radius, texture):
    """Its poles lie along the line of sight, so that it looks the same turned by a quarter: exactly as wide as high."""
    lines = [plane(add(centre, [0, s, 0], radius), [0.0, float(s), 0.0], texture) for s in (-1, 1)]
    for ring in range(1, 8):
        polar = math.pi * ring / 8
        for step in range(24):
            turn = 2 * math.pi * step / 24
            normal = [math.sin(polar) * math.cos(turn), math.cos(polar), math.sin(polar) * math.sin(turn)]
            lines.append(plane(add(centre, normal, radius), normal, texture))
    return '{\n' + '\n'.join(lines) + '\n}\n'


def entity(**keys):
    return '{\n' + '\n'.join('"%s" "%s"' % pair for pair in keys.items()) + '\n}\n'


def source():
    walls = [((-420, -220, -420), (-400, 620, 420)), ((400, -220, -420), (420, 620, 420)),
             ((-420, -240, -420), (420, -220, 420)), ((-420, 620, -420), (420, 640, 420)),
             ((-420, -220, -440), (420, 620, -420)), ((-420, -220, 420), (420, 620, 440)),
             ((-40, -40, -420), (40, 40, 0))]
    brushes = ''.join(box(low, high, 'black') for low, high in walls)
    brushes += sphere([0.0, float(DISTANCE), float(EYE_Z)], RADIUS, 'white')
    lights = [(0, -20, EYE_Z + 40)]
    lights += [(x * 250, DISTANCE - 40, EYE_Z + z * 250) for x, z in ((1, 0), (-1, 0), (0, 1), (0, -1))]
    text = '{\n"classname" "worldspawn"\n' + brushes + '}\n'
    text += entity(classname='info_player_start', origin='0 0 24', angle='90')
    return text + ''.join(entity(classname='light', origin='%d %d %d' % place, light='600') for place in lights)


def build(programs, palette, folder):
    """Compiles the level into `folder`; the path of its BSP."""
    write_png(folder + '/black.png', (0, 0, 0))
    write_png(folder + '/white.png', (235, 235, 235))
    with open(folder + '/sphere.map', 'w') as file:
        file.write(source())
    subprocess.run([programs + '/oblong-texture', 'pack', folder + '/black.png', folder + '/white.png',
                    '-o', folder + '/sphere.wad', '--palette', palette], check=True)
    subprocess.run([programs + '/oblong-map', folder + '/sphere.map', '-o', folder + '/sphere.bsp',
                    '--wad', folder + '/sphere.wad', '--fast'], check=True, stdout=subprocess.DEVNULL)
    return folder + '/sphere.bsp'
