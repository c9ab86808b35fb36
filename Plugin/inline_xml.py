#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes VTK's XML files readable again where they are "not well-formed" or come out empty.

inline_xml.py <file> [<inline file>]

VTK may keep all arrays of an XML file (.vtu, .vtp, .vti, ...) behind the XML proper, "appended". The
parsers of VTK before 9.3 take a wrong turn there with the expat of 2024 and later, which security
updates brought to older systems, too (Debian 12). In the inline file each array stands in its own
element: the same bytes, a third more room than raw ones take, read by every VTK. Without a second
name the file itself is replaced. Needs nothing but Python.
"""

import base64
import os
import re
import struct
import sys

ARRAY = re.compile(rb'<(DataArray|Array)\b[^>]*\bformat="appended"[^>]*>')


class Appended:
    """What stands behind the XML: arrays at offsets, each with a header of its sizes."""

    def __init__(self, root, encoding, text):
        self.is_raw = encoding == b"raw"
        self.text = text
        order = ">" if attribute(root, b"byte_order") == b"BigEndian" else "<"
        self.word = struct.Struct(order + ("Q" if attribute(root, b"header_type") == b"UInt64" else "I"))
        self.is_compressed = attribute(root, b"compressor") is not None

    def words(self, offset, number):
        """The first numbers of what is at an offset."""
        size = number * self.word.size
        data = (self.text[offset:offset + size] if self.is_raw else base64.b64decode(
            self.text[offset:offset + encoded_size(size)]))
        return [value for (value, ) in self.word.iter_unpack(data[:size])]

    def sizes(self, offset):
        """How many bytes the parts have that are encoded one by one."""
        first = self.words(offset, 1)[0]
        if not self.is_compressed:
            return [self.word.size + first]
        number = 3 + first # of blocks, the size of one, the size of the last, then each compressed
        return [number * self.word.size, sum(self.words(offset, number)[3:])]

    def inline(self, offset):
        """An array as it stands in an element of its own."""
        if not self.is_raw:
            return self.text[offset:offset + sum(map(encoded_size, self.sizes(offset)))]
        parts = []
        for size in self.sizes(offset):
            parts.append(base64.b64encode(self.text[offset:offset + size]))
            offset += size
        return b"".join(parts)


def encoded_size(size):
    return (size + 2) // 3 * 4


def attribute(element, name):
    found = re.search(rb"\b" + name + rb'="([^"]*)"', element)
    return found and found.group(1)


def inlined(text):
    """The same file with nothing appended; `text` itself if nothing is."""
    start = re.search(rb'<AppendedData\b[^>]*>\s*_', text)
    if not start:
        return text
    head = text[:start.start()]
    root = re.search(rb"<VTKFile\b[^>]*>", head).group()
    appended = Appended(root, attribute(start.group(), b"encoding"), text[start.end():])

    def replaced(element):
        tag = element.group()
        data = appended.inline(int(attribute(tag, b"offset")))
        tag = tag.replace(b'format="appended"', b'format="binary"')
        tag = re.sub(rb'\s*\boffset="[^"]*"', b"", tag)
        if tag.endswith(b"/>"):
            return tag[:-2].rstrip() + b">\n" + data + b"\n</" + element.group(1) + b">"
        return tag + b"\n" + data + b"\n"

    return ARRAY.sub(replaced, head).rstrip() + b"\n</VTKFile>\n"


def main(file, result=None):
    with open(file, "rb") as stream:
        text = inlined(stream.read())
    result = result or file
    # Whoever reads the file meanwhile finds the old one or the new one, whole.
    temporary = f"{result}.{os.getpid()}"
    with open(temporary, "wb") as stream:
        stream.write(text)
    os.replace(temporary, result)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
