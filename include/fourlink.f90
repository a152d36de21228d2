! SPDX-License-Identifier: GPL-3.0-or-later
!
! fourlink.f90 - the library for Fortran 2003: results by name, numbers set, extremes, and one crank position
! by structures.  fourlink.h says what each function does, and has the others.
!
! Compile this file with the program that uses it, and link with -lfourlink.
!
! The names are those of fourlink.h, except one: Fortran ignores case and would take FOURLINK_CRANK for the
! type; it is fourlink_crank_link.
!
! - Arrays over links are indexed by the link's number, as in C.
! - What the caller fills in (design, load, crank, motion, source) is initially 0.
! - Outputs are intent(inout), since a call that fails leaves them untouched.
! - Outputs that may be null in C must be given, but for those of type c_ptr: these may be c_null_ptr.
! - For other arguments that may be null give an array without elements.
! - An unsigned long of C is an integer(c_long): none is too large for it.
! - Texts for C end in c_null_char; fourlink_text turns those of C into characters.
module fourlink
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_funptr, &
    c_int, c_long, c_null_char, c_null_funptr, c_null_ptr, c_ptr, c_size_t
  implicit none

  private :: c_associated, c_char, c_double, c_f_pointer, c_funptr, c_int, c_long, c_null_char, &
    c_null_funptr, c_null_ptr, c_ptr, c_size_t
  private :: copy_text, text_of_array, text_of_pointer

  ! Status codes.
  integer(c_int), parameter :: &
    fourlink_ok = 0, fourlink_too_far = 1, fourlink_too_near = 2, fourlink_rod_too_short = 3, &
    fourlink_dead_position = 4, fourlink_change_point = 5, fourlink_singular = 6, &
    fourlink_lost_in_rounding = 7, fourlink_not_reached = 8, fourlink_no_mean = 9, &
    fourlink_locked = 10, fourlink_no_direction = 11, fourlink_does_not_start = 12, &
    fourlink_stalls = 13, fourlink_no_steady = 14, fourlink_no_inertia = 15, &
    fourlink_too_long = 16, fourlink_overflow = 17, fourlink_long_search = 18, &
    fourlink_group_apart = 19, fourlink_input_dead_centre = 63, &
    fourlink_null = 20, fourlink_bad_number = 21, fourlink_bad_kind = 22, &
    fourlink_bad_length = 23, fourlink_bad_mass = 24, fourlink_bad_branch = 25, &
    fourlink_bad_link = 26, fourlink_bad_frame = 27, fourlink_bad_interval = 28, &
    fourlink_bad_range = 29, fourlink_no_run_up = 30, fourlink_too_many_rows = 31, &
    fourlink_no_such_row = 32, fourlink_not_an_engine = 33, fourlink_no_series = 34, &
    fourlink_rod_off_line = 35, fourlink_bad_deck = 36, fourlink_no_memory = 37, &
    fourlink_no_such_point = 38, fourlink_too_many_loads = 39, fourlink_bad_approximation = 40, &
    fourlink_no_such_name = 41, fourlink_no_such_fact = 42, fourlink_no_such_angle = 43, &
    fourlink_no_turning_moment = 44, fourlink_no_such_list = 45, fourlink_bad_friction = 46, &
    fourlink_bad_spring = 47, fourlink_bad_balance = 48, fourlink_bad_motor = 49, &
    fourlink_constant = 50, fourlink_not_a_number = 51, fourlink_dependent = 52, &
    fourlink_infinite_link = 53, fourlink_no_linkage = 54, fourlink_no_length = 55, &
    fourlink_no_full_turn = 56, fourlink_none_found = 57, fourlink_bad_points = 58, &
    fourlink_bad_time_ratio = 59, fourlink_bad_choice = 60, fourlink_parallel_slot = 61, &
    fourlink_bad_group = 62

  ! Kinds of mechanisms, branches, links, frames of loads.
  integer(c_int), parameter :: fourlink_four_bar = 1, fourlink_slider_crank = 2, &
    fourlink_inverted_slider_crank = 4, fourlink_scotch_yoke = 8
  integer(c_int), parameter :: fourlink_open = 1, fourlink_crossed = -1
  integer(c_int), parameter :: fourlink_ground = 1, fourlink_crank_link = 2, &
    fourlink_coupler = 3, fourlink_follower = 4
  integer(c_int), parameter :: fourlink_frame_ground = 0, fourlink_frame_link = 1

  ! Lists, groups of facts, what is added to the handle of a column; any design without mistakes.
  integer(c_int), parameter :: fourlink_columns = 1, fourlink_all_columns = 2, &
    fourlink_inputs = 3, fourlink_variables = 4, fourlink_outputs = 5, fourlink_conditions = 6
  integer(c_int), parameter :: fourlink_facts_limits = 1, fourlink_facts_extremes = 2, &
    fourlink_facts_turning = 4, fourlink_facts_motion = 8, fourlink_facts_names = 16
  integer(c_int), parameter :: fourlink_max = 1, fourlink_min = 2, fourlink_mean = 3, &
    fourlink_rms = 4
  integer(c_long), parameter :: fourlink_any_design = int(z'ffffffff', c_long)

  ! The mechanism.
  type, bind(c) :: fourlink_vector
    real(c_double) :: x = 0, y = 0
  end type fourlink_vector

  type, bind(c) :: fourlink_link
    real(c_double) :: length = 0, mass = 0, inertia = 0
    type(fourlink_vector) :: cg
  end type fourlink_link

  type, bind(c) :: fourlink_design
    integer(c_int) :: kind = 0
    type(fourlink_link) :: link(0:4) ! (0) is unused
    real(c_double) :: offset = 0
    type(fourlink_vector) :: gravity
    real(c_double) :: angle = 0
    type(c_ptr) :: group = c_null_ptr ! an array of n_groups
    integer(c_int) :: n_groups = 0
  end type fourlink_design

  type, bind(c) :: fourlink_mechanism
    type(fourlink_design) :: design
    real(c_double) :: stretched, folded
    integer(c_int) :: change_stretched, change_folded
    real(c_double) :: dead_centre, h
    type(fourlink_vector) :: lever, slot
    type(c_ptr) :: drive = c_null_ptr ! of a deck
  end type fourlink_mechanism

  ! A crank position.
  type, bind(c) :: fourlink_crank
    real(c_double) :: theta2 = 0, omega2 = 0, alpha2 = 0
  end type fourlink_crank

  type, bind(c) :: fourlink_link_state
    real(c_double) :: theta, omega, alpha, k
    type(fourlink_vector) :: axis, origin, k_origin, velocity, acceleration
  end type fourlink_link_state

  type, bind(c) :: fourlink_state
    integer(c_int) :: branch, last
    real(c_double) :: sine, mu, phi, x, v, a, slide, slide_v, slide_a, coriolis, s, group_sine
    type(fourlink_link_state) :: link(0:20) ! (0), (1) and those after `last` are unused
  end type fourlink_state

  type, bind(c) :: fourlink_load
    integer(c_int) :: link = 0
    integer(c_int) :: frame = fourlink_frame_ground
    type(fourlink_vector) :: force, at
    real(c_double) :: torque = 0
  end type fourlink_load

  type, bind(c) :: fourlink_forces
    real(c_double) :: F12x, F12y, F23x, F23y, F34x, F34y, F14x, F14y
    real(c_double) :: M14, Ts, drive, at_crank, Ts_work, residual, N34, M34
  end type fourlink_forces

  ! The motion of the crank.
  type, bind(c) :: fourlink_motion
    real(c_double) :: angle_unit = 0, from = 0, to = 0, interval = 0, run_up = 0, speed = 0
    real(c_double) :: acceleration = 0
    integer(c_int) :: hold = 0
    real(c_double) :: x_at = 0
  end type fourlink_motion

  ! Decks.
  type, bind(c) :: fourlink_mistake
    character(kind=c_char) :: file(1024) ! for fourlink_text
    integer(c_long) :: line
    character(kind=c_char) :: message(400) ! for fourlink_text
  end type fourlink_mistake

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
    integer(c_long) :: effort = 0
    type(c_ptr) :: near = c_null_ptr
  end type fourlink_source

  ! Results by name.  Results themselves are a type(c_ptr).
  type, bind(c) :: fourlink_value
    type(c_ptr) :: name, unit, quantity, meaning, source ! for fourlink_text
    type(c_ptr) :: words                                 ! the same; c_null_ptr: a number
    real(c_double) :: value, to_si
    integer(c_int) :: has_angle
    real(c_double) :: angle
    integer(c_int) :: branch, flags, handle
    type(c_ptr) :: line_unit ! for fourlink_text; c_null_ptr: it cannot be set
  end type fourlink_value

  interface
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

    subroutine fourlink_results_free(results) bind(c)
      import
      type(c_ptr), value :: results
    end subroutine fourlink_results_free

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

    integer(c_int) function fourlink_results_value(results, name, branch, angle, value) bind(c)
      import
      type(c_ptr), value :: results
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), value :: branch
      real(c_double), value :: angle
      type(fourlink_value), intent(inout) :: value
    end function fourlink_results_value

    integer(c_int) function fourlink_results_input(results, name, input) bind(c)
      import
      type(c_ptr), value :: results
      character(kind=c_char), intent(in) :: name(*)
      type(fourlink_value), intent(inout) :: input
    end function fourlink_results_input

    integer(c_int) function fourlink_results_set(results, name, value, mistake) bind(c)
      import
      type(c_ptr), value :: results
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), value :: value
      type(fourlink_mistake), intent(inout) :: mistake
    end function fourlink_results_set

    integer(c_int) function fourlink_results_set_text(results, words, mistake) bind(c)
      import
      type(c_ptr), value :: results
      character(kind=c_char), intent(in) :: words(*)
      type(fourlink_mistake), intent(inout) :: mistake
    end function fourlink_results_set_text

    integer(c_int) function fourlink_results_put(results, n, handles, values, mistake) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_long), value :: n
      integer(c_int), intent(in) :: handles(*)
      real(c_double), intent(in) :: values(*)
      type(fourlink_mistake), intent(inout) :: mistake
    end function fourlink_results_put

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
      type(c_ptr), value :: instant, loads
    end function fourlink_results_row

    integer(c_int) function fourlink_results_motion(results, branch, i, values, instant) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch
      integer(c_long), value :: i
      real(c_double), intent(inout) :: values(*)
      type(c_ptr), value :: instant
    end function fourlink_results_motion

    integer(c_int) function fourlink_results_at(results, branch, angle, values, instant, loads) &
        bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch
      real(c_double), value :: angle
      real(c_double), intent(inout) :: values(*)
      type(c_ptr), value :: instant, loads
    end function fourlink_results_at

    integer(c_int) function fourlink_results_size(results, handle, instant, size) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: handle
      type(c_ptr), value :: instant
      real(c_double), intent(inout) :: size
    end function fourlink_results_size

    integer(c_int) function fourlink_results_along(results, branch, place, values, instant, loads) &
        bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch
      real(c_double), value :: place
      real(c_double), intent(inout) :: values(*)
      type(c_ptr), value :: instant, loads
    end function fourlink_results_along

    integer(c_int) function fourlink_results_on_side(results, branch, side, place, values, &
        instant, loads) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch, side
      real(c_double), value :: place
      real(c_double), intent(inout) :: values(*)
      type(c_ptr), value :: instant, loads
    end function fourlink_results_on_side

    ! The facts are an array of n fourlink_value, for c_f_pointer.
    integer(c_int) function fourlink_results_facts(results, branch, groups, facts, n) bind(c)
      import
      type(c_ptr), value :: results
      integer(c_int), value :: branch, groups
      type(c_ptr), intent(inout) :: facts
      integer(c_long), intent(inout) :: n
    end function fourlink_results_facts

    integer(c_int) function fourlink_prepare(design, mechanism) bind(c)
      import
      type(fourlink_design), intent(in) :: design
      type(fourlink_mechanism), intent(inout) :: mechanism
    end function fourlink_prepare

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
  end interface

  ! A null-terminated text of C, as an array or by its address, padded with blanks.
  interface fourlink_text
    module procedure text_of_array, text_of_pointer
  end interface fourlink_text

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
