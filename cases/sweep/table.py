"""The table of a sweep as a page: out/sweep/CASE/index.html, one row for each variant with its numbers, its pictures as
thumbnails and links to its files. Opens without a server; needs no script."""
import glob
import html
import os

STYLE = """body { font: 14px sans-serif; margin: 1.5em; color: #222 }
table { border-collapse: collapse } td, th { border: 1px solid #ccc; padding: 3px 7px; text-align: right }
th { background: #eee; position: sticky; top: 0 } tr:nth-child(even) { background: #f7f7f7 }
.failed { background: #fbe3d6 } td.pictures { text-align: left; white-space: nowrap } .pictures img { height: 90px }
.whole img { max-width: 100%; display: block; margin: 1em 0 }"""
MOST = 6  # thumbnails of a variant


def shown(text):
    """A number with six digits, other texts as they are."""
    try:
        return f"{float(text):.6g}"
    except ValueError:
        return html.escape(text)


def pictures_of(folder, top):
    """Thumbnails that link to the pictures of a variant."""
    found = sorted(glob.glob(os.path.join(folder, "*.png")))[:MOST]
    paths = [html.escape(os.path.relpath(path, top), quote=True) for path in found]
    return " ".join(f'<a href="{p}"><img src="{p}" alt="{p}" loading="lazy"></a>' for p in paths)


def head(sweep, columns):
    units = {p["name"]: p["unit"] for p in sweep["parameters"]}
    meanings = {p["name"]: p["meaning"] for p in sweep["parameters"]}
    cells = []
    for name in columns:
        unit = units.get(name, "")
        title = html.escape(meanings.get(name, ""), quote=True)
        cells.append(f'<th title="{title}">{html.escape(name)}' + (f"<br>[{html.escape(unit)}]" if unit.strip("-") else "") + "</th>")
    return "<tr>" + "".join(cells) + "<th>files</th><th>pictures</th></tr>"


def write_table(sweep, rows, columns, top):
    """index.html of the rows of sweep.csv; returns its path."""
    lines = []
    for variant, row in zip(sweep["variants"], rows):
        folder = variant["folder"]
        link = html.escape(os.path.relpath(folder, top), quote=True)
        files = " ".join(f'<a href="{link}/{name}">{name.split(".")[0]}</a>' for name in ("log.txt", "report.txt", "summary.json")
                         if os.path.exists(os.path.join(folder, name)))
        kind = "" if row["status"] == "finished" else ' class="failed"'
        lines.append(f"<tr{kind}>" + "".join(f"<td>{shown(row[c])}</td>" for c in columns)
                     + f'<td>{files}</td><td class="pictures">{pictures_of(folder, top)}</td></tr>')
    whole = [name for name in ("sweep.png", "histories.png", "cost.png") if os.path.exists(os.path.join(top, name))]
    title = f"{html.escape(sweep['case'])}: {len(rows)} variants"
    path = os.path.join(top, "index.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>\n<style>{STYLE}</style>'
                   f"</head><body>\n<h1>{title}</h1>\n<table>\n{head(sweep, columns)}\n" + "\n".join(lines)
                   + '\n</table>\n<div class="whole">' + "".join(f'<img src="{n}" alt="{n}">' for n in whole)
                   + "</div>\n</body></html>\n")
    return path
