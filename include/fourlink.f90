! SPDX-License-Identifier: GPL-3.0-or-later
!
! fourlink.f90 - the library for Fortran 2003: see fourlink.h for what each function does.
!
! Compile this file with the program that uses it, and link with -lfourlink.
!
! The names are those of fourlink.h, except two: Fortran ignores case and would take them for
! names of types.  The crank's link number is fourlink_crank_link, and the type of linkage
! FOURLINK_ENGINE is fourlink_engine_type.
!
! - Arrays over links are indexed by the link's number, as in C.
! - What the caller fills in (design, load, crank, motion, source) is initially 0.
! - Outputs are intent(inout), since a call that fails leaves them untouched.
! - Outputs that may be null in C must be given: Fortran 2003 has no optional arguments in bind(c).
! - For other arguments that may be null give an array without elements, c_null_ptr or c_null_funptr.
! - An unsigned long of C is an integer(c_long): none is too large for it.
module fourlink
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_funptr, &
    c_int, c_long, c_null_char, c_null_funptr, c_null_ptr, c_ptr, c_size_t
  implicit none

  private :: c_associated, c_char, c_double, c_f_pointer, c_funptr, c_int, c_long, c_null_char, &
    c_null_funptr, c_null_ptr, c_ptr, c_size_t
  private :: copy_text, text_of_array, text_of_pointer

  ! Status codes.
  integer(c_int), parameter :: &
    fourlink_ok = 0, &
    fourlink_too_far = 1, &
    fourlink_too_near = 2, &
    fourlink_rod_too_short = 3, &
    fourlink_dead_position = 4, &
    fourlink_change_point = 5, &
    fourlink_singular = 6, &
    fourlink_lost_in_rounding = 7, &
    fourlink_not_reached = 8, &
    fourlink_no_mean = 9, &
    fourlink_locked = 10, &
    fourlink_no_direction = 11, &
    fourlink_does_not_start = 12, &
    fourlink_stalls = 13, &
    fourlink_no_steady = 14, &
    fourlink_no_inertia = 15, &
    fourlink_too_long = 16, &
    fourlink_overflow = 17, &
    fourlink_long_search = 18, &
    fourlink_null = 20, &
    fourlink_bad_number = 21, &
    fourlink_bad_kind = 22, &
    fourlink_bad_length = 23, &
    fourlink_bad_mass = 24, &
    fourlink_bad_branch = 25, &
    fourlink_bad_link = 26, &
    fourlink_bad_frame = 27, &
    fourlink_bad_interval = 28, &
    fourlink_bad_range = 29, &
    fourlink_no_run_up = 30, &
    fourlink_too_many_rows = 31, &
    fourlink_no_such_row = 32, &
    fourlink_not_an_engine = 33, &
    fourlink_no_series = 34, &
    fourlink_rod_off_line = 35, &
    fourlink_bad_deck = 36, &
    fourlink_no_memory = 37, &
    fourlink_no_such_point = 38, &
    fourlink_too_many_loads = 39, &
    fourlink_bad_approximation = 40, &
    fourlink_no_such_name = 41, &
    fourlink_no_such_fact = 42, &
    fourlink_no_such_angle = 43, &
    fourlink_no_turning_moment = 44, &
    fourlink_no_such_list = 45, &
    fourlink_bad_friction = 46, &
    fourlink_bad_spring = 47, &
    fourlink_bad_balance = 48, &
    fourlink_bad_motor = 49, fourlink_constant = 50, &
    fourlink_not_a_number = 51, &
    fourlink_dependent = 52, &
    fourlink_infinite_link = 53, &
    fourlink_no_linkage = 54, &
    fourlink_no_length = 55, &
    fourlink_no_full_turn = 56, &
    fourlink_none_found = 57, &
    fourlink_bad_points = 58, &
    fourlink_bad_time_ratio = 59, &
    fourlink_bad_choice = 60

  ! Types of linkages.
  integer(c_int), parameter :: &
    fourlink_crank_rocker = 1, &
    fourlink_rocker_crank = 2, &
    fourlink_double_crank = 3, &
    fourlink_double_rocker = 4, &
    fourlink_triple_rocker = 5, &
    fourlink_parallelogram = 6, &
    fourlink_deltoid = 7, &
    fourlink_rhombus = 8, &
    fourlink_change_point_linkage = 9, &
    fourlink_engine_type = 10, &
    fourlink_slider_rocker = 11, &
    fourlink_change_point_slider = 12, fourlink_slotted_lever = 13, fourlink_whitworth = 14, &
    fourlink_inverted_rocker = 15, fourlink_change_point_inverted = 16

  ! Kinds of mechanisms, branches, links, frames and sorts of loads, approximations.
  integer(c_int), parameter :: fourlink_four_bar = 1, fourlink_slider_crank = 2, &
    fourlink_inverted_slider_crank = 4
  integer(c_int), parameter :: fourlink_open = 1, fourlink_crossed = -1
  integer(c_int), parameter :: fourlink_ground = 1, fourlink_crank_link = 2, &
    fourlink_coupler = 3, fourlink_follower = 4
  integer(c_int), parameter :: fourlink_frame_ground = 0, fourlink_frame_link = 1
  integer(c_int), parameter :: fourlink_load_own = 1, fourlink_load_spring = 2, &
    fourlink_load_friction = 3, fourlink_load_gas = 4
  integer(c_int), parameter :: fourlink_exact = 0, fourlink_series_piston = 1, &
    fourlink_series_all = 2

  ! Lists, groups of facts, flags of columns, verdicts on printed values.
  integer(c_int), parameter :: fourlink_columns = 1, fourlink_all_columns = 2, &
    fourlink_inputs = 3, fourlink_variables = 4, fourlink_outputs = 5, &
    fourlink_conditions = 6
  integer(c_int), parameter :: fourlink_above = 1, fourlink_below = 2, fourlink_or_equal = 4
  integer(c_int), parameter :: fourlink_facts_limits = 1, fourlink_facts_extremes = 2, &
    fourlink_facts_turning = 4, fourlink_facts_motion = 8
  integer(c_int), parameter :: fourlink_no_motor = 0, fourlink_motor_torque_type = 1, &
    fourlink_motor_linear = 2, fourlink_motor_curve = 3, fourlink_motor_power = 4, &
    fourlink_motor_balance = 5
  integer(c_int), parameter :: fourlink_mode_given = 0, fourlink_mode_free = 1, &
    fourlink_mode_run_up = 2, fourlink_mode_steady = 3
  integer(c_int), parameter :: fourlink_of_crank = 1, fourlink_crank_angle = 2, &
    fourlink_of_rounding = 4, fourlink_of_forces = 8
  integer(c_int), parameter :: fourlink_max = 1, fourlink_min = 2, fourlink_mean = 3, &
    fourlink_rms = 4
  integer(c_int), parameter :: fourlink_agrees = 0, fourlink_differs = 1, &
    fourlink_misprint = 2, fourlink_no_misprint = 3, fourlink_no_value = 4

  ! The most areas of a turning moment; for a source, any design without mistakes.
  integer(c_int), parameter :: fourlink_from_digit = 1, fourlink_from_section = 2, &
    fourlink_from_grading = 3, fourlink_from_change = 4
  integer(c_int), parameter :: fourlink_areas = 40
  integer(c_long), parameter :: fourlink_any_design = int(z'ffffffff', c_long)

  ! Synthesis: defects, what is fitted, what is given of a dyad, the slow stroke, cognates; the most points.
  integer(c_int), parameter :: fourlink_defect_branch = 1, fourlink_defect_circuit = 2, &
    fourlink_defect_order = 4, fourlink_defect_dead = 8, fourlink_defect_way = 16, &
    fourlink_defect_reach = 32, fourlink_defect_missed = 64
  integer(c_int), parameter :: fourlink_fit_equation = 0, fourlink_fit_angle = 1
  integer(c_int), parameter :: fourlink_fixed_pivot = 1, fourlink_moving_pivot = 2, &
    fourlink_rotations = 3, fourlink_slider = 4
  integer(c_int), parameter :: fourlink_slow_with = 1, fourlink_slow_against = -1
  integer(c_int), parameter :: fourlink_left = 1, fourlink_right = 2
  integer(c_int), parameter :: fourlink_precision_max = 100

  ! The range of numbers.
  real(c_double), parameter :: fourlink_length_min = 1e-15_c_double ! m
  real(c_double), parameter :: fourlink_length_max = 1e15_c_double  ! m
  real(c_double), parameter :: fourlink_number_max = 1e30_c_double

  ! The mechanism.
  type, bind(c) :: fourlink_vector
    real(c_double) :: x = 0, y = 0
  end type fourlink_vector

  type, bind(c) :: fourlink_link
    real(c_double) :: length = 0, mass = 0, inertia = 0
    type(fourlink_vector) :: cg
  end type fourlink_link

  type, bind(c) :: fourlink_joint
    type(c_ptr) :: letter ! for fourlink_text
    integer(c_int) :: from, on, at, is_tip, slider
  end type fourlink_joint

  type, bind(c) :: fourlink_kind_facts
    integer(c_int) :: kind
    type(c_ptr) :: name, words, link(0:4) ! for fourlink_text
    integer(c_int) :: slides_on(0:4), has_stroke, has_slot
    type(fourlink_joint) :: joint(4)
  end type fourlink_kind_facts

  type, bind(c) :: fourlink_design
    integer(c_int) :: kind = 0
    type(fourlink_link) :: link(0:4) ! (0) is unused
    real(c_double) :: offset = 0
    type(fourlink_vector) :: gravity
    real(c_double) :: angle = 0
  end type fourlink_design

  type, bind(c) :: fourlink_mechanism
    type(fourlink_design) :: design
    real(c_double) :: stretched, folded
    integer(c_int) :: change_stretched, change_folded
    real(c_double) :: dead_centre, h
    type(fourlink_vector) :: lever
  end type fourlink_mechanism

  ! One crank position.
  type, bind(c) :: fourlink_crank
    real(c_double) :: theta2 = 0, omega2 = 0, alpha2 = 0
  end type fourlink_crank

  type, bind(c) :: fourlink_link_state
    real(c_double) :: theta, omega, alpha, k
    type(fourlink_vector) :: axis, origin, k_origin, velocity, acceleration
  end type fourlink_link_state

  type, bind(c) :: fourlink_state
    type(fourlink_link_state) :: link(0:4) ! (0) and (1) are unused
    integer(c_int) :: branch
    real(c_double) :: sine, mu, phi, x, v, a, slide, slide_v, slide_a, coriolis, s
  end type fourlink_state

  ! Loads and forces.
  type, bind(c) :: fourlink_load
    integer(c_int) :: link = 0
    integer(c_int) :: frame = fourlink_frame_ground
    type(fourlink_vector) :: force, at
    real(c_double) :: torque = 0
  end type fourlink_load

  type, bind(c) :: fourlink_forces
    real(c_double) :: F12x, F12y, F23x, F23y, F34x, F34y, F14x, F14y
    real(c_double) :: M14, Ts, Ts_work, residual, N34, M34
  end type fourlink_forces

  ! Friction, springs, counterweights.
  integer(c_int), parameter :: fourlink_friction_loads = 6
  integer(c_int), parameter :: fourlink_pushes = 1, fourlink_pulls = 2

  type, bind(c) :: fourlink_friction
    real(c_double) :: circle(4) = 0, guide = 0, guide_length = 0
    integer(c_int) :: direction = 0
  end type fourlink_friction

  type, bind(c) :: fourlink_losses
    real(c_double) :: Ts0, pin(4), guide, power, efficiency
    integer(c_long) :: n_loads
    type(fourlink_load) :: load(fourlink_friction_loads)
  end type fourlink_losses

  type, bind(c) :: fourlink_spring
    integer(c_int) :: link = 0, to = 0, is_torsional = 0
    type(fourlink_vector) :: at, to_at
    real(c_double) :: stiffness = 0, free_length = 0, preload = 0, damping = 0, turns(2) = 0
    integer(c_int) :: only = 0
  end type fourlink_spring

  type, bind(c) :: fourlink_spring_state
    real(c_double) :: length, rate, force, energy, power
    integer(c_long) :: n_loads
    type(fourlink_load) :: load(2)
    type(fourlink_vector) :: ground
    real(c_double) :: ground_moment
  end type fourlink_spring_state

  ! Points of a curve: c_loc of arrays.
  type, bind(c) :: fourlink_motor
    integer(c_int) :: kind = fourlink_no_motor
    real(c_double) :: torque = 0, stall_torque = 0, no_load_speed = 0, power = 0, max_torque = 0
    type(c_ptr) :: curve_speed = c_null_ptr, curve_torque = c_null_ptr
    integer(c_long) :: n_curve = 0
    real(c_double) :: inertia = 0, ratio = 1
  end type fourlink_motor

  type, bind(c) :: fourlink_balance
    type(fourlink_vector) :: crank, rocker
  end type fourlink_balance

  ! The mechanism as a whole.
  type, bind(c) :: fourlink_reach
    integer(c_int) :: n_ranges
    real(c_double) :: from(2), to(2)
  end type fourlink_reach

  type, bind(c) :: fourlink_limits
    real(c_double) :: mu_min, mu_max
    real(c_double) :: gamma_min, gamma_max
    integer(c_int) :: has_swing
    real(c_double) :: theta4_min, theta4_max, theta2_min, theta2_max, time_ratio
    integer(c_int) :: has_stroke
    real(c_double) :: stroke, inner, outer
  end type fourlink_limits

  ! Engines.
  type, bind(c) :: fourlink_series
    real(c_double) :: x, v, a, omega3, alpha3, x_harmonic, v_harmonic, a_harmonic
  end type fourlink_series

  type, bind(c) :: fourlink_rod
    real(c_double) :: n, k, b, m_a, m_b, d, L, m_d, m_g, k1
  end type fourlink_rod

  type, bind(c) :: fourlink_engine
    real(c_double) :: gas_force, inertia_force, piston_effort, rod_force, side_thrust
    real(c_double) :: crank_effort, radial_force, correction_couple
    real(c_double) :: T_piston, T_correction, T_weight_a, T_inertia_a, T_engine
    real(c_double) :: correction_force, T_weight_b
  end type fourlink_engine

  type, bind(c) :: fourlink_klein
    real(c_double) :: OM, BM, BQ, QN, ON, IX, IY, FT
  end type fourlink_klein

  ! The motion of the crank.
  type, bind(c) :: fourlink_motion
    real(c_double) :: angle_unit = 0, from = 0, to = 0, interval = 0, run_up = 0, speed = 0
    real(c_double) :: acceleration = 0
    integer(c_int) :: hold = 0
  end type fourlink_motion

  type, bind(c) :: fourlink_range
    integer(c_long) :: n_rows
    integer(c_int) :: stops
    real(c_double) :: stop_angle
  end type fourlink_range

  type, bind(c) :: fourlink_row
    type(fourlink_crank) :: crank
    real(c_double) :: angle, time
  end type fourlink_row

  ! Decks.  A deck itself is a type(c_ptr).
  type, bind(c) :: fourlink_mistake
    character(kind=c_char) :: file(1024) ! for fourlink_text
    integer(c_long) :: line
    character(kind=c_char) :: message(400) ! for fourlink_text
  end type fourlink_mistake

  type, bind(c) :: fourlink_problem
    character(kind=c_char) :: title(256) ! for fourlink_text
    type(fourlink_mechanism) :: mechanism
    type(fourlink_motion) :: motion
    real(c_double) :: cycle
    integer(c_int) :: open, crossed, asks_for_both, has_forces, has_friction, has_gas, approximation
    integer(c_long) :: n_loads, n_springs, n_points
    real(c_double) :: flywheel_fluctuation, flywheel_inertia
    integer(c_long) :: n_rows
    integer(c_int) :: one_instant, one_revolution, digits
    integer(c_long) :: n_expected, n_designs, design
    integer(c_int) :: has_outputs, has_values, is_graded, shows_answers
    real(c_double) :: late
    integer(c_int) :: mode, by_time ! mode 0: given, 1: free, 2: run-up, 3: steady
    real(c_double) :: time_step, duration ! s, of rows by time
  end type fourlink_problem

  type, bind(c) :: fourlink_load_info
    type(c_ptr) :: name ! for fourlink_text
    integer(c_int) :: sort ! fourlink_load_own ...
    integer(c_long) :: element ! counts from 0; of friction 0 to 3 for A, B, C, D
    integer(c_int) :: link, has_torque
  end type fourlink_load_info

  type, bind(c) :: fourlink_unit
    type(c_ptr) :: name ! for fourlink_text
    real(c_double) :: up, down
    integer(c_int) :: is_given
  end type fourlink_unit

  type, bind(c) :: fourlink_change
    type(c_ptr) :: origin = c_null_ptr     ! texts that end in c_null_char
    type(c_ptr) :: assignment = c_null_ptr
  end type fourlink_change

  ! The text may be a character variable that is a target: its c_loc, and its len.
  type, bind(c) :: fourlink_source
    type(c_ptr) :: name = c_null_ptr ! ends in c_null_char
    type(c_ptr) :: text = c_null_ptr
    integer(c_long) :: length = 0
    type(c_funptr) :: load = c_null_funptr
    type(c_ptr) :: host = c_null_ptr
    type(c_ptr) :: changes = c_null_ptr ! an array of fourlink_change
    integer(c_long) :: n_changes = 0
    type(c_ptr) :: answers_name = c_null_ptr ! ends in c_null_char
    type(c_ptr) :: answers = c_null_ptr
    integer(c_long) :: answers_length = 0
    integer(c_long) :: design = 0
    type(c_ptr) :: units = c_null_ptr ! ends in c_null_char
    integer(c_int) :: deck_units = 0
    integer(c_long) :: synthesis = 0
    integer(c_int) :: whole_cycle = 0
  end type fourlink_source

  ! Results by name.  Results themselves are a type(c_ptr).
  type, bind(c) :: fourlink_value
    type(c_ptr) :: name, unit, quantity, meaning, source ! for fourlink_text
    type(c_ptr) :: words                                 ! the same; c_null_ptr: a number
    real(c_double) :: value, to_si
    integer(c_int) :: has_angle
    real(c_double) :: angle
    integer(c_int) :: branch, flags, handle
  end type fourlink_value

  type, bind(c) :: fourlink_instant
    type(fourlink_row) :: row
    integer(c_int) :: branch, status
    type(fourlink_state) :: state
    type(fourlink_forces) :: forces
    real(c_double) :: gas_force
    type(fourlink_losses) :: losses
  end type fourlink_instant

  type, bind(c) :: fourlink_area
    real(c_double) :: from, to, energy
  end type fourlink_area

  type, bind(c) :: fourlink_turning
    real(c_double) :: mean_torque, mean_power, energy_fluctuation
    integer(c_int) :: has_coefficient
    real(c_double) :: energy_coefficient, inertia, fluctuation
    integer(c_int) :: n_areas
    type(fourlink_area) :: area(fourlink_areas)
  end type fourlink_turning

  type, bind(c) :: fourlink_check
    integer(c_int) :: verdict
    type(c_ptr) :: file ! for fourlink_text
    integer(c_long) :: line
    character(kind=c_char) :: name(64), printed_text(64) ! for fourlink_text
    real(c_double) :: printed, computed, tolerance
    type(c_ptr) :: unit                     ! for fourlink_text
    character(kind=c_char) :: words(100)    ! the same
    integer(c_int) :: has_angle
    real(c_double) :: angle
    integer(c_int) :: has_time
    real(c_double) :: time
    integer(c_int) :: branch
    integer(c_long) :: message_line
    character(kind=c_char) :: message(400)  ! for fourlink_text
    character(kind=c_char) :: hint(200)     ! the same
    integer(c_int) :: tolerance_from
    real(c_double) :: marks
    integer(c_int) :: is_short
  end type fourlink_check

  ! Synthesis.
  type, bind(c) :: fourlink_precision
    real(c_double) :: theta2, output, theta3
    type(fourlink_vector) :: point
    real(c_double) :: error, residual, mu
    integer(c_int) :: branch, status
  end type fourlink_precision

  type, bind(c) :: fourlink_solution
    type(fourlink_design) :: design
    integer(c_int) :: branch
    real(c_double) :: a, c, crank_turn, rocker_turn, k(3), condition
    type(fourlink_vector) :: origin
    real(c_double) :: direction
    integer(c_int) :: has_point
    type(fourlink_vector) :: point
    real(c_double) :: from, to
    integer(c_int) :: n_positions
    type(fourlink_precision) :: position(fourlink_precision_max)
    integer(c_int) :: defects, type
    real(c_double) :: ratio, mu_min, mu_min_at, mu_positions, max_error, max_error_at
    integer(c_int) :: is_better_longer
  end type fourlink_solution

  type, bind(c) :: fourlink_function_task
    integer(c_int) :: kind = 0
    real(c_double) :: ground = 0
    integer(c_long) :: n = 0
    type(c_ptr) :: theta2 = c_null_ptr, output = c_null_ptr, weight = c_null_ptr
    integer(c_int) :: fit = fourlink_fit_equation
    real(c_double) :: from = 0, to = 0
    type(c_funptr) :: wanted = c_null_funptr
    type(c_ptr) :: host = c_null_ptr
  end type fourlink_function_task

  type, bind(c) :: fourlink_dyad
    integer(c_int) :: choice = 0
    type(fourlink_vector) :: pivot
    real(c_double) :: rotation(2) = 0
  end type fourlink_dyad

  type, bind(c) :: fourlink_motion_task
    type(fourlink_vector) :: point(3)
    real(c_double) :: angle(3) = 0
    type(fourlink_dyad) :: left, right
  end type fourlink_motion_task

  type, bind(c) :: fourlink_path_task
    type(fourlink_vector) :: point(3)
    real(c_double) :: timing(2) = 0
    integer(c_int) :: search = 0
    real(c_double) :: rotation(2) = 0, step = 0
    type(fourlink_dyad) :: right
  end type fourlink_path_task

  type, bind(c) :: fourlink_quick_return_task
    integer(c_int) :: type = 0
    real(c_double) :: time_ratio = 0, swing = 0, stroke = 0
    real(c_double) :: length(0:4) = 0 ! (0) is unused
    real(c_double) :: offset = 0
    integer(c_int) :: slow = 0
  end type fourlink_quick_return_task

  type, bind(c) :: fourlink_cognate_task
    type(fourlink_design) :: design
    integer(c_int) :: branch = 0
    type(fourlink_vector) :: point
    integer(c_int) :: side = 0
    real(c_double) :: from = 0, to = 0
  end type fourlink_cognate_task

  ! The wanted output of a function generator: give its c_funloc in the task.
  abstract interface
    real(c_double) function fourlink_wanted(host, theta2) bind(c)
      import
      type(c_ptr), value :: host
      real(c_double), value :: theta2
    end function fourlink_wanted
  end interface

  ! A loader of files: give its c_funloc to fourlink_deck_read.
  abstract interface
    type(c_ptr) function fourlink_loader(host, file_name, length) bind(c)
      import
      type(c_ptr), value :: host
      type(c_ptr), value :: file_name ! for fourlink_text
      integer(c_long), intent(inout) :: length
    end function fourlink_loader
  end interface

  ! The functions of the library.
  interface
    integer(c_int) function fourlink_prepare(design, mechanism) bind(c)
      import
      type(fourlink_design), intent(in) :: design
      type(fourlink_mechanism), intent(inout) :: mechanism
    end function fourlink_prepare

    integer(c_int) function fourlink_has_type(kind, type) bind(c)
      import :: c_int
      integer(c_int), value :: kind, type
    end function fourlink_has_type
    integer(c_int) function fourlink_kind_of(kind, facts) bind(c)
      import
      integer(c_int), value :: kind
      type(fourlink_kind_facts), intent(inout) :: facts
    end function fourlink_kind_of

    integer(c_int) function fourlink_slides(kind, link) bind(c)
      import
      integer(c_int), value :: kind, link
    end function fourlink_slides

    integer(c_int) function fourlink_type_of(mechanism, type) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      integer(c_int), intent(inout) :: type
    end function fourlink_type_of

    integer(c_int) function fourlink_reach_of(mechanism, reach) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_reach), intent(inout) :: reach
    end function fourlink_reach_of

    integer(c_int) function fourlink_limits_of(mechanism, branch, limits) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      integer(c_int), value :: branch
      type(fourlink_limits), intent(inout) :: limits
    end function fourlink_limits_of

    integer(c_int) function fourlink_position(mechanism, branch, theta2, state) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      integer(c_int), value :: branch
      real(c_double), value :: theta2
      type(fourlink_state), intent(inout) :: state
    end function fourlink_position

    integer(c_int) function fourlink_velocity(mechanism, omega2, state) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      real(c_double), value :: omega2
      type(fourlink_state), intent(inout) :: state
    end function fourlink_velocity

    integer(c_int) function fourlink_acceleration(mechanism, alpha2, state) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      real(c_double), value :: alpha2
      type(fourlink_state), intent(inout) :: state
    end function fourlink_acceleration

    integer(c_int) function fourlink_point(state, link, at, position, velocity, acceleration) &
        bind(c)
      import
      type(fourlink_state), intent(in) :: state
      integer(c_int), value :: link
      type(fourlink_vector), intent(in) :: at
      type(fourlink_vector), intent(inout) :: position, velocity, acceleration
    end function fourlink_point

    integer(c_int) function fourlink_solve(mechanism, state, loads, n_loads, forces) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      type(fourlink_forces), intent(inout) :: forces
    end function fourlink_solve

    integer(c_int) function fourlink_solve_dyad(mechanism, state, loads, n_loads, forces) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      type(fourlink_forces), intent(inout) :: forces
    end function fourlink_solve_dyad

    integer(c_int) function fourlink_solve_friction(mechanism, state, loads, n_loads, friction, &
        closed_form, forces, losses) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      type(fourlink_friction), intent(in) :: friction
      integer(c_int), value :: closed_form
      type(fourlink_forces), intent(inout) :: forces
      type(fourlink_losses), intent(inout) :: losses
    end function fourlink_solve_friction

    integer(c_int) function fourlink_spring_prepare(mechanism, spring) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_spring), intent(inout) :: spring
    end function fourlink_spring_prepare

    integer(c_int) function fourlink_spring_at(mechanism, state, spring, at) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      type(fourlink_spring), intent(in) :: spring
      type(fourlink_spring_state), intent(inout) :: at
    end function fourlink_spring_at

    integer(c_int) function fourlink_inertia(mechanism, state, J, slope) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      real(c_double), intent(inout) :: J, slope
    end function fourlink_inertia

    integer(c_int) function fourlink_generalised_force(mechanism, state, loads, n_loads, Q) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      real(c_double), intent(inout) :: Q
    end function fourlink_generalised_force

    integer(c_int) function fourlink_motor_torque(motor, omega2, torque) bind(c)
      import
      type(fourlink_motor), intent(in) :: motor
      real(c_double), value :: omega2
      real(c_double), intent(inout) :: torque
    end function fourlink_motor_torque

    integer(c_int) function fourlink_balance_of(mechanism, fraction, balance) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      real(c_double), value :: fraction
      type(fourlink_balance), intent(inout) :: balance
    end function fourlink_balance_of

    integer(c_int) function fourlink_uniform_bar(length, mass, link) bind(c)
      import
      real(c_double), value :: length, mass
      type(fourlink_link), intent(inout) :: link
    end function fourlink_uniform_bar

    integer(c_int) function fourlink_add_counterweight(link, moment, radius, balanced, mass) &
        bind(c)
      import
      type(fourlink_link), intent(in) :: link
      type(fourlink_vector), intent(in) :: moment
      real(c_double), value :: radius
      type(fourlink_link), intent(inout) :: balanced
      real(c_double), intent(inout) :: mass
    end function fourlink_add_counterweight

    integer(c_int) function fourlink_deck_analyse(deck, branch, crank, closed_form, loads, state, &
        forces, losses, gas_force) bind(c)
      import
      type(c_ptr), value :: deck
      integer(c_int), value :: branch
      type(fourlink_crank), intent(in) :: crank
      integer(c_int), value :: closed_form
      type(fourlink_load), intent(inout) :: loads(*)
      type(fourlink_state), intent(inout) :: state
      type(fourlink_forces), intent(inout) :: forces
      type(fourlink_losses), intent(inout) :: losses
      real(c_double), intent(inout) :: gas_force
    end function fourlink_deck_analyse

    integer(c_int) function fourlink_deck_spring(deck, i, name, spring) bind(c)
      import
      type(c_ptr), value :: deck
      integer(c_long), value :: i
      type(c_ptr), intent(inout) :: name ! for fourlink_text
      type(fourlink_spring), intent(inout) :: spring
    end function fourlink_deck_spring

    integer(c_int) function fourlink_deck_friction(deck, friction) bind(c)
      import
      type(c_ptr), value :: deck
      type(fourlink_friction), intent(inout) :: friction
    end function fourlink_deck_friction

    ! The matrix is transposed: a(j, i) is A[i-1][j-1] in C, row i, column j.
    integer(c_int) function fourlink_system(mechanism, state, loads, n_loads, a, b) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      real(c_double), intent(inout) :: a(9, 9), b(9)
    end function fourlink_system

    integer(c_int) function fourlink_unknowns(mechanism, forces, x) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_forces), intent(in) :: forces
      real(c_double), intent(inout) :: x(9)
    end function fourlink_unknowns

    integer(c_int) function fourlink_analyse(mechanism, branch, crank, loads, n_loads, state, &
        forces) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      integer(c_int), value :: branch
      type(fourlink_crank), intent(in) :: crank
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      type(fourlink_state), intent(inout) :: state
      type(fourlink_forces), intent(inout) :: forces
    end function fourlink_analyse

    integer(c_int) function fourlink_analyse_dyad(mechanism, branch, crank, loads, n_loads, state, &
        forces) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      integer(c_int), value :: branch
      type(fourlink_crank), intent(in) :: crank
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      type(fourlink_state), intent(inout) :: state
      type(fourlink_forces), intent(inout) :: forces
    end function fourlink_analyse_dyad

    integer(c_int) function fourlink_analyse_design(design, branch, crank, loads, n_loads, state, &
        forces) bind(c)
      import
      type(fourlink_design), intent(in) :: design
      integer(c_int), value :: branch
      type(fourlink_crank), intent(in) :: crank
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      type(fourlink_state), intent(inout) :: state
      type(fourlink_forces), intent(inout) :: forces
    end function fourlink_analyse_design

    integer(c_int) function fourlink_chebyshev(from, to, n, x) bind(c)
      import
      real(c_double), value :: from, to
      integer(c_long), value :: n
      real(c_double), intent(inout) :: x(*)
    end function fourlink_chebyshev

    integer(c_int) function fourlink_synthesis_error(solution, theta2, wanted, error) bind(c)
      import
      type(fourlink_solution), intent(in) :: solution
      real(c_double), value :: theta2, wanted
      real(c_double), intent(inout) :: error
    end function fourlink_synthesis_error

    integer(c_int) function fourlink_synthesis_function(task, max, solutions, n) bind(c)
      import
      type(fourlink_function_task), intent(in) :: task
      integer(c_long), value :: max
      type(fourlink_solution), intent(inout) :: solutions(*)
      integer(c_long), intent(inout) :: n
    end function fourlink_synthesis_function

    integer(c_int) function fourlink_synthesis_motion(task, max, solutions, n) bind(c)
      import
      type(fourlink_motion_task), intent(in) :: task
      integer(c_long), value :: max
      type(fourlink_solution), intent(inout) :: solutions(*)
      integer(c_long), intent(inout) :: n
    end function fourlink_synthesis_motion

    integer(c_int) function fourlink_synthesis_path(task, max, solutions, n) bind(c)
      import
      type(fourlink_path_task), intent(in) :: task
      integer(c_long), value :: max
      type(fourlink_solution), intent(inout) :: solutions(*)
      integer(c_long), intent(inout) :: n
    end function fourlink_synthesis_path

    integer(c_int) function fourlink_synthesis_quick_return(task, max, solutions, n) bind(c)
      import
      type(fourlink_quick_return_task), intent(in) :: task
      integer(c_long), value :: max
      type(fourlink_solution), intent(inout) :: solutions(*)
      integer(c_long), intent(inout) :: n
    end function fourlink_synthesis_quick_return

    integer(c_int) function fourlink_synthesis_cognate(task, max, solutions, n) bind(c)
      import
      type(fourlink_cognate_task), intent(in) :: task
      integer(c_long), value :: max
      type(fourlink_solution), intent(inout) :: solutions(*)
      integer(c_long), intent(inout) :: n
    end function fourlink_synthesis_cognate

    integer(c_int) function fourlink_textbook_series(mechanism, state, series) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      type(fourlink_series), intent(inout) :: series
    end function fourlink_textbook_series

    integer(c_int) function fourlink_rod_masses(mechanism, rod) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_rod), intent(inout) :: rod
    end function fourlink_rod_masses

    integer(c_int) function fourlink_engine_method(mechanism, state, gas_force, loads, n_loads, &
        approximation, engine) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      real(c_double), value :: gas_force
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      integer(c_int), value :: approximation
      type(fourlink_engine), intent(inout) :: engine
    end function fourlink_engine_method

    integer(c_int) function fourlink_klein_construction(mechanism, state, klein) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_state), intent(in) :: state
      type(fourlink_klein), intent(inout) :: klein
    end function fourlink_klein_construction

    integer(c_int) function fourlink_motion_range(motion, range) bind(c)
      import
      type(fourlink_motion), intent(in) :: motion
      type(fourlink_range), intent(inout) :: range
    end function fourlink_motion_range

    ! Row i counts from 0, as in C.
    integer(c_int) function fourlink_motion_row(motion, range, i, row) bind(c)
      import
      type(fourlink_motion), intent(in) :: motion
      type(fourlink_range), intent(in) :: range
      integer(c_long), value :: i
      type(fourlink_row), intent(inout) :: row
    end function fourlink_motion_row

    integer(c_int) function fourlink_motion_at(motion, angle, row) bind(c)
      import
      type(fourlink_motion), intent(in) :: motion
      real(c_double), value :: angle
      type(fourlink_row), intent(inout) :: row
    end function fourlink_motion_at

    integer(c_int) function fourlink_extreme(mechanism, motion, loads, n_loads, branch, name, &
        value, angle) bind(c)
      import
      type(fourlink_mechanism), intent(in) :: mechanism
      type(fourlink_motion), intent(in) :: motion
      type(fourlink_load), intent(in) :: loads(*)
      integer(c_long), value :: n_loads
      integer(c_int), value :: branch
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: value, angle
    end function fourlink_extreme

    ! The text may be a character variable, and length its len.
    integer(c_int) function fourlink_deck_read(text, length, load, host, max_mistakes, deck, &
        mistakes, n_mistakes) bind(c)
      import
      character(kind=c_char), intent(in) :: text(*)
      integer(c_long), value :: length
      type(c_funptr), value :: load
      type(c_ptr), value :: host
      integer(c_long), value :: max_mistakes
      type(c_ptr), intent(inout) :: deck
      type(fourlink_mistake), intent(inout) :: mistakes(*)
      integer(c_long), intent(inout) :: n_mistakes
    end function fourlink_deck_read

    subroutine fourlink_deck_free(deck) bind(c)
      import
      type(c_ptr), value :: deck
    end subroutine fourlink_deck_free

    integer(c_int) function fourlink_deck_problem(deck, problem) bind(c)
      import
      type(c_ptr), value :: deck
      type(fourlink_problem), intent(inout) :: problem
    end function fourlink_deck_problem

    integer(c_int) function fourlink_deck_loads(deck, branch, theta2, loads, gas_force) bind(c)
      import
      type(c_ptr), value :: deck
      integer(c_int), value :: branch
      real(c_double), value :: theta2
      type(fourlink_load), intent(inout) :: loads(*)
      real(c_double), intent(inout) :: gas_force
    end function fourlink_deck_loads

    ! Point i counts from 0, as in C; the name is for fourlink_text.
    integer(c_int) function fourlink_deck_point(deck, i, name, link, at) bind(c)
      import
      type(c_ptr), value :: deck
      integer(c_long), value :: i
      type(c_ptr), intent(inout) :: name
      integer(c_int), intent(inout) :: link
      type(fourlink_vector), intent(inout) :: at
    end function fourlink_deck_point

    ! The quantity ends in c_null_char.
    integer(c_int) function fourlink_deck_unit(deck, quantity, unit) bind(c)
      import
      type(c_ptr), value :: deck
      character(kind=c_char), intent(in) :: quantity(*)
      type(fourlink_unit), intent(inout) :: unit
    end function fourlink_deck_unit

    ! Load i counts from 0, as in C.
    integer(c_int) function fourlink_deck_load(deck, i, info) bind(c)
      import
      type(c_ptr), value :: deck
      integer(c_long), value :: i
      type(fourlink_load_info), intent(inout) :: info
    end function fourlink_deck_load

    integer(c_int) function fourlink_deck_write(deck, out, size, length) bind(c)
      import
      type(c_ptr), value :: deck
      character(c_char), intent(inout) :: out(*)
      integer(c_long), value :: size
      integer(c_long), intent(inout) :: length
    end function fourlink_deck_write

    integer(c_int) function fourlink_deck_solutions(deck, max, solutions, chosen, n) bind(c)
      import
      type(c_ptr), value :: deck
      integer(c_long), value :: max
      type(fourlink_solution), intent(inout) :: solutions(*)
      integer(c_long), intent(inout) :: chosen, n
    end function fourlink_deck_solutions

    integer(c_int) function fourlink_deck_defects(deck, max, list, n) bind(c)
      import
      type(c_ptr), value :: deck
      integer(c_long), value :: max
      type(fourlink_mistake), intent(inout) :: list(*)
      integer(c_long), intent(inout) :: n
    end function fourlink_deck_defects

    integer(c_int) function fourlink_results_open(source, max_mistakes, results, mistakes, &
        n_mistakes) bind(c)
      import
      type(fourlink_source), intent(in) :: source
      integer(c_long), value :: max_mistakes
      type(c_ptr), intent(inout) :: results
      type(fourlink_mistake), intent(inout) :: mistakes(*)
      integer(c_long), intent(inout) :: n_mistakes
    end function fourlink_results_open

    integer(c_int) function fourlink_results_design(from, design, max_mistakes, results, mistakes, &
        n_mistakes) bind(c)
      import
      type(c_ptr), value :: from
      integer(c_long), value :: design, max_mistakes
      type(c_ptr), intent(inout) :: results
      type(fourlink_mistake), intent(inout) :: mistakes(*)
      integer(c_long), intent(inout) :: n_mistakes
    end function fourlink_results_design

    integer(c_int) function fourlink_results_variables(results, design, max, values, low, high) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_long), value :: design, max
      real(c_double), intent(inout) :: values(*)
      real(c_double), intent(inout) :: low(*), high(*)
    end function fourlink_results_variables

    integer(c_int) function fourlink_results_set(results, name, value, mistake) bind(c)
      import
      type(c_ptr), value :: results
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), value :: value
      type(fourlink_mistake), intent(inout) :: mistake
    end function fourlink_results_set

    integer(c_int) function fourlink_results_put(results, n, handles, values, mistake) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_long), value :: n
      integer(c_int), intent(in) :: handles(*)
      real(c_double), intent(in) :: values(*)
      type(fourlink_mistake), intent(inout) :: mistake
    end function fourlink_results_put

    subroutine fourlink_results_free(results) bind(c)
      import
      type(c_ptr), value :: results
    end subroutine fourlink_results_free

    type(c_ptr) function fourlink_results_deck(results) bind(c)
      import
      type(c_ptr), value :: results
    end function fourlink_results_deck

    integer(c_int) function fourlink_results_notes(results, max_notes, notes, n_notes) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_long), value :: max_notes
      type(fourlink_mistake), intent(inout) :: notes(*)
      integer(c_long), intent(inout) :: n_notes
    end function fourlink_results_notes

    type(c_ptr) function fourlink_results_meant(results, name) bind(c) ! for fourlink_text
      import
      type(c_ptr), value :: results
      character(kind=c_char), intent(in) :: name(*)
    end function fourlink_results_meant

    integer(c_int) function fourlink_results_slips(results, max_slips, slips, n_slips) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_long), value :: max_slips
      type(fourlink_mistake), intent(inout) :: slips(*)
      integer(c_long), intent(inout) :: n_slips
    end function fourlink_results_slips

    ! The list is an array of n fourlink_value, for c_f_pointer.
    integer(c_int) function fourlink_results_list(results, which, list, n) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: which
      type(c_ptr), intent(inout) :: list
      integer(c_long), intent(inout) :: n
    end function fourlink_results_list

    ! Row i counts from 0, as in C.
    integer(c_int) function fourlink_results_row(results, branch, i, values, instant, loads) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch
      integer(c_long), value :: i
      real(c_double), intent(inout) :: values(*)
      type(fourlink_instant), intent(inout) :: instant
      type(fourlink_load), intent(inout) :: loads(*)
    end function fourlink_results_row

    integer(c_int) function fourlink_results_at(results, branch, angle, values, instant, loads) &
        bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch
      real(c_double), value :: angle
      real(c_double), intent(inout) :: values(*)
      type(fourlink_instant), intent(inout) :: instant
      type(fourlink_load), intent(inout) :: loads(*)
    end function fourlink_results_at

    ! The name ends in c_null_char.
    integer(c_int) function fourlink_results_crossings(results, column, branch, value, max, angles, n) &
        bind(c)
      import
      type(c_ptr), value :: results
      character(kind=c_char), intent(in) :: column(*)
      integer(c_int), value :: branch
      real(c_double), value :: value
      integer(c_long), value :: max
      real(c_double), intent(inout) :: angles(*)
      integer(c_long), intent(inout) :: n
    end function fourlink_results_crossings

    ! The name ends in c_null_char.
    integer(c_int) function fourlink_results_find(results, name, found) bind(c)
      import
      type(c_ptr), value :: results
      character(kind=c_char), intent(in) :: name(*)
      type(fourlink_value), intent(inout) :: found
    end function fourlink_results_find

    integer(c_int) function fourlink_results_get(results, handle, branch, angle, value) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: handle, branch
      real(c_double), value :: angle
      type(fourlink_value), intent(inout) :: value
    end function fourlink_results_get

    ! The name ends in c_null_char.
    integer(c_int) function fourlink_results_value(results, name, branch, angle, value) bind(c)
      import
      type(c_ptr), value :: results
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), value :: branch
      real(c_double), value :: angle
      type(fourlink_value), intent(inout) :: value
    end function fourlink_results_value

    ! The facts are an array of n fourlink_value, for c_f_pointer.
    integer(c_int) function fourlink_results_facts(results, branch, groups, facts, n) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch, groups
      type(c_ptr), intent(inout) :: facts
      integer(c_long), intent(inout) :: n
    end function fourlink_results_facts

    integer(c_int) function fourlink_results_end(results, branch, angle) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch
      real(c_double), intent(inout) :: angle
    end function fourlink_results_end

    integer(c_int) function fourlink_results_turning(results, branch, turning) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch
      type(fourlink_turning), intent(inout) :: turning
    end function fourlink_results_turning

    ! Value i counts from 0, as in C.
    integer(c_int) function fourlink_results_check(results, i, check) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_long), value :: i
      type(fourlink_check), intent(inout) :: check
    end function fourlink_results_check
  end interface

  ! A null-terminated text of C, as an array or by its address, padded with blanks.
  interface fourlink_text
    module procedure text_of_array, text_of_pointer
  end interface fourlink_text

  ! In `contains`: the functions that return a text, fourlink_..._text and fourlink_version, as
  ! character(len=80), padded with blanks.

contains

  function fourlink_status_text(status) result(text)
    integer(c_int), intent(in) :: status
    character(len=80) :: text
    interface
      type(c_ptr) function fourlink_status_text_c(status) bind(c, name="fourlink_status_text")
        import
        integer(c_int), value :: status
      end function fourlink_status_text_c
    end interface

    call copy_text(fourlink_status_text_c(status), text)
  end function fourlink_status_text

  function fourlink_branch_text(branch) result(text)
    integer(c_int), intent(in) :: branch
    character(len=80) :: text
    interface
      type(c_ptr) function fourlink_branch_text_c(branch) bind(c, name="fourlink_branch_text")
        import
        integer(c_int), value :: branch
      end function fourlink_branch_text_c
    end interface

    call copy_text(fourlink_branch_text_c(branch), text)
  end function fourlink_branch_text

  function fourlink_type_text(type) result(text)
    integer(c_int), intent(in) :: type
    character(len=80) :: text
    interface
      type(c_ptr) function fourlink_type_text_c(type) bind(c, name="fourlink_type_text")
        import
        integer(c_int), value :: type
      end function fourlink_type_text_c
    end interface

    call copy_text(fourlink_type_text_c(type), text)
  end function fourlink_type_text

  function fourlink_defect_text(defect) result(text)
    integer(c_int), intent(in) :: defect
    character(len=80) :: text
    interface
      type(c_ptr) function fourlink_defect_text_c(defect) bind(c, name="fourlink_defect_text")
        import
        integer(c_int), value :: defect
      end function fourlink_defect_text_c
    end interface

    call copy_text(fourlink_defect_text_c(defect), text)
  end function fourlink_defect_text

  function fourlink_kind_text(kind) result(text)
    integer(c_int), intent(in) :: kind
    character(len=80) :: text
    interface
      type(c_ptr) function fourlink_kind_text_c(kind) bind(c, name="fourlink_kind_text")
        import
        integer(c_int), value :: kind
      end function fourlink_kind_text_c
    end interface

    call copy_text(fourlink_kind_text_c(kind), text)
  end function fourlink_kind_text

  function fourlink_link_text(kind, link) result(text)
    integer(c_int), intent(in) :: kind, link
    character(len=80) :: text
    interface
      type(c_ptr) function fourlink_link_text_c(kind, link) bind(c, name="fourlink_link_text")
        import
        integer(c_int), value :: kind, link
      end function fourlink_link_text_c
    end interface

    call copy_text(fourlink_link_text_c(kind, link), text)
  end function fourlink_link_text

  function fourlink_unknown_text(kind, i) result(text)
    integer(c_int), intent(in) :: kind, i
    character(len=80) :: text
    interface
      type(c_ptr) function fourlink_unknown_text_c(kind, i) bind(c, name="fourlink_unknown_text")
        import
        integer(c_int), value :: kind, i
      end function fourlink_unknown_text_c
    end interface

    call copy_text(fourlink_unknown_text_c(kind, i), text)
  end function fourlink_unknown_text

  function fourlink_version() result(text)
    character(len=80) :: text
    interface
      type(c_ptr) function fourlink_version_c() bind(c, name="fourlink_version")
        import
      end function fourlink_version_c
    end interface

    call copy_text(fourlink_version_c(), text)
  end function fourlink_version

  function text_of_array(array) result(text)
    character(kind=c_char), intent(in) :: array(:)
    character(len=1024) :: text
    integer :: i

    text = ' '
    do i = 1, min(size(array), len(text))
      if (array(i) == c_null_char) exit
      text(i:i) = array(i)
    end do
  end function text_of_array

  function text_of_pointer(pointer) result(text)
    type(c_ptr), intent(in) :: pointer
    character(len=1024) :: text

    call copy_text(pointer, text)
  end function text_of_pointer

  subroutine copy_text(from, to)
    type(c_ptr), intent(in) :: from
    character(len=*), intent(out) :: to
    character(kind=c_char), pointer :: array(:)
    integer :: i
    interface
      integer(c_size_t) function strlen(text) bind(c)
        import
        type(c_ptr), value :: text
      end function strlen
    end interface

    to = ' '
    if (.not. c_associated(from)) return
    call c_f_pointer(from, array, (/ strlen(from) /))
    do i = 1, min(size(array), len(to))
      to(i:i) = array(i)
    end do
  end subroutine copy_text

end module fourlink
