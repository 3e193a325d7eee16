"""
Makes the page that explains every public name of the language, from the documentation in its source.

In: `rosy-hs/src`, through Haddock (it comes with GHC); the page's colours and fonts. Out: a folder that the service serves under `/api-docs/`:
`Rosy.html` (all that a program may use) and `Rosy-Model.html` (what a program means). Every name has Haddock's own anchor: `Rosy.html#v:wait`,
`Rosy.html#t:Velocity`. What a learner has no use for (lists of instances, Haddock's scripts, a formula renderer from elsewhere) is left out.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from html import escape
from html.parser import HTMLParser
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCE = ROOT / "rosy-hs" / "src"
STYLES = [ROOT / "editor" / "src" / "styles" / "tokens.css", ROOT / "scripts" / "api_docs.css"]
FONTS = {
    "inter-400.woff2": "inter/files/inter-latin-400-normal.woff2",
    "inter-600.woff2": "inter/files/inter-latin-600-normal.woff2",
    "mono-400.woff2": "jetbrains-mono/files/jetbrains-mono-latin-400-normal.woff2",
}

# What is shown, with its title. All other modules are hidden: Haddock then explains their names where a shown one exports them.
PAGES = {"Rosy": "All the words of Rosy", "Rosy.Model": "What a program means"}

PLACES = {"", *(module.replace(".", "-") + ".html" for module in PAGES)}
"""Where a link may lead, beside another place of its own page."""

LEFT_OUT = {"instances", "selflink", "info", "synopsis", "fixity"}
"""Classes and ids of Haddock's that are left out."""

VOID = {"br", "hr", "img", "input", "link", "meta"}

# A file of its own: the service's Content Security Policy allows no script inside of a page.
SCRIPT = 'if (matchMedia("(prefers-color-scheme: dark)").matches) document.documentElement.dataset.theme = "dark"\n'

SHELL = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} · Rosy</title>
<link rel="stylesheet" href="api-docs.css">
<script src="api-docs.js"></script>
</head>
<body>
<header><h1>{title}</h1><nav>{links}</nav></header>
{content}
</body>
</html>
"""


class Content(HTMLParser):
    """The part of one of Haddock's pages that is worth reading, and where its links lead."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=False)
        self.text: list[str] = []
        self.anchors: set[str] = set()
        self.links: set[str] = set()
        # The tags that are open, each with whether what is inside is kept.
        self.open: list[tuple[str, bool]] = []

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        facts = {name: value or "" for name, value in attributes}
        names = {facts.get("id", ""), *facts.get("class", "").split()}
        keep = (self._kept() or facts.get("id") == "content") and tag != "script" and not names & LEFT_OUT
        if tag not in VOID:
            self.open.append((tag, keep))
        if not keep:
            return
        # A module that is not shown keeps its name and loses the link.
        if (target := facts.get("href")) is not None:
            if target.partition("#")[0] in PLACES:
                self.links.add(target)
            else:
                del facts["href"]
        if "id" in facts:
            self.anchors.add(facts["id"])
        shown = "".join(f' {name}="{escape(value)}"' for name, value in facts.items() if name in {"id", "class", "href", "colspan"})
        self.text.append(f"<{tag}{shown}>")

    def handle_endtag(self, tag: str) -> None:
        if tag in VOID or not self.open:
            return
        _, keep = self.open.pop()
        if keep:
            self.text.append(f"</{tag}>")

    def handle_data(self, data: str) -> None:
        if self._kept():
            self.text.append(data)

    def handle_entityref(self, name: str) -> None:
        self.handle_data(f"&{name};")

    def handle_charref(self, name: str) -> None:
        self.handle_data(f"&#{name};")

    def _kept(self) -> bool:
        return bool(self.open) and self.open[-1][1]


def haddock(into: Path) -> None:
    """Haddock's own pages."""
    files = sorted(SOURCE.rglob("*.hs"))
    modules = [".".join(file.relative_to(SOURCE).with_suffix("").parts) for file in files]
    hidden = [f"--hide={module}" for module in modules if module not in PAGES]
    options = ["--html", "--no-warnings", f"--odir={into}", f"--optghc=-i{SOURCE}", "--optghc=-w", *hidden]
    subprocess.run(["haddock", *options, *map(str, files)], check=True)


def page_name(module: str) -> str:
    return module.replace(".", "-") + ".html"


def dead_links(pages: dict[str, Content]) -> list[str]:
    """Links that lead to no anchor of these pages."""
    dead = []
    for name, page in pages.items():
        for link in sorted(page.links):
            file, _, anchor = link.partition("#")
            target = pages[file or name]
            if anchor and anchor not in target.anchors:
                dead.append(f"{name}: {link}")
    return dead


def main() -> int:
    target = Path(sys.argv[1])
    pages: dict[str, Content] = {}
    with tempfile.TemporaryDirectory() as folder:
        haddock(Path(folder))
        for module in PAGES:
            pages[page_name(module)] = page = Content()
            page.feed((Path(folder) / page_name(module)).read_text())
    if dead := dead_links(pages):
        print("api_docs: these links lead nowhere:", *dead, sep="\n  ", file=sys.stderr)
        return 1
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    for module, title in PAGES.items():
        links = " ".join(f'<a href="{page_name(other)}">{name}</a>' for other, name in PAGES.items() if other != module)
        # A mark of strictness says nothing to a learner.
        content = re.sub(r"(?<=[ >])!(?=[A-Z(<])", "", "".join(pages[page_name(module)].text))
        (target / page_name(module)).write_text(SHELL.format(title=title, links=links, content=content))
    shutil.copy(target / page_name("Rosy"), target / "index.html")
    (target / "api-docs.js").write_text(SCRIPT)
    (target / "api-docs.css").write_text("\n".join(style.read_text() for style in STYLES))
    for name, where in FONTS.items():
        shutil.copy(ROOT / "node_modules" / "@fontsource" / where, target / name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
