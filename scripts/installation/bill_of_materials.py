"""
Bill of materials of the packages that are given away: which software of others they hold, as CycloneDX JSON.

Debian packages of the root file system and of the libraries on the stick, Haskell packages, Python packages, and packages of npm that the
page is built from, each with its name, version and package URL.
"""

from __future__ import annotations

import datetime
import json
import re
import subprocess
import tarfile
import uuid
from collections.abc import Iterator, Set
from dataclasses import dataclass
from pathlib import Path

from cyclonedx.model.bom import Bom
from cyclonedx.model.component import Component, ComponentType
from cyclonedx.output import make_outputter
from cyclonedx.schema import OutputFormat, SchemaVersion
from packageurl import PackageURL
from rosy_sim.version import VERSION

from .installed_tree import package_versions

__all__ = ["Part", "bill_of_materials", "debian_parts", "haskell_parts", "npm_parts", "owners_of_libraries", "python_parts"]

_STATUS = "var/lib/dpkg/status"


@dataclass(frozen=True, slots=True, order=True)
class Part:
    """A package of others. ``kind`` and ``namespace`` are those of a package URL (purl-spec, "Known types")."""

    kind: str
    namespace: str
    name: str
    version: str


def bill_of_materials(parts: Set[Part], epoch: int) -> str:
    """CycloneDX 1.6 in JSON. The same parts and the same ``epoch``, in seconds since 1970, give the same text."""
    components = [
        Component(type=ComponentType.LIBRARY, name=part.name, version=part.version, purl=url, bom_ref=url.to_string())
        for part in sorted(parts)
        for url in [PackageURL(part.kind, part.namespace or None, part.name, part.version)]
    ]
    rosy = Component(type=ComponentType.APPLICATION, name="rosy", version=VERSION, bom_ref="rosy")
    number = uuid.uuid5(uuid.NAMESPACE_URL, "\n".join([VERSION, *(str(component.purl) for component in components)]))
    bom = Bom(serial_number=number, components=components)
    bom.metadata.component = rosy
    bom.metadata.timestamp = datetime.datetime.fromtimestamp(epoch, datetime.UTC)
    bom.register_dependency(rosy, components)
    return make_outputter(bom, OutputFormat.JSON, SchemaVersion.V1_6).output_as_string(indent=2) + "\n"


def debian_parts(base: Path, distribution: str) -> Iterator[Part]:
    """Packages that are installed in the archive of a root file system (dpkg-query(1), "status")."""
    with tarfile.open(base) as archive:
        for name in (_STATUS, f"./{_STATUS}"):
            try:
                found = archive.extractfile(name)
            except KeyError:
                continue
            if found is not None:
                for paragraph in found.read().decode().split("\n\n"):
                    fields = dict(re.findall(r"^(Package|Version): (.*)$", paragraph, re.MULTILINE))
                    if len(fields) == 2:
                        yield Part("deb", distribution, fields["Package"], fields["Version"])


def owners_of_libraries(tree: Path, distribution: str) -> Iterator[Part]:
    """Debian packages of this machine that the files of the stick's ``lib`` and ``bin`` were copied from."""
    for file in sorted([*(tree / "lib").glob("*"), *(tree / "bin").glob("*")]):
        done = subprocess.run(["dpkg-query", "--search", f"*/{file.name}"], capture_output=True, text=True, check=False)
        for line in done.stdout.splitlines()[:1]:
            package = line.split(":")[0]
            version = subprocess.run(["dpkg-query", "--show", "-f", "${Version}", package], capture_output=True, text=True, check=False).stdout
            if version:
                yield Part("deb", distribution, package, version)


def haskell_parts(tree: Path) -> Iterator[Part]:
    """Packages that GHC's descriptions on the stick name; Rosy's own are not there."""
    for file in sorted((tree / "ghc/package.conf.d").glob("*.conf")):
        fields = dict(re.findall(r"^(name|version):\s*(\S+)", file.read_text(), re.MULTILINE))
        yield Part("hackage", "", fields["name"], fields["version"])


def python_parts(lock: Path) -> Iterator[Part]:
    """Distributions in a lock file of pip."""
    for name, version in package_versions(lock).items():
        yield Part("pypi", "", name.lower().replace("_", "-"), version)


def npm_parts(lock: Path) -> Iterator[Part]:
    """Packages in a lock file of npm that are no tools of developers and no folders of this project."""
    for place, about in json.loads(lock.read_text())["packages"].items():
        name = place.rpartition("node_modules/")[2]
        if "node_modules/" in place and not (about.get("dev") or about.get("link") or about.get("optional")):
            namespace, _, own = name.rpartition("/")
            yield Part("npm", namespace, own, about["version"])
