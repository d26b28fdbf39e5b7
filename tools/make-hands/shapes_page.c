/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "shapes.h"

/* Below the text, and beside its short last line. */
const shape shapes_page[] = {
    /* Lines outwards in all directions. */
    {SHAPE_LINE, 191, 1230, 100, 0, 2, 0, 0},
    {SHAPE_LINE, 189, 1239, 96, 0, 27, 0, 0},
    {SHAPE_LINE, 180, 1249, 104, 0, 61, 0, 0},
    {SHAPE_LINE, 168, 1251, 98, 0, 93, 0, 0},
    {SHAPE_LINE, 159, 1249, 101, 0, 118, 0, 0},
    {SHAPE_LINE, 150, 1241, 95, 0, 150, 0, 0},
    {SHAPE_LINE, 148, 1228, 103, 0, 183, 0, 0},
    {SHAPE_LINE, 150, 1219, 97, 0, 209, 0, 0},
    {SHAPE_LINE, 159, 1210, 99, 0, 242, 0, 0},
    {SHAPE_LINE, 168, 1208, 102, 0, 267, 0, 0},
    {SHAPE_LINE, 181, 1211, 96, 0, 301, 0, 0},
    {SHAPE_LINE, 188, 1218, 100, 0, 328, 0, 0},
    /* Gentle long waves. */
    {SHAPE_WAVE, 1090, 950, 168, 22, 0, 0, 5},
    {SHAPE_WAVE, 1935, 1035, 138, 15, 180, 0, 6},
    /* Long lines. */
    {SHAPE_LINE, 350, 1110, 420, 0, 1, 0, 0},
    {SHAPE_LINE, 770, 1150, 415, 0, 180, 0, 0},
    {SHAPE_LINE, 356, 1190, 160, 0, 89, 0, 0},
    {SHAPE_LINE, 410, 1348, 158, 0, 270, 0, 0},
    {SHAPE_LINE, 440, 1190, 200, 0, 52, 0, 0},
    {SHAPE_LINE, 640, 1350, 200, 0, 310, 0, 0},
    /* Circles and ellipses, both ways. */
    {SHAPE_ARC, 910, 1180, 78, 78, 0, -75, -385},
    {SHAPE_ARC, 1090, 1182, 76, 76, 0, -110, 385},
    {SHAPE_ARC, 1240, 1180, 44, 80, 8, -80, -380},
    {SHAPE_ARC, 1360, 1180, 46, 80, 8, -100, 380},
    {SHAPE_ARC, 1510, 1140, 86, 38, -4, -70, -380},
    {SHAPE_ARC, 1510, 1232, 84, 36, 2, -8, 378},
    {SHAPE_ARC, 870, 1318, 34, 34, 0, 180, -385},
    {SHAPE_ARC, 960, 1318, 32, 32, 0, 0, 380},
    /* Spirals. */
    {SHAPE_SPIRAL, 1720, 1190, 10, 92, 0, 0, 2.6},
    {SHAPE_SPIRAL, 1890, 1190, 76, 8, 0, 180, -2.4},
    /* Open arcs. */
    {SHAPE_ARC, 1120, 1370, 80, 70, 0, 190, 160},
    {SHAPE_ARC, 1300, 1370, 82, 72, 0, 345, -155},
    {SHAPE_ARC, 1470, 1310, 80, 60, 0, 170, -150},
    {SHAPE_ARC, 1650, 1312, 80, 60, 0, 12, 155},
    {SHAPE_ARC, 1850, 1335, 70, 62, 0, 300, -235},
    /* S curves. */
    {SHAPE_WAVE, 70, 1490, 120, 48, 0, 0, 2},
    {SHAPE_WAVE, 560, 1480, 118, 46, 180, 0, 2},
    {SHAPE_WAVE, 620, 1400, 80, 36, 82, 0, 2},
    {SHAPE_WAVE, 740, 1565, 82, -34, 278, 0, 2},
    {SHAPE_WAVE, 820, 1565, 115, 34, 325, 0, 2},
    {SHAPE_WAVE, 1240, 1430, 112, -32, 140, 0, 2},
    /* Long curves. */
    {SHAPE_ARC, 1500, 1960, 480, 480, 0, 236, 62},
    {SHAPE_ARC, 1520, 1200, 460, 400, 0, 118, -58},
    {SHAPE_ARC, 1620, 1560, 300, 130, -8, 200, 130},
    /* Corners. */
    {SHAPE_CORNERS, 120, 1700, 76, 2, 0, 205, 4},
    {SHAPE_CORNERS, 260, 1690, 78, 2, 0, 45, -4},
    {SHAPE_CORNERS, 420, 1700, 72, 4, 0, 225, 4},
    {SHAPE_CORNERS, 580, 1708, 76, 3, 0, 270, -3},
    {SHAPE_CORNERS, 1430, 1715, 62, 5, 0, 270, 5},
    /* Zigzags and hatching. */
    {SHAPE_ZIGZAG, 680, 1745, 34, 90, 0, 0, 9},
    {SHAPE_ZIGZAG, 1050, 1640, 18, 96, 90, 0, 6},
    {SHAPE_LINE, 1190, 1740, 120, 0, -58, 0, 0},
    {SHAPE_LINE, 1218, 1742, 122, 0, -57, 0, 0},
    {SHAPE_LINE, 1247, 1740, 120, 0, -59, 0, 0},
    {SHAPE_LINE, 1276, 1741, 121, 0, -58, 0, 0},
    /* Waves and loops. */
    {SHAPE_WAVE, 70, 1870, 56, 32, 0, 0, 8},
    {SHAPE_LOOPS, 620, 1905, 62, 84, 0, 0, 6},
    {SHAPE_LOOPS, 1080, 1850, 54, -46, 0, 0, 6},
    {SHAPE_WAVE, 1910, 1690, 62, 26, 181, 0, 6},
    /* Ticks and dots. */
    {SHAPE_ZIGZAG, 1500, 1890, 44, -34, -22, -0.5, 2},
    {SHAPE_LINE, 1650, 1860, 34, 0, 75, 0, 0},
    {SHAPE_LINE, 1700, 1862, 32, 0, 105, 0, 0},
    {SHAPE_LINE, 1820, 1880, 8, 0, 30, 0, 0},
    {SHAPE_LINE, 1856, 1884, 7, 0, 80, 0, 0},
};

const size_t shapes_count = sizeof shapes_page / sizeof shapes_page[0];
