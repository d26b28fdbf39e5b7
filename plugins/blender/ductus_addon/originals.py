# SPDX-License-Identifier: GPL-3.0-or-later
"""Which layer is the result of which, so that running again starts from the original and it can be brought back.

The record is saved with the object's data: for each result its layer's and its original's name, whether the original
was hidden, and for each drawing the fingerprints of the lines that were made and of those they were made from. A line
of a result layer that has no such fingerprint any more was edited or drawn by the user: it is nobody's result.
"""

import json
from collections import defaultdict, deque


class Originals:
    def __init__(self, host, ob):
        self.host, self.ob = host, ob
        try:
            self.results = json.loads(host.record(ob).get("results", "[]"))
        except ValueError:
            self.results = []

    def save(self):
        self.host.set_record(self.ob, {"results": json.dumps(self.results)} if self.results else {})

    def of(self, layer, names):
        """The entry of a result layer whose original is still there, or None."""
        for entry in self.results:
            if entry["result"] == layer and entry["original"] in names:
                return entry
        return None

    def start(self, result, original, hidden):
        self.results = [entry for entry in self.results if entry["result"] != result]
        entry = {"result": result, "original": original, "hidden": hidden, "frames": {}}
        self.results.append(entry)
        return entry

    def drop(self, entry):
        self.results.remove(entry)

    @staticmethod
    def prefix(entry, layer):
        """The name that lines' ids begin with: the original's for a result, so that they stay the same."""
        return entry["original"] if entry else layer


def remember(entry, number, made, source, now):
    """Adds pairs of fingerprints of a drawing; forgets those that are not in it any more (`now`)."""
    old_made, old_source = entry["frames"].get(str(number), ([], []))
    pairs = dict(zip(old_made, old_source))
    pairs.update(zip(made, source))
    there = set(now)
    pairs = {key: value for key, value in pairs.items() if key in there}
    entry["frames"][str(number)] = (list(pairs), list(pairs.values()))


def sources(entry, number, now, original):
    """For each line of a result's drawing (fingerprints `now`) the place of the line in the original's drawing
    (fingerprints `original`) that it was made from, or None."""
    pairs = dict(zip(*entry["frames"].get(str(number), ([], []))))
    places = defaultdict(deque)
    for place, mark in enumerate(original):
        places[mark].append(place)
    found = []
    for mark in now:
        queue = places.get(pairs.get(mark, mark))
        found.append(queue.popleft() if queue else None)
    return found
