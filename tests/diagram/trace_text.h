/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_DIAGRAM_TRACE_TEXT_H
#define DUCTUS_TESTS_DIAGRAM_TRACE_TEXT_H

/* A trace as restyle writes it, in small: stroke "a" has both passes, "b" only one, "c" was passed over. */
static const char TRACE[] =
    "{\n  \"operation\": \"restyle\",\n  \"settings\": {\"hand\": \"somebody\", \"mode\": \"two-pass\"},\n"
    "  \"unit\": 2.5,\n"
    "  \"library\": {\"name\": \"x\", \"strokes\": 2, \"samples\": 9, \"stroke_samples\": [5, 4]},\n"
    "  \"strokes\": [\n"
    "{\"id\": \"a\", \"passes\": [{\"pass\": \"trajectory\", \"twist_deviation\": 0.1, \"samples\": [\n"
    "  {\"candidates\": [[0, 1, 0.5], [1, 2, 0.25]], \"vectors\": [[1, 2], [3, 4]], \"chosen\": [0, 1, 0.5],"
    " \"next\": \"consecutive\", \"costs\": {\"total\": 1}},\n"
    "  {\"chosen\": [0, 2, 0.5], \"next\": \"stretch\"},\n"
    "  {\"chosen\": [0, 2, 0.5], \"next\": \"jump\"},\n"
    "  {\"chosen\": [0, 0, 0.5], \"next\": \"jump\"},\n"
    "  {\"chosen\": [1, 3, 0.5]}], \"costs\": {\"total\": 4}},\n"
    " {\"pass\": \"pose\", \"samples\": [{\"chosen\": [1, 0, 0.5], \"next\": \"shrink\"}, {\"chosen\": [1, "
    "2, 1]}]}]},\n"
    "{\"passes\": [{\"samples\": [{\"chosen\": [0, 4, 0]}], \"pass\": \"trajectory\"}], \"id\": \"b\"},\n"
    "{\"id\": \"c \\\"\\u00e4\", \"passes\": []}\n"
    "  ]\n}\n";

#endif
