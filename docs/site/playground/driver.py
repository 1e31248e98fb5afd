"""What the playground's page asks of urdfctl, in a browser's Python: files in, JSON out."""

import gc
import io
import json
import os
import shutil
import sys
import zipfile

FOLDER = "/home/robot"
MADE = "/home/made"
MOST_BYTES = 20_000_000


def put(files):
    """Replace the files of the project by those of a JavaScript object: texts by their paths."""
    files = files.to_py()
    shutil.rmtree(FOLDER, ignore_errors=True)
    for path, content in files.items():
        place = _inside(path)
        os.makedirs(os.path.dirname(place), exist_ok=True)
        with open(place, "wb") as file:
            file.write(content.encode())


def unpacked(data):
    """Return the texts of a zip file by path. Files that are no text are left out; a bomb is refused."""
    with zipfile.ZipFile(io.BytesIO(data.to_py())) as archive:
        entries = [entry for entry in archive.infolist() if not entry.is_dir()]
        if sum(entry.file_size for entry in entries) > MOST_BYTES:
            raise ValueError("the files of this zip are larger than 20 MB")
        texts = {}
        for entry in entries:
            content = archive.read(entry)
            if b"\0" not in content[:8000]:
                texts[entry.filename] = content.decode("utf-8", "replace")
        return json.dumps(texts)


def run(words):
    """Run a command line, given as an array of words, in the project. Return its status and what it prints, as JSON."""
    from urdfctl.__main__ import run as run_line
    from urdfctl.errors import UserError
    from urdfctl.source.disk.shown import forget_files

    for folder in (FOLDER, MADE):
        os.makedirs(folder, exist_ok=True)
    os.chdir(FOLDER)
    forget_files()
    streams = sys.stdout, sys.stderr
    out, errors = (io.TextIOWrapper(io.BytesIO(), "utf-8", write_through=True) for _ in range(2))
    sys.stdout, sys.stderr = out, errors
    try:
        status = run_line(list(words.to_py()))
    except UserError as error:
        errors.write(f"{error}\n")
        status = 2
    except (RecursionError, MemoryError):
        errors.write("this robot takes more memory than a page has\n")
        status = 2
    except SystemExit as end:
        status = end.code or 0
    finally:
        sys.stdout, sys.stderr = streams
        gc.enable()
    said = [stream.buffer.getvalue().decode("utf-8", "replace") for stream in (out, errors)]
    return json.dumps({"status": status, "out": said[0], "errors": said[1]})


def texts():
    """Return the texts of the project as JSON, after a fix."""
    return json.dumps(_texts_in(FOLDER))


def made():
    """Return what a generator wrote, as JSON, and remove it."""
    written = _texts_in(MADE)
    shutil.rmtree(MADE, ignore_errors=True)
    return json.dumps(written)


def _inside(path):
    place = os.path.normpath(os.path.join(FOLDER, path.lstrip("/")))
    if not place.startswith(FOLDER + "/"):
        raise ValueError(f"'{path}' leads out of the project")
    return place


def _texts_in(folder):
    found = {}
    for where, _, names in os.walk(folder):
        for name in names:
            place = os.path.join(where, name)
            with open(place, "rb") as file:
                found[os.path.relpath(place, folder)] = file.read().decode("utf-8", "replace")
    return found
