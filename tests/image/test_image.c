/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include <ductus/image.h>

#include "base/file.h"
#include "brush/canvas.h"
#include "image/image_private.h"

#include <dirent.h>
#include <math.h>
#include <sys/stat.h>
#include <unistd.h>

static duct_error error;
static char folder[] = "/tmp/ductus-image-XXXXXX";

static const char *place(const char *name)
{
    static char path[4][128];
    static int next;
    char *given = path[next++ % 4];
    snprintf(given, sizeof path[0], "%s/%s", folder, name);
    return given;
}

static void put(const char *path, const void *data, size_t size)
{
    assert_ok(duct_file_write(duct_allocator_of(NULL), path, data, size, &error));
}

static char *get(const char *path, size_t *size)
{
    char *data = NULL;
    assert_ok(duct_file_read(duct_allocator_of(NULL), path, 1 << 28, &data, size, &error));
    return data;
}

/* A canvas with a ramp of colours in x and of alpha in y; nothing is painted right of column 128. */
static duct_canvas *ramp(int width, int height)
{
    duct_canvas *canvas = NULL;
    assert_ok(duct_canvas_new(NULL, width, height, &canvas, &error));
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width && x < 128; x++) {
            uint16_t *tile = duct_canvas_touch(canvas, x / DUCT_TILE_SIZE, y / DUCT_TILE_SIZE);
            uint16_t *pixel = tile + ((y % DUCT_TILE_SIZE) * DUCT_TILE_SIZE + x % DUCT_TILE_SIZE) * 4;
            int alpha = 32768 * y / (height - 1);
            pixel[0] = (uint16_t)(alpha * x / 128);
            pixel[1] = (uint16_t)(alpha / 2);
            pixel[2] = (uint16_t)(alpha - alpha * x / 128);
            pixel[3] = (uint16_t)alpha;
        }
    }
    return canvas;
}

static void check_ramp(const duct_image *image, int width, int height, float tolerance)
{
    assert_int_equal(image->width, width);
    assert_int_equal(image->height, height);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const float *pixel = image->pixels + ((size_t)y * (size_t)width + (size_t)x) * 4;
            float alpha = x < 128 ? (float)y / (float)(height - 1) : 0;
            assert_float_equal(pixel[3], alpha, tolerance);
            if (alpha > 0.1f) {
                float red = (float)x / 128;
                assert_float_equal(pixel[0], red, tolerance / alpha);
                assert_float_equal(pixel[1], 0.5f, tolerance / alpha);
                assert_float_equal(pixel[2], 1 - red, tolerance / alpha);
            }
        }
    }
}

static void formats_keep_colour_alpha_and_resolution(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int bits;
        float tolerance;
    } cases[] = {{"a.png", 8, 0.003f},  {"a.png", 16, 0.0001f}, {"a.tif", 8, 0.003f}, {"a.tiff", 16, 0.0001f},
                 {"a.exr", 16, 0.002f}, {"a.EXR", 32, 0.0002f}, {"a.png", 0, 0.003f}, {"a.exr", 0, 0.002f}};
    duct_canvas *canvas = ramp(200, 150);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        duct_image_options options = {{0, 0, 0, 0}, 300, cases[i].bits};
        duct_image image = {0};
        assert_ok(duct_image_write(NULL, canvas, place(cases[i].name), &options, &error));
        assert_ok(duct_image_read(NULL, place(cases[i].name), &image, &error));
        check_ramp(&image, 200, 150, cases[i].tolerance);
        assert_float_equal(image.resolution, 300, 0.1f);
        duct_image_free(NULL, &image);
        assert_null(image.pixels);
        unlink(place(cases[i].name));
    }
    duct_canvas_free(canvas);
}

static void background_lies_below(void **state)
{
    (void)state;
    duct_canvas *canvas = ramp(140, 65);
    duct_image_options options = {{1, 0.5f, 0, 1}, 0, 8};
    duct_image image = {0};
    assert_ok(duct_image_write(NULL, canvas, place("b.png"), &options, &error));
    assert_ok(duct_image_read(NULL, place("b.png"), &image, &error));
    assert_float_equal(image.resolution, 0, 1e-6f);
    const float *empty = image.pixels + (size_t)(10 * 140 + 135) * 4;
    assert_float_equal(empty[0], 1, 0.003f);
    assert_float_equal(empty[1], 0.5f, 0.003f);
    assert_float_equal(empty[2], 0, 0.003f);
    assert_float_equal(empty[3], 1, 0);
    const float *half = image.pixels + (size_t)(32 * 140 + 64) * 4; /* half transparent grey over it */
    assert_float_equal(half[0], 0.75f, 0.006f);
    assert_float_equal(half[2], 0.25f, 0.006f);
    duct_image_free(NULL, &image);
    /* No options: opaque white. */
    assert_ok(duct_image_write(NULL, canvas, place("b.png"), NULL, &error));
    assert_ok(duct_image_read(NULL, place("b.png"), &image, &error));
    assert_float_equal(image.pixels[135 * 4 + 2], 1, 0);
    duct_image_free(NULL, &image);
    unlink(place("b.png"));
    duct_canvas_free(canvas);
}

static void same_canvas_same_bytes(void **state)
{
    (void)state;
    static const char *const names[] = {"c.png", "c.tif", "c.exr"};
    duct_canvas *canvas = ramp(100, 70);
    for (size_t i = 0; i < 3; i++) {
        size_t size[2];
        char *data[2];
        for (int k = 0; k < 2; k++) {
            if (k == 1) {
                sleep(1); /* so that a time stamp would show */
            }
            assert_ok(duct_image_write(NULL, canvas, place(names[i]), NULL, &error));
            data[k] = get(place(names[i]), &size[k]);
        }
        assert_int_equal(size[0], size[1]);
        assert_memory_equal(data[0], data[1], size[0]);
        free(data[0]);
        free(data[1]);
        unlink(place(names[i]));
    }
    duct_canvas_free(canvas);
}

static int files_there(void)
{
    int count = 0;
    DIR *open_folder = opendir(folder);
    assert_non_null(open_folder);
    struct dirent *entry;
    while ((entry = readdir(open_folder)) != NULL) {
        count += entry->d_name[0] != '.' || strlen(entry->d_name) > 2;
    }
    closedir(open_folder);
    return count;
}

static void refused_writing_leaves_nothing(void **state)
{
    (void)state;
    duct_canvas *canvas = ramp(20, 20);
    assert_true(duct_image_writable("x.PNG") && duct_image_writable("x.tiff") &&
                duct_image_writable("x.exr"));
    assert_false(duct_image_writable("x.jpg") || duct_image_writable("png") || duct_image_writable(""));
    assert_int_equal(duct_image_write(NULL, canvas, place("d.gif"), NULL, &error), DUCT_UNSUPPORTED);
    assert_int_not_equal(duct_image_write(NULL, canvas, place("no/folder.png"), NULL, &error), DUCT_OK);
    assert_non_null(strstr(error.message, "folder.png"));
    duct_image_options options = {{0, 0, 0, 0}, 0, 12};
    assert_int_equal(duct_image_write(NULL, canvas, place("d.png"), &options, &error), DUCT_UNSUPPORTED);
    options = (duct_image_options){{NAN, 7, -1, NAN}, NAN, 0};
    assert_ok(duct_image_write(NULL, canvas, place("d.png"), &options, &error));
    unlink(place("d.png"));
    assert_int_equal(mkdir(place("e.png"), 0777), 0);
    assert_int_equal(duct_image_write(NULL, canvas, place("e.png"), NULL, &error), DUCT_IO);
    assert_int_equal(rmdir(place("e.png")), 0);
    assert_int_equal(files_there(), 0);
    duct_canvas_free(canvas);
}

static void broken_files_are_refused(void **state)
{
    (void)state;
    static const char *const names[] = {"f.png", "f.tif", "f.exr"};
    duct_canvas *canvas = ramp(300, 200);
    duct_image image = {0};
    for (size_t i = 0; i < 3; i++) {
        size_t size;
        assert_ok(duct_image_write(NULL, canvas, place(names[i]), NULL, &error));
        char *data = get(place(names[i]), &size);
        static const double parts[] = {0.01, 0.3, 0.6, 0.9};
        for (size_t k = 0; k < 4; k++) {
            put(place(names[i]), data, (size_t)((double)size * parts[k]));
            duct_status status = duct_image_read(NULL, place(names[i]), &image, &error);
            if (status != DUCT_BAD_FORMAT) {
                fail_msg("%s cut to %g: %d", names[i], parts[k], (int)status);
            }
            assert_non_null(strstr(error.message, names[i]));
        }
        free(data);
        unlink(place(names[i]));
    }
    duct_canvas_free(canvas);
    put(place("g.png"), "", 0);
    assert_int_equal(duct_image_read(NULL, place("g.png"), &image, &error), DUCT_BAD_FORMAT);
    assert_non_null(strstr(error.message, "empty"));
    put(place("g.png"), "this is text\n", 13);
    assert_int_equal(duct_image_read(NULL, place("g.png"), &image, &error), DUCT_BAD_FORMAT);
    unlink(place("g.png"));
    assert_int_equal(duct_image_read(NULL, place("g.png"), &image, &error), DUCT_NOT_FOUND);
    assert_int_not_equal(duct_image_read(NULL, folder, &image, &error), DUCT_OK);
    assert_null(image.pixels);
}

static uint32_t crc(const unsigned char *data, size_t size)
{
    uint32_t sum = 0xffffffffu;
    for (size_t i = 0; i < size; i++) {
        sum ^= data[i];
        for (int k = 0; k < 8; k++) {
            sum = (sum >> 1) ^ (0xedb88320u & (0u - (sum & 1)));
        }
    }
    return ~sum;
}

static void huge_sizes_are_refused_before_memory_is_taken(void **state)
{
    (void)state;
    duct_canvas *canvas = ramp(10, 10);
    assert_ok(duct_image_write(NULL, canvas, place("h.png"), NULL, &error));
    duct_canvas_free(canvas);
    size_t size;
    unsigned char *data = (unsigned char *)get(place("h.png"), &size);
    data[16] = data[20] = 0;
    data[17] = data[21] = 1; /* 65536 + 10 a side */
    uint32_t sum = crc(data + 12, 17);
    for (int i = 0; i < 4; i++) {
        data[29 + i] = (unsigned char)(sum >> (24 - 8 * i));
    }
    put(place("h.png"), data, size);
    free(data);
    failing_allocator failing;
    failing_init(&failing, 0);
    duct_context context = duct_context_default();
    context.allocator = &failing.allocator;
    duct_image image = {0};
    assert_int_equal(duct_image_read(&context, place("h.png"), &image, &error), DUCT_LIMIT);
    assert_non_null(strstr(error.message, "65546"));
    assert_int_equal(failing.held, 0);
    unlink(place("h.png"));
}

/* Plain PNM files are the easiest to write by hand; OpenImageIO tells formats by their content too. */
static void grey_and_other_layouts_become_rgba(void **state)
{
    (void)state;
    duct_image image = {0};
    put(place("i.pgm"), "P2\n2 1\n255\n0 255\n", 17);
    assert_ok(duct_image_read(NULL, place("i.pgm"), &image, &error));
    assert_int_equal(image.width, 2);
    for (int k = 0; k < 4; k++) {
        assert_float_equal(image.pixels[k], k < 3 ? 0 : 1, 0.001f);
        assert_float_equal(image.pixels[4 + k], 1, 0.001f);
    }
    duct_image_free(NULL, &image);
    unlink(place("i.pgm"));
}

static void cut_jpeg_is_an_error(void **state)
{
    (void)state;
    const duct_image_module *module = NULL;
    assert_ok(duct_image_module_load(NULL, &module, &error));
    const duct_image_facts facts = {64, 48, 3, 0, DUCT_IMAGE_SRGB, 150, 8};
    char reason[DUCT_IMAGE_REASON_SIZE];
    void *handle = module->open_write(place("l.jpg"), &facts, reason);
    assert_non_null(handle);
    float row[64 * 3];
    for (int y = 0; y < 48; y++) {
        for (int x = 0; x < 64 * 3; x++) {
            row[x] = (float)((x * 7 + y * 13) % 64) / 63;
        }
        assert_int_equal(module->write_row(handle, y, row, reason), 1);
    }
    assert_int_equal(module->close_write(handle, 1, reason), 1);
    duct_image image = {0};
    assert_ok(duct_image_read(NULL, place("l.jpg"), &image, &error));
    assert_int_equal(image.width, 64);
    assert_float_equal(image.resolution, 150, 0.5f);
    duct_image_free(NULL, &image);
    size_t size;
    char *data = get(place("l.jpg"), &size);
    put(place("l.jpg"), data, size - 20);
    free(data);
    assert_int_equal(duct_image_read(NULL, place("l.jpg"), &image, &error), DUCT_BAD_FORMAT);
    assert_non_null(strstr(error.message, "cut off"));
    unlink(place("l.jpg"));
}

static void missing_module_is_named(void **state)
{
    (void)state;
    char *kept = strdup(getenv("DUCTUS_MODULE_FOLDER"));
    setenv("DUCTUS_MODULE_FOLDER", folder, 1);
    duct_canvas *canvas = ramp(10, 10);
    assert_int_equal(duct_image_write(NULL, canvas, place("j.png"), NULL, &error), DUCT_UNSUPPORTED);
    assert_non_null(strstr(error.message, "ductus-image.so"));
    put(place("ductus-image.so"), "no library", 10);
    assert_int_equal(duct_image_write(NULL, canvas, place("j.png"), NULL, &error), DUCT_UNSUPPORTED);
    assert_non_null(strstr(error.message, "loaded"));
    unlink(place("ductus-image.so"));
    assert_int_equal(files_there(), 0);
    duct_canvas_free(canvas);
    setenv("DUCTUS_MODULE_FOLDER", kept, 1);
    free(kept);
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    duct_canvas *canvas = ramp(30, 30);
    for (long n = 1;; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_image image = {0};
        duct_status status = duct_image_write(&context, canvas, place("k.png"), NULL, &error);
        if (status == DUCT_OK) {
            status = duct_image_read(&context, place("k.png"), &image, &error);
        }
        duct_image_free(&context, &image);
        unlink(place("k.png"));
        assert_int_equal(failing.held, 0);
        assert_int_equal(files_there(), 0);
        if (failing.calls < n) {
            assert_int_equal(status, DUCT_OK);
            break;
        }
        assert_int_equal(status, DUCT_NO_MEMORY);
    }
    duct_canvas_free(canvas);
}

static void transfer_functions_are_inverse(void **state)
{
    (void)state;
    for (int i = -100; i <= 200; i++) {
        float value = (float)i / 100;
        assert_float_equal(duct_linear_from_srgb(duct_srgb_from_linear(value)), value, 1e-5f);
    }
    assert_float_equal(duct_linear_from_srgb(0.5f), 0.2140411f, 1e-6f);
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) == NULL;
}

static int remove_folder(void **state)
{
    (void)state;
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formats_keep_colour_alpha_and_resolution),
        cmocka_unit_test(background_lies_below),
        cmocka_unit_test(same_canvas_same_bytes),
        cmocka_unit_test(refused_writing_leaves_nothing),
        cmocka_unit_test(broken_files_are_refused),
        cmocka_unit_test(huge_sizes_are_refused_before_memory_is_taken),
        cmocka_unit_test(grey_and_other_layouts_become_rgba),
        cmocka_unit_test(cut_jpeg_is_an_error),
        cmocka_unit_test(missing_module_is_named),
        cmocka_unit_test(every_allocation_may_fail),
        cmocka_unit_test(transfer_functions_are_inverse),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
