/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench-helpinghand PART... OUT: measures parts of HelpingHand on the recordings in $DUCTUS_DATA (else
 * ../shared/data), prints tables and writes OUT/NAME.csv. bench/helpinghand/run runs all of them. */
#include "bench.h"

#include <stdio.h>
#include <string.h>

int main(int count, char **words)
{
    static const struct {
        const char *name;
        void (*run)(const char *out);
    } parts[] = {{"search", bench_search_speed}, {"strokes", bench_stroke_speed}, {"live", bench_live}};
    if (count < 3) {
        fputs("usage: bench-helpinghand PART... OUT, where a part is search, strokes or live\n", stderr);
        return 2;
    }
    for (int i = 1; i + 1 < count; i++) {
        bool known = false;
        for (size_t p = 0; p < sizeof parts / sizeof *parts; p++) {
            if (strcmp(words[i], parts[p].name) == 0) {
                parts[p].run(words[count - 1]);
                known = true;
            }
        }
        if (!known) {
            fprintf(stderr, "bench-helpinghand: there is no part '%s'\n", words[i]);
            return 2;
        }
    }
    return 0;
}
