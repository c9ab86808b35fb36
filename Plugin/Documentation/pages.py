# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the user guide, and ParaView's help made from them.

    python3 pages.py --update         writes what the proxies' XML says into the pages
    python3 pages.py --new SkdTreeX   writes the headings of the page of a new filter, and its row in
                                      the list of pages
    python3 pages.py --html <folder>  writes the pages as HTML, for ParaView's help

Descriptions of filters and properties are written once, in Plugin/XML: a page holds a copy of them
between two comments,
    <!-- SkdTreeAMR: description -->  and  <!-- SkdTreeAMR: properties -->  ...  <!-- end -->
and a test compares both. In ParaView's help the page of a filter takes the place of the one that
ParaView makes from the XML alone.
"""

import filecmp
import glob
import html
import os
import re
import shutil
import sys
import textwrap
import xml.etree.ElementTree

FOLDER = os.path.dirname(os.path.abspath(__file__))
XML_FOLDER = os.path.join(FOLDER, os.pardir, "XML")
SECTIONS = ["What it answers", "When to use it", "Properties", "Accuracy and cost", "Limits",
    "In the window", "In pvpython"]
BLOCK = re.compile(r"(<!-- (\w+): (\w+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)


# What the XML says


def proxies():
    """{name: (group, element)} of all proxies of the plugin."""
    found = {}
    for file in sorted(glob.glob(os.path.join(XML_FOLDER, "*.xml"))):
        for group in xml.etree.ElementTree.parse(file).getroot().iter("ProxyGroup"):
            for proxy in group:
                found[proxy.get("name")] = (group.get("name"), proxy)
    return found


def text_of(element):
    return textwrap.dedent(element.find("Documentation").text).strip()


def default_of(element):
    """The default as the window shows it."""
    default = element.get("default_values")
    if element.tag == "InputProperty":
        return "none" if element.get("null_on_empty") == "1" else "required"
    for entry in element.iter("Entry"):
        if entry.get("value") == default:
            return entry.get("text")
    if element.find("BooleanDomain") is not None:
        return "on" if default == "1" else "off"
    return default or "none"


def row(element):
    meaning = " ".join(text_of(element).split()).replace("|", "\\|")
    values = ["*%s*" % entry.get("text") for entry in element.iter("Entry")]
    if values:
        meaning += " (" + ", ".join(values) + ")"
    advanced = ", advanced" if element.get("panel_visibility") == "advanced" else ""
    return "| **%s**%s | %s | %s |" % (
        element.get("label"), advanced, default_of(element), meaning)


def properties_of(proxy):
    return [element for element in proxy
        if element.tag.endswith("Property") and element.get("information_only") != "1"]


def generated(proxy, kind):
    if kind == "description":
        return text_of(proxy) + "\n"
    rows = ["| property | default | meaning |", "| --- | --- | --- |"]
    return "\n".join(rows + [row(element) for element in properties_of(proxy)]) + "\n"


# Pages


def page_files():
    return sorted(glob.glob(os.path.join(FOLDER, "*.md")))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    """Writes a file, and says so, if that changes it."""
    if not os.path.exists(path) or read(path) != text:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        print("wrote", os.path.basename(path))


def updated(text, known):
    """The text of a page with what the XML says today."""
    return BLOCK.sub(
        lambda match: match[1] + generated(known[match[2]][1], match[3]) + match[5], text)


def update():
    known = proxies()
    for path in page_files():
        write(path, updated(read(path), known))


# A new page


def begun(proxy):
    """The page of a proxy before anything is written but its XML."""
    name = proxy.get("name")
    blocks = {"What it answers": "description", "Properties": "properties"}
    text = "# %s\n" % proxy.get("label")
    for title in SECTIONS:
        text += "\n## %s\n" % title
        if title in blocks:
            text += "\n<!-- %s: %s -->\n<!-- end -->\n" % (name, blocks[title])
    return updated(text, {name: (None, proxy)})


def with_row(text, proxy):
    """The list of pages with a row for a proxy, after those of the filters."""
    link = "[%s](%s.md)" % (proxy.get("label"), proxy.get("name"))
    subject = proxy.find("Documentation").get("short_help").rstrip(".")
    rows = list(re.finditer(r"^\| \[SkdTree .*\n", text, re.MULTILINE))
    if link in text:
        return text
    row = "| %s | %s |\n" % (link, subject[:1].lower() + subject[1:])
    return text[:rows[-1].end()] + row + text[rows[-1].end():]


def begin(name):
    proxy = proxies()[name][1]
    path = os.path.join(FOLDER, name + ".md")
    if not os.path.exists(path):
        write(path, begun(proxy))
    contents = os.path.join(FOLDER, "README.md")
    write(contents, with_row(read(contents), proxy))


# HTML, of as much Markdown as the pages use


def target(link, names):
    """Where a link of a page leads in the help; None if it is not there."""
    if "://" in link or link.startswith("#"):
        return link
    file, mark, anchor = link.partition("#")
    return names[file] + mark + anchor if file in names else None


def anchor_of(title):
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")


def inline(text, names):
    codes = []

    def keep(match):
        codes.append("<code>%s</code>" % html.escape(match[1]))
        return "\0%d\0" % (len(codes) - 1)

    def link(match):
        where = target(match[2], names)
        return '<a href="%s">%s</a>' % (where, match[1]) if where else match[1]

    text = html.escape(re.sub(r"`([^`]+)`", keep, text), quote=False).replace("\\|", "|")
    text = re.sub(r"!\[([^\]]*)\]\(([^)]+)\)", r'<img src="\2" alt="\1">', text)
    text = re.sub(r"\[([^\]]+)\]\(([^)]+)\)", link, text)
    text = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", text)
    text = re.sub(r"(?<![\w*])\*([^*]+?)\*(?![\w*])", r"<i>\1</i>", text)
    return re.sub("\0(\\d+)\0", lambda match: codes[int(match[1])], text)


def table(lines, names):
    rows = [re.split(r"(?<!\\)\|", line.strip().strip("|")) for line in lines]
    made = []
    for number, cells in enumerate(rows):
        if number != 1:
            tag = "th" if number == 0 else "td"
            made.append("<tr>%s</tr>" % "".join(
                "<%s>%s</%s>" % (tag, inline(cell.strip(), names), tag) for cell in cells))
    return '<table border="1" cellpadding="4" cellspacing="0">\n%s\n</table>' % "\n".join(made)


def items(lines, names):
    """A list: an item begins with a dash or a number, and goes on where lines are indented."""
    tag = "ul" if lines[0].startswith("- ") else "ol"
    found = re.split(r"^(?:- |\d+\. )", "\n".join(lines), flags=re.MULTILINE)[1:]
    return "<%s>\n%s\n</%s>" % (tag, "\n".join(
        "<li>%s</li>" % inline(" ".join(item.split()), names) for item in found), tag)


def block(text, names):
    lines = text.split("\n")
    heading = re.match(r"(#+) (.*)", text)
    if heading:
        level = len(heading[1])
        return '<h%d><a name="%s"></a>%s</h%d>' % (
            level, anchor_of(heading[2]), inline(heading[2], names), level)
    if text.startswith("```"):
        return "<pre>%s</pre>" % html.escape("\n".join(lines[1:-1]))
    if text.startswith("|"):
        return table(lines, names)
    if re.match(r"(- |\d+\. )", text):
        return items(lines, names)
    return "<p>%s</p>" % inline(" ".join(lines), names)


def blocks(text):
    """Parts between empty lines, code as one part each."""
    for part in re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL):
        if part.startswith("```"):
            yield part
        else:
            yield from (some.strip("\n") for some in re.split(r"\n\s*\n", part) if some.strip())


def to_html(text, names):
    text = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    title = re.match(r"# (.*)", text)[1]
    body = "\n".join(block(part, names) for part in blocks(text))
    return ("<html><head><title>%s</title>\n<meta charset=\"utf-8\"></head>\n<body>\n%s\n</body>"
        "</html>\n" % (html.escape(title), body))


def help_name(page, known):
    """The name of a page in the help: of a proxy, what ParaView looks for."""
    name = os.path.splitext(os.path.basename(page))[0]
    if name == "README":
        return "index.html"
    group = known[name][0].replace("_", "_u") if name in known else "guide"
    return "%s.%s.html" % (group, name)


def copy(picture, path):
    if not os.path.exists(path) or not filecmp.cmp(picture, path, shallow=False):
        shutil.copyfile(picture, path)
        print("wrote", os.path.basename(path))


def write_html(folder):
    known = proxies()
    names = {os.path.basename(page): help_name(page, known) for page in page_files()}
    os.makedirs(folder, exist_ok=True)
    for page in page_files():
        text = updated(read(page), known)
        write(os.path.join(folder, names[os.path.basename(page)]), to_html(text, names))
        for picture in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text):
            copy(os.path.join(FOLDER, picture), os.path.join(folder, picture))


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        update()
    elif sys.argv[1:2] == ["--new"] and len(sys.argv) == 3:
        begin(sys.argv[2])
    elif sys.argv[1:2] == ["--html"] and len(sys.argv) == 3:
        write_html(sys.argv[2])
    else:
        sys.exit(__doc__)
