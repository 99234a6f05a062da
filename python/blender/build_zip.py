"""Zips the add-on with the package `lancret` and its library, to be installed in Blender.

Usage: python3 build_zip.py LIBRARY ZIP
"""

import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ADDON = HERE / "lancret_blender"
PACKAGE = HERE.parent / "lancret"
FIRST_DATE = (1980, 1, 1, 0, 0, 0)  # fixed, so that equal contents give equal bytes


def contents(library):
    for folder, name in ((ADDON, ADDON.name), (PACKAGE, f"{ADDON.name}/lancret")):
        for file in sorted(folder.rglob("*")):
            inside = file.relative_to(folder)
            if (
                file.is_file()
                and "__pycache__" not in inside.parts
                and file.suffix != ".so"
            ):
                yield f"{name}/{inside.as_posix()}", file
    yield f"{ADDON.name}/lancret/liblancret_procedural.so", library


def main():
    library, target = map(Path, sys.argv[1:])
    target.parent.mkdir(parents=True, exist_ok=True)
    beside = target.with_name(f".{target.name}.tmp")
    with zipfile.ZipFile(beside, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, file in contents(library.resolve()):
            archive.writestr(
                zipfile.ZipInfo(name, FIRST_DATE), file.read_bytes(), zipfile.ZIP_DEFLATED
            )
    beside.replace(target)
    print(target)


if __name__ == "__main__":
    main()
