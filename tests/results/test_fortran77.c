/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_fortran77.c - results by name as FORTRAN 77 calls them: blanks, lengths, numbers from 1, statuses.
*/
#include "check.h"
#include "fourlink.h"

static const char deck[] = "mechanism = four-bar\n[units]\nlength = mm\n[ground]\nlength = 80\n"
                           "[crank]\nlength = 20\n[coupler]\nlength = 66\n[rocker]\nlength = 56\n"
                           "[motion]\nspeed = 10.5 rad/s\ninterval = 40 deg\n"
                           "[table]\ncolumns = theta2, theta4, mu\n    ";

static int open_deck(const char *text, fourlink_results **handle, char *msg, unsigned long size)
{
    int status = -1;

    flopen_(text, handle, &status, msg, (unsigned long)strlen(text), size);
    return status;
}

static int value(fourlink_results *handle, const char *name, int branch, double angle, double *v)
{
    int status = -1;

    flval_(&handle, name, &branch, &angle, v, &status, (unsigned long)strlen(name));
    return status;
}

static int row(fourlink_results *handle, int branch, int i, int n, double *values)
{
    int status = -1;

    flrow_(&handle, &branch, &i, &n, values, &status);
    return status;
}

static int column(fourlink_results *handle, int i, char name[8], char unit[8])
{
    int status = -1;

    flname_(&handle, &i, name, unit, &status, 8, 8);
    return status;
}

TEST(test_open)
{
    fourlink_results *handle = NULL;
    char msg[60];

    assert_int_equal(open_deck(deck, &handle, msg, sizeof msg), FOURLINK_OK);
    assert_non_null(handle);
    assert_int_equal(msg[0], ' ');
    flshut_(&handle);
    assert_null(handle);
    flshut_(&handle);
}

TEST(test_mistake)
{
    fourlink_results *handle = NULL;
    char msg[60], cut[6];

    assert_int_equal(open_deck("mechanism = four-bar\n[krank]\n", &handle, msg, sizeof msg),
                     FOURLINK_BAD_DECK);
    assert_null(handle);
    assert_memory_equal(msg, "2: ", 3);
    assert_int_equal(msg[sizeof msg - 1], ' ');
    assert_int_equal(open_deck("[krank]\n", &handle, cut, sizeof cut), FOURLINK_BAD_DECK);
    assert_memory_equal(cut, "1: ", 3);
}

TEST(test_values)
{
    fourlink_results *handle;
    char msg[60];
    double v = 7;

    assert_int_equal(open_deck(deck, &handle, msg, sizeof msg), FOURLINK_OK);
    assert_int_equal(value(handle, "theta4   ", 1, 40, &v), FOURLINK_OK);
    assert_true(fabs(v - 103.820764813) < 1e-9);
    assert_int_equal(value(handle, "theta4", -1, 40, &v), FOURLINK_OK);
    assert_true(fabs(v + 126.304) < 1e-3);
    assert_int_equal(value(handle, "min(mu) ", 1, 0, &v), FOURLINK_OK);
    assert_true(fabs(v - 58.2297013788) < 1e-9);
    assert_int_equal(value(handle, "mu_min", 1, 0, &v), FOURLINK_OK);
    assert_true(fabs(v - 58.2297013788) < 1e-9);
    v = 7;
    assert_int_equal(value(handle, "type", 1, 0, &v), FOURLINK_NO_SUCH_FACT);
    assert_int_equal(value(handle, "stroke", 1, 0, &v), FOURLINK_NO_SUCH_FACT);
    assert_int_equal(value(handle, "theta5", 1, 0, &v), FOURLINK_NO_SUCH_NAME);
    assert_int_equal(value(handle, "", 1, 0, &v), FOURLINK_NO_SUCH_NAME);
    assert_int_equal(value(handle, "theta4", 0, 0, &v), FOURLINK_BAD_BRANCH);
    memset(msg, 'x', sizeof msg - 1);
    msg[sizeof msg - 1] = '\0';
    assert_int_equal(value(handle, msg, 1, 0, &v), FOURLINK_NO_SUCH_NAME);
    assert_true(v == 7);
    flshut_(&handle);
    assert_int_equal(value(handle, "mu_min", 1, 0, &v), FOURLINK_NULL);
}

/* Khurmi and Gupta's slotted lever, example 5.3, and a task that no linkage solves. */
TEST(test_synthesis)
{
    static const char task[] = "mechanism = inverted-slider-crank\n[crank]\nlength = 30 mm\n"
                               "[synthesis]\ntask = quick-return\ntime_ratio = 1.7\n";
    double wanted = 0.030 / cos(PI * 1.7 / 2.7),
           v = 0; /* A-D: the crank is at right angles to the lever */
    fourlink_results *handle;
    char msg[60];

    assert_int_equal(open_deck(task, &handle, msg, sizeof msg), FOURLINK_OK);
    assert_int_equal(value(handle, "ground.length", 1, 0, &v), FOURLINK_OK);
    assert_near(v, fabs(wanted), 1e-15);
    assert_int_equal(value(handle, "crank.length", 1, 0, &v), FOURLINK_OK);
    assert_near(v, 0.030, 1e-15);
    flshut_(&handle);
    assert_int_equal(
        open_deck("mechanism = slider-crank\n[synthesis]\ntask = quick-return\ntime_ratio = 9\n"
                  "stroke = 50 mm\n[ground]\noffset = 1 mm\n",
                  &handle, msg, sizeof msg),
        FOURLINK_NO_FULL_TURN);
    assert_null(handle);
}

TEST(test_rows)
{
    fourlink_results *handle;
    char msg[60], name[8], unit[8];
    double values[4] = {7, 7, 7, 7};
    int rows = -1, columns = -1;

    assert_int_equal(open_deck(deck, &handle, msg, sizeof msg), FOURLINK_OK);
    flnrow_(&handle, &rows, &columns);
    assert_int_equal(rows, 10);
    assert_int_equal(columns, 3);
    assert_int_equal(column(handle, 2, name, unit), FOURLINK_OK);
    assert_memory_equal(name, "theta4  ", 8);
    assert_memory_equal(unit, "deg     ", 8);
    assert_int_equal(column(handle, 0, name, unit), FOURLINK_NO_SUCH_NAME);
    assert_int_equal(column(handle, 4, name, unit), FOURLINK_NO_SUCH_NAME);
    assert_int_equal(row(handle, 1, 0, 4, values), FOURLINK_NO_SUCH_ROW);
    assert_int_equal(row(handle, 1, 11, 4, values), FOURLINK_NO_SUCH_ROW);
    assert_int_equal(row(handle, 3, 1, 4, values), FOURLINK_BAD_BRANCH);
    assert_true(values[0] == 7);
    assert_int_equal(row(handle, 1, 2, 2, values), FOURLINK_OK);
    assert_true(values[0] == 40 && fabs(values[1] - 103.820764813) < 1e-9 && values[2] == 7);
    assert_int_equal(row(handle, 1, 2, 4, values), FOURLINK_OK);
    assert_true(fabs(values[2] - 64.8344) < 1e-4 && values[3] == 7);
    flshut_(&handle);
    flnrow_(&handle, &rows, &columns);
    assert_true(rows == 0 && columns == 0);
    assert_int_equal(column(handle, 1, name, unit), FOURLINK_NULL);
    assert_int_equal(row(handle, 1, 1, 4, values), FOURLINK_NULL);
}

/* A row that is not reached has the crank's columns, and no others. */
TEST(test_unreached)
{
    static const char reach[] = "mechanism=four-bar\n[ground]\nlength=750 mm\n[crank]\n"
                                "length=300 mm\n[coupler]\nlength=400 mm\n[rocker]\n"
                                "length=500 mm\n[motion]\nspeed=1 rad/s\ninterval=40 deg\n"
                                "[table]\ncolumns = theta2, theta4\n";
    fourlink_results *handle;
    char msg[60];
    double values[2], v = 7;

    assert_int_equal(open_deck(reach, &handle, msg, sizeof msg), FOURLINK_OK);
    assert_int_equal(row(handle, 1, 4, 2, values), FOURLINK_TOO_FAR);
    assert_true(values[0] == 120 && isnan(values[1]));
    assert_int_equal(value(handle, "theta4", 1, 120, &v), FOURLINK_TOO_FAR);
    assert_true(v == 7);
    assert_int_equal(value(handle, "max(omega4)", 1, 0, &v), FOURLINK_OK);
    assert_true(isinf(v));
    flshut_(&handle);
}

int main(void)
{
    return run_all_tests(NULL);
}
