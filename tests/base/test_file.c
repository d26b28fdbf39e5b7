/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/file.h"

#include <dirent.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct {
    const duct_allocator *allocator;
    char folder[64], path[100];
} place;

static int set_up(void **state)
{
    place *p = calloc(1, sizeof *p);
    if (p == NULL) {
        return -1;
    }
    p->allocator = duct_allocator_of(NULL);
    strcpy(p->folder, "/tmp/ductus-file-XXXXXX");
    *state = p;
    if (mkdtemp(p->folder) == NULL) {
        return -1;
    }
    snprintf(p->path, sizeof p->path, "%s/a.txt", p->folder);
    return 0;
}

static size_t count_files(const place *p)
{
    size_t count = 0;
    DIR *folder = opendir(p->folder);
    assert_non_null(folder);
    for (struct dirent *entry = readdir(folder); entry != NULL; entry = readdir(folder)) {
        count += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    }
    closedir(folder);
    return count;
}

static int tear_down(void **state)
{
    place *p = *state;
    unlink(p->path);
    int left = rmdir(p->folder); /* fails where anything is left over */
    free(p);
    return left;
}

static void assert_content(const place *p, const char *expected)
{
    duct_error error;
    char *data;
    size_t size;
    assert_ok(duct_file_read(p->allocator, p->path, 1 << 20, &data, &size, &error));
    assert_string_equal(data, expected);
    assert_int_equal(size, strlen(expected));
    duct_release(p->allocator, data);
}

static void writes_and_replaces_whole_files(void **state)
{
    const place *p = *state;
    duct_error error;
    assert_ok(duct_file_write(p->allocator, p->path, "", 0, &error));
    assert_content(p, "");
    assert_int_equal(chmod(p->path, 0640), 0);
    assert_ok(duct_file_write(p->allocator, p->path, "new", 3, &error));
    assert_content(p, "new");
    struct stat facts;
    assert_int_equal(stat(p->path, &facts), 0);
    assert_int_equal(facts.st_mode & 0777, 0640);
    assert_int_equal(count_files(p), 1);
}

/* The disk is full, as far as this process may write. */
static void a_failed_write_leaves_the_old_file_and_nothing_else(void **state)
{
    const place *p = *state;
    duct_error error;
    enum { SIZE = 1 << 20 };
    char *large = calloc(1, SIZE);
    assert_non_null(large);
    assert_ok(duct_file_write(p->allocator, p->path, "old", 3, &error));
    struct rlimit before, tight;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    tight = before;
    tight.rlim_cur = 4096;
    void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &tight), 0);
    duct_status status = duct_file_write(p->allocator, p->path, large, SIZE, &error);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, handler);
    free(large);
    assert_int_equal(status, DUCT_IO);
    assert_int_equal(strncmp(error.message, p->path, strlen(p->path)), 0);
    assert_content(p, "old");
    assert_int_equal(count_files(p), 1);
}

static void failing_allocations_leave_the_old_file(void **state)
{
    const place *p = *state;
    duct_error error;
    assert_ok(duct_file_write(p->allocator, p->path, "old", 3, &error));
    failing_allocator failing;
    failing_init(&failing, 1);
    assert_int_equal(duct_file_write(&failing.allocator, p->path, "new", 3, &error), DUCT_NO_MEMORY);
    assert_int_equal(failing.held, 0);
    assert_content(p, "old");
    char *data;
    size_t size;
    failing_init(&failing, 1);
    assert_int_equal(duct_file_read(&failing.allocator, p->path, 100, &data, &size, &error), DUCT_NO_MEMORY);
    assert_int_equal(failing.held, 0);
    assert_int_equal(count_files(p), 1);
}

static void folders_missing_files_and_large_files_are_refused(void **state)
{
    const place *p = *state;
    duct_error error;
    char *data = NULL;
    size_t size = 77;
    assert_int_equal(duct_file_read(p->allocator, p->path, 100, &data, &size, &error), DUCT_NOT_FOUND);
    assert_int_equal(duct_file_read(p->allocator, p->folder, 100, &data, &size, &error), DUCT_IO);
    assert_int_equal(duct_file_write(p->allocator, p->folder, "x", 1, &error), DUCT_IO);
    assert_ok(duct_file_write(p->allocator, p->path, "12345", 5, &error));
    assert_int_equal(duct_file_read(p->allocator, p->path, 4, &data, &size, &error), DUCT_LIMIT);
    assert_int_equal(duct_file_read(p->allocator, "/dev/zero", 1 << 20, &data, &size, &error), DUCT_LIMIT);
    assert_null(data);
    assert_int_equal(size, 77);
}

static void what_is_no_regular_file_is_written_directly(void **state)
{
    const place *p = *state;
    duct_error error;
    assert_ok(duct_file_write(p->allocator, "/dev/null", "x", 1, &error));
    struct stat facts;
    assert_int_equal(stat("/dev/null", &facts), 0);
    assert_true(S_ISCHR(facts.st_mode));
}

static void temporary_names_keep_the_folder_and_the_ending(void **state)
{
    const place *p = *state;
    duct_error error;
    char *first, *second;
    assert_ok(duct_file_beside(p->allocator, p->path, &first, &error));
    assert_ok(duct_file_beside(p->allocator, p->path, &second, &error));
    assert_string_not_equal(first, second);
    assert_int_equal(strncmp(first, p->folder, strlen(p->folder)), 0);
    assert_string_equal(duct_path_ending(first), "txt");
    assert_ok(duct_file_commit(first, p->path, &error));
    assert_int_equal(unlink(second), 0);
    duct_release(p->allocator, first);
    duct_release(p->allocator, second);
}

static void paths_have_names_and_endings(void **state)
{
    const place *p = *state;
    assert_string_equal(duct_path_name("a/b.c"), "b.c");
    assert_string_equal(duct_path_ending("a/b.tar.gz"), "gz");
    assert_string_equal(duct_path_ending("a.b/c"), "");
    assert_string_equal(duct_path_ending(".name"), "");
    assert_true(duct_path_ends("a.SVG", "svg"));
    assert_false(duct_path_ends("svg", "svg"));
    char *joined = duct_path_join(p->allocator, "a", "b");
    assert_string_equal(joined, "a/b");
    duct_release(p->allocator, joined);
    assert_true(duct_file_is_folder(p->folder));
    assert_false(duct_file_exists(p->path));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(writes_and_replaces_whole_files, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_failed_write_leaves_the_old_file_and_nothing_else, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(failing_allocations_leave_the_old_file, set_up, tear_down),
        cmocka_unit_test_setup_teardown(folders_missing_files_and_large_files_are_refused, set_up, tear_down),
        cmocka_unit_test_setup_teardown(what_is_no_regular_file_is_written_directly, set_up, tear_down),
        cmocka_unit_test_setup_teardown(temporary_names_keep_the_folder_and_the_ending, set_up, tear_down),
        cmocka_unit_test_setup_teardown(paths_have_names_and_endings, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
