"""The pages of the course: their links and pictures are there, and GitHub shows their equations.

usage: pages_test.py LAB
"""

import pathlib
import re
import sys

# Allowed by TeX, but not by GitHub; and numbers of equations that would be set outside of narrow pages.
FORBIDDEN = re.compile(r"\\(operatorname|mbox|phantom|newcommand|def|tag)\b")


def without_code(text):
    blocks = re.compile(r"^```.*?^```$|^ {4}[^\n]*$", re.MULTILINE | re.DOTALL)
    return re.sub(r"`[^`\n]*`", "", blocks.sub("", text))


def equations(text):
    """(TeX, whether within a line)"""
    for block in re.findall(r"^```math\n(.*?)^```$", text, flags=re.MULTILINE | re.DOTALL):
        yield block, False
    for piece in re.findall(r"\$([^$]+)\$", without_code(text)):
        yield piece, True


def local_links(text):
    return [link.split("#")[0] for link in re.findall(r"\]\(([^)\s]+)\)", without_code(text)) if not re.match(r"\w+:|#", link)]


def complaints(page):
    text = page.read_text(encoding="utf-8")
    for link in local_links(text):
        if not (page.parent / link).exists():
            yield f"{page.name}: there is no {link}"
    for tex, is_inline in equations(text):
        if FORBIDDEN.search(tex):
            yield f"{page.name}: GitHub does not show {tex.strip()}"
        # There Markdown takes the backslash for its own.
        if is_inline and re.search(r"\\[^A-Za-z]", tex):
            yield f"{page.name}: GitHub drops a backslash of ${tex}$"


def main():
    lab = pathlib.Path(sys.argv[1])
    pages = sorted(lab.glob("*.md"))
    found = [complaint for page in pages for complaint in complaints(page)]
    shown = {(lab / link).resolve() for page in pages for link in local_links(page.read_text(encoding="utf-8"))}
    found += [f"no page shows {path.name}" for path in sorted((lab / "pictures").iterdir()) if path.resolve() not in shown]
    if len(pages) < 8 or len(shown) < 20:
        found.append("pages or links are missing")
    sys.exit("\n".join(found) or 0)


if __name__ == "__main__":
    main()
