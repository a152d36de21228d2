! SPDX-License-Identifier: GPL-3.0-or-later
! results.f90 - a deck in, named numbers out, in Fortran 2003.
program consumer
  use, intrinsic :: iso_c_binding
  use fourlink
  implicit none
  character(len=7), parameter :: names(4) = (/ 'theta4 ', 'Ts     ', 'min(Ts)', 'mu_min ' /)
  character(len=10000), target :: text = ' '
  character(len=200) :: line
  type(fourlink_source) :: source
  type(fourlink_mistake) :: mistakes(1)
  type(fourlink_value) :: found, v
  type(c_ptr) :: results = c_null_ptr
  integer(c_long) :: n
  integer :: i
  do
    read (*, '(a)', end=10) line
    text = trim(text) // trim(line) // c_new_line
  end do
  10 source%text = c_loc(text)
  source%length = len(text)
  if (fourlink_results_open(source, 1_c_long, results, mistakes, n) /= fourlink_ok) &
    write (*, '(i0, 2a)') mistakes(1)%line, ': ', trim(fourlink_text(mistakes(1)%message))
  do i = 1, 4
    if (fourlink_results_find(results, trim(names(i)) // c_null_char, found) /= fourlink_ok) cycle
    if (fourlink_results_get(results, found%handle, fourlink_open, 40.0_c_double, v) == &
        fourlink_ok) &
      write (*, '(a, " =", f15.9, 1x, a)') trim(names(i)), v%value, trim(fourlink_text(v%unit))
  end do
  call fourlink_results_free(results)
end program consumer
