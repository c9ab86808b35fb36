# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs clang-tidy with the repository's .clang-tidy over Filters:

    python lint.py <root> <build> [<clang-tidy>]

Reads <build>/compile_commands.json, prints "file:line:column: warning: ... [check]" and returns 1 if
there is anything to print.

Most of what clang-tidy takes goes into VTK's headers, which it reads and searches again for every
source: 6 s each, 15 minutes of processor time. So sources are compiled in a few groups, each a
generated source that includes some twenty; those that give the same name to something of their own
are kept apart, and a group that does not compile is halved until each part does. That takes 2
minutes of processor time, shared by all processors. All headers together are one more group, for
those that no source includes. The static analyzer (clang-analyzer-*) is left to editors: it takes
as much again.

A group that passed is not checked again while its sources, the headers that they include and the
configuration are as they were: a file in <build>/lint, named by their hash, says so.
"""
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

import check_layout
import source_groups

NUMBER_OF_GROUPS, GROUP_SIZE = 8, 12
CHECKS = "-clang-analyzer-*,-bugprone-suspicious-include"  # groups include sources, on purpose
WARNING = re.compile(r"^(/.*?):(\d+:\d+: (?:warning|error): .*)$", re.M)


def read_sources(path):
    """The path, or the paths of the sources that it puts together (SkdTreeUnity.cmake)."""
    if path.parent.name != "Unity" or not path.is_file():
        return [path]
    return list(map(pathlib.Path, re.findall(r'^#include "(.*)"', path.read_text(encoding="utf8"), re.M)))


def read_flags(root, build):
    """{path of a source below Filters: the flags that decide how it is read}."""
    flags = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf8")):
        path = (pathlib.Path(entry["directory"]) / entry["file"]).resolve()
        sources = [each for each in read_sources(path)
            if root / "Filters" in each.parents and each.is_file()]
        if not sources:
            continue  # another's source, or one that was there when the build was configured
        words, kept = shlex.split(entry["command"]), []
        for word, following in zip(words, words[1:] + [""]):
            if word in ("-I", "-isystem", "-D"):
                kept += [word, following]
            elif re.match(r"-(I|isystem|D|U|std=|m)\S", word):
                kept.append(word)
        flags.update(dict.fromkeys(sources, tuple(kept)))
    return flags


def group(flags):
    """Lists of sources of the same flags without a common name, of about equal sizes. Sources of public
    classes use the namespace that the others are in, so their own names would be ambiguous beside those."""
    groups = []
    kinds = {path: (flags[path], path.parent.name == "Filters") for path in flags}
    number = collections.Counter(kinds.values())
    for path in sorted(flags):
        text = path.read_text(encoding="utf8")
        names = source_groups.read_own_names(text)
        kind = kinds[path]
        fitting = [each for each in groups if each["kind"] == kind and not each["names"] & names]
        same = sum(each["kind"] == kind for each in groups)
        if not fitting or same < min(NUMBER_OF_GROUPS, number[kind] // GROUP_SIZE):
            fitting = [{"kind": kind, "names": set(), "size": 0, "sources": []}]
            groups += fitting
        smallest = min(fitting, key=lambda each: each["size"])
        smallest["names"] |= names
        smallest["size"] += len(text)
        smallest["sources"].append(path)
    return [(each["sources"], each["kind"][0]) for each in groups]


class Lint:
    def __init__(self, root, build, command):
        self.root, self.folder, self.command = root, build / "lint", command
        self.folder.mkdir(exist_ok=True)
        version = subprocess.run([command, "--version"], check=True, capture_output=True, text=True)
        self.configuration = version.stdout + CHECKS + \
            (root / ".clang-tidy").read_text(encoding="utf8")
        names = {path.relative_to(root / "Filters").as_posix()
            for path in (root / "Filters").rglob("*") if path.suffix in (".h", ".cxx")}
        self.includes = check_layout.read_includes(root / "Filters", names)
        self.headers = [root / "Filters" / name for name in sorted(names) if name.endswith(".h")]

    def hash(self, sources, flags):
        """Of all that decides what clang-tidy says of these."""
        open_, seen = [path.relative_to(self.root / "Filters").as_posix() for path in sources], set()
        while open_:
            name = open_.pop()
            if name not in seen:
                seen.add(name)
                open_ += [target for _, _, target in self.includes[name] if target]
        texts = [self.configuration, str(self.root), *flags]
        for name in sorted(seen):
            texts += [name, (self.root / "Filters" / name).read_text(encoding="utf8")]
        return hashlib.sha256("\0".join(texts).encode()).hexdigest()

    def check(self, sources, flags):
        """The lines that clang-tidy prints of these, each with what follows it."""
        stamp = self.folder / (self.hash(sources, flags) + ".passed")
        if stamp.exists():
            return []
        file = stamp.with_suffix(".cxx")
        file.write_text("".join('#include "%s"\n' % path for path in sources), encoding="utf8")
        run = subprocess.run([self.command, "--quiet", "--config-file=%s" % (self.root / ".clang-tidy"),
            "--checks=" + CHECKS, str(file), "--", *flags], capture_output=True, text=True)
        file.unlink()
        if "[clang-diagnostic-error]" in run.stdout and len(sources) > 1:
            middle = len(sources) // 2
            return self.check(sources[:middle], flags) + self.check(sources[middle:], flags)
        found = ["%s:%s" % (os.path.relpath(os.path.realpath(path), self.root), told)
            for path, told in WARNING.findall(run.stdout)]
        if run.returncode != 0 and not found:
            found = [run.stdout + run.stderr]
        if not found:
            stamp.touch()
        return found


def main():
    root, build = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    lint = Lint(root, build, sys.argv[3] if len(sys.argv) > 3 else "clang-tidy")
    flags = read_flags(root, build)
    work = group(flags)
    if lint.headers and work:
        usual = max(set(flags.values()), key=list(flags.values()).count)
        work.append((lint.headers, usual))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = set(sum(pool.map(lambda each: lint.check(*each), work), []))
    print("\n".join(sorted(found)) if found else "%d sources pass" % len(flags))
    return 1 if found or not flags else 0


if __name__ == "__main__":
    sys.exit(main())
