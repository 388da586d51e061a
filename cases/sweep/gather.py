"""Collects the summaries of a study: rows of sweep.csv, one for each variant, and why variants failed. Columns: the varied options,
status, the results of the script (NAME_error where one has an expected value), then every number of the summary's "final"
("final.NAME" where a result has the same name; "run.NAME" where a varied option has it), steps, cpu_seconds, and reason, again where
a variant failed or was tried again.
"""
import csv
import json
import os

from request import read_text, words_of
from study import ended, finished, read_again
from values import SweepError


def read_summary(folder):
    """{} of a run that left none, or was killed."""
    try:
        summary = json.loads(read_text(os.path.join(folder, "summary.json")))
        return summary if isinstance(summary, dict) and summary.get("status") != "running" else {}
    except ValueError:
        return {}


def row_of(summary):
    """{column: number} of one summary, the script's own results first."""
    results, row = summary.get("results") or {}, {}
    for name, entry in results.items():
        row[name] = entry["value"]
        if "error" in entry:
            row[name + "_error"] = entry["error"]
    row.update({("final." + k if k in results else k): v for k, v in (summary.get("final") or {}).items()})
    if summary:
        row["steps"] = summary["counts"]["steps"]
        row["cpu_seconds"] = summary["cpu_seconds"]["total"]
    return row


def why(folder, summary):
    """What a failed variant says: the summary's reason, else the last line of burnish or of anything in its log."""
    if summary.get("reason"):
        return summary["reason"]
    lines = [line.strip() for line in read_text(os.path.join(folder, "log.txt")).splitlines() if line.strip()]
    told = [line for line in lines if line.startswith("burnish:") and "warning" not in line]
    said = (told or lines or ["no log"])[-1]
    return said[len("burnish:"):].strip() if said.startswith("burnish:") else said


def status_of(folder, summary):
    """finished, or what the summary says, or failed; missing where no run has ended."""
    if not ended(folder):
        return "missing"
    if finished(folder):
        return "finished"
    said = summary.get("status", "failed")
    return "failed" if said == "finished" else said


def rows_of(study):
    """(columns, rows) of all variants, as sweep.csv has them."""
    rows, own, columns = [], [], []
    for name, values in study.variants.items():
        folder = study.place_of(name)
        summary = read_summary(folder)
        row = {("run." + k if k in values else k): v for k, v in row_of(summary).items()}
        state = status_of(folder, summary)
        if state not in ("finished", "missing"):
            row["reason"] = f"exit code {read_text(os.path.join(folder, 'exit.txt')).strip()}: {why(folder, summary)}"
        if os.path.exists(os.path.join(folder, "again.json")):
            row["again"] = " ".join(words_of(read_again(folder))) or "once more"
        own += [c for c in summary.get("results") or {} if c not in own and c in row]
        columns += [c for c in row if c not in columns]
        rows.append({**values, "status": state, **row})
    last = [c for c in ("steps", "cpu_seconds", "again", "reason") if c in columns]
    between = [c for c in columns if c not in own and c not in last]
    return [p["name"] for p in study.parameters] + ["status", *own, *between, *last], rows


def asked_columns(study):
    """Columns that -draw names; [] as long as no variant has finished.

    Raises SweepError for one that is no result.
    """
    columns, rows = rows_of(study)
    if not any(row["status"] == "finished" for row in rows):
        return []
    text, own = study.request.draw, {p["name"] for p in study.parameters} | {"status", "t", "reason", "again"}
    columns = [c for c in columns if c not in own]
    asked = [name.strip() for name in text.split(";" if ";" in text else ",") if name.strip()]
    missing = [name for name in asked if name not in columns]
    if missing:
        raise SweepError(f"-draw: no result {', '.join(missing)}; there are: {', '.join(columns)}")
    return asked


def write_csv(path, columns, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
