"""Makes PNG pictures small: without transparency, and where that is not enough with 256 colours."""

import struct
import zlib
from collections import Counter

from png import PREDICTORS

ENOUGH = 130_000
MOST_COLOURS = 256
TRUE_COLOUR, INDEXED = 2, 3


def widest(box):
    """(extent, channel) of the channel along which the colours of a box lie farthest apart."""
    return max((max(colour[k] for colour, _ in box) - min(colour[k] for colour, _ in box), k) for k in range(3))


def cut(box):
    """Two boxes of about as many pixels each."""
    channel = widest(box)[1]
    box = sorted(box, key=lambda entry: entry[0][channel])
    half, sum_so_far = sum(count for _, count in box) / 2, 0
    for i, (_, count) in enumerate(box[:-1], 1):
        sum_so_far += count
        if sum_so_far >= half:
            break
    return box[:i], box[i:]


def boxes_of(counts):
    """The colours, with how many pixels have each, in at most MOST_COLOURS boxes."""
    def weight(box):
        # Few pixels of a far colour matter less than many of nearly one.
        return widest(box)[0] * sum(count for _, count in box) ** 0.25 if len(box) > 1 else 0

    boxes = [(weight(box), box) for box in [sorted(counts.items())]]
    while len(boxes) < MOST_COLOURS:
        largest = max(range(len(boxes)), key=lambda i: boxes[i][0])
        if boxes[largest][0] == 0:
            break
        boxes += [(weight(box), box) for box in cut(boxes.pop(largest)[1])]
    return [box for _, box in boxes]


def mean(box):
    pixels = sum(count for _, count in box)
    return tuple(round(sum(colour[k] * count for colour, count in box) / pixels) for k in range(3))


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def png_of(width, height, colour_type, lines, palette=b""):
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, colour_type, 0, 0, 0))
            + (chunk(b"PLTE", palette) if palette else b"") + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def filtered(kind, line, before):
    """A line of three channels as its differences from what a predictor says."""
    predict = PREDICTORS[kind]
    corners = bytes(3) + before
    return bytes((value - predict(left, above, corner)) & 255 for value, left, above, corner in zip(line, bytes(3) + line, before, corners))


def with_all_colours(width, height, rows):
    lines, before = [], bytes(3 * width)
    for row in rows:
        line = bytes(value for pixel in row for value in pixel[:3])
        # The usual choice: of the smallest differences.
        choices = [(kind, filtered(kind, line, before)) for kind in PREDICTORS]
        kind, best = min(choices, key=lambda choice: sum(min(value, 256 - value) for value in choice[1]))
        lines.append(bytes([kind]) + best)
        before = line
    return png_of(width, height, TRUE_COLOUR, b"".join(lines))


def with_few_colours(width, height, rows):
    """By median cut (Heckbert 1982)."""
    palette, index = [], {}
    for i, box in enumerate(boxes_of(Counter(pixel[:3] for row in rows for pixel in row))):
        palette.append(mean(box))
        index.update((colour, i) for colour, _ in box)
    lines = b"".join(b"\0" + bytes(index[pixel[:3]] for pixel in row) for row in rows)
    return png_of(width, height, INDEXED, lines, bytes(value for colour in palette for value in colour))


def small_png(width, height, rows):
    """The file of a picture; rows of tuples of which the first three are red, green and blue."""
    picture = with_all_colours(width, height, rows)
    return picture if len(picture) <= ENOUGH else with_few_colours(width, height, rows)
