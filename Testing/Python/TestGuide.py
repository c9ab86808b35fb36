# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The user guide: what its pages say of properties and arrays is so, links and pictures are there, the
recipes for pvpython run, and ParaView's help is made from it.

What the pages tell readers to type elsewhere, Testing/Install/readme.py runs.
"""

import glob
import os
import re
import sqlite3
import sys
import zlib

from paraview import servermanager, simple

import skdtesting

FOLDER = os.path.join(skdtesting.SOURCE_DIR, "Plugin", "Documentation")
sys.path.insert(0, FOLDER)
import pages  # noqa: E402

RUN_UPDATE = "run: python3 Plugin/Documentation/pages.py --update"
RUN_NEW = "run: python3 Plugin/Documentation/pages.py --new %s, and write what is missing"


def page_of(name):
    return pages.read(os.path.join(FOLDER, name + ".md"))


def guide():
    return {os.path.basename(path): pages.read(path) for path in pages.page_files()}


def snippets(text):
    return re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def prose(text):
    """A page without code."""
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S))


def anchors(text):
    return {pages.anchor_of(title) for title in re.findall(r"^#+ (.*)$", text, re.MULTILINE)}


def test_pages_say_what_the_xml_says():
    known = pages.proxies()
    for name, text in guide().items():
        assert pages.updated(text, known) == text, name + " is out of date, " + RUN_UPDATE


def sections_of(text):
    """{title: what is below it}"""
    parts = re.split(r"^## (.*)$", text, flags=re.MULTILINE)
    return dict(zip(parts[1::2], map(str.strip, parts[2::2])))


def test_every_proxy_has_a_page_with_all_sections():
    contents = page_of("README")
    for _, proxy in skdtesting.our_proxies():
        name = proxy.get("name")
        assert name + ".md" in guide(), RUN_NEW % name
        text = page_of(name)
        assert text.startswith("# %s\n" % proxy.get("label")), name
        sections = sections_of(text)
        assert [title for title in sections if title in pages.SECTIONS] == pages.SECTIONS, RUN_NEW % name
        empty = [title for title in sections if not sections[title]]
        assert not empty, (name, "these sections are empty", empty)
        for kind in ("description", "properties"):
            assert "<!-- %s: %s -->" % (name, kind) in text
        assert "](%s.md)" % name in contents, RUN_NEW % name


def test_a_new_page_has_what_the_xml_says():
    contents = "# Guide\n\n| [SkdTree A](SkdTreeA.md) | a |\n| [Building](Building.md) | b |\n"
    for _, proxy in skdtesting.our_proxies():
        begun, sections = sections_of(pages.begun(proxy)), sections_of(page_of(proxy.get("name")))
        assert list(begun) == pages.SECTIONS
        assert begun["Properties"] in sections["Properties"], proxy.get("name")
        assert pages.text_of(proxy) in begun["What it answers"]
        longer = pages.with_row(contents, proxy)
        assert longer.splitlines()[3].startswith("| [%s](" % proxy.get("label")), longer
        assert pages.with_row(longer, proxy) == longer


def shown_default(prop, element):
    """The default of a live property, as the pages write it."""
    if element.tag == "InputProperty":
        return "none" if element.get("null_on_empty") == "1" else "required"
    values = [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]
    domain = prop.FindDomain("vtkSMEnumerationDomain") or prop.FindDomain("vtkSMBooleanDomain")
    if prop.FindDomain("vtkSMBooleanDomain"):
        return "on" if values == [1] else "off"
    if domain:
        texts = {domain.GetEntryValue(i): domain.GetEntryText(i)
            for i in range(domain.GetNumberOfEntries())}
        return texts[values[0]]
    return values


def same_default(written, live):
    if isinstance(live, str):
        return written == live
    if written == "none":
        return live in ([], [""])
    return [float(word) for word in written.split()] == [float(value) for value in live]


def test_properties_are_those_of_the_proxies():
    manager = servermanager.ProxyManager()
    for group, proxy in skdtesting.our_proxies():
        made = manager.NewProxy(group, proxy.get("name"))
        table = page_of(proxy.get("name")).split("properties -->\n")[1].split("<!--")[0]
        rows = re.findall(r"^\| \*\*(.*?)\*\*(?:, advanced)? \| (.*?) \| .+ \|$", table, re.M)
        assert len(rows) == table.count("\n") - 2, table
        elements = {e.get("label"): e for e in skdtesting.properties_of(proxy)}
        assert [label for label, _ in rows] == list(elements), proxy.get("name")
        for label, written in rows:
            prop = made.GetProperty(label.replace(" ", ""))
            assert prop is not None and prop.GetXMLLabel() == label, label
            live = shown_default(prop, elements[label])
            assert same_default(written, live), (proxy.get("name"), label, written, live)


def test_links_and_pictures_are_there():
    texts = guide()
    texts["../../README.md"] = pages.read(os.path.join(skdtesting.SOURCE_DIR, "README.md"))
    for name, text in texts.items():
        folder = os.path.dirname(os.path.join(FOLDER, name))
        for mark, link in re.findall(r"(!?)\[[^\]]*\]\(([^)\s]+)\)", prose(text)):
            file, _, anchor = link.partition("#")
            path = os.path.join(folder, file) if file else os.path.join(FOLDER, name)
            assert "://" in link or os.path.exists(path), (name, link)
            assert not anchor or anchor in anchors(pages.read(path)), (name, link)
            assert not mark or os.path.getsize(path) < 150000, (name, link)
        for example in re.findall(r"`(Plugin/Examples/\w+\.py)`", text):
            assert os.path.exists(os.path.join(skdtesting.SOURCE_DIR, example)), (name, example)


def information_of(source, port):
    information = source.SMProxy.GetOutputPort(port).GetDataInformation()
    return [information.GetPointDataInformation(), information.GetCellDataInformation(),
        information.GetRowDataInformation(), information.GetFieldDataInformation()]


def arrays_of(source):
    """The names of what a filter of ours adds to any of its outputs."""
    for port in range(source.SMProxy.GetNumberOfOutputPorts()):
        simple.UpdatePipeline(proxy=simple.OutputPort(source, port))
        for data in information_of(source, port):
            for i in range(data.GetNumberOfArrays()):
                name = data.GetArrayInformation(i).GetName()
                if name.startswith("Skd"):
                    yield name


def filters_among(values, name):
    return [value for value in values
        if type(value).__name__ == name and value.Port == 0]


def test_recipes_run_and_pages_name_their_arrays():
    folder = os.getcwd()
    os.chdir(skdtesting.SOURCE_DIR)
    reports = page_of("ReportsAndWarnings")
    for name, text in guide().items():
        for code in snippets(text):
            if "paraview" not in code:
                continue
            names = {}
            exec(compile(code, name, "exec"), names)
            ours = filters_among(names.values(), os.path.splitext(name)[0])
            assert len(ours) == 1 or "CellLocator" in name, name
            for array in set(arrays_of(ours[0])) if ours else ():
                if array.startswith("SkdValid_"):
                    assert "SkdValid_" in reports # of any array
                elif array.startswith("SkdReport"):
                    assert re.search(r"\b%s\b" % array[9:], reports), (name, array)
                else:
                    assert "**%s**" % array in text, (name, array, "is to be named in bold")
    os.chdir(folder)


def test_messages_are_those_of_the_sources():
    sources = "".join(pages.read(path) for path in glob.glob(
        os.path.join(skdtesting.SOURCE_DIR, "Filters", "**", "*.*"), recursive=True)
        if path.endswith((".cxx", ".h")))
    sources = re.sub(r'"\s+"', "", sources)  # literals that go on in the next line
    table = page_of("ReportsAndWarnings").split("| message |")[1]
    messages = re.findall(r"^\| `(.*?)` \|", table, re.MULTILINE)
    assert len(messages) > 10
    for message in messages:
        for part in re.split(r"\b[NX]\b", message):
            assert part.strip(' "') in sources, (message, part)


def test_help_has_the_pages():
    folder = skdtesting.temporary("help")
    pages.write_html(folder)
    made = {os.path.basename(path): pages.read(path)
        for path in glob.glob(os.path.join(folder, "*.html"))}
    assert len(made) == len(guide())
    for group, proxy in skdtesting.our_proxies():
        # What ParaView makes of the XML has this name, too: the page takes its place.
        made_by_paraview = "%s.%s.html" % (group.replace("_", "_u"), proxy.get("name"))
        assert "When to use it" in made[made_by_paraview]
    for name, text in made.items():
        shown = re.sub(r"<(pre|code)>.*?</\1>", "", text, flags=re.DOTALL)
        assert "**" not in shown and "](" not in shown and "`" not in shown, name
        for link in re.findall(r'(?:href|src)="([^"#:]+)(?:#[^"]*)?"', text):
            assert os.path.exists(os.path.join(folder, link)), (name, link)


def test_help_of_the_plugin_has_them():
    collection = os.path.join(
        skdtesting.TEMPORARY_DIR, os.pardir, os.pardir, "Plugin", "paraview_help", "SkdTree.qch")
    if not os.path.exists(collection):
        return  # built without Qt
    rows = sqlite3.connect(collection).execute(
        "select Data from FileDataTable join FileNameTable on FileId = Id where Name = ?",
        ("filters.SkdTreeProbe.html", )).fetchall()
    assert len(rows) == 1
    assert b"When to use it" in zlib.decompress(rows[0][0][4:])  # four bytes have the size


skdtesting.run_tests(globals())
