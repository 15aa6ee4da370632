"""Reads PNG pictures of 8 bits a channel, as browsers write them."""

import struct
import zlib


def chunks(data):
    at = 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + length]
        at += 12 + length


def nearest(left, above, corner):
    """The predictor of Paeth, PNG specification 9.4."""
    to_left, to_above, to_corner = abs(above - corner), abs(left - corner), abs(left + above - 2 * corner)
    if to_left <= to_above and to_left <= to_corner:
        return left
    return above if to_above <= to_corner else corner


PREDICTORS = {
    1: lambda left, above, corner: left,
    2: lambda left, above, corner: above,
    3: lambda left, above, corner: (left + above) // 2,
    4: nearest,
}


def unfilter(kind, line, before, step):
    if kind == 0:
        return line
    predict = PREDICTORS[kind]
    for i, value in enumerate(line):
        left, corner = (line[i - step], before[i - step]) if i >= step else (0, 0)
        line[i] = (value + predict(left, before[i], corner)) & 255
    return line


def read_png(data):
    """(width, height, rows), a row a list of tuples of channels."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    found = list(chunks(data))
    width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", dict(found)[b"IHDR"])
    assert depth == 8 and interlace == 0 and colour in (2, 6)
    step = 3 if colour == 2 else 4
    raw = zlib.decompress(b"".join(body for kind, body in found if kind == b"IDAT"))
    rows = []
    line = bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        line = unfilter(raw[start], bytearray(raw[start + 1:start + 1 + width * step]), line, step)
        rows.append([tuple(line[i:i + step]) for i in range(0, len(line), step)])
    return width, height, rows
