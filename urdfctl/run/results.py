"""Do one job, and encode its result or its failure as JSON: nothing from an untrusted robot is unpickled or run."""

from __future__ import annotations

import json
import os
from collections.abc import Callable

from urdfctl.run.limits import Json, Result, WorkerFailure, stop_clock
from urdfctl.source.budget import OUT_OF_MEMORY, OverBudget


def encoded_result(job: Json, function: Callable[[Json], Json]) -> bytes:
    """Return the job's result, or the reason why there is none, as one line of JSON."""
    try:
        text = json.dumps(function(job)).encode()
        stop_clock()
    except OverBudget as error:
        return _failure(str(error), our_fault=False)
    except MemoryError:
        return _failure(OUT_OF_MEMORY, our_fault=False)
    except BaseException as error:  # noqa: BLE001 (the parent reports it, whatever it is)
        stop_clock()
        import traceback

        frame = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{os.path.basename(frame.filename)}:{frame.lineno} in {frame.name}"
        return _failure(f"{type(error).__name__}: {error} ({where})", our_fault=True)
    return text


def decoded_result(text: bytes) -> Result:
    """Return what `encoded_result` was given."""
    result: Json = json.loads(text)
    return WorkerFailure(result["failed"], result["our_fault"]) if "failed" in result else result


def _failure(reason: str, *, our_fault: bool) -> bytes:
    return json.dumps({"failed": reason, "our_fault": our_fault}).encode()
