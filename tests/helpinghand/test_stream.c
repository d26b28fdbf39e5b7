/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pose while a stroke is drawn. */
#include "testing.h"

#include "base/memory.h"
#include "features/features.h"
#include "geometry/resample.h"
#include "library/feature_index.h"
#include "library/library_private.h"

#include <ductus/ductus.h>

#include <math.h>
#include <time.h>

enum { STROKES = 40, SAMPLES = 90, K = 20, QUERY = 160 };

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time); /* others may keep the machine busy */
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* A wavy line whose pose follows its direction. */
static void wave(size_t count, double phase, double *x, double *y)
{
    double at_x = 0, at_y = 0;
    for (size_t i = 0; i < count; i++) {
        double angle = 1.5 * sin(0.06 * (double)i + phase) + 0.3 * phase;
        at_x += i > 0 ? cos(angle) : 0;
        at_y += i > 0 ? sin(angle) : 0;
        x[i] = at_x;
        y[i] = at_y;
    }
}

/* `channels`: how many pose channels the recording has, in the order of duct_channel. */
static duct_library *make_library(const duct_context *context, int channels)
{
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(context, &drawing, &error));
    for (size_t s = 0; s < STROKES; s++) {
        duct_stroke *stroke;
        char id[32];
        snprintf(id, sizeof id, "s%zu", s);
        assert_ok(duct_drawing_add_stroke(drawing, id, SAMPLES, &stroke, &error));
        double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
        wave(SAMPLES, 0.2 * (double)s, x, y);
        for (int c = 0; c < channels; c++) {
            double *values = duct_stroke_edit(stroke, (duct_channel)(DUCT_PRESSURE + c));
            for (size_t i = 0; i < SAMPLES; i++) {
                size_t to = i > 0 ? i : 1;
                double angle = atan2(y[to] - y[to - 1], x[to] - x[to - 1]);
                double end = fmin(1, 0.1 * (double)(SAMPLES - 1 - i));
                values[i] = c == 0  ? end * (0.5 + 0.2 * sin(angle))
                            : c < 3 ? 0.4 * cos(angle + c)
                                    : 3 + 0.5 * angle;
            }
        }
    }
    duct_library *library;
    const duct_library_options options = {.unit = 1, .name = "waves"};
    const duct_drawing *recordings[] = {drawing};
    assert_ok(duct_library_build(context, recordings, 1, &options, &library, &error));
    duct_drawing_free(drawing);
    return library;
}

static duct_stream *make_stream(const duct_library *library, const char *features, double smoothing)
{
    duct_error error;
    duct_stream *stream;
    duct_stream_options options = duct_stream_options_default();
    options.features = features;
    options.smoothing = smoothing;
    assert_ok(duct_stream_new(NULL, library, &options, &stream, &error));
    return stream;
}

static void push_all(duct_stream *stream, const double *x, const double *y, size_t count,
                     duct_stream_pose *poses)
{
    duct_error error;
    for (size_t i = 0; i < count; i++) {
        assert_ok(duct_stream_push(stream, x[i], y[i], (double)i / 140, &poses[i], &error));
    }
}

typedef struct {
    double square;
    size_t row;
} scored;

static int by_square(const void *a, const void *b)
{
    const scored *p = a, *q = b;
    return p->square != q->square ? (p->square > q->square) - (p->square < q->square)
                                  : (p->row > q->row) - (p->row < q->row);
}

/* The weighted average of section 4.2.2 for a whole stroke, straight from its definition, of features that
 * know no future. */
static void average_without_future(const duct_library *library, const duct_feature_options *options,
                                   const double *x, const double *y, size_t count, duct_stream_pose *poses)
{
    duct_error error;
    duct_feature_index index;
    assert_ok(duct_library_features(library, options, DUCT_SEARCH_EXACT, &index, &error));
    size_t dimensions = index.dimensions, past = duct_feature_past_dimensions(options);
    float *rows = calloc(count * dimensions, sizeof *rows);
    assert_ok(duct_features_compute(duct_allocator_of(NULL), options, x, y, count, rows, &error));
    scored *all = calloc(library->sample_count, sizeof *all);
    for (size_t i = 0; i < count; i++) {
        float *query = rows + i * dimensions;
        query[1] = 1;
        for (size_t r = 0; r < library->sample_count; r++) {
            double square = 0;
            for (size_t d = 0; d < past; d++) {
                double difference = (double)query[d] - (double)index.rows[r * dimensions + d];
                square += difference * difference;
            }
            all[r] = (scored){square, r};
        }
        qsort(all, library->sample_count, sizeof *all, by_square);
        double sums[4] = {0}, weights = 0, c = 0, s = 0;
        for (size_t n = 0; n < K; n++) {
            double weight = 1 / fmax(sqrt(all[n].square), 1e-6);
            weights += weight;
            for (int v = 0; v < 3; v++) {
                sums[v] += weight * library->channels[DUCT_PRESSURE + v][all[n].row];
            }
            c += weight * cos(library->channels[DUCT_TWIST][all[n].row]);
            s += weight * sin(library->channels[DUCT_TWIST][all[n].row]);
        }
        poses[i] = (duct_stream_pose){sums[0] / weights, sums[1] / weights, sums[2] / weights, atan2(s, c)};
    }
    free(all);
    free(rows);
}

static void a_stream_averages_as_a_whole_stroke_does(const char *features, duct_feature_kind kind)
{
    duct_library *library = make_library(NULL, 4);
    duct_feature_options options = duct_feature_options_default();
    options.kind = kind;
    double x[QUERY], y[QUERY], worst = 0;
    wave(QUERY, 1.23, x, y);
    duct_stream_pose streamed[QUERY], whole[QUERY];
    duct_stream *stream = make_stream(library, features, 0);
    push_all(stream, x, y, QUERY, streamed);
    average_without_future(library, &options, x, y, QUERY, whole);
    for (size_t i = 0; i < QUERY; i++) {
        worst = fmax(worst, fabs(streamed[i].pressure - whole[i].pressure));
        worst = fmax(worst, fabs(streamed[i].tilt_x - whole[i].tilt_x));
        worst = fmax(worst, fabs(streamed[i].tilt_y - whole[i].tilt_y));
        worst = fmax(worst, fabs(remainder(streamed[i].twist - whole[i].twist, 2 * M_PI)));
    }
    print_message("%s: largest difference %g\n", features, worst);
    assert_true(worst < 1e-4);
    duct_stream_free(stream);
    duct_library_free(library);
}

static void streams_average_as_whole_strokes_do(void **state)
{
    (void)state;
    a_stream_averages_as_a_whole_stroke_does("velocities", DUCT_FEATURE_VELOCITIES);
    a_stream_averages_as_a_whole_stroke_does("contexts", DUCT_FEATURE_CONTEXTS);
}

/* Samples as tablets give them, not a unit apart: near what restyle makes of the finished stroke by the same
 * average, of features that know the future. */
static void the_middle_is_near_restyle_with_the_average(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library(NULL, 4);
    double x[QUERY], y[QUERY], line_x[3 * QUERY], line_y[3 * QUERY];
    duct_stream_pose poses[3 * QUERY];
    wave(QUERY, 1.23, x, y);
    size_t count = 0;
    for (size_t i = 0; i + 1 < QUERY; i++) {
        for (size_t p = 0; p < 1 + i % 3; p++, count++) {
            double share = (double)p / (double)(1 + i % 3);
            line_x[count] = x[i] + share * (x[i + 1] - x[i]);
            line_y[count] = y[i] + share * (y[i + 1] - y[i]);
        }
    }
    duct_stream *stream = make_stream(library, "velocities", 2);
    push_all(stream, line_x, line_y, count, poses);
    duct_drawing *drawing, *styled;
    duct_stroke *stroke;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    assert_ok(duct_drawing_add_stroke(drawing, "q", count, &stroke, &error));
    memcpy(duct_stroke_edit(stroke, DUCT_X), line_x, count * sizeof *line_x);
    memcpy(duct_stroke_edit(stroke, DUCT_Y), line_y, count * sizeof *line_y);
    double *t = duct_stroke_edit(stroke, DUCT_T);
    for (size_t i = 0; i < count; i++) {
        t[i] = (double)i / 140;
    }
    const duct_operation *operation;
    duct_settings *settings;
    assert_ok(duct_operation_find("restyle", &operation, &error));
    assert_ok(duct_settings_new(NULL, operation, &settings, &error));
    assert_ok(duct_settings_library(settings, "hand", library, &error));
    assert_ok(duct_settings_set(settings, "mode", "pose", &error));
    assert_ok(duct_settings_set(settings, "select", "average", &error));
    assert_ok(duct_settings_set(settings, "scale", "1", &error));
    assert_ok(duct_operation_run(NULL, settings, drawing, NULL, &styled, &error));
    const duct_stroke *made = duct_drawing_stroke(styled, 0);
    assert_int_equal(duct_stroke_size(made), count);
    const double *pressure = duct_stroke_values(made, DUCT_PRESSURE),
                 *tilt = duct_stroke_values(made, DUCT_TILT_X);
    double sum = 0, spread = 0;
    size_t used = 0;
    for (size_t i = count / 4; i < 3 * count / 4; i++, used++) {
        sum += fabs(poses[i].pressure - pressure[i]) + fabs(poses[i].tilt_x - tilt[i]);
        spread += fabs(pressure[i] - 0.5) + fabs(tilt[i]);
    }
    print_message("mean difference %g of a mean size %g\n", sum / (double)used, spread / (double)used);
    assert_true(sum < 0.25 * spread);
    duct_drawing_free(styled);
    duct_drawing_free(drawing);
    duct_settings_free(settings);
    duct_stream_free(stream);
    duct_library_free(library);
}

static void poses_are_smooth_and_the_same_each_time(void **state)
{
    (void)state;
    enum { DENSE = 1500 };
    duct_library *library = make_library(NULL, 4);
    double wide_x[QUERY], wide_y[QUERY], at[QUERY];
    static double x[DENSE], y[DENSE];
    static duct_stream_pose first[DENSE], again[DENSE];
    wave(QUERY, 2.1, wide_x, wide_y);
    double length = duct_arc_lengths(wide_x, wide_y, QUERY, at);
    size_t hint_x = 0, hint_y = 0;
    for (size_t i = 0; i < DENSE; i++) {
        double where = length * (double)i / (DENSE - 1);
        x[i] = duct_interpolate(at, wide_x, QUERY, where, &hint_x);
        y[i] = duct_interpolate(at, wide_y, QUERY, where, &hint_y);
    }
    duct_stream *stream = make_stream(library, "velocities", 2);
    push_all(stream, x, y, DENSE, first);
    double most = 0;
    for (size_t i = 1; i < DENSE; i++) {
        most = fmax(most, fabs(first[i].pressure - first[i - 1].pressure));
        most = fmax(most, fabs(first[i].tilt_x - first[i - 1].tilt_x));
        most = fmax(most, fabs(first[i].twist - first[i - 1].twist));
    }
    print_message("largest step at a tenth of a unit: %g\n", most);
    assert_true(most < 0.05);
    /* The second stroke of a stream, and another stream. */
    duct_stream_pose end, other_end;
    assert_true(duct_stream_flush(stream, &end));
    push_all(stream, x, y, DENSE, again);
    assert_memory_equal(first, again, sizeof first);
    duct_stream *other = make_stream(library, "velocities", 2);
    push_all(other, x, y, DENSE, again);
    assert_memory_equal(first, again, sizeof first);
    assert_true(duct_stream_flush(other, &other_end));
    assert_memory_equal(&end, &other_end, sizeof end);
    duct_stream_free(stream);
    duct_stream_free(other);
    duct_library_free(library);
}

/* How densely a tablet samples the same line changes little. */
static void a_faster_tablet_gives_the_same_poses(void **state)
{
    (void)state;
    duct_library *library = make_library(NULL, 4);
    double x[QUERY], y[QUERY];
    wave(QUERY, 0.7, x, y);
    duct_stream_pose coarse[QUERY], pose;
    duct_stream *stream = make_stream(library, "velocities", 2);
    push_all(stream, x, y, QUERY, coarse);
    assert_true(duct_stream_flush(stream, NULL));
    double sum = 0;
    duct_error error;
    for (size_t i = 0; i < QUERY; i++) {
        for (int p = i > 0 ? 1 : 8; p <= 8; p++) {
            double share = p / 8.0;
            size_t from = i > 0 ? i - 1 : 0;
            assert_ok(duct_stream_push(stream, x[from] + share * (x[i] - x[from]),
                                       y[from] + share * (y[i] - y[from]), 0, &pose, &error));
        }
        sum += fabs(pose.pressure - coarse[i].pressure);
    }
    print_message("mean difference %g\n", sum / QUERY);
    assert_true(sum / QUERY < 0.02);
    duct_stream_free(stream);
    duct_library_free(library);
}

/* The library's pressure falls to 0 within the last samples of a stroke: only the flush can know. */
static void the_flush_gives_the_end(void **state)
{
    (void)state;
    duct_library *library = make_library(NULL, 4);
    double x[SAMPLES], y[SAMPLES];
    wave(SAMPLES, 1.0, x, y);
    duct_stream_pose poses[SAMPLES], end = {-1, -1, -1, -1};
    duct_stream *stream = make_stream(library, "velocities", 2);
    assert_false(duct_stream_flush(stream, &end));
    assert_true(end.pressure == -1);
    push_all(stream, x, y, SAMPLES, poses);
    assert_true(poses[SAMPLES - 1].pressure > 0.25);
    assert_true(duct_stream_flush(stream, &end));
    assert_true(end.pressure < 0.1);
    assert_false(duct_stream_flush(stream, &end));
    duct_stream_free(stream);
    duct_library_free(library);
}

static void absent_channels_stay_0(void **state)
{
    (void)state;
    duct_library *library = make_library(NULL, 1);
    double x[SAMPLES], y[SAMPLES];
    wave(SAMPLES, 1.0, x, y);
    duct_stream_pose poses[SAMPLES];
    duct_stream *stream = make_stream(library, "velocities", 2);
    push_all(stream, x, y, SAMPLES, poses);
    for (size_t i = 0; i < SAMPLES; i++) {
        assert_true(poses[i].pressure > 0 && poses[i].pressure <= 1);
        assert_true(poses[i].tilt_x == 0 && poses[i].tilt_y == 0 && poses[i].twist == 0);
    }
    duct_stream_free(stream);
    duct_library_free(library);
}

static void a_pen_that_stays_in_place_keeps_its_pose(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library(NULL, 4);
    duct_stream *stream = make_stream(library, "contexts", 2);
    duct_stream_pose first, pose;
    assert_ok(duct_stream_push(stream, 5, 5, 0, &first, &error));
    for (int i = 0; i < 1000; i++) {
        /* Trembling below the trail's detail makes no way. */
        assert_ok(duct_stream_push(stream, 5 + 0.01 * (i % 3), 5, 0, &pose, &error));
        assert_true(fabs(pose.pressure - first.pressure) < 0.02);
    }
    duct_stream_free(stream);
    duct_library_free(library);
}

static void hostile_samples_are_refused_and_change_nothing(void **state)
{
    (void)state;
    static const double bad[][3] = {{NAN, 0, 1},   {0, INFINITY, 1}, {0, 0, NAN},
                                    {1e300, 0, 1}, {0, -1e12, 1},    {0, 0, 0.01}};
    duct_error error;
    duct_library *library = make_library(NULL, 4);
    double x[SAMPLES], y[SAMPLES];
    wave(SAMPLES, 1.0, x, y);
    duct_stream_pose poses[SAMPLES], pose;
    duct_stream *stream = make_stream(library, "velocities", 2),
                *other = make_stream(library, "velocities", 2);
    push_all(other, x, y, SAMPLES, poses);
    for (size_t i = 0; i < SAMPLES; i++) {
        assert_ok(duct_stream_push(stream, x[i], y[i], 0.5, &pose, &error));
        assert_memory_equal(&pose, &poses[i], sizeof pose);
        for (size_t b = 0; b < 6; b++) {
            duct_stream_pose before = pose;
            duct_status status = duct_stream_push(stream, bad[b][0], bad[b][1], bad[b][2], &pose, &error);
            assert_int_equal(status, b == 3 || b == 4 ? DUCT_LIMIT : DUCT_BAD_ARGUMENT);
            assert_true(error.message[0] != '\0');
            assert_memory_equal(&pose, &before, sizeof pose);
        }
    }
    /* As far as it goes, there and back. */
    for (int i = 0; i < 200; i++) {
        assert_ok(duct_stream_push(stream, i % 2 == 0 ? 1e9 : -1e9, 1e9, 1, &pose, &error));
        assert_true(isfinite(pose.pressure) && isfinite(pose.twist));
    }
    duct_stream_free(stream);
    duct_stream_free(other);
    duct_library_free(library);
}

static void bad_options_are_refused(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library(NULL, 4), *poseless = make_library(NULL, 0);
    duct_stream *stream = NULL;
    assert_int_equal(duct_stream_new(NULL, poseless, NULL, &stream, &error), DUCT_UNSUPPORTED);
    assert_non_null(strstr(error.message, "waves"));
    for (int i = 0; i < 12; i++) {
        duct_stream_options options = duct_stream_options_default();
        switch (i) {
        case 0:
            options.unit = -1;
            break;
        case 1:
            options.unit = NAN;
            break;
        case 2:
            options.unit = INFINITY;
            break;
        case 3:
            options.features = "moments";
            break;
        case 4:
            options.neighbours = 0;
            break;
        case 5:
            options.neighbours = 101;
            break;
        case 6:
            options.reach = 6;
            break;
        case 7:
            options.reach = 1e9;
            break;
        case 8:
            options.weight = NAN;
            break;
        case 9:
            options.weight = -1;
            break;
        case 10:
            options.smoothing = INFINITY;
            break;
        default:
            options.features = NULL;
            break;
        }
        assert_int_equal(duct_stream_new(NULL, library, &options, &stream, &error), DUCT_BAD_ARGUMENT);
        assert_null(stream);
    }
    duct_stream_free(NULL);
    duct_library_free(library);
    duct_library_free(poseless);
}

/* Every combination of the options' ends works, also with fewer library samples than neighbours. */
static void extreme_options_work(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library(NULL, 4);
    double x[SAMPLES], y[SAMPLES];
    wave(SAMPLES, 1.0, x, y);
    for (int i = 0; i < 16; i++) {
        duct_stream_options options = {
            i & 1 ? 1e-3 : 1e3, i & 2 ? "velocities" : "contexts", i & 4 ? 1 : 100, i & 8 ? 7 : 500, 0.3,
            i & 1 ? 0 : 100};
        duct_stream *stream;
        duct_stream_pose poses[SAMPLES];
        assert_ok(duct_stream_new(NULL, library, &options, &stream, &error));
        push_all(stream, x, y, SAMPLES, poses);
        for (size_t k = 0; k < SAMPLES; k++) {
            assert_true(poses[k].pressure >= 0 && poses[k].pressure <= 1 && isfinite(poses[k].twist));
        }
        duct_stream_free(stream);
    }
    duct_library_free(library);
}

/* After the start nothing is allocated, and a sample takes far less than a tablet leaves for it, however long
 * the stroke is. */
static void long_strokes_cost_the_same_a_sample(void **state)
{
    (void)state;
    enum { MANY = 100000 };
    duct_error error;
    duct_library *library = make_library(NULL, 4);
    failing_allocator counting;
    failing_init(&counting, 0);
    duct_context context = duct_context_default();
    context.allocator = &counting.allocator;
    duct_stream *stream;
    assert_ok(duct_stream_new(&context, library, NULL, &stream, &error));
    duct_stream_pose pose;
    assert_ok(duct_stream_push(stream, 0, 0, 0, &pose, &error));
    long calls = counting.calls;
    double begun = now();
    for (size_t i = 1; i < MANY; i++) {
        double angle = 0.05 * (double)i, radius = 20 + 1e-4 * (double)i;
        assert_ok(duct_stream_push(stream, radius * cos(angle), radius * sin(angle), 0, &pose, &error));
    }
    double each = (now() - begun) / MANY;
    print_message("%.1f us a sample\n", 1e6 * each);
    assert_int_equal(counting.calls, calls);
    assert_true(each < 0.25 / 140);
    duct_stream_free(stream);
    assert_int_equal(counting.held, 0);
    duct_library_free(library);
}

static void survives_failing_allocations(void **state)
{
    (void)state;
    duct_error error;
    duct_status status = DUCT_NO_MEMORY;
    failing_allocator failing;
    failing_init(&failing, 0);
    duct_context context = duct_context_default();
    context.allocator = &failing.allocator;
    for (long n = 1; status != DUCT_OK; n++) {
        /* A new library each time, so that what is kept with it is made again. */
        duct_library *library = make_library(&context, 4);
        long held = failing.held;
        duct_stream *stream = NULL;
        failing.fails_at = failing.calls + n;
        status = duct_stream_new(&context, library, NULL, &stream, &error);
        failing.fails_at = 0;
        if (status != DUCT_OK) {
            assert_int_equal(status, DUCT_NO_MEMORY);
            assert_null(stream);
            /* It works once there is memory. */
            assert_ok(duct_stream_new(&context, library, NULL, &stream, &error));
        }
        assert_true(failing.held >= held);
        duct_stream_free(stream);
        duct_library_free(library);
        assert_int_equal(failing.held, 0);
        assert_true(n < 200);
    }
}

/* A page of one writer drawn with another's hand, at the tablet's own samples. */
static void recordings_stream_in_real_time(void **state)
{
    (void)state;
    const char *folder = shared_data();
    if (folder == NULL) {
        skip();
    }
    duct_error error;
    char path[4300];
    duct_library *library;
    duct_drawing *drawing;
    snprintf(path, sizeof path, "%s/helpinghand/SteveEnglish1.cyn", folder);
    assert_ok(duct_library_open(NULL, path, &library, &error));
    snprintf(path, sizeof path, "%s/helpinghand/BrendaEnglish2.cyn", folder);
    assert_ok(duct_drawing_read(NULL, path, NULL, &drawing, &error));
    duct_stream *stream;
    assert_ok(duct_stream_new(NULL, library, NULL, &stream, &error));
    size_t samples = 0;
    double begun = now();
    for (size_t s = 0; s < duct_drawing_stroke_count(drawing); s++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, s);
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        const double *t = duct_stroke_values(stroke, DUCT_T);
        duct_stream_pose pose;
        for (size_t i = 0; i < duct_stroke_size(stroke); i++, samples++) {
            assert_ok(duct_stream_push(stream, x[i], y[i], t[i], &pose, &error));
            assert_true(pose.pressure > 0 && pose.pressure < 1);
        }
        assert_true(duct_stream_flush(stream, &pose));
    }
    double each = (now() - begun) / (double)samples;
    print_message("%zu samples, %.1f us each\n", samples, 1e6 * each);
    assert_true(each < 0.25 / 140);
    duct_stream_free(stream);
    duct_drawing_free(drawing);
    duct_library_free(library);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(streams_average_as_whole_strokes_do),
        cmocka_unit_test(the_middle_is_near_restyle_with_the_average),
        cmocka_unit_test(poses_are_smooth_and_the_same_each_time),
        cmocka_unit_test(a_faster_tablet_gives_the_same_poses),
        cmocka_unit_test(the_flush_gives_the_end),
        cmocka_unit_test(absent_channels_stay_0),
        cmocka_unit_test(a_pen_that_stays_in_place_keeps_its_pose),
        cmocka_unit_test(hostile_samples_are_refused_and_change_nothing),
        cmocka_unit_test(bad_options_are_refused),
        cmocka_unit_test(extreme_options_work),
        cmocka_unit_test(long_strokes_cost_the_same_a_sample),
        cmocka_unit_test(survives_failing_allocations),
        cmocka_unit_test(recordings_stream_in_real_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
