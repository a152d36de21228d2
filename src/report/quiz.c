/* SPDX-License-Identifier: GPL-3.0-or-later
**
** quiz.c - the exercise of a deck as a quiz in Moodle XML: a question of the type cloze for each design.
**
** The text of such a question is HTML with fields, as docs.moodle.org has them ("Embedded Answers (Cloze)
** question type"):
**
**    {2:NUMERICAL:=103.8:0.5~%50%-103.8:0.5#the sign is the opposite}
**
** of two marks, with the right value and its tolerance, and one with half of the marks and what is told
** then.  Braces of other texts are written as &#123; so that none of them begins a field.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "system/memory.h"
#include "system/system.h"
#include "system/xml.h"
#include "page.h"
#include "pictures/plot.h"
#include "quiz.h"
#include "report.h"
#include "view/results.h"

#define MOST_PARTS 100 /* by which marks are multiplied, so that they are whole */

/* What a question is written from. */
typedef struct quiz {
    page page; /* of the text, which is HTML */
    const char *title;
    const fourlink_source *source;
    view v;
    unsigned long design;
    int marks_times; /* by which marks are multiplied */
    fourlink_mistake *why;
} quiz;

/* ---------------------------------------------------------------------------------------------- texts */

/* Write a text of the deck as HTML; none of it begins a field. */
static void put_words(page *p, const char *words)
{
    size_t n;

    for (; *words; words += n) {
        n = strcspn(words, "{");
        xml_put(p->out, words, n);
        if (words[n]) {
            page_print(p, "&#123;");
            n++;
        }
    }
}

/* Copy HTML from a file into an element of XML, byte by byte: pieces for xml_put would cut characters.
** 0 if the file failed. */
static int put_file(FILE *out, FILE *html)
{
    int c;

    if (fflush(html) != 0 || ferror(html))
        return 0;
    rewind(html);
    while ((c = getc(html)) != EOF) {
        if (c == '&' || c == '<' || c == '>')
            fputs(c == '&' ? "&amp;" : c == '<' ? "&lt;" : "&gt;", out);
        else
            putc(c, out);
    }
    return !ferror(html);
}

/* ---------------------------------------------------------------------------------------------- fields */

/* Another answer and its hint; none of our hints has a sign of the field: } ~ # */
static void put_alternative(page *p, const fourlink_check *c, int per_cent, double value,
                            const char *hint)
{
    page_print(p, "~%%%d%%%.10g:%.6g%s%s", per_cent, value, c->tolerance, *hint ? "#" : "", hint);
}

/* A direction a turn beside it. */
static double turned(double value, double turn)
{
    return value + (value < 0 ? turn : -turn);
}

/* Another answer, and for a direction a turn beside it. */
static void put_turned(page *p, const fourlink_check *c, int per_cent, double value, double turn,
                       const char *hint)
{
    put_alternative(p, c, per_cent, value, hint);
    if (turn > 0)
        put_alternative(p, c, per_cent, turned(value, turn), hint);
}

/* 1 if an answer cannot be taken for the value itself. */
static int is_apart(const fourlink_check *c, double value)
{
    return gsl_finite(value) && fabs(value - c->computed) > 2 * c->tolerance;
}

/* The slips that are told, with part of the marks: the sign, the other branch, rpm for rad/s. */
static void put_slips(quiz *z, const fourlink_check *c, const fourlink_value *v, double turn)
{
    fourlink_branch other = c->branch == FOURLINK_OPEN ? FOURLINK_CROSSED : FOURLINK_OPEN;
    int part = z->v.problem.is_half_for_hint ? 50 : 0;
    double in_rpm = c->computed * 30 / M_PI;
    int has_sign = c->has_angle && is_apart(c, -c->computed), has_branch;
    fourlink_value there;
    char words[100];

    if (has_sign)
        put_turned(&z->page, c, part, -c->computed, turn, "the sign is the opposite");
    memset(&there, 0, sizeof there);
    has_branch = results_value(z->v.results, c->name, other, c->angle, &there) == FOURLINK_OK &&
                 !there.words && is_apart(c, there.value) &&
                 (!has_sign || fabs(there.value + c->computed) > 2 * c->tolerance);
    if (has_branch)
        put_turned(&z->page, c, part, there.value, turn,
                   flk_message(words, sizeof words, "it is the %s branch's value",
                               fourlink_branch_text((int)other)));
    if (strcmp(v->quantity, "angular_speed") == 0 && strcmp(c->unit, "rad/s") == 0 &&
        is_apart(c, in_rpm) && !(has_branch && fabs(in_rpm - there.value) <= 2 * c->tolerance))
        put_alternative(&z->page, c, part, in_rpm, "it is in rpm");
}

/* The rest of a field for words, with blanks for hyphens too, and without their end in parentheses. */
static void put_word_field(page *p, const char *words)
{
    text front, end;
    char copy[sizeof((fourlink_check *)0)->words], *c;

    if (!flk_text_cut(flk_text_of(words), " (", &front, &end))
        front = flk_text_of(words);
    flk_text_copy(front, copy, sizeof copy);
    page_print(p, "SHORTANSWER:=%s", words);
    page_print(p, strcmp(copy, words) != 0 ? "~=%s" : "", copy);
    for (c = copy; *c; c++)
        *c = (char)(*c == '-' ? ' ' : *c);
    page_print(p, "~=%s}", copy);
}

/* The field of a value. */
static void put_field(quiz *z, const fourlink_check *c, const fourlink_value *v)
{
    page *p = &z->page;
    double turn = v->flags & FOURLINK_DIRECTION ? 2 * M_PI / z->v.problem.motion.angle_unit : 0;

    page_print(p, "{%d:", (int)floor(c->marks * z->marks_times + 0.5));
    if (c->words[0]) {
        put_word_field(p, c->words);
        return;
    }
    if (gsl_isinf(c->computed)) {
        page_print(p, "SHORTANSWER:=%s}", c->computed > 0 ? "inf" : "-inf");
        return;
    }
    page_print(p, "NUMERICAL:=%.10g:%.6g", c->computed, c->tolerance);
    if (turn > 0)
        put_alternative(p, c, 100, turned(c->computed, turn), "");
    put_slips(z, c, v, turn);
    page_print(p, "} ");
    if (strcmp(c->unit, "1") != 0)
        page_print(p, "%s", c->unit);
}

/* "theta4, angle of the rocker, at 60 deg" */
static void put_name(quiz *z, const fourlink_check *c, const fourlink_value *v)
{
    page *p = &z->page;

    page_print(p, "%n", c->name);
    if (v->meaning && v->meaning[0]) {
        page_print(p, ", ");
        put_words(p, v->meaning);
    }
    if (c->has_place)
        page_print(p, ", at %.9g%U", c->place, c->place_unit);
    else if (c->has_angle)
        page_print(p, ", at %.9g%U", c->angle, z->v.units[QUANTITY_ANGLE].name);
    if (c->side)
        page_print(p, ", where it is %s", fourlink_input_side_text(c->side));
    if (c->branch == FOURLINK_CROSSED)
        page_print(p, ", crossed branch");
}

/* Refuse a value that cannot be asked for; returns 0, for the caller to return. */
static int refuse(quiz *z, const fourlink_check *c, const char *why)
{
    flk_text_copy(flk_text_of(c->file), z->why->file, sizeof z->why->file);
    z->why->line = c->line;
    flk_message(z->why->message, sizeof z->why->message,
                z->design ? "%s cannot be asked for: %s (design %ld)"
                          : "%s cannot be asked for: %s",
                c->name, why, (long)z->design);
    return 0;
}

/* Value i of the deck, with 0 for rounding error; 0 if it is not asked for. */
static int find_asked(const quiz *z, unsigned long i, fourlink_check *c)
{
    results_check(z->v.results, i, c);
    if (fabs(c->computed) <= 1e-6 * c->tolerance)
        c->computed = 0;
    return !c->is_misprint;
}

/* Find by what marks are multiplied so that they are whole. */
static void find_times(quiz *z)
{
    fourlink_check c;
    unsigned long i;
    double marks;

    for (z->marks_times = 1; z->marks_times < MOST_PARTS; z->marks_times++) {
        for (i = 0; i < z->v.problem.n_expected; i++) {
            marks = find_asked(z, i, &c) ? c.marks * z->marks_times : 0;
            if (fabs(marks - floor(marks + 0.5)) > 1e-9)
                break;
        }
        if (i == z->v.problem.n_expected)
            return;
    }
}

/* What is asked, a line each; 0 and the reason if something cannot be. */
static int put_fields(quiz *z)
{
    fourlink_check c;
    fourlink_value v;
    unsigned long i;

    find_times(z);
    page_print(&z->page, "<table>\n");
    for (i = 0; i < z->v.problem.n_expected; i++) {
        if (!find_asked(z, i, &c))
            continue;
        if (c.verdict == FOURLINK_NO_VALUE)
            return refuse(z, &c, c.message);
        if (c.tolerance_from == FOURLINK_FROM_DIGIT)
            return refuse(z, &c,
                          "it has no tolerance; add one to [grading], such as tolerance = 1 %");
        memset(&v, 0, sizeof v);
        results_value(z->v.results, c.name, c.branch, c.angle, &v);
        v.quantity = v.quantity ? v.quantity : "";
        page_print(&z->page, "<tr><td>");
        put_name(z, &c, &v);
        page_print(&z->page, "</td><td>");
        put_field(z, &c, &v);
        page_print(&z->page, "</td></tr>\n");
    }
    page_print(&z->page, "</table>\n");
    return 1;
}

/* ---------------------------------------------------------------------------------------- what is given */

/* 1 if a number of the deck is not of the exercise: the steps of the rows. */
static int is_of_rows(const char *name)
{
    return strcmp(name, "motion.interval") == 0 || strcmp(name, "motion.from") == 0 ||
           strcmp(name, "motion.to") == 0 || strcmp(name, "motion.time_step") == 0;
}

/* crank.length as "crank length" */
static void put_given_name(page *p, const char *name)
{
    char words[200], *dot;

    flk_text_copy(flk_text_of(name), words, sizeof words);
    while ((dot = strchr(words, '.')) != NULL)
        *dot = ' ';
    put_words(p, words);
}

/* The numbers that the deck gives, or with words of its own those that its designs differ in. */
static void put_given(quiz *z)
{
    int which = z->v.problem.task[0] ? FOURLINK_VARIABLES : FOURLINK_INPUTS;
    const fourlink_value *list;
    fourlink_value x;
    unsigned long n = 0, i;
    int n_put = 0;

    fourlink_results_list(z->v.results, which, &list, &n);
    for (i = 0; i < n; i++) {
        if (is_of_rows(list[i].name) ||
            (!list[i].words &&
             (fourlink_results_input(z->v.results, list[i].name, &x) != FOURLINK_OK ||
              gsl_isnan(x.value))))
            continue;
        page_print(&z->page, n_put++ ? ", " : "<p>Given: ");
        put_given_name(&z->page, list[i].name);
        page_print(&z->page, " = ");
        if (list[i].words)
            put_words(&z->page, list[i].words);
        else
            page_print(&z->page, "%.9g%U", x.value, x.unit);
    }
    page_print(&z->page, n_put ? ".</p>\n" : "");
}

static int put_text(quiz *z)
{
    const fourlink_problem *problem = &z->v.problem;

    page_print(&z->page, "<p><b>");
    put_words(&z->page, z->title);
    page_print(&z->page, "</b></p>\n<p>");
    if (problem->task[0])
        put_words(&z->page, problem->task);
    else
        page_print(&z->page, "Mechanism: %s.", fourlink_kind_text((int)z->v.kind.kind));
    page_print(&z->page,
               "</p>\n<p>Angles and torques are positive counter-clockwise; angles are measured "
               "from %s.</p>\n",
               problem->axes_on_page ? "the horizontal" : "x of link 1");
    put_given(z);
    page_print(&z->page, "<p><img src=\"@@PLUGINFILE@@/figure.svg\" alt=\"the mechanism\"/></p>\n");
    return put_fields(z);
}

/* ---------------------------------------------------------------------------------------- the question */

/* The sample calculation at the first crank angle that is asked for, and the right values. */
static int put_feedback(quiz *z)
{
    report_request request;
    fourlink_mistake mistake;
    fourlink_check c;
    char at[80] = "", number[FORMAT_SIZE];
    unsigned long i;
    int status, n_put = 0;

    page_print(&z->page, "<p>Right: ");
    for (i = 0; i < z->v.problem.n_expected; i++) {
        if (!find_asked(z, i, &c))
            continue;
        if (c.has_angle && !c.has_place && !at[0])
            flk_text_join(at, sizeof at, format_general(c.angle, 17, number), " ",
                          z->v.units[QUANTITY_ANGLE].name, (char *)NULL);
        page_print(&z->page, n_put++ ? ", %n = " : "%n = ", c.name);
        if (c.words[0])
            put_words(&z->page, c.words);
        else
            page_print(&z->page, "%.6g%U", c.computed, c.unit);
    }
    page_print(&z->page, "</p>\n");
    memset(&request, 0, sizeof request);
    request.opened = z->v.results;
    request.at = at[0] ? at : NULL;
    status = report_write_sample(z->page.out, z->source, &request, &mistake);
    return status < 0 ? -1 : 1;
}

/* Write the parts of the text, each into its own file, and from there into the question. */
static int put_parts(FILE *out, quiz *z, FILE *words, FILE *svg, FILE *feedback)
{
    page p;
    int status;

    z->page.out = words;
    status = put_text(z);
    if (status > 0)
        status = plot_write_exercise(z->source, z->v.results, svg, z->why);
    z->page.out = feedback;
    if (status > 0)
        status = put_feedback(z);
    if (status <= 0)
        return status;
    memset(&p, 0, sizeof p);
    p.out = out;
    page_print(&p, "<question type=\"cloze\">\n<name><text>%s", z->title);
    page_print(&p, z->design ? ", design %lu" : "", z->design);
    page_print(&p, "</text></name>\n<questiontext format=\"html\">\n<text>");
    status = put_file(out, words);
    page_print(&p, "</text>\n<file name=\"figure.svg\" path=\"/\" encoding=\"base64\">");
    status = fflush(svg) == 0 && status;
    rewind(svg);
    page_base64(&p, svg);
    page_print(&p, "</file>\n</questiontext>\n<generalfeedback format=\"html\">\n<text>");
    status = put_file(out, feedback) && status;
    page_print(&p, "</text>\n</generalfeedback>\n</question>\n");
    return status ? 1 : -1;
}

int quiz_put_question(FILE *out, const char *title, const fourlink_source *source,
                      fourlink_results *results, unsigned long design, fourlink_mistake *why)
{
    FILE *file[3];
    int status = 1, i;
    quiz z;

    memset(&z, 0, sizeof z);
    memset(why, 0, sizeof *why);
    z.title = title;
    z.source = source;
    z.design = design;
    z.why = why;
    view_take(&z.v, results);
    if (!view_find_motion(&z.v))
        return -1;
    for (i = 0; i < 3; i++) {
        file[i] = system_scratch();
        status = file[i] ? status : -1;
    }
    if (status > 0)
        status = put_parts(out, &z, file[0], file[1], file[2]);
    for (i = 0; i < 3; i++)
        if (file[i])
            fclose(file[i]);
    return memory_has_failed() ? -1 : status;
}

/* ------------------------------------------------------------------------------------------- the file */

void quiz_begin(FILE *out, const char *title)
{
    size_t n;
    page p;

    memset(&p, 0, sizeof p);
    p.out = out;
    page_print(&p, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n"
                   "<question type=\"category\">\n<category><text>$course$/");
    for (; *title; title += n) { /* two slashes are one in the name of a category */
        n = strcspn(title, "/");
        xml_put(out, title, n);
        if (title[n]) {
            page_print(&p, "//");
            n++;
        }
    }
    page_print(&p, "</text></category>\n</question>\n");
}

void quiz_end(FILE *out)
{
    fputs("</quiz>\n", out);
}
