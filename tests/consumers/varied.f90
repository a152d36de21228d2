! SPDX-License-Identifier: GPL-3.0-or-later
! varied.f90 - a deck in, the largest torque for several cranks out, in Fortran 2003: the deck is read once.
program consumer
  use, intrinsic :: iso_c_binding
  use fourlink
  implicit none
  character(len=10000), target :: text = ' '
  character(len=200) :: line
  type(fourlink_source) :: source
  type(fourlink_mistake) :: mistakes(1)
  type(fourlink_value) :: crank, torque
  type(c_ptr) :: results = c_null_ptr
  real(c_double) :: length(1)
  integer(c_long) :: n
  integer :: i
  do
    read (*, '(a)', end=10) line
    text = trim(text) // trim(line) // c_new_line
  end do
  10 source%text = c_loc(text)
  source%length = len(text)
  if (fourlink_results_open(source, 1_c_long, results, mistakes, n) /= fourlink_ok) stop
  if (fourlink_results_find(results, 'crank.length' // c_null_char, crank) /= fourlink_ok) stop
  do i = 0, 2
    length(1) = 18 + 2 * i ! in the unit of its line
    if (fourlink_results_put(results, 1_c_long, (/ crank%handle /), length, mistakes(1)) /= &
        fourlink_ok) cycle
    if (fourlink_results_value(results, 'max(Ts)' // c_null_char, fourlink_open, 0.0_c_double, &
        torque) == fourlink_ok) &
      write (*, '(i2, 1x, 4a, f11.9, 1x, a)') nint(length(1)), trim(fourlink_text(crank%line_unit)), ': ', &
        trim(fourlink_text(torque%name)), ' = ', torque%value, trim(fourlink_text(torque%unit))
  end do
  if (fourlink_results_set(results, 'crank.length' // c_null_char, -1.0_c_double, mistakes(1)) == &
      fourlink_bad_deck) write (*, '(a)') trim(fourlink_text(mistakes(1)%message))
  call fourlink_results_free(results)
end program consumer
