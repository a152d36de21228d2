/* SPDX-License-Identifier: GPL-3.0-or-later
**
** element.h - the elements that exert known loads on the links: given forces and torques, springs and
** dampers, gas.
**
** A machine has a list of elements (machine.h).  Each type of element is one file.  Friction is not an
** element: it belongs to the joints and depends on their forces.
*/
#ifndef FOURLINK_ELEMENT_H
#define FOURLINK_ELEMENT_H

#include "curve.h"
#include "variable.h"

struct flk_machine;

/* What the elements exert in a state.
**
** Switches (switch.h) divide the motion into cells.  With `held`, a state at unit speed, the cell of that
** state is used for other states too: the loads continue smoothly beyond the ends of the cell, so that
** integration steps may overshoot them (Modelica: relations are frozen between events). */
typedef struct flk_acting {
    const fourlink_state *held; /* null: the cell is that of the state itself */
    double held_speed;          /* rad/s, a crank speed in the held piece of the motor's curve */
    int sense;                  /* 1 or -1: the crank turns, or starts, in this sense */
    fourlink_load *load;        /* array of the machine's n_loads */
    double
        gas_force; /* N, of the gas on the piston, towards the crank; on a rod, along the slide */
} flk_acting;

typedef struct flk_element flk_element;
typedef struct flk_switch flk_switch;

#define FLK_ELEMENT_SWITCHES 6

/* A type of element.
**
**    act         sets the element's loads for a state; returns a status
**    switches    lists where it is not smooth (switch.h) and returns their number; null: it is smooth
**    switching   changes sign where the element begins or stops acting; null: it always acts */
typedef struct flk_element_type {
    int code; /* FOURLINK_LOAD_OWN ... */
    int (*act)(const flk_element *element, const struct flk_machine *machine,
               const fourlink_state *state, fourlink_load *load, flk_acting *acting);
    size_t (*switches)(const flk_element *element, const struct flk_machine *machine,
                       flk_switch *list);
    double (*switching)(const flk_element *element, const struct flk_machine *machine,
                        const fourlink_state *state);
} flk_element_type;

extern const flk_element_type flk_given_load_type, flk_spring_type, flk_gas_type;

#define FLK_ELEMENT_COLUMNS 4

struct flk_element {
    const flk_element_type *type;
    const char *name;                              /* of its section; "": none */
    const char *column_names[FLK_ELEMENT_COLUMNS]; /* of a spring, NAME.length ... */
    void *data;                                    /* flk_given_load, fourlink_spring, flk_gas */
    unsigned long first; /* index of its first load among those of the machine */
    int n_loads;         /* 1 or 2 */
    int link[2];         /* on which these act */
    int needs_motion;    /* 1: its loads depend on more than the crank angle */
    int needs_angles;    /* 1: ... on the angles of links 3 and 4 */
    int has_torque;      /* 1: it has a torque at some crank angle */
};

/* The values of a load: constant ones, or curves over its variable. */
typedef struct flk_load_values {
    fourlink_vector force; /* N */
    double torque;         /* N m */
    curve force_curve[2], torque_curve;
} flk_load_values;

/* A given load: a force and a torque (given_load.c). */
typedef struct flk_given_load {
    fourlink_load load; /* its link, point and axes; the values are 0 */
    flk_load_values values, back;
    flk_variable over;
    double exponent; /* 1 */
    double at_speed; /* rad/s, m/s: value sign(w) (|w| / at_speed)^exponent; 0: values or curves */
    int is_unknown; /* 1: its size is unknown, and drives: `values` are of size 1, and are not exerted */
    int has_back;     /* 1: `back` has the values for where the variable falls */
    int is_windowed;  /* 1: it acts only between two crank angles, in every cycle */
    double window[2]; /* rad, from and to */
} flk_given_load;

/* Gas in a cylinder (gas.c). */
typedef struct flk_gas {
    double area, back_area; /* m2, of the piston, on the cover side and on the crank side */
    double pressure;        /* Pa, on the cover side */
    curve indicator;        /* Pa over the crank angle in rad, instead of pressure */
    double back_pressure;   /* Pa, on the crank side */
    double clearance;       /* m3, on the cover side at the inner dead centre; 0: not given */
} flk_gas;

/* The gas on a piston or yoke; null if there is none. */
const flk_gas *flk_gas_on_piston(const struct flk_machine *machine);

/* It on the cover side. */
typedef struct flk_gas_state {
    double volume, rate; /* m3, m3/s */
    double pressure;     /* Pa */
} flk_gas_state;

/* At a position.  `within`: a crank angle in the piece of the indicator's curve to use (curve.h). */
void flk_gas_in_cylinder(const flk_gas *gas, const fourlink_state *state, double within,
                         flk_gas_state *at);

/* Set up an element of each type with its data (given_load.c, spring.c, gas.c). */
void flk_element_of_given_load(flk_given_load *given, flk_element *element);
void flk_element_of_spring(fourlink_spring *spring, flk_element *element);
void flk_element_of_gas(flk_gas *gas, fourlink_kind kind, flk_element *element);

#endif
