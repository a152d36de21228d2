/* SPDX-License-Identifier: GPL-3.0-or-later
**
** option_pairs.c - option_pairs FOURLINK [all]: no option does nothing.  Each option is tried beside each kind of
** output, with all also each two of those that it takes, on each kind of deck.  Either they are refused, with exit
** status 2, nothing written, and a message that names both or says what one of them needs, or each changes what is
** printed or written without it.  Without "all", the quick kinds of output on a few kinds of decks.
**
** The options are those of --help: one without a sample here is a failure.  Prints for each option with how many
** others it was done, and with how many it was only refused.
*/
#define _XOPEN_SOURCE 700

#include <dirent.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define WORDS 24 /* of a command line */
#define MADE "made"

extern char **environ;

/* ------------------------------------------------------------------------------------------ what is tried */

/* A value for each option, which changes what it can change.  What needs others has them in the outputs below. */
typedef struct sample {
    const char *option, *value; /* null: it takes none */
    int is_preference; /* 1: of messages, permissions or a terminal, which other tests see to */
} sample;

static const sample samples[] = {
    {"--set", "crank.length=24 mm", 0},
    {"--branch", "crossed", 0},
    {"--interval", "25 deg", 0},
    {"--allow-files", NULL, 1},
    {"--print-deck", NULL, 0},
    {"--pins", NULL, 0},
    {"--import", "link.txt", 0},
    {"--columns", "mu,omega3", 0},
    {"--at", "33 deg", 0},
    {"--summary", NULL, 0},
    {"--matrix", NULL, 0},
    {"--list", NULL, 0},
    {"--format", "csv", 0},
    {"--format", "json", 0},
    {"--format", "paper", 0},
    {"--format", "html", 0},
    {"--output", MADE "/output", 0},
    {"--output", MADE "/", 0},
    {"--units", "rad, in, lbf, rpm", 0},
    {"--wide", NULL, 1},
    {"--color", "always", 1},
    {"--check", NULL, 0},
    {"--check", "wrong.expect", 0},
    {"--answers", "answers", 0},
    {"--scores", NULL, 0},
    {"--feedback", MADE "/", 0},
    {"--exercise", "exam.deck", 0},
    {"--tolerance", "40 %", 0},
    {"--expect", NULL, 0},
    {"--form", NULL, 0},
    {"--quiz", MADE "/quiz.xml", 0},
    {"--plot", MADE "/plot.svg", 0},
    {"--plot", MADE "/plot.txt", 0},
    {"--plot-kind", "motion", 0},
    {"--plot-kind", "columns", 0},
    {"--plot-at", "77 deg", 0},
    {"--plot-x", "omega3", 0},
    {"--ascii", NULL, 0},
    {"--report", MADE "/report.html", 0},
    {"--report", MADE "/", 0},
    {"--plot", MADE "/", 0},
    {"--part", "1/2", 0},
    {"--design", "2", 0},
    {"--design", "all", 0},
    {"--names", "class.csv", 0},
    {"--best", "max mu_min", 0},
    {"--solve", "crank.length = 10 mm .. 30 mm where min(mu) = 64 deg", 0},
    {"--synthesis", NULL, 0},
    {"--solution", "2", 0},
    {"--effort", "2", 0}};

#define SAMPLES (sizeof samples / sizeof *samples)

/* One option asks for all that another one does. */
static const char *const includes[][2] = {
    {"--scores", "--check"},    {"--answers", "--check"}, {"--feedback", "--check"},
    {"--feedback", "--scores"}, {"--form", "--expect"},   {"--synthesis", "--print-deck"}};

/* Another sample where the first one changes nothing of an output: a value of the deck that it does print. */
static const char *const other_values[][2] = {
    {"--set", "coupler.mass=3 kg"},       {"--set", "title=Another"},
    {"--set", "motion.speed=7 rad/s"},    {"--set", "rocker.length=55 mm"},
    {"--set", "gravity.y=-1 m/s2"},       {"--set", "expect.swing=7 deg"},
    {"--set", "synthesis.mu_min=11 deg"}, {"--set", "crank.length=70 mm"},
    {"--set", "crank.mass=0 kg"},         {"--set", "flywheel.inertia=1 kg m2"},
    {"--set", "rod.length=70 mm"}};

/* Kinds of output: options that a pair is put beside. */
static const char *const outputs[][4] = {
    {NULL},
    {"--summary"},
    {"--matrix"},
    {"--list"},
    {"--check"},
    {"--check=wrong.expect"},
    {"--answers=answers"},
    {"--answers=answers", "--scores"},
    {"--check=answers", "--scores", "--format=csv"},
    {"--answers=answers", "--feedback=" MADE "/"},
    {"--expect"},
    {"--form"},
    {"--quiz=" MADE "/q.xml"},
    {"--print-deck"},
    {"--print-deck", "--pins"},
    {"--best=max mu_min"},
    {"--solve=crank.length = 10 mm .. 30 mm where min(mu) = 64 deg"},
    {"--solve=crank.length = 10 mm .. 30 mm where min(mu) = 64 deg", "--print-deck"},
    {"--synthesis"},
    {"--synthesis", "--format=table"},
    {"--synthesis", "--summary"},
    {"--synthesis", "--best=max mu_min"},
    {"--plot=" MADE "/p.svg"},
    {"--plot=" MADE "/p.txt"},
    {"--plot=" MADE "/p.svg", "--format=csv"},
    {"--plot=" MADE "/p.svg", "--plot-kind=columns"},
    {"--plot=" MADE "/p.svg", "--plot-kind=motion"},
    {"--plot=" MADE "/p.svg", "--plot-kind=vectors"},
    {"--plot=" MADE "/p.svg", "--plot-kind=limits"},
    {"--plot=" MADE "/p.svg", "--plot-kind=klein"},
    {"--plot=" MADE "/p.svg", "--plot-kind=animation"},
    {"--plot=" MADE "/p.svg", "--plot-kind=speed"},
    {"--plot=" MADE "/p.svg", "--plot-kind=error"},
    {"--report=" MADE "/r.html"},
    {"--part=1/2"},
    {"--design=2"},
    {"--design=2", "--summary"},
    {"--design=all", "--print-deck", "--output=" MADE "/"},
    {"--design=all", "--expect", "--output=" MADE "/"},
    {"--design=all", "--form", "--output=" MADE "/"},
    {"--design=all", "--report=" MADE "/"},
    {"--format=csv"},
    {"--format=json"},
    {"--format=jsonl"},
    {"--format=paper"}};

#define OUTPUTS (sizeof outputs / sizeof *outputs)

#define FOUR_BAR                                                                               \
    "title = A crank-rocker\nmechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\n"        \
    "length = 20 mm\nmass = 0.2 kg\nuniform = yes\n[coupler]\nlength = 66 mm\nmass = 0.5 kg\n" \
    "uniform = yes\n[rocker]\nlength = 56 mm\nmass = 0.6 kg\nuniform = yes\n"
#define STEADY "[motion]\nspeed = 300 rpm\ninterval = 30 deg\n"
#define EXPECT \
    "[expect]\nmu_min = 58.2 deg\n[expect]\nat = 40 deg\nmu = 70 deg\nomega3 = -9.44 rad/s\n"
#define SWEEP "[sweep]\ncrank.length = 18 mm, 60 mm\n"

typedef struct text_file {
    const char *name, *text;
} text_file;

static const text_file files[] = {
    {"plain.deck", FOUR_BAR STEADY},
    {"asked.deck", FOUR_BAR STEADY EXPECT},
    {"other.deck", FOUR_BAR STEADY EXPECT "[load W]\nlink = rocker\ntorque = 2 N m\n"},
    {"rows.deck", FOUR_BAR STEADY SWEEP},
    {"outputs.deck", FOUR_BAR STEADY SWEEP "output = mu_max, mu_min\n"},
    {"values.deck", FOUR_BAR STEADY "[table]\ncolumns = mu_min, max(omega3)\n"},
    {"instant.deck", FOUR_BAR EXPECT "[motion]\nspeed = 300 rpm\nat = 40 deg\n"},
    {"piston.deck",
     "mechanism = slider-crank\n[crank]\nlength = 20 mm\n[rod]\nlength = 66 mm\nmass = 0.5 kg\n"
     "uniform = yes\n[piston]\nmass = 0.6 kg\n" STEADY},
    {"motor.deck",
     FOUR_BAR "[motor]\nstall_torque = 2 N m\nno_load_speed = 400 rpm\n[motion]\n"
              "mode = steady\ninterval = 30 deg\n[load W]\nlink = rocker\ntorque = -0.1 N m\n"},
    {"run.deck",
     FOUR_BAR "[motor]\nstall_torque = 20 N m\nno_load_speed = 400 rpm\n[motion]\nmode = run-up\n"
              "rows = time\ntime_step = 0.01 s\nduration = 0.1 s\n"},
    {"function.deck",
     "mechanism = four-bar\n[ground]\nlength = 100 mm\n[synthesis]\ntask = function\n"
     "function = log10\nx = 1 to 2\ncrank = 45 deg to 105 deg\nrocker = 135 deg to 225 deg\n"},
    {"path.deck", "mechanism = four-bar\n[synthesis]\ntask = path\npositions = (0, 0) mm, (12, 5) "
                  "mm, (21, 16) mm\n"
                  "timing = 40 deg, 85 deg\nright = fixed (50, -10) mm\n"},
    {"returns.deck",
     "mechanism = four-bar\n[crank]\nlength = 60 mm\n[ground]\nlength = 120 mm\n[synthesis]\n"
     "task = quick-return\ntime_ratio = 1.1\nswing = 80 deg\n[sweep]\n"
     "synthesis.time_ratio = 1.1 to 1.2 step 0.05\n"},
    {"wrong.expect",
     "[expect]\nmu_min = 58.23 deg\n[expect]\nat = 40 deg\nmu = 60 deg\nomega3 = -9.44 rad/s\n"},
    {"exam.deck", FOUR_BAR "[expect]\nmu_max = 0 deg\n"},
    {"answers/anna.txt", EXPECT},
    {"answers/ben.txt", "[expect]\nmu_max = 12 deg\nmu_min = 58 deg\n"},
    {"class.csv", "Surname,First name,ID number,late\nan,Anna,1001,1\nen,Ben,1002,0\n"},
};

#define FILES (sizeof files / sizeof *files)

/* Kinds of decks. */
static const char *const decks[][3] = {{"asked.deck"},
                                       {"plain.deck"},
                                       {"outputs.deck"},
                                       {"rows.deck"},
                                       {"values.deck"},
                                       {"instant.deck"},
                                       {"piston.deck"},
                                       {"motor.deck"},
                                       {"run.deck"},
                                       {"function.deck"},
                                       {"path.deck"},
                                       {"returns.deck"},
                                       {"asked.deck", "other.deck"}};

#define DECKS (sizeof decks / sizeof *decks)

/* ------------------------------------------------------------------------------------------- runs */

static char folder[] = "/tmp/pairs.XXXXXX";
static const char *fourlink;
static unsigned long n_runs;

typedef struct outcome {
    int status, wrote; /* 1: something was printed or written */
    uint64_t sum;      /* of all of it, and of the messages */
    char messages[2000];
} outcome;

static void fail(const char *what)
{
    perror(what);
    exit(1);
}

static uint64_t mix(uint64_t sum, const char *bytes, size_t n)
{
    size_t i;

    for (i = 0; i < n; i++)
        sum = (sum ^ (unsigned char)bytes[i]) * 1099511628211u;
    return sum;
}

/* Add a file to the sum; its length. */
static size_t take_file(const char *name, uint64_t *sum)
{
    static char bytes[1 << 16];
    FILE *f = fopen(name, "rb");
    size_t n, all = 0;

    if (!f)
        fail(name);
    while ((n = fread(bytes, 1, sizeof bytes, f)) > 0) {
        *sum = mix(*sum, bytes, n);
        all += n;
    }
    fclose(f);
    return all;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Add all files that were made to the sum, by name, and remove them. */
static void take_made(outcome *o)
{
    char *names[64], path[300];
    DIR *d = opendir(MADE);
    struct dirent *e;
    size_t n = 0, i;

    while ((e = readdir(d)) != NULL && n < 64)
        if (e->d_name[0] != '.')
            names[n++] = strdup(e->d_name);
    closedir(d);
    qsort(names, n, sizeof *names, by_name);
    for (i = 0; i < n; i++) {
        snprintf(path, sizeof path, MADE "/%s", names[i]);
        o->sum = mix(o->sum, path, strlen(path));
        take_file(path, &o->sum);
        remove(path);
        free(names[i]);
        o->wrote = 1;
    }
}

static void run(const char *const *words, size_t n, outcome *o)
{
    char *arguments[WORDS + 2];
    posix_spawn_file_actions_t actions;
    FILE *err;
    pid_t child;
    size_t i;
    int status = 0;

    arguments[0] = (char *)fourlink;
    for (i = 0; i < n; i++)
        arguments[i + 1] = (char *)words[i];
    arguments[n + 1] = NULL;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "out", O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, "err", O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (posix_spawn(&child, fourlink, &actions, NULL, arguments, environ) != 0 ||
        waitpid(child, &status, 0) < 0)
        fail(fourlink);
    posix_spawn_file_actions_destroy(&actions);
    n_runs++;
    memset(o, 0, sizeof *o);
    o->status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    o->sum = mix(14695981039346656037u, (const char *)&o->status, sizeof o->status);
    o->wrote = take_file("out", &o->sum) > 0;
    err = fopen("err", "r");
    if (!err)
        fail("err");
    o->messages[fread(o->messages, 1, sizeof o->messages - 1, err)] = '\0';
    fclose(err);
    take_file("err", &o->sum);
    take_made(o);
}

/* ----------------------------------------------------------------------------------------- commands */

/* A command line: options, then decks. */
typedef struct command {
    char words[WORDS][200];
    size_t n;
} command;

static void add_word(command *c, const char *word)
{
    snprintf(c->words[c->n++], sizeof c->words[0], "%s", word);
}

static void add_sample(command *c, const sample *s)
{
    if (s->value)
        snprintf(c->words[c->n++], sizeof c->words[0], "%s=%s", s->option, s->value);
    else
        add_word(c, s->option);
}

static void run_command(const command *c, size_t deck, outcome *o)
{
    const char *words[WORDS];
    size_t i, n;

    for (n = 0; n < c->n; n++)
        words[n] = c->words[n];
    for (i = 0; i < 3 && decks[deck][i]; i++)
        words[n++] = decks[deck][i];
    run(words, n, o);
}

static void print_command(const command *c, size_t deck)
{
    size_t i;

    printf("    fourlink");
    for (i = 0; i < c->n; i++)
        printf(strchr(c->words[i], ' ') ? " '%s'" : " %s", c->words[i]);
    for (i = 0; i < 3 && decks[deck][i]; i++)
        printf(" %s", decks[deck][i]);
    printf("\n");
}

/* 1 if an option, or one with this value, is in the command. */
static int has(const command *c, const char *option)
{
    size_t i, n = strlen(option);

    for (i = 0; i < c->n; i++)
        if (strncmp(c->words[i], option, n) == 0 &&
            (c->words[i][n] == '\0' || c->words[i][n] == '='))
            return 1;
    return 0;
}

/* ------------------------------------------------------------------------------------------- verdicts */

static unsigned char done[SAMPLES][SAMPLES], refused[SAMPLES][SAMPLES]; /* by place_of */
static unsigned long n_failed, n_done, n_refused;

/* The first sample of an option. */
static size_t place_of(const char *word)
{
    size_t i, n = strcspn(word, "=");

    for (i = 0; i < SAMPLES; i++)
        if (strlen(samples[i].option) == n && strncmp(samples[i].option, word, n) == 0)
            return i;
    printf("FAILED: no sample for %s\n", word);
    exit(1);
}

static void note(unsigned char verdicts[SAMPLES][SAMPLES], const char *a, const char *b)
{
    verdicts[place_of(a)][place_of(b)] = verdicts[place_of(b)][place_of(a)] = 1;
}

static void tell(const char *what, const char *option, const command *c, size_t deck,
                 const outcome *o)
{
    n_failed++;
    printf("FAILED: %s: %s\n", option, what);
    print_command(c, deck);
    printf("    %s", o->messages);
}

static int is_refused(const outcome *o)
{
    return o->status == 2 && !o->wrote;
}

/* 1 if a command did what it was asked for; with a mistake in a deck, or a file that cannot be written, it need not
** have done all. */
static int is_done(const outcome *o)
{
    return o->status < 2;
}

/* 1 if a message names an option: not only a longer one. */
static int names(const char *messages, const char *word)
{
    size_t n = strcspn(word, "=");
    const char *at = messages;

    while ((at = strstr(at, "--")) != NULL) {
        if (strncmp(at, word, n) == 0 && !strchr("-abcdefghijklmnopqrstuvwxyz", at[n]))
            return 1;
        at += 2;
    }
    return 0;
}

/* 1 if `all` asks for all that `part` does. */
static int asks_for(const command *all, const char *part)
{
    size_t i;

    for (i = 0; i < sizeof includes / sizeof *includes; i++)
        if (strcmp(part, includes[i][1]) == 0 && has(all, includes[i][0]))
            return 1;
    return 0;
}

/* What is printed anyway, and what marks need not show: a wrong answer can be wrong in another branch too. */
static int may_do_nothing(const command *c, const char *word)
{
    static const char *const of_marks[] = {"--set", "--branch", "--tolerance", "--units"};
    size_t i;

    for (i = 0; i < sizeof of_marks / sizeof *of_marks; i++)
        if (strncmp(word, of_marks[i], strlen(of_marks[i])) == 0 &&
            (has(c, "--scores") || has(c, "--feedback")))
            return 1;
    return strcmp(word, "--format=table") == 0 && c->n > 2;
}

/* The command with a sample more. */
static command with(const command *c, const sample *s)
{
    command more = *c;

    add_sample(&more, s);
    return more;
}

/* 1 if --set does something in a command with some value, where it did nothing with its first. */
static int other_value_does(const command *without, const outcome *before, size_t deck)
{
    sample s;
    outcome o;
    command c;
    size_t i;

    for (i = 0; i < sizeof other_values / sizeof *other_values; i++) {
        memset(&s, 0, sizeof s);
        s.option = other_values[i][0];
        s.value = other_values[i][1];
        c = with(without, &s);
        run_command(&c, deck, &o);
        if (is_done(&o) && o.sum != before->sum)
            return 1;
    }
    return 0;
}

/* See that a sample changes what a command does without it. */
static void see(const sample *s, const command *without, const outcome *before, const command *c,
                const outcome *after, size_t deck)
{
    if (after->status == 1 && !after->wrote)
        return; /* there is no answer in which it could show */
    if (after->sum != before->sum || s->is_preference || asks_for(without, s->option) ||
        may_do_nothing(c, s->option))
        return;
    if (strcmp(s->option, "--set") == 0 && other_value_does(without, before, deck))
        return;
    tell("does nothing", s->option, c, deck, after);
}

/* The options of a kind of output, each beside the sample that was added: without it something else is done. */
static void see_output(const command *c, size_t n_output, const sample *added, const outcome *after,
                       size_t deck)
{
    command without;
    outcome o;
    size_t i, k;

    for (i = 0; i < n_output; i++) {
        memset(&without, 0, sizeof without);
        for (k = 0; k < c->n; k++)
            if (k != i)
                add_word(&without, c->words[k]);
        run_command(&without, deck, &o);
        if (!is_done(&o) || o.sum != after->sum || added->is_preference)
            note(done, c->words[i], added->option);
        else if (!asks_for(&without, "--check") && !may_do_nothing(c, c->words[i]))
            tell("does nothing", c->words[i], c, deck, after);
    }
}

/* 1 if a refusal says what an option needs, what is wrong with its value, or with the decks. */
static int is_lack(const char *messages)
{
    return strstr(messages, " needs ") || strstr(messages, ": error: ") ||
           strstr(messages, "several decks");
}

/* See that a refusal of a command names a sample that was added, and another option of it, unless the sample lacks
** something. */
static void see_refusal(const sample *s, const command *c, const outcome *o, size_t deck)
{
    int is_named = is_lack(o->messages), has_name = names(o->messages, s->option);
    size_t i;

    for (i = 0; i < c->n; i++) {
        if (place_of(c->words[i]) == place_of(s->option))
            continue;
        is_named |= names(o->messages, c->words[i]);
        has_name |= is_lack(o->messages) && names(o->messages, c->words[i]);
        if (names(o->messages, c->words[i]) && names(o->messages, s->option))
            note(refused, c->words[i], s->option);
    }
    if (!is_named || !(has_name || strstr(o->messages, ": error: ")))
        tell("refused without both names", s->option, c, deck, o);
}

/* Try a pair of samples that a command takes one by one. */
static void try_pair(const command *base, size_t deck, const sample *a, const sample *b,
                     const outcome *of_a, const outcome *of_b)
{
    command with_a = with(base, a), with_b = with(base, b), both = with(&with_a, b);
    outcome o;

    run_command(&both, deck, &o);
    if (is_refused(&o)) {
        see_refusal(b, &both, &o, deck);
    } else if (is_done(&o)) {
        note(done, a->option, b->option);
        see(b, &with_a, of_a, &both, &o, deck);
        see(a, &with_b, of_b, &both, &o, deck);
    }
}

/* Try all samples, and their pairs, beside a kind of output on a kind of deck. */
static void try_output(size_t output, size_t deck, int all)
{
    outcome before, after[SAMPLES];
    int is_taken[SAMPLES];
    command base;
    size_t n_output, i, k;

    memset(&base, 0, sizeof base);
    for (i = 0; i < 4 && outputs[output][i]; i++)
        add_word(&base, outputs[output][i]);
    n_output = base.n;
    run_command(&base, deck, &before);
    if (!is_done(&before))
        return;
    for (i = 0; i < SAMPLES; i++) {
        command c = with(&base, &samples[i]);

        is_taken[i] = 0;
        if (has(&base, samples[i].option))
            continue;
        run_command(&c, deck, &after[i]);
        is_taken[i] = is_done(&after[i]);
        if (is_taken[i]) {
            see(&samples[i], &base, &before, &c, &after[i], deck);
            see_output(&c, n_output, &samples[i], &after[i], deck);
        } else if (is_refused(&after[i])) {
            see_refusal(&samples[i], &c, &after[i], deck);
        }
    }
    for (i = 0; i < SAMPLES && all; i++)
        for (k = i + 1; k < SAMPLES; k++)
            if (is_taken[i] && is_taken[k] && strcmp(samples[i].option, samples[k].option) != 0)
                try_pair(&base, deck, &samples[i], &samples[k], &after[i], &after[k]);
}

/* --------------------------------------------------------------------------------------------- all */

static void make_files(void)
{
    size_t i;
    FILE *f;

    if (!mkdtemp(folder) || chdir(folder) != 0 || mkdir(MADE, 0700) != 0 ||
        mkdir("answers", 0700) != 0)
        fail(folder);
    for (i = 0; i < FILES; i++) {
        f = fopen(files[i].name, "w");
        if (!f || fputs(files[i].text, f) < 0 || fclose(f) != 0)
            fail(files[i].name);
    }
}

static void remove_files(void)
{
    size_t i;

    for (i = 0; i < FILES; i++)
        remove(files[i].name);
    remove("out");
    remove("err");
    rmdir(MADE);
    rmdir("answers");
    if (chdir("/") != 0 || rmdir(folder) != 0)
        fail(folder);
}

/* See that each option of --help has a sample, and that --help and --version say the same beside each. */
static void see_help(void)
{
    static const sample helps[] = {{"--help", NULL, 0}, {"--version", NULL, 0}};
    command c, none;
    char line[500], *option;
    outcome alone, o;
    size_t i, k;
    FILE *f;

    memset(&none, 0, sizeof none);
    for (k = 0; k < 2; k++) {
        c = with(&none, &helps[k]);
        run_command(&c, 0, &alone);
        for (i = 0; i < SAMPLES; i++) {
            command more = with(&c, &samples[i]);

            run_command(&more, 0, &o);
            if (is_done(&o) && o.sum != alone.sum)
                tell("changes help", samples[i].option, &more, 0, &o);
        }
    }
    f = popen("\"$FOURLINK\" --help", "r");
    while (f && fgets(line, sizeof line, f)) {
        option = strstr(line, "--");
        if (strncmp(line, "  ", 2) != 0 || !option || option - line != 6)
            continue;
        option[strcspn(option, "=[ \n")] = '\0';
        if (strcmp(option, "--help") != 0 && strcmp(option, "--version") != 0)
            place_of(option);
    }
    if (!f || pclose(f) != 0)
        fail("--help");
}

/* Print for each option with how many others it was done, and with how many it was only refused. */
static void print_table(void)
{
    size_t i, k;

    printf("%-14s %5s %8s\n", "option", "done", "refused");
    for (i = 0; i < SAMPLES; i++) {
        int n = 0, m = 0;

        if (i && strcmp(samples[i].option, samples[i - 1].option) == 0)
            continue;
        for (k = 0; k < SAMPLES; k++) {
            n += done[i][k];
            m += refused[i][k] && !done[i][k];
            n_done += k > i && done[i][k];
            n_refused += k > i && refused[i][k] && !done[i][k];
        }
        printf("%-14s %5d %8d\n", samples[i].option, n, m);
    }
}

/* One deck, a [sweep], several decks. */
static int is_quick_deck(size_t deck)
{
    return deck == 0 || strcmp(decks[deck][0], "outputs.deck") == 0 || deck == DECKS - 1;
}

/* Neither a report nor one of many pictures. */
static int is_quick_output(size_t output)
{
    size_t i;

    for (i = 0; i < 4 && outputs[output][i]; i++)
        if (strncmp(outputs[output][i], "--report", 8) == 0 ||
            strncmp(outputs[output][i], "--plot-kind", 11) == 0)
            return 0;
    return 1;
}

int main(int argc, char **argv)
{
    int all = argc > 2 && strcmp(argv[2], "all") == 0;
    size_t output, deck;

    if (argc < 2)
        return 2;
    fourlink = argv[1];
    setenv("FOURLINK", fourlink, 1);
    setenv("LC_ALL", "C.UTF-8", 1);
    make_files();
    see_help();
    setvbuf(stdout, NULL, _IOLBF, 0);
    for (deck = 0; deck < DECKS; deck++)
        for (output = 0; output < OUTPUTS; output++)
            if (all || (is_quick_deck(deck) && is_quick_output(output)))
                try_output(output, deck, all);
    remove_files();
    print_table();
    printf("%lu runs; %lu pairs done, %lu refused; %lu failed\n", n_runs, n_done, n_refused,
           n_failed);
    return n_failed != 0;
}
