/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_card.c - curves from files as instruments write them: each form that is read beside one that is
** refused; bare numbers.
*/
#include "outcome.h"
#include "elements.h"
#include "deck/reader.h"

/* Nine lines; the indicator is open. */
#define ENGINE                   \
    "mechanism = slider-crank\n" \
    "[crank]\n"                  \
    "length = 50 mm\n"           \
    "[rod]\n"                    \
    "length = 200 mm\n"          \
    "[gas]\n"                    \
    "bore = 80 mm\n"             \
    "# no pressure\n"            \
    "\n"

/* The same card in all: 1 bar at 0, 32.5 bar at 20.5 deg, 4 bar at 180 deg. */
static const struct {
    const char *key, *file;
} same[] = {
    {"file card.csv deg bar", "0 1\n20.5 32.5\n180 4\n"},
    {"file card.csv deg bar", "0,1\n20.5,32.5\n180,4\n"},
    {"file card.csv deg bar", "0, 1\r\n20.5, 32.5\r\n180, 4\r\n"},
    {"file card.csv deg bar", "0\t1\n20.5\t32.5\n180\t4\n"},
    {"file card.csv deg bar", " 0 \t 1 \n20.5\t\t32.5\n180\t4\t\n"},
    {"file card.csv deg bar", "0;1\n20.5;32.5\n180;4\n"},
    {"file card.csv deg bar", "0;1\n20,5;32,5\n180;4,0\n"},
    {"file card.csv deg bar", "0 ; 1\n20,5 ; 32,5\n180 ; 4,0 ;\n"},
    {"file card.csv deg bar", "0;1;;\n20,5;32,5;;\n180;4;;\n"},
    {"file card.csv deg bar", "\357\273\277# a card\n\n0 1 # top\n; a remark\n20.5 32.5\n180 4"},
    {"file card.csv deg bar", "0 1 ; at the top\n20.5 32.5\n180 4\n"},
    {"file card.csv deg bar", "\342\210\2220 1 ; a minus of print\n20.5 32.5\n180 4\n"},
    {"file card.csv deg bar", "\"0\",\"1\"\n\"20.5\",\"32.5\"\n\"180\",\"4\"\n"},
    {"file card.csv deg bar", "\"0\";\"1\"\n\"20,5\";\"32,5\"\n\"180\";\"4\"\n"},
    {"file card.csv bar", "0 1\n20.5 32.5\n180 4\n"},
    {"file card.csv \302\260 bar", "0 1\n20.5 32.5\n180 4\n"},
    {"file \"my card.csv\" deg bar", "0 1\n20.5 32.5\n180 4\n"},
    {"file my card.csv deg bar", "0 1\n20.5 32.5\n180 4\n"},
    {"file card.csv deg kPa", "0 100\n20.5 3250\n180 400\n"},
    {"file card.csv", "Angle [deg],Pressure [bar]\n0,1\n20.5,32.5\n180,4\n"},
    {"file card.csv", "angle (deg);p (bar)\n0;1\n20,5;32,5\n180;4\n"},
    {"file card.csv", "phi/deg;p/kPa\n0;100\n20,5;3250\n180;400\n"},
    {"file card.csv", "deg\tbar\n0\t1\n20.5\t32.5\n180\t4\n"},
    {"file card.csv", "deg bar\n0 1\n20.5 32.5\n180 4\n"},
    {"file card.csv", "crank angle [deg]  p [bar]\n0 1\n20.5 32.5\n180 4\n"},
    {"file card.csv", "crank angle deg,cylinder pressure bar\n0,1\n20.5,32.5\n180,4\n"},
    {"file card.csv", "\"phi [\302\260CA]\";\"p [bar]\"\n0;1\n20,5;32,5\n180;4\n"},
    {"file card.csv", "CAD,p_bar\n0,1\n20.5,32.5\n180,4\n"},
    {"file card.csv", "phi;p (abs) [bar]\n0;1\n20,5;32,5\n180;4\n"},
    {"file card.csv", "phi;p\ndeg;bar\n0;1\n20,5;32,5\n180;4\n"},
    {"file card.csv deg bar", "phi,p\n0,1\n20.5,32.5\n180,4\n"},
    {"file card.csv deg bar", "phi [deg],p [bar]\n0,1\n20.5,32.5\n180,4\n"},
    {"file card.csv", "0 deg, 1 bar\n20.5 deg, 32.5 bar\n180 deg, 400 kPa\n"},
    {"file card.csv", "phi [deg],p [bar]\n0,1\n20.5,32.5\n180,400 kPa\n"},
    {"file card.csv deg bar", "0,1*10^0\n20.5,3.25e1\n180,4\n"},
    {"file card.csv deg bar", "0 1\n20.5 32.5\n180 4\n360 1\n"},
};

TEST(test_forms)
{
    size_t i;

    for (i = 0; i < COUNT(same); i++) {
        char contents[400];
        deck d;

        print_message("%s\n%s\n", same[i].key, same[i].file);
        sprintf(contents, ENGINE "indicator = %s\n", same[i].key);
        read_accepted(contents, same[i].file, &d);
        assert_int_equal(d.notes.count, 0);
        assert_int_equal(gas_of(&d)->indicator.n, 3);
        assert_near(flk_curve_piece(&gas_of(&d)->indicator, 0, 0), 1e5, 1e-6);
        assert_near(flk_curve_piece(&gas_of(&d)->indicator, 20.5 * DEG, 20.5 * DEG), 32.5e5, 1e-5);
        assert_near(flk_curve_piece(&gas_of(&d)->indicator, 180 * DEG, 180 * DEG), 4e5, 1e-6);
        flk_deck_free(&d);
    }
}

/* What is refused, with its line in the file; 0: the line of the deck. */
static const struct {
    const char *key, *file;
    long line;
    const char *message;
} refused[] = {
    /* columns */
    {"file card.csv", "phi,p,V\n0,1,3\n", 1,
     "'phi,p,V' has 3 columns; a curve has two, the crank angle and the value"},
    {"file card.csv deg bar", "0,1\n20,32,5\n", 2,
     "'20,32,5' has 3 columns; a curve has two, the crank angle and the value"},
    {"file card.csv deg bar", "0;1\n20;32;5\n", 2,
     "'20;32;5' has 3 columns; a curve has two, the crank angle and the value"},
    {"file card.csv deg bar", "0\t1\n20\t32\t5\n", 2,
     "'20 32 5' has 3 columns; a curve has two, the crank angle and the value"},
    {"file card.csv deg bar", "0 1\n20 32 5\n", 2,
     "'20 32 5': two numbers in place of one; a blank does not separate thousands"},
    {"file card.csv deg bar", "0;1\n20;\n", 2,
     "expected an angle and a value, such as 20 deg 32 bar, not '20;'"},
    {"file card.csv deg bar", "phi;\n0;1\n90;2\n", 1,
     "'phi;' has 1 column; a curve has two, the crank angle and the value"},
    {"file card.csv deg bar", "crank angle pressure\n0 1\n90 2\n", 1,
     "'crank angle pressure' has 3 columns; a curve has two, the crank angle and the value"},
    /* separators and decimal marks */
    {"file card.csv deg bar", "0;1\n20,32\n", 2,
     "'20,32': mixed separators; numbers with decimal commas are separated by ;"},
    {"file card.csv deg bar", "0,1\n20;32\n", 2,
     "'20;32': mixed separators; numbers with decimal commas are separated by ;"},
    {"file card.csv deg bar", "phi,p\n0;1\n90;2\n", 2,
     "'0;1': mixed separators; numbers with decimal commas are separated by ;"},
    {"file card.csv deg bar", "0 1,5\n20 32\n", 1,
     "'0 1,5': mixed separators; numbers with decimal commas are separated by ;"},
    {"file card.csv deg bar", "0,0 1,5\n20 32\n", 1,
     "'0,0 1,5': mixed separators; numbers with decimal commas are separated by ;"},
    {"file card.csv deg bar", "0;1.5\n20;32,5\n", 2,
     "'20;32,5': decimal commas and decimal points in one file"},
    {"file card.csv deg bar", "0;1\n20;1.032,5\n", 2,
     "'20;1.032,5': a comma within a number: write it without"},
    {"file card.csv deg bar", "0,\"1,5\"\n20,\"32,5\"\n", 1,
     "'0,\"1,5\"': a comma as decimal mark: write 1.5"},
    /* headers */
    {"file card.csv", "phi;p [mmHg]\n0;1\n90;2\n", 1, "unknown unit 'mmHg' in 'mmHg'"},
    {"file card.csv", "phi;p [mm]\n0;1\n90;2\n", 1,
     "'mm' is a length; expected a pressure, such as 2 N/mm2"},
    {"file card.csv", "p [bar];phi [deg]\n0;1\n90;2\n", 1,
     "'bar' is a pressure; expected an angle, such as 40 deg"},
    {"file card.csv deg bar", "phi [deg];p [kPa]\n0;1\n90;2\n", 1,
     "the header has the unit 'kPa', the deck 'bar'"},
    {"file card.csv deg bar", "phi;p\nangle;pressure\n0;1\n90;2\n", 2,
     "expected an angle, such as 40 deg, not 'angle;pressure'"},
    {"file card.csv deg bar", "0;1\nphi;p\n90;2\n", 2,
     "expected an angle, such as 40 deg, not 'phi;p'"},
    {"file card.csv deg bar", "phi;p\n", 0, "a curve needs at least two points"},
    /* the key */
    {"file", "0 1\n90 2\n", 0, "expected an angle, such as 40 deg, not 'file'"},
};

TEST(test_refused)
{
    size_t i;

    for (i = 0; i < COUNT(refused); i++) {
        char contents[400];
        deck d;

        print_message("%s\n%s\n", refused[i].key, refused[i].file);
        sprintf(contents, ENGINE "indicator = %s\n", refused[i].key);
        assert_int_equal(read_outcome(contents, refused[i].file, &d), 0);
        assert_true(d.mistakes.count >= 1);
        assert_string_equal(d.mistakes.list[0].message, refused[i].message);
        assert_string_equal(d.mistakes.list[0].place.source,
                            refused[i].line ? "card.csv" : "x.deck");
        assert_int_equal(d.mistakes.list[0].place.line, refused[i].line ? refused[i].line : 10);
        flk_deck_free(&d);
    }
}

TEST(test_missing)
{
    check_mistake(ENGINE "indicator = file card.csv\n", NULL, 10,
                  "cannot read the file 'card.csv'");
    check_mistake(
        ENGINE "indicator = file card.csv deg baar\n", NULL, 10,
        "cannot read the file 'card.csv deg baar'; units after its name are written as in "
        "deg bar");
    check_mistake(ENGINE "indicator = file \"card.csv\" deg bar\n", NULL, 10,
                  "cannot read the file 'card.csv'");
    /* without the word */
    check_mistake(ENGINE "indicator = card.csv\n", NULL, 10,
                  "expected a pressure or a curve, not 'card.csv'; did you mean 'file card.csv'?");
    check_mistake(ENGINE "indicator = \"my card.csv\"\n", NULL, 10,
                  "expected a pressure or a curve, not '\"my card.csv\"'; did you mean 'file "
                  "\"my card.csv\"'?");
    check_mistake(ENGINE "indicator = bar\n", NULL, 10,
                  "expected an angle, such as 40 deg, not 'bar'");
}

#define NOTE(unit, largest, example)                                                  \
    "the values of this curve are read as " unit ", the largest as " largest " " unit \
    ": give their unit, such as '" example "'"

/* Bare numbers are in the deck's unit, or in SI units: that is noted, unless the deck says it. */
TEST(test_bare_numbers)
{
    check_note(ENGINE "indicator = file card.csv\n", "0 1\n90 45\n180 -7\n", 10,
               NOTE("Pa", "45", "file card.csv deg bar"));
    check_note(ENGINE "indicator = file card.csv\n", "phi;p\n0;1\n90;-45,5\n180;7\n", 10,
               NOTE("Pa", "45.5", "file card.csv deg bar"));
    check_note(ENGINE "indicator = 0 1, 90 45\n", NULL, 10, NOTE("Pa", "45", "20 deg 32 bar"));
    check_note(ENGINE "pressure = 1 bar\n[load]\nlink = crank\ntorque = file t.csv\n",
               "0 1\n90 45\n", 13, NOTE("N.m", "45", "file card.csv deg N m"));
    check_note(ENGINE "pressure = 1 bar\n[load]\nlink = piston\nforce = 0 3, 90 -4\n", NULL, 13,
               NOTE("N", "4", "20 deg (43, 25) N"));
    check_note(ENGINE "indicator = file card.csv\n[units]\npressure = bar\n", "0 1\n90 45\n", 0,
               NULL);
    check_note(ENGINE "indicator = file card.csv bar\n", "0 1\n90 45\n", 0, NULL);
    check_note(ENGINE "indicator = file card.csv\n", "0 1\n90 45 Pa\n", 0, NULL);
    check_note(ENGINE "indicator = file card.csv\n", "phi,p [Pa]\n0,1\n90,45\n", 0, NULL);
    check_note(ENGINE "indicator = 0 0, 90 0\n", NULL, 0, NULL);
}

/* Files of any contents: a curve, or mistakes with lines of the file. */
TEST(test_random_files)
{
    static const char likely[] =
        "0123456789012345..,,;;\t\t  \"#[]()/-\n\n\n\n\rdegbar\260\302\267^*e";
    static const char *const keys[] = {"file card.csv", "file card.csv deg bar"};
    uint64_t seed = 14;
    int i, good = 0;

    for (i = 0; i < some_of(20000); i++) {
        char contents[400], file[120];
        size_t n = (size_t)uniform(&seed, 0, sizeof file), k, lines = 1;
        deck d;

        for (k = 0; k + 1 < n; k++) {
            file[k] = i % 4 ? likely[(size_t)uniform(&seed, 0, sizeof likely - 1)]
                            : (char)(1 + (unsigned char)uniform(&seed, 0, 255));
            lines += file[k] == '\n' || file[k] == '\r';
        }
        file[k] = '\0';
        if (i % 8 == 1) /* often a curve */
            sprintf(file, "%d%s%d\n%d;%d\n", i % 90, i % 3 ? ";" : ",", i, 91 + i % 100, i % 7);
        sprintf(contents, ENGINE "indicator = %s\n", keys[i % 2]);
        {
            fourlink_source source = deck_source(contents);

            source.load = load_text;
            source.host = file;
            good += flk_deck_read(&source, &d) == 1;
        }
        for (k = 0; k < d.mistakes.count; k++)
            if (strcmp(d.mistakes.list[k].place.source, "card.csv") == 0)
                assert_in_range(d.mistakes.list[k].place.line, 1, lines + 2);
        for (k = 0; k < 20 && gas_of(&d)->indicator.n; k++)
            assert_true(fabs(flk_curve_piece(&gas_of(&d)->indicator, (double)k, (double)k)) <=
                        FOURLINK_NUMBER_MAX);
        flk_deck_free(&d);
    }
    print_message("%d in order\n", good);
    assert_in_range(good, some_of(500), some_of(19000));
}

int main(void)
{
    return run_all_tests(NULL);
}
