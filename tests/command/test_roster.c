/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_roster.c - the list of a class: random classes, written as lists and as spreadsheets do, are read back.
*/
#include "check.h"
#include "command/command.h"
#include "command/roster.h"

#define STUDENTS 40
#define FILE_NAME "test_roster.csv"

static const char *const first_names[] = {"Ada", "Zo\303\253", "Jean Luc", "Ben",    "M.",
                                          "O",   "Li",         "Name",     "Student"};
static const char *const surnames[] = {"Li",    "O'Neil",   "van der Berg", "D\303\274",
                                       "Email", "Ray, Jr.", "Ott; B.",      "X-Y"};

/* A column of a file: its headings, any of which may stand there. */
typedef struct column {
    const char *headings[5];
} column;

enum { NAME, FIRST_NAME, SURNAME, ID, LATE, EMAIL, NONSENSE, COLUMNS };

static const column columns[COLUMNS] = {{{"name", "Full name", "STUDENT", "Student name"}},
                                        {{"First name", "Given name", "first name"}},
                                        {{"Surname", "Last name", "Family Name"}},
                                        {{"id", "ID number", "Student ID"}},
                                        {{"late", "Days late"}},
                                        {{"Email", "Email address"}},
                                        {{"Marks", "", "x y z"}}};

static unsigned long pick(uint64_t *seed, unsigned long n)
{
    return (unsigned long)uniform(seed, 0, (double)n);
}

/* A class, and how its file is written. */
typedef struct class_file {
    size_t n;
    char first[STUDENTS][40], last[STUDENTS][40];
    int late[STUDENTS]; /* -1: none is given */
    int order[COLUMNS], n_columns;
    char separator;
    const char *line_end;
    int is_quoted, has_mark, has_blank_lines;
} class_file;

/* Write a field; one with a separator, or that looks like a quote, is quoted. */
static void put(FILE *f, const class_file *c, const char *words)
{
    int quoted = c->is_quoted || strpbrk(words, ",;\t") != NULL;

    fprintf(f, quoted ? "\"%s\"" : "%s", words);
}

static void put_cell(FILE *f, const class_file *c, int k, size_t i)
{
    char words[100] = "";

    switch (k) {
    case NAME:
        sprintf(words, "%s %s", c->first[i], c->last[i]);
        break;
    case FIRST_NAME:
        strcpy(words, c->first[i]);
        break;
    case SURNAME:
        strcpy(words, c->last[i]);
        break;
    case ID:
        sprintf(words, "00%d", (int)i);
        break;
    case LATE:
        if (c->late[i] >= 0)
            sprintf(words, "%d", c->late[i]);
        break;
    default:
        strcpy(words, "late");
    }
    put(f, c, words);
}

static void write_file(const class_file *c, uint64_t *seed)
{
    FILE *f = fopen(FILE_NAME, "wb");
    size_t i;
    int k;

    assert_non_null(f);
    fputs(c->has_mark ? "\357\273\277" : "", f);
    for (k = 0; k < c->n_columns; k++) {
        const column *own = &columns[c->order[k]];
        unsigned long n = 0;

        while (n < 5 && own->headings[n])
            n++;
        put(f, c, own->headings[pick(seed, n)]);
        if (k + 1 < c->n_columns)
            putc(c->separator, f);
    }
    fputs(c->line_end, f);
    for (i = 0; i < c->n; i++) {
        for (k = 0; k < c->n_columns; k++) {
            put_cell(f, c, c->order[k], i);
            if (k + 1 < c->n_columns)
                putc(c->separator, f);
        }
        fputs(i + 1 < c->n || pick(seed, 2) ? c->line_end : "", f);
        if (c->has_blank_lines && pick(seed, 3) == 0)
            fputs(c->line_end, f);
    }
    assert_int_equal(fclose(f), 0);
}

/* Choose columns, in any order: a name in one or in two, and some of the others. */
static void choose_columns(class_file *c, uint64_t *seed)
{
    int is_whole = (int)pick(seed, 2), k, other, kept;

    c->n_columns = 0;
    for (k = 0; k < COLUMNS; k++)
        if (k == NAME ? is_whole : k == FIRST_NAME || k == SURNAME ? !is_whole : pick(seed, 2) == 0)
            c->order[c->n_columns++] = k;
    for (k = c->n_columns - 1; k > 0; k--) {
        other = (int)pick(seed, (unsigned long)k + 1);
        kept = c->order[k];
        c->order[k] = c->order[other];
        c->order[other] = kept;
    }
}

static int has_column(const class_file *c, int which)
{
    int k;

    for (k = 0; k < c->n_columns; k++)
        if (c->order[k] == which)
            return 1;
    return 0;
}

static void make_class(class_file *c, uint64_t *seed)
{
    static const char separators[] = ",;\t";
    size_t i;

    memset(c, 0, sizeof *c);
    c->n = 1 + pick(seed, STUDENTS - 1);
    for (i = 0; i < c->n; i++) {
        strcpy(c->first[i], first_names[pick(seed, COUNT(first_names))]);
        strcpy(c->last[i], surnames[pick(seed, COUNT(surnames))]);
        c->late[i] = (int)pick(seed, 8) - 1;
    }
    choose_columns(c, seed);
    c->separator = separators[pick(seed, 3)];
    c->line_end = pick(seed, 2) ? "\n" : "\r\n";
    c->is_quoted = pick(seed, 3) == 0;
    c->has_mark = pick(seed, 3) == 0;
    c->has_blank_lines = pick(seed, 4) == 0;
}

TEST(test_spreadsheets)
{
    uint64_t seed = 7;
    class_file c;
    roster r;
    size_t i;
    int k, n = some_of(5000);
    char name[100], id[20];

    for (k = 0; k < n; k++) {
        make_class(&c, &seed);
        write_file(&c, &seed);
        assert_int_equal(roster_read(&r, FILE_NAME), 0);
        assert_true(r.has_header);
        assert_int_equal(r.n, c.n);
        for (i = 0; i < c.n; i++) {
            sprintf(name, "%s %s", c.first[i], c.last[i]);
            assert_string_equal(r.list[i].name.start, name);
            assert_int_equal(r.list[i].name.length, strlen(name));
            assert_near(r.list[i].late, has_column(&c, LATE) && c.late[i] > 0 ? c.late[i] : 0, 0);
            sprintf(id, "00%d", (int)i);
            assert_true(flk_text_same(r.list[i].id, has_column(&c, ID) ? id : ""));
            assert_true(c.has_blank_lines || r.list[i].line == (long)i + 2);
        }
        roster_free(&r);
    }
    remove(FILE_NAME);
}

static void write_text(const char *words)
{
    FILE *f = fopen(FILE_NAME, "wb");

    assert_non_null(f);
    assert_true(fputs(words, f) >= 0);
    assert_int_equal(fclose(f), 0);
}

/* A list of names has no header, whatever stands in its lines. */
TEST(test_lists)
{
    static const char *const lists[] = {"Ada Li\nBo Ray\n", "\357\273\277Ada Li\r\n\r\n  Bo Ray",
                                        "Ada Li\rBo Ray\r", "\nAda Li\nBo Ray\n"};
    roster r;
    size_t i;

    for (i = 0; i < COUNT(lists); i++) {
        write_text(lists[i]);
        assert_int_equal(roster_read(&r, FILE_NAME), 0);
        assert_false(r.has_header);
        assert_int_equal(r.n, 2);
        assert_string_equal(r.list[0].name.start, "Ada Li");
        assert_string_equal(r.list[1].name.start, "Bo Ray");
        roster_free(&r);
    }
    write_text("Li, Ada\nRay, Bo\n");
    assert_int_equal(roster_read(&r, FILE_NAME), 0);
    assert_string_equal(r.list[0].name.start, "Li, Ada");
    roster_free(&r);
    remove(FILE_NAME);
}

/* A header without a name, days that are none, and what is odd but can be read. */
TEST(test_odd_files)
{
    static const struct {
        const char *words;
        int status;
        size_t n;
        const char *first;
    } cases[] = {{"", EXIT_USAGE, 0, NULL},
                 {"Nachname,Vorname,Nr\nLi,Ada,1\n", EXIT_USAGE, 0, NULL},
                 {"id,late\n1,2\n", EXIT_USAGE, 0, NULL},
                 {"Email\tGroup\nx\ty\n", EXIT_USAGE, 0, NULL},
                 {"name\n", EXIT_USAGE, 0, NULL},
                 {"name,late\nAda,-1\n", EXIT_USAGE, 0, NULL},
                 {"name,late\nAda,two\n", EXIT_USAGE, 0, NULL},
                 {"name,late\n,two\nAda,2\n", 0, 1, "Ada"},
                 {"Surname,id\nLi,1\n", 0, 1, "Li"},
                 {"name,surname\nAda Li,Li\n", 0, 1, "Ada Li"},
                 {"name;late\nAda\nBo;1;2;3\n", 0, 2, "Ada"},
                 {"\"name\",\"late\"\n\"Li, Ada\",\"1\"\n", 0, 1, "Li, Ada"},
                 {"name,late\n\"Ada,1\n", 0, 1, "\"Ada"}};
    roster r;
    size_t i;

    command_be_silent(1);
    for (i = 0; i < COUNT(cases); i++) {
        write_text(cases[i].words);
        assert_int_equal(roster_read(&r, FILE_NAME), cases[i].status);
        if (!cases[i].status)
            assert_int_equal(r.n, cases[i].n);
        if (cases[i].first)
            assert_string_equal(r.list[0].name.start, cases[i].first);
        roster_free(&r);
    }
    command_be_silent(0);
    remove(FILE_NAME);
    assert_int_equal(roster_read(&r, FILE_NAME), EXIT_FILES);
    roster_free(&r);
}

int main(void)
{
    return run_all_tests(NULL);
}
