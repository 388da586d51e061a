"""Collects the summaries of a sweep: out/sweep/CASE/sweep.csv, one row for each variant of sweep.json, and the list of
those that failed. Columns: the varied options, status, every number of the summary's "final" and "results" (NAME_error
where a result has an expected value; "final.NAME" where a result has the same name; "run.NAME" where a varied option
has it), steps, cpu_seconds. Exit status 1 if one failed.
"""
import csv
import json
import os
import sys

from grid import case_name, read_text


def read_summary(folder):
    """{} of a run that left none, or was killed."""
    try:
        summary = json.loads(read_text(os.path.join(folder, "summary.json")))
        return summary if isinstance(summary, dict) and summary.get("status") != "running" else {}
    except ValueError:
        return {}


def row_of(summary):
    """{column: number} of one summary."""
    results = summary.get("results") or {}
    row = {("final." + k if k in results else k): v for k, v in (summary.get("final") or {}).items()}
    for name, entry in results.items():
        row[name] = entry["value"]
        if "error" in entry:
            row[name + "_error"] = entry["error"]
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
    return (told or lines or ["no log"])[-1]


def main():
    top = f"out/sweep/{case_name()}"
    with open(f"{top}/sweep.json", encoding="utf-8") as file:
        sweep = json.load(file)
    rows, failed, columns = [], [], ["status"]
    for variant in sweep["variants"]:
        folder = variant["folder"]
        summary, code = read_summary(folder), read_text(f"{folder}/exit.txt").strip() or "none"
        good = code == "0" and summary.get("status") == "finished"
        row = {("run." + k if k in variant["values"] else k): v for k, v in row_of(summary).items()}
        columns += [c for c in row if c not in columns]
        rows.append({**variant["values"], "status": "finished" if good else summary.get("status", "failed"), **row})
        if not good:
            rows[-1]["status"] = "failed" if rows[-1]["status"] == "finished" else rows[-1]["status"]
            failed.append((os.path.basename(folder), code, why(folder, summary)))
    columns += [columns.pop(columns.index(c)) for c in ("steps", "cpu_seconds") if c in columns]
    with open(f"{top}/sweep.csv", "w", encoding="utf-8", newline="") as file:
        names = [p["name"] for p in sweep["parameters"]]
        writer = csv.DictWriter(file, names + columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    print(f"{top}/sweep.csv")
    if failed:
        print(f"{len(failed)} of {len(rows)} variants failed (log.txt in their folders in {top}):")
        for name, code, reason in failed:
            print(f"  {name}: exit code {code}: {reason}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
