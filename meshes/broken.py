"""Files that are no mesh: (name, bytes, line of the first fault or None where it has none, words)."""

import formats
import shapes

TRIANGLE = ["Vertex 1 0 0 0", "Vertex 2 1 0 0", "Vertex 3 0 1 0", "Face 1 1 2 3"]


def with_line(number, line):
    lines = list(TRIANGLE)
    lines[number - 1] = line
    return formats.text(lines)


def all_broken():
    cube = shapes.cube()
    yield "wrong_keyword.mesh", with_line(3, "Corner 3 0 1 0"), 3, "`Corner` is neither Vertex nor Face."
    yield "nan.mesh", with_line(2, "Vertex 2 nan 0 0"), 2, "A coordinate is NaN."
    yield "infinite.mesh", with_line(2, "Vertex 2 1 -inf 0"), 2, "A coordinate is infinite."
    yield "too_large.mesh", with_line(2, "Vertex 2 1e999 0 0"), 2, "A coordinate is larger than a double can be."
    yield "missing_coordinate.mesh", with_line(2, "Vertex 2 1 0"), 2, "A coordinate is missing."
    yield "word_for_number.mesh", with_line(3, "Vertex 3 0 one 0"), 3, "A coordinate is a word."
    yield "face_of_two.mesh", with_line(4, "Face 1 1 2"), 4, "A face of two corners."
    yield "fractional_index.mesh", with_line(4, "Face 1 1 2 3.5"), 4, "A vertex id is no integer."
    yield "index_zero.mesh", with_line(4, "Face 1 0 2 3"), 4, "Ids are larger than zero."
    yield "empty.mesh", b"", None, "Nothing at all."
    yield "index_zero.obj", formats.text(["v 0 0 0", "v 1 0 0", "v 0 1 0", "f 0 1 2"]), 4, "OBJ counts from 1."
    yield ("huge_count.off", formats.text(["OFF", "4000000000 1 0", "0 0 0", "3 0 0 0"]), None,
           "The header claims more vertices than the file has bytes: no memory may be taken for them.")
    yield "negative_count.off", formats.text(["OFF", "-3 1 0", "0 0 0"]), 2, "A negative number of vertices."
    yield "truncated.off", formats.off(cube)[:60], None, "The unit cube, cut off among its vertices."
    yield "truncated_binary.stl", formats.stl_binary(cube)[:300], None, "The unit cube, cut off within face 5."
    yield "huge_count.stl", formats.stl_binary(cube, 0xFFFFFFFF), None, "The header claims 4,294,967,295 faces; 12 follow."
    yield "unfinished.stl", formats.stl_ascii(cube)[:150], None, "The text ends within a facet."
    yield "no_end_of_header.ply", formats.ply(cube)[:120], None, "The header does not end."
    yield "unknown_encoding.ply", formats.ply(cube).replace(b"ascii", b"middle_endian"), 2, "There is no such encoding."
    yield "truncated_little.ply", formats.ply(cube, "binary_little_endian")[:-1], None, "The last byte is missing."
    yield ("huge_count.ply", formats.ply(cube, "binary_big_endian", (8, 4000000000)), None,
           "The header claims four thousand million faces; 12 follow.")
    yield "letter.txt", b"Dear reader,\nthis is no mesh.\n", None, "Plain prose, with a name that tells no format."
