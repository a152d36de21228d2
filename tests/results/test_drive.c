/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_drive.c - drives that are not the crank, by both solvers, against values of two other methods: absolute coordinates
** with multipliers, the driver at its real place; and series of the places in 40 digits with Newton's and Euler's equations
** of each body.
*/
#include "../check.h"
#include "fourlink.h"

#define EXACT 2e-11 /* of the largest force of the row: the values have 12 digits */

static const char four_bar[] =
    "mechanism = four-bar\n[ground]\nlength = 0.5 m\n"
    "[crank]\nlength = 0.15 m\nmass = 2 kg\ninertia = 0.01 kg m2\ncg = 0.07 m\n"
    "[coupler]\nlength = 0.4 m\nmass = 3 kg\ninertia = 0.05 kg m2\ncg = (0.2, 0.01) m\n"
    "[rocker]\nlength = 0.35 m\nmass = 4 kg\ninertia = 0.06 kg m2\ncg = (0.17, -0.02) m\n"
    "[load L]\nlink = coupler\nforce = (0, -150) N\nat = (0.2, 0.1) m\n";
static const char engine[] =
    "mechanism = slider-crank\n[crank]\nlength = 0.05 m\nmass = 1.2 kg\ninertia = 0.003 kg m2\n"
    "[piston]\nmass = 0.6 kg\n[load L]\nlink = piston\nforce = (-300, 0) N\n"
    "[rod]\nlength = 0.2 m\nmass = 0.8 kg\ninertia = 0.004 kg m2\n";
static const char boom[] = "mechanism = boom\n[ground]\nlength = 1.2 m\n"
                           "[boom]\nlength = 0.8 m\nmass = 40 kg\ninertia = 9 kg m2\ncg = 1.5 m\n"
                           "[load L]\nlink = crank\nforce = (0, -2000) N\nat = 2.5 m\n";
static const char yoke[] =
    "mechanism = scotch-yoke\n[ground]\noffset = 0.025 m\n"
    "[crank]\nlength = 0.06 m\nmass = 0.8 kg\ninertia = 0.0012 kg m2\ncg = 0.02 m\n"
    "[slider]\nmass = 0.25 kg\ninertia = 0.0001 kg m2\n"
    "[yoke]\nangle = 60 deg\nmass = 2.4 kg\ncg = (0.15, 0.01) m\n"
    "[load L]\nlink = yoke\nforce = (-400, 0) N\nat = 0.3 m\n";
static const char lever[] =
    "mechanism = inverted-slider-crank\n[ground]\nlength = 0.25 m\n"
    "[crank]\nlength = 0.12 m\nmass = 0.8 kg\ninertia = 0.0015 kg m2\ncg = (0.05, 0.004) m\n"
    "[slider]\nmass = 0.3 kg\ninertia = 0.00012 kg m2\ncg = (0.002, -0.001) m\n"
    "[lever]\noffset = 0.03 m\nmass = 2.5 kg\ninertia = 0.035 kg m2\ncg = (0.21, 0.012) m\n"
    "[load L]\nlink = lever\nforce = (-150, 0) N\nat = 0.45 m\n";

static const char to_ground[] =
    "[actuator A1]\nlink = rocker\nat = (0.15, 0.05) m\nto = ground\nto_at = (0.1, -0.3) m\n";
static const char to_crank[] =
    "[actuator A1]\nlink = coupler\nat = (0.1, 0.05) m\nto = crank\nto_at = (-0.05, 0.1) m\n";

static const char pins[] = "F12x, F12y, F23x, F23y, F34x, F34y, F14x, F14y, drive";
static const char guided[] = "F12x, F12y, F23x, F23y, F34x, F34y, N, M14, drive, C.x, C.vx, C.ax";
static const char slotted[] = "F12x, F12y, F23x, F23y, F34x, F34y, M34, F14x, F14y, drive";
static const char of_yoke[] = "F12x, F12y, F23x, F23y, F34x, F34y, M34, N, M14, drive";
static const char actuated[] = "F12x, F12y, F23x, F23y, F34x, F34y, F14x, F14y, A1.force, "
                               "A1.length, A1.speed, A1.acceleration";

/* A row: the crank in deg, rad/s, rad/s2, the torque that it would need, the columns. */
static const struct {
    const char *machine, *more, *drive, *branch, *columns;
    double theta2, omega2, alpha2, Ts, values[14];
} rows[] = {
    {engine,
     "cg = 0.07 m\n[ground]\noffset = 0.01 m\n",
     "piston",
     "open",
     guided,
     60,
     12,
     -40,
     -14.2395832006,
     {-1.58949929838, 13.8189064566, -1.58949929838, 2.0469064566, -0.305814416839, -2.03869443163,
      7.92469443163, 0, 299.636490199, 0.222208076416, -0.57027432905, -1.11554036243}},
    {engine,
     "cg = 0.07 m\n[ground]\noffset = 0.01 m\n",
     "piston",
     "open",
     guided,
     200,
     -8,
     100,
     3.41117900315,
     {-14.0148172815, 13.0560903057, -14.0148172815, 1.28409030571, -17.447124667, -4.68983039874,
      10.5758303987, 0, 319.545852864, 0.151170700483, -0.085400676556, 3.49788032811}},
    {engine,
     "cg = 0.07 m\n[ground]\noffset = 0.01 m\n",
     "piston",
     "open",
     guided,
     330,
     5,
     0,
     9.99268451649,
     {-7.25336289289, 15.9597310187, -7.25336289289, 4.18773101874, -6.34968316471, -3.98526898126,
      9.87126898126, 0, 305.619476274, 0.240214956864, 0.163482455999, -1.21701148474}},
    {four_bar,
     to_ground,
     "A1",
     "open",
     actuated,
     50,
     0,
     0,
     11.4165505273,
     {249.486690939, 307.790660231, 249.486690939, 288.170660231, 249.486690939, 108.740660231,
      127.33969237, 445.020910794, -637.754318063, 0.540381840582, 0, 0}},
    {four_bar,
     to_ground,
     "A1",
     "open",
     actuated,
     110,
     3,
     -5,
     -13.4588628582,
     {-35.2439374146, 107.412874395, -36.3326676298, 88.7374729972, -39.2179079994, -88.8443977575,
      -71.9436809206, -34.755295264, 197.543880131, 0.488834581708, -0.204393011556,
      0.234687566822}},
    {four_bar,
     to_ground,
     "A1",
     "open",
     actuated,
     290,
     -2,
     4,
     12.0590523385,
     {-36.9039145658, 111.9502337, -37.2386111532, 91.612474552, -38.7379570579, -89.8391391687,
      -104.627563778, -73.9285607271, 250.088385108, 0.434820735329, -0.0964383238614,
      0.382291383916}},
    {four_bar,
     "",
     "rocker",
     "open",
     pins,
     50,
     0,
     0,
     11.4165505273,
     {249.486690939, 307.790660231, 249.486690939, 288.170660231, 249.486690939, 108.740660231,
      -249.486690939, -69.500660231, 92.7607134174}},
    {four_bar,
     "",
     "rocker",
     "open",
     pins,
     110,
     3,
     -5,
     -13.4588628582,
     {-35.2439374146, 107.412874395, -36.3326676298, 88.7374729972, -39.2179079994, -88.8443977575,
      40.7213068236, 127.510490144, -31.1068178398}},
    {four_bar,
     "",
     "rocker",
     "open",
     pins,
     290,
     -2,
     4,
     12.0590523385,
     {-36.9039145658, 111.9502337, -37.2386111532, 91.612474552, -38.7379570579, -89.8391391687,
      40.0926094524, 130.032886184, -38.1685267951}},
    {boom,
     "",
     "slide",
     "open",
     "F12x, F12y, F23x, F23y, F14x, F14y, drive, slide, slide_v, slide_a",
     40,
     0.2,
     0,
     4281.11597482,
     {4071.75803339, -1176.73933594, 4073.59654005, -3567.59664568, -4073.59654005, 3567.59664568,
      5414.97318529, 0.780509237108, 0.158121409962, 0.00565493157237}},
    {boom,
     "",
     "slide",
     "open",
     "F12x, F12y, F23x, F23y, F14x, F14y, drive, slide, slide_v, slide_a",
     100,
     0.2,
     0,
     -970.450205711,
     {-1373.95657877, 3198.74496615, -1374.3733344, 808.708504758, 1374.3733344, -808.708504758,
      -1594.65090474, 1.55351359863, 0.121713185353, -0.0138281309737}},
    {boom,
     "",
     "slide",
     "open",
     "F12x, F12y, F23x, F23y, F14x, F14y, drive, slide, slide_v, slide_a",
     100,
     0.3,
     0.5,
     -920.95020571,
     {-1332.87685727, 3149.33109756, -1304.27032484, 767.458504758, 1304.27032484, -767.458504758,
      -1513.31214123, 1.55351359863, 0.18256977803, 0.273169668692}},
    {yoke,
     "",
     "yoke",
     "open",
     of_yoke,
     40,
     30,
     0,
     -22.476353059,
     {-17.7943277342, -9.69921383881, -6.76328775328, -8.29107225932, 3.57831222882, -2.06593952856,
      0, 25.6099395286, 4.1081608802, 345.238650436}},
    {yoke,
     "",
     "yoke",
     "open",
     of_yoke,
     215,
     -12,
     -40,
     25.0273154605,
     {8.45442110144, 10.69609354, 6.93418371066, 1.00231612226, 5.5089611568, -3.18060020684, 0,
      26.7246002068, 3.05427117961, 398.582234559}},
    {yoke,
     "",
     "yoke",
     "open",
     of_yoke,
     300,
     0,
     0,
     14.0084614606,
     {-4.38944975908, 12.83475, -4.38944975908, 4.98675, -4.38944975908, 2.53425, 0, 21.00975,
      3.98202499197, 404.389449759}},
    {lever,
     "",
     "lever",
     "open",
     slotted,
     60,
     6,
     20,
     -2.20539589242,
     {19.0096459062, 38.1554437014, 20.3547001027, 31.2675459087, 21.6373849166, 29.0926574192,
      -0.00261078717624, 123.022588381, -12.8197607459, -34.090446207}},
    {lever,
     "",
     "slide",
     "open",
     slotted,
     60,
     6,
     20,
     -2.20539589242,
     {97.7381590839, 174.51722853, 99.0832132804, 167.629330737, 114.974441621, 154.589478116,
      -0.00261078717624, 44.2940752029, -149.181545574, -18.2059602754}},
    {lever,
     "",
     "lever",
     "open",
     slotted,
     200,
     -5,
     10,
     -1.49085003885,
     {2.21200069024, 5.44930044211, 1.13279145973, -2.45096270715, 0.16300102513, -5.36160457759,
      0.00658167384492, 151.211976371, 28.970033807, -4.75994639077}},
    {lever,
     "",
     "slide",
     "open",
     slotted,
     200,
     -5,
     10,
     -1.49085003885,
     {54.523381596, 24.4890860052, 53.4441723655, 16.5888228559, -0.366998906798, 12.0717217397,
      0.00658167384492, 98.9005954647, 9.93024824393, 52.8657946138}},
    {lever,
     "",
     "lever",
     "crossed",
     slotted,
     200,
     -5,
     10,
     -3.09822770629,
     {3.04634100953, 5.75297548358, 1.96713177902, -2.14728766568, 0.999457551027, -5.06225365213,
      -0.00722308103638, 147.250094109, 30.7857611863, -9.50660798661}},
    {lever,
     "",
     "slide",
     "crossed",
     slotted,
     200,
     -5,
     10,
     -3.09822770629,
     {107.523104125, 43.77940743, 106.443894894, 35.8791442808, -2.30685204671, 11.6842082852,
      -0.00722308103638, 42.773330994, -7.24067076014, -109.863678652}},
    {engine,
     "cg = (0.07, 0.005) m\n[ground]\noffset = -0.02 m\n",
     "piston",
     "crossed",
     guided,
     75,
     20,
     50,
     -12.2256396258,
     {2.94468043924, 11.1705870958, 2.94468043924, -0.601412904187, 11.1775623593, 1.3873577997,
      4.4986422003, 0, 280.439514287, -0.175036750127, -0.871891370723, -13.9715389235}},
    {engine,
     "cg = (0.07, 0.005) m\n[ground]\noffset = -0.02 m\n",
     "piston",
     "crossed",
     guided,
     250,
     -8,
     0,
     14.7480445878,
     {2.24809320689, 17.9485853228, 2.24809320689, 6.17658532276, 1.40009500583, -3.22879793441,
      9.11479793441, 0, 299.068625755, -0.215272220231, -0.39450596466, 0.781201267261}},
    {four_bar,
     to_crank,
     "A1",
     "open",
     actuated,
     50,
     0,
     0,
     11.4165505273,
     {18.5809432109, 122.269233396, -127.840725475, -2.95648216822, 18.5809432109, -76.7807666039,
      -18.5809432109, 116.020766604, 180.532191647, 0.319448466791, 0, 0}},
    {four_bar,
     to_crank,
     "A1",
     "open",
     actuated,
     110,
     3,
     -5,
     -13.4588628582,
     {30.8266164461, 169.626510075, -58.411357903, -125.865111579, 26.8526458613, -26.6307620778,
      -25.3492470371, 65.2968544641, 290.512493772, 0.322610432774, -0.138984000482,
      -0.420696237391}}};

static void compare_row(size_t i, const char *solver)
{
    char text[3000];
    fourlink_source source;
    fourlink_mistake mistake;
    fourlink_results *r;
    fourlink_instant now;
    const fourlink_value *columns;
    double values[20], largest = 0;
    unsigned long n, j;
    int branch = strcmp(rows[i].branch, "open") == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;

    snprintf(text, sizeof text,
             "solver = %s\n%s%s[motion]\ndrive = %s\nat = %g deg\nspeed = %g rad/s\nacceleration = "
             "%g rad/s2\n"
             "hold = yes\n[gravity]\nacceleration = 9.81 m/s2\ndirection = -90 deg\n"
             "[units]\nlength = m\nforce = N\n[table]\nbranch = %s\ncolumns = %s\n",
             solver, rows[i].machine, rows[i].more, rows[i].drive, rows[i].theta2, rows[i].omega2,
             rows[i].alpha2, rows[i].branch, rows[i].columns);
    memset(&source, 0, sizeof source);
    source.text = text;
    source.length = strlen(text);
    if (fourlink_results_open(&source, 1, &r, &mistake, NULL) != FOURLINK_OK)
        fail_msg("row %lu, line %ld: %s", (unsigned long)i, mistake.line, mistake.message);
    fourlink_results_list(r, FOURLINK_COLUMNS, &columns, &n);
    assert_int_equal(fourlink_results_row(r, (fourlink_branch)branch, 0, values, &now, NULL),
                     FOURLINK_OK);
    for (j = 0; j < n; j++)
        largest = fmax(largest, fabs(rows[i].values[j]));
    for (j = 0; j < n; j++)
        if (!(fabs(values[j] - rows[i].values[j]) <= EXACT * largest))
            fail_msg("row %lu by %s, %s: %.12g, not %.12g", (unsigned long)i, solver,
                     columns[j].name, values[j], rows[i].values[j]);
    assert_true(now.forces.Ts == 0);
    assert_true(fabs(now.forces.at_crank - rows[i].Ts) <= EXACT * fmax(1, fabs(rows[i].Ts)));
    assert_true(fabs(now.forces.residual) < 1e-12);
    fourlink_results_free(r);
}

TEST(rows_are_those_of_two_other_methods)
{
    size_t i;

    for (i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        compare_row(i, "matrix");
        compare_row(i, "dyad");
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
