/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fuzz_seeds FOLDER BRUSHES: makes FOLDER/FORMAT/... of small files that use what each reader knows, for the
 * fuzzers to start from. */
#include "base/file.h"

#include <ductus/ductus.h>

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

typedef struct {
    const char *format, *text;
} seed;

static const seed seeds[] = {
    {"svg",
     "<svg xmlns='http://www.w3.org/2000/svg' width='10cm' height='5in' viewBox='0 0 100 50'><style>.a, "
     "path{stroke:#f00;stroke-width:2px}</style><g id='layer' transform='rotate(30 5 5) scale(2,-1)'>"
     "<path class='a' id='p' d='M1 2L3,4h5v-6c1 1 2 2 3 0s1 1 2 2q1 1 2 0t3 3a5 4 20 0 1 6 6z m1e1-.5l2 2'/>"
     "<polyline points='1,2 3,4 5,6'/><line x1='1' y1='50%' x2='3em' y2='4mm' stroke='hsl(20,50%,30%)'/>"
     "<circle cx='5' cy='5' r='3'/><ellipse rx='3' ry='2'/><rect x='1' y='1' width='5' height='4' rx='1'/>"
     "</g><defs><symbol id='s'><path d='M0 0 1 1'/></symbol></defs><use href='#p' x='3'/></svg>"},
    {"inkml",
     "<ink xmlns='http://www.w3.org/2003/InkML'><annotation type='artist'>a</annotation><definitions>"
     "<context xml:id='c'><inkSource><traceFormat><channel name='X' type='decimal' units='mm'/><channel "
     "name='Y' type='decimal' units='mm' orientation='-ve'/><channel name='F' max='100'/><channel name='T' "
     "units='ms'/><intermittentChannels><channel name='OTx'/></intermittentChannels></traceFormat>"
     "<sampleRate value='100'/></inkSource></context><brush xml:id='b'><brushProperty name='color' "
     "value='#ff0000'/></brush></definitions><traceGroup><trace xml:id='t' contextRef='#c' brushRef='#b'>"
     "1 2 3 4,'1 '2 3 5,\"1\"1 * ?,2 3 4 #1f</trace><trace type='penUp'>1 1 1 1</trace><trace "
     "continuation='end' priorRef='#t'>5 6 7 8</trace></traceGroup></ink>"},
    {"cyn",
     "#\nVersion 0.0\n#\n\nphotoshop 5\n1\nunrelated\n\n1\nstroke 0\n2\n0 0 0.25 0.5 0.5 350 0.5 -0.25\n"
     "1 0.007 0.26 0.5 0.6 10 0.5 -0.25\n"},
    {"csv",
     "# c\nstroke,x,y_mm,t_ms,pressure,tilt_x_deg,tilt_y,twist,other\na,1,2,3,0.5,10,0.1,0.2,z\n\"b\"\"\",1,2"
     ",,,,,,\n\n,3,4,5,1,1,1,1,\n"},
    {"csv", "idx;SPLINE_X;SPLINE_Y;SENSOR_TIMESTAMP;SENSOR_PRESSURE;SENSOR_ALTITUDE;SENSOR_AZIMUTH\n"
            "0;1.5;2;1722443386312.5;0.07;0.6;0\n1;10;2;1722443388312.25;0.2;0.6;1.5\n"},
    {"svc", "3\n100 200 1000 1 900 600 512\n110 220 1008 0 900 600 1000\n130 240 1023 1 3100 600 700\n"},
    {"svc", "1.5 2.5 0.000 1 180.0 45.0 0.25\n2.5 2.5 0.007 1 180.0 45.0 1\n"},
    {"svc", "2\n0 0 0 1\n5 5 10 1\n"},
    {"mypaint", "# t\n0.0 1.5e+01 20 0.0 0.1 0\n0.1 16 20 0.25 0.1 -1\n0.2 1 2 0.3\n"},
    {"xopp",
     "<?xml version='1.0'?><xournal creator='Xournal++ 1.2'><page width='600' height='300'><background "
     "type='solid'/><layer name='a'><stroke tool='pen' color='#3333ccff' width='2 1 0.5 2'>30 60 60 60 90 "
     "75</stroke><stroke tool='highlighter' color='yellow' width='8'>0 0 1 "
     "1</stroke></layer></page></xournal>"},
    {"xopp",
     "<xournal version='0.4.8'><page width='6' height='3'><layer><stroke color='red' width='1 2 1'>1 1 2 2 3 "
     "3</stroke></layer></page></xournal>"},
    {"pointer-events",
     "[{\"type\":\"pointerdown\",\"clientX\":1,\"clientY\":2,\"timeStamp\":3,\"pressure\":0.25,"
     "\"tiltX\":30,\"tiltY\":-45,\"twist\":350,\"pointerId\":1,\"pointerType\":\"pen\"},{\"type\":"
     "\"pointermove\",\"pageX\":1,\"pageY\":2,\"offsetX\":1,\"offsetY\":1,\"buttons\":1,"
     "\"altitudeAngle\":1,\"azimuthAngle\":2,\"coalescedEvents\":[],\"predictedEvents\":[null]},"
     "{\"type\":\"pointerup\",\"x\":1,\"y\":2}]"},
    {"pointer-events",
     "{\"x\":[1,2,3],\"y\":[1,1,1],\"time\":[0,8,16],\"buttons\":[1,0,1],\"pressure\":[1,null,0.5]}"},
    {"pointer-events",
     "{\"x\":1,\"y\":2,\"pressure\":0.5,\"t\":1}\n{\"x\":2,\"y\":2,\"pressure\":0.5,\"a\\n\":{\"b\":"
     "[true,-1e3,\"c\"]}}\n"},
    {"brush", "{\"version\":3,\"settings\":{\"radius_logarithmic\":{\"base_value\":1.0,\"inputs\":{"
              "\"pressure\":[[0,-1],"
              "[1,1]]}},\"opaque\":{\"base_value\":1.0,\"inputs\":{}},\"hardness\":{\"base_value\":0.5,"
              "\"inputs\":{}}}}"},
    {"path", "M1 2L3,4h5v-6c1 1 2 2 3 0s1 1 2 2q1 1 2 0t3 3a5 4 20 0 1 6 6z m1e1-.5l2 2"},
    {"path",
     "M 10 10 C 20 20, 40 20, 50 10 S 80 0 90 10 Z M 0 0 A 25 26 -30 0 1 50 25 H 9 V 9 Q 1 2 3 4 T 5 6"},
    {"gzip", "some some some some text text"},
    {"index", "\001\002\003\004\005\006\007"},
    {"index", "DUCTIDX1"},
    {"trace",
     "{\"operation\":\"restyle\",\"settings\":{\"hand\":\"a\",\"select\":\"optimal\"},\"unit\":0.5,"
     "\"library\":{\"name\":\"a\",\"strokes\":2,\"samples\":9,\"stroke_samples\":[4,5]},\"strokes\":["
     "{\"id\":\"s\",\"passes\":[{\"name\":\"trajectory\",\"costs\":[1,2,3,4],\"total\":10,\"samples\":["
     "{\"candidates\":[[0,1,0.5],[1,2,0.25]],\"vectors\":[[0,1],[1,0]],\"chosen\":[0,1,0.5],\"next\":"
     "\"consecutive\",\"costs\":[1,2,3,4]},{\"candidates\":[[0,2,0.5]],\"chosen\":[0,2,0.5],\"next\":"
     "\"jump\"}"
     ",{\"candidates\":[[1,2,1]],\"chosen\":[1,2,1]}]}]},{\"id\":\"t\",\"passes\":[]}]}"},
};

static int failed;

static void put(const char *folder, const char *format, const char *name, const char *data, size_t size)
{
    char path[4096];
    duct_error error;
    snprintf(path, sizeof path, "%s/%s", folder, format);
    mkdir(path, 0777);
    snprintf(path, sizeof path, "%s/%s/%s", folder, format, name);
    if (duct_file_write(duct_allocator_of(NULL), path, data, size, &error) != DUCT_OK) {
        fprintf(stderr, "%s\n", error.message);
        failed = 1;
    }
}

/* The same by gzip. */
static void put_packed(const char *folder, const char *format, const char *name, const char *text)
{
    char packed[4096], copy[4096];
    z_stream stream = {0};
    snprintf(copy, sizeof copy, "%s", text);
    if (deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
        failed = 1;
        return;
    }
    stream.next_in = (Bytef *)copy;
    stream.avail_in = (uInt)strlen(copy);
    stream.next_out = (Bytef *)packed;
    stream.avail_out = sizeof packed;
    deflate(&stream, Z_FINISH);
    put(folder, format, name, packed, sizeof packed - stream.avail_out);
    deflateEnd(&stream);
}

static void put_brushes(const char *folder, const char *brushes)
{
    DIR *list = opendir(brushes);
    struct dirent *entry;
    while (list != NULL && (entry = readdir(list)) != NULL) {
        char path[4096], *data;
        size_t size;
        snprintf(path, sizeof path, "%s/%s", brushes, entry->d_name);
        if (duct_path_ends(path, "myb") &&
            duct_file_read(duct_allocator_of(NULL), path, 1 << 20, &data, &size, NULL) == DUCT_OK) {
            put(folder, "brush", entry->d_name, data, size);
            free(data);
        }
    }
    if (list != NULL) {
        closedir(list);
    }
}

int main(int count, char **arguments)
{
    if (count != 3) {
        fprintf(stderr, "usage: fuzz_seeds FOLDER BRUSHES\n");
        return 2;
    }
    mkdir(arguments[1], 0777);
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++) {
        char name[32];
        snprintf(name, sizeof name, "%s-%zu", seeds[i].format, i);
        put(arguments[1], seeds[i].format, name, seeds[i].text, strlen(seeds[i].text));
        if (strcmp(seeds[i].format, "xopp") == 0 || strcmp(seeds[i].format, "gzip") == 0) {
            strcat(name, "-packed");
            put_packed(arguments[1], seeds[i].format, name, seeds[i].text);
        }
        if (strstr("brush index trace path gzip", seeds[i].format) == NULL) {
            put(arguments[1], "any", name, seeds[i].text, strlen(seeds[i].text));
        }
    }
    put_brushes(arguments[1], arguments[2]);
    return failed;
}
