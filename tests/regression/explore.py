"""Whether explore.html of a sweep holds what its variants left:  explore.py FOLDER REASON...

Every number, every curve, every link; REASON: words of what failed variants say. Exit status 1 and a line for each fault.
"""
import csv
import json
import os
import sys
from html.parser import HTMLParser

FOLDER, REASONS = sys.argv[1], sys.argv[2:]


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.inside, self.data, self.links = None, "", []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.inside = attributes.get("id")
        self.links += [attributes[name] for name in ("src", "href") if name in attributes]

    def handle_endtag(self, tag):
        self.inside = None

    def handle_data(self, data):
        if self.inside == "data":
            self.data += data


def faults():
    with open(os.path.join(FOLDER, "explore.html"), encoding="utf-8") as file:
        page = Page(file.read())
    data = json.loads(page.data)
    with open(os.path.join(FOLDER, "sweep.csv"), encoding="utf-8") as file:
        rows = [{name.strip(): text for name, text in row.items()} for row in csv.DictReader(file)]
    for link in page.links + [p for v in data["variants"] for p in [v["folder"] + "/log.txt", *v["pictures"].values()]]:
        if not os.path.exists(os.path.join(FOLDER, link)):
            yield f"{link}: not there"
    if len(data["variants"]) != len(rows):
        yield f"{len(data['variants'])} variants, {len(rows)} rows"
    names = [p["name"] for p in data["parameters"]]
    for p in data["parameters"]:
        if sorted(p["values"], key=float) != p["values"] or set(p["values"]) != {r[p["name"]] for r in rows}:
            yield f"values of {p['name']}: {p['values']}"
    for variant, row in zip(data["variants"], rows):
        who = ",".join(f"{n}={row[n]}" for n in names)
        if [variant["values"][n] for n in names] != [row[n] for n in names] or variant["status"] != row["status"]:
            yield f"{who}: {variant['values']}, {variant['status']}"
        for name, value, _, _ in variant["results"]:
            if abs(value - float(row[name])) > 1e-4 * abs(value):
                yield f"{who}: {name} = {value} instead of {row[name]}"
        if row["status"] == "finished":
            if not variant["results"] or not data["columns"]:
                yield f"{who}: no results or curves"
            for name, _ in data["columns"]:
                if len(variant["curves"][name]) != len(variant["t"]) or len(variant["t"]) < 3:
                    yield f"{who}: curve {name}"
        elif not any(words in variant["reason"] for words in REASONS):
            yield f"{who}: reason {variant['reason']!r}"
    if REASONS and all(row["status"] == "finished" for row in rows):
        yield "no variant failed"


found = list(faults())
print("\n".join(found))
sys.exit(bool(found))
