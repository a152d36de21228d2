/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_dead_position.c - a motion that starts or ends in a dead position of the crank has its row there.
**
** Over the input all columns are smooth at that position, so that the row is what the rows beside it tend to: the polynomial
** through eight of them, equally spaced, continued to it.
*/
#include "../chance.h"
#include "../check.h"
#include "fourlink.h"
#include "fourlink/structures.h"

#define NODES 8
#define STEP 0.0015 /* of the range of the input */
#define SAME 1e-7   /* of the largest value of the same group in the rows beside it, */
#define SURE \
    1e-6 /* ... and ten times how far the polynomial of one row less is from that of all: at most this */
#define COLUMNS 40

enum { FOUR_BAR, ACTUATOR, ENGINE, PIN, SLIDE, LEVER, CASES };
#define GROUPS 8

/* The columns of a kind, and their groups by letters: of lengths L, speeds S, accelerations A; angular ones W and B; forces
** F; power P; numbers N. */
static const char *const columns[4][2] = {
    {"omega2, alpha2, omega3, alpha3, omega4, alpha4, C.x, C.y, C.vx, C.vy, C.ax, C.ay, G3.x, "
     "G3.y, "
     "G3.vx, G3.vy, G3.ax, G3.ay, F12x, F12y, F23x, F23y, F34x, F34y, F14x, F14y, drive, power, "
     "Fsx, "
     "Fsy, residual",
     "WBWBWBLLSSAALLSSAAFFFFFFFFFPFFN"},
    {"omega2, alpha2, omega3, alpha3, x, v, a, G3.x, G3.y, G3.vx, G3.vy, G3.ax, G3.ay, F12x, F12y, "
     "F23x, F23y, F34x, F34y, N, drive, power, Fsx, Fsy, residual",
     "WBWBLSALLSSAAFFFFFFFFPFFN"},
    {"omega2, alpha2, omega4, alpha4, slide, slide_v, slide_a, G4.x, G4.y, G4.vx, G4.vy, G4.ax, "
     "G4.ay, F12x, F12y, F23x, F23y, F34x, F34y, F14x, F14y, drive, power, Fsx, Fsy, residual",
     "WBWBLSALLSSAAFFFFFFFFFPFFN"},
    {"omega2, alpha2, omega3, alpha3, omega4, alpha4, P.x, P.v, P.a, P.rod_omega, P.rod_alpha, "
     "P.FPx, "
     "P.FPy, F12x, F12y, F23x, F23y, F34x, F34y, F14x, F14y, drive, power, Fsx, "
     "Fsy, residual",
     "WBWBWBLSAWBFFFFFFFFFFFPFFN"}};
static const char letters[] = "LSAWBFPN";

static char text[4000];
static double worst[GROUPS];
static int groups[COLUMNS], n_columns, set;
static long n_rows[CASES], n_outputs, n_ends, n_unsure;

static const struct {
    const char *input, *drive, *unit;
} cases[CASES] = {{"theta4", "rocker", "rad"}, {"ram.length", "ram", "m"},
                  {"x", "piston", "m"},        {"C.x", "piston", "m"},
                  {"slide", "slide", "m"},     {"theta4", "lever", "rad"}};

static void add_link(const char *name, double length, const char *more, double size)
{
    char line[40] = "";

    if (length > 0)
        sprintf(line, "length = %.17g m\n", length);
    sprintf(text + strlen(text),
            "[%s]\n%s%smass = %.17g kg\ninertia = %.17g kg m2\ncg = (%.17g, %.17g) m\n", name, line,
            more, between(0.1, 5), size * size * between(0.01, 2), size * between(-1, 1),
            size * between(-1, 1));
}

/* A machine whose crank does not turn fully in most cases. */
static void make_machine(int sort, int has_output)
{
    int is_wild = seldom(0.2);
    double size = seldom(0.2) ? power_of_ten(-2, 2) : 0.1, a, b, c, d, more = is_wild ? 1 : 0;
    char offset[60];

    a = size * between(2, 5) * power_of_ten(-more, more);
    b = size * between(1, 5) * power_of_ten(-more, more);
    c = size * between(1, 5) * power_of_ten(-more, more);
    d = size * between(1, 5) * power_of_ten(-more, more);
    sprintf(text, "mechanism = %s\n",
            sort <= ACTUATOR ? "four-bar"
            : sort <= PIN    ? "slider-crank"
                             : "inverted-slider-crank");
    if (sort == ENGINE || sort == PIN)
        sprintf(text + strlen(text), "[ground]\noffset = %.17g m\n",
                seldom(0.3) ? 0 : size * between(-1, 1));
    else
        sprintf(text + strlen(text), "[ground]\nlength = %.17g m\n", d);
    add_link("crank", a, "", size);
    if (sort <= ACTUATOR) {
        add_link("coupler", b, "", size);
        add_link("rocker", c, "", size);
        if (sort == ACTUATOR)
            sprintf(text + strlen(text),
                    "[actuator ram]\nlink = rocker\nat = (%.17g, %.17g) m\nto = ground\n"
                    "to_at = (%.17g, %.17g) m\n",
                    size * between(-2, 2), size * between(-2, 2), size * between(-4, 4),
                    size * between(-4, 4));
    } else if (sort <= PIN) {
        add_link("rod", a * between(0.5, 1.1), "", size);
        sprintf(text + strlen(text), "[piston]\nmass = %.17g kg\n", between(0.1, 5));
    } else {
        sprintf(offset, "offset = %.17g m\n",
                (seldom(0.5) ? -1 : 1) * between(1.02, 1.5) * fabs(a - d));
        add_link("slider", 0, "", size);
        add_link("lever", 0, offset, size);
    }
    sprintf(text + strlen(text),
            "[load L]\nlink = %s\nforce = (%.17g, %.17g) N\nat = (%.17g, 0) m\n",
            sort <= ACTUATOR ? "coupler"
            : sort <= PIN    ? "rod"
                             : "lever",
            between(-100, 100), between(-100, 100), size * between(-2, 2));
    if (has_output)
        sprintf(
            text + strlen(text),
            "[output P]\nlink = coupler\nat = (%.17g, %.17g) m\nrod = %.17g m\nmass = %.17g kg\n"
            "line = (0, %.17g) m\nangle = %.17g deg\n",
            b * between(-1, 1), b * between(-1, 1), 3 * (a + b + c + d), between(0.1, 5),
            size * between(-1, 1), between(0, 360));
}

static void choose_columns(int which)
{
    const char *of = columns[which][1];

    set = which;
    for (n_columns = 0; of[n_columns]; n_columns++)
        groups[n_columns] = (int)(strchr(letters, of[n_columns]) - letters);
}

static fourlink_results *open_machine(int sort, int branch, int side, double speed, int dyad)
{
    char whole[5000];
    fourlink_source source;
    fourlink_results *results;

    sprintf(whole,
            "solver = %s\n%s[motion]\ninput = %s\ndrive = %s\nside = %s\n"
            "speed = %.17g %s/s\nacceleration = %.17g %s/s2\nhold = yes\n[table]\nbranch = %s\n"
            "columns = %s\n[units]\nangle = rad\n",
            dyad ? "dyad" : "matrix", text, cases[sort].input, cases[sort].drive,
            side > 0 ? "rising" : "falling", speed, cases[sort].unit, speed * between(-3, 3),
            cases[sort].unit, branch > 0 ? "open" : "crossed", columns[set][0]);
    memset(&source, 0, sizeof source);
    source.text = whole;
    source.length = (unsigned long)strlen(whole);
    source.units = "SI";
    return fourlink_results_open(&source, 0, &results, NULL, NULL) == FOURLINK_OK ? results : NULL;
}

/* The polynomial through the values at 1 ... n, at 0. */
static double continued(double values[NODES][COLUMNS], int column, int n)
{
    double sum = 0, factor = -1;
    int k;

    for (k = 1; k <= n; k++) {
        factor *= -(double)(n - k + 1) / k;
        sum += factor * values[k - 1][column];
    }
    return sum;
}

/* Compare the row of an end, if it is a dead position; 0 if the rows beside it do not tell what it must be. */
static int check_end(fourlink_results *results, int sort, int branch, unsigned long i,
                     unsigned long j)
{
    double row[COLUMNS], beside[NODES][COLUMNS], largest[GROUPS] = {0}, gap = 0, limit, less, error;
    fourlink_instant end, other;
    int k, c;

    if (fourlink_results_row(results, (fourlink_branch)branch, i, row, &end, NULL) != FOURLINK_OK ||
        end.state.sine != 0)
        return 0;
    fourlink_results_row(results, (fourlink_branch)branch, j, NULL, &other, NULL);
    for (k = 0; k < NODES; k++) {
        if (fourlink_results_along(results, (fourlink_branch)branch,
                                   end.row.place +
                                       (k + 1) * STEP * (other.row.place - end.row.place),
                                   beside[k], NULL, NULL) != FOURLINK_OK)
            return 0;
        for (c = 0; c < n_columns; c++)
            largest[groups[c]] = fmax(largest[groups[c]], fabs(beside[k][c]));
    }
    largest[GROUPS - 1] = 1; /* of numbers */
    n_ends++;
    for (c = 0; c < n_columns; c++) {
        limit = continued(beside, c, NODES);
        less = continued(beside, c, NODES - 1);
        if (largest[groups[c]] > 0)
            gap = fmax(gap, fabs(limit - less) / largest[groups[c]]);
    }
    if (!(gap <= SURE)) {
        n_unsure++;
        return 0;
    }
    assert_true(row[0] == 0);
    for (c = 0; c < n_columns; c++) {
        limit = continued(beside, c, NODES);
        error = fabs(row[c] - limit);
        if (largest[groups[c]] > 0)
            worst[groups[c]] = fmax(worst[groups[c]], error / largest[groups[c]]);
        if (!(error <= (SAME + 10 * gap) * largest[groups[c]]))
            fail_msg("column %d: %.15g, not %.15g, of %.3g\n%s%s %d", c, row[c], limit,
                     largest[groups[c]], text, cases[sort].input, branch);
    }
    n_rows[sort]++;
    n_outputs += set == 3;
    return 1;
}

TEST(the_row_of_a_dead_position_is_what_the_rows_beside_it_tend_to)
{
    long number, n = some_of(20000);
    int i;

    for (number = 0; number < n; number++) {
        int sort = (int)(number % CASES), branch, side;
        int has_output = sort <= ACTUATOR && number / CASES % 2;

        begin_chance(71, number);
        make_machine(sort, has_output);
        choose_columns(has_output ? 3 : sort / 2);
        for (branch = 1; branch >= -1; branch -= 2)
            for (side = 1; side >= -1; side -= 2) {
                double speed = (seldom(0.5) ? -1 : 1) * between(0.2, 3);
                fourlink_results *results = open_machine(sort, branch, side, speed, one_of(2));
                fourlink_problem problem;

                if (!results)
                    continue;
                fourlink_deck_problem(fourlink_results_deck(results), &problem);
                if (problem.n_rows > 1) {
                    check_end(results, sort, branch, 0, problem.n_rows - 1);
                    check_end(results, sort, branch, problem.n_rows - 1, 0);
                }
                fourlink_results_free(results);
            }
    }
    printf("%ld machines, %ld ends, %ld not told by the rows beside them; worst", n, n_ends,
           n_unsure);
    for (i = 0; i < GROUPS; i++)
        printf(" %.1e", worst[i]);
    printf("; of each input");
    for (i = 0; i < CASES; i++)
        printf(" %s %ld", cases[i].input, n_rows[i]);
    printf("; %ld with an output\n", n_outputs);
    assert_true(n_outputs > n / 50);
    for (i = 0; i < CASES; i++)
        assert_true(n_rows[i] > n / 100);
    assert_true(n_unsure < n_ends / 4);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
