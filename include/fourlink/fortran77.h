/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fortran77.h - calls for FORTRAN 77: a part of fourlink.h, which includes it.
*/
#ifndef FOURLINK_FORTRAN77_H
#define FOURLINK_FORTRAN77_H

#ifndef FOURLINK_H
#error "include fourlink.h"
#endif

/* Calls for FORTRAN 77 programs, with the usual Unix conventions: names in lower case with a trailing
** underscore, all arguments by reference, and the lengths of texts after all arguments.  For Fortran 2003
** there is a module, fourlink.f90.
**
**       DOUBLE PRECISION LINKS(5,4), OFFSET, GRAV(2), CRANK(3), LOADS(7,*)
**       DOUBLE PRECISION ANGLE, STATE(9,4), SLIDE(4), FORCES(10)
**       INTEGER IBRNCH, NLOADS, ISTAT
**       CHARACTER*80 TEXT
**       CALL FLFBAR(LINKS, GRAV, IBRNCH, CRANK, NLOADS, LOADS, STATE, FORCES, ISTAT)
**       CALL FLSLCR(LINKS, OFFSET, GRAV, IBRNCH, CRANK, NLOADS, LOADS, STATE, FORCES, ISTAT)
**       CALL FLINVS(LINKS, OFFSET, ANGLE, GRAV, IBRNCH, CRANK, NLOADS, LOADS, STATE, SLIDE, FORCES,
**                   ISTAT)
**       CALL FLYOKE(LINKS, OFFSET, ANGLE, GRAV, CRANK, NLOADS, LOADS, STATE, SLIDE, FORCES, ISTAT)
**       CALL FLTEXT(ISTAT, TEXT)
**
** The analysis of one crank position of a four-bar linkage, a slider-crank, an inverted slider-crank, or
** a Scotch yoke.
**
** Given:
**    LINKS      by link number: length (m; unused for piston, slider, yoke; lever: DC, or 0), mass (kg),
**               moment of inertia about the centre of mass (kg m2), x and y of the centre of mass in the
**               link's own axes (m)
**    OFFSET     m, slider-crank: the line of stroke is y = OFFSET; others: as in fourlink_design
**    ANGLE      rad, angle of the slide from the line DC of a lever with a length; of the slot from the guide
**    GRAV       m/s2, in the frame of link 1
**    IBRNCH     1 open, -1 crossed
**    CRANK      theta2 (rad), omega2 (rad/s), alpha2 (rad/s2)
**    NLOADS     how many loads, 0 to 100
**    LOADS      for each: link (2, 3 or 4), frame (0 ground, 1 link), x and y of the force (N), x and y
**               of the point where it acts, in the link's own axes (m), torque (N m)
** Returned:
**    STATE      by link number: theta (rad), omega (rad/s), alpha (rad/s2), and x, y (m), vx, vy (m/s), ax,
**               ay (m/s2) of the link's origin; link 1 is 0
**    SLIDE      slide (m), slide_v (m/s), slide_a and coriolis (m/s2), as in fourlink_state
**    FORCES     F12x F12y F23x F23y F34x F34y F14x F14y (N), M14, Ts (N m), as in fourlink_forces; M34 in
**               place of M14 for an inverted slider-crank; FLYOKE: M14, and M34 as an eleventh number
**    ISTAT      0, or a status; then STATE and FORCES are unchanged
**
** FLTEXT gives the text of a status, padded with blanks.  The type of the length is that of gfortran 8 and
** later; older compilers pass an int and may need their own interface.
**
** Reference:
**    as fourlink_analyse
*/
#define FOURLINK_F77_LOADS 100 /* as in the text of FOURLINK_TOO_MANY_LOADS */
FOURLINK_API void flfbar_(const double links[20], const double grav[2], const int *ibrnch,
                          const double crank[3], const int *nloads, const double *loads,
                          double state[36], double forces[10], int *istat);
FOURLINK_API void flslcr_(const double links[20], const double *offset, const double grav[2],
                          const int *ibrnch, const double crank[3], const int *nloads,
                          const double *loads, double state[36], double forces[10], int *istat);
FOURLINK_API void flinvs_(const double links[20], const double *offset, const double *angle,
                          const double grav[2], const int *ibrnch, const double crank[3],
                          const int *nloads, const double *loads, double state[36], double slide[4],
                          double forces[10], int *istat);
FOURLINK_API void flyoke_(const double links[20], const double *offset, const double *angle,
                          const double grav[2], const double crank[3], const int *nloads,
                          const double *loads, double state[36], double slide[3], double forces[11],
                          int *istat);
FOURLINK_API void fltext_(const int *istat, char *text, unsigned long length);

/* Results by name, in the deck's units.
**
**       INTEGER*8 HANDLE
**       INTEGER ISTAT, IBRNCH, ID, I, N, NROWS, NCOLS
**       DOUBLE PRECISION ANGLE, VALUE, VALUES(N)
**       CHARACTER TEXT*4000, MSG*80, NAME*32, UNIT*16
**       CALL FLOPEN(TEXT, HANDLE, ISTAT, MSG)
**       CALL FLVAL(HANDLE, NAME, IBRNCH, ANGLE, VALUE, ISTAT)
**       CALL FLFIND(HANDLE, NAME, ID, ISTAT)
**       CALL FLGET(HANDLE, ID, IBRNCH, ANGLE, VALUE, ISTAT)
**       CALL FLSET(HANDLE, NAME, VALUE, ISTAT, MSG)
**       CALL FLPUT(HANDLE, N, IDS, VALUES, ISTAT, MSG)
**       CALL FLSETT(HANDLE, WORDS, ISTAT, MSG)
**       CALL FLUNIT(HANDLE, NAME, UNIT, ISTAT)
**       CALL FLNROW(HANDLE, NROWS, NCOLS)
**       CALL FLNAME(HANDLE, I, NAME, UNIT, ISTAT)
**       CALL FLROW(HANDLE, IBRNCH, I, N, VALUES, ISTAT)
**       CALL FLSHUT(HANDLE)
**
** FLOPEN opens a deck.
**
** Given:
**    TEXT       the deck, with CHAR(10) at the end of each line; trailing blanks are ignored
** Returned:
**    HANDLE     for the other calls; free it with FLSHUT; 0 if ISTAT is not 0.  Of a deck with [synthesis]
**               it is the first linkage that its task finds: FLVAL gives crank.length and its kin
**    ISTAT      FOURLINK_OK, FOURLINK_BAD_DECK, FOURLINK_NO_MEMORY; with [synthesis] also why no linkage is
**               found
**    MSG        the first mistake of the deck as LINE: MESSAGE, or the text of another status
**
** FLVAL returns any number by its name.
**
** Given:
**    NAME       a column such as Ts; max(Ts), min(Ts), mean(Ts), rms(Ts); Ts at 30 deg; a fact such as
**               mu_min; an input such as crank.length
**    IBRNCH     1 open, -1 crossed
**    ANGLE      of a column: crank angle in the deck's unit; else not used
** Returned:
**    VALUE      the number; unchanged if ISTAT is not 0
**    ISTAT      as from fourlink_results_value; FOURLINK_NO_SUCH_FACT for a fact in words
**
** FLFIND looks up a name once, and FLGET returns its values without a search: ID is the handle of
** fourlink_results_find.  For the statistics of a column add 1 (max), 2 (min), 3 (mean) or 4 (rms).
**
** FLSET sets a number of the deck, such as crank.length; FLPUT sets N of them at once, by their IDs from
** FLFIND.  A number is in the unit that its line has in the deck: 45.0D0 for `length = 40 mm` is 45 mm.
** FLUNIT tells that unit.  FLSETT takes a number with a unit, 'motion.speed = 60 rpm', and leaves the unit of
** the line as it was.
**
** Given:
**    VALUE      in the unit of its line
**    WORDS      NAME = NUMBER UNIT
** Returned:
**    UNIT       such as mm; 1 of a plain number
**    ISTAT      as from fourlink_results_set, _set_text, _input
**    MSG        as from FLOPEN; of WORDS that set nothing, why
**
** FLNROW returns the number of rows and columns of the deck's table.  FLNAME returns the name and unit of
** column I, 1 to NCOLS; otherwise ISTAT is FOURLINK_NO_SUCH_NAME.  FLROW returns row I, 1 to NROWS.
**
** Given:
**    N          size of VALUES; columns after the first N are omitted
** Returned:
**    VALUES     by column; NaN if a column has no value
**    ISTAT      as from fourlink_results_row
**
** FLSHUT frees the memory and sets HANDLE to 0; the other calls then return FOURLINK_NULL.
** Returned texts are padded with blanks, or cut off.
**
** Reference:
**    as fourlink_results_open, _value, _find, _get, _set, _put, _set_text, _input, _row
*/
FOURLINK_API void flopen_(const char *text, fourlink_results **handle, int *istat, char *msg,
                          unsigned long text_length, unsigned long msg_length);
FOURLINK_API void flval_(fourlink_results *const *handle, const char *name, const int *ibrnch,
                         const double *angle, double *value, int *istat, unsigned long name_length);
FOURLINK_API void flfind_(fourlink_results *const *handle, const char *name, int *id, int *istat,
                          unsigned long name_length);
FOURLINK_API void flget_(fourlink_results *const *handle, const int *id, const int *ibrnch,
                         const double *angle, double *value, int *istat);
FOURLINK_API void flset_(fourlink_results *const *handle, const char *name, const double *value,
                         int *istat, char *msg, unsigned long name_length,
                         unsigned long msg_length);
FOURLINK_API void flput_(fourlink_results *const *handle, const int *n, const int *ids,
                         const double *values, int *istat, char *msg, unsigned long msg_length);
FOURLINK_API void flsett_(fourlink_results *const *handle, const char *words, int *istat, char *msg,
                          unsigned long words_length, unsigned long msg_length);
FOURLINK_API void flunit_(fourlink_results *const *handle, const char *name, char *unit, int *istat,
                          unsigned long name_length, unsigned long unit_length);
FOURLINK_API void flnrow_(fourlink_results *const *handle, int *nrows, int *ncols);
FOURLINK_API void flname_(fourlink_results *const *handle, const int *i, char *name, char *unit,
                          int *istat, unsigned long name_length, unsigned long unit_length);
FOURLINK_API void flrow_(fourlink_results *const *handle, const int *ibrnch, const int *i,
                         const int *n, double *values, int *istat);
FOURLINK_API void flshut_(fourlink_results **handle);

#endif
