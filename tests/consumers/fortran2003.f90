! SPDX-License-Identifier: GPL-3.0-or-later
!
! fortran2003.f90 - the whole job in one call, from Fortran 2003: the linkage of
! data/me3491-matrix.deck at 40 deg.
program consumer
  use, intrinsic :: iso_c_binding, only: c_double, c_int, c_long
  use fourlink
  implicit none

  real(c_double), parameter :: radian = 3.14159265358979323846_c_double / 180
  type(fourlink_design) :: design
  type(fourlink_crank) :: crank
  type(fourlink_load) :: loads(1)
  type(fourlink_state) :: state
  type(fourlink_forces) :: forces
  integer(c_int) :: status

  design%kind = fourlink_four_bar
  design%link(fourlink_ground)%length = 0.080_c_double
  design%link(fourlink_crank_link) = &
    new_link(0.020_c_double, 0.10_c_double, 0.008_c_double, 0.010_c_double, 0.0_c_double)
  design%link(fourlink_coupler) = &
    new_link(0.066_c_double, 0.30_c_double, 0.025_c_double, 0.030_c_double, 10.0_c_double)
  design%link(fourlink_follower) = &
    new_link(0.056_c_double, 0.25_c_double, 0.020_c_double, 0.028_c_double, -5.0_c_double)
  design%gravity%y = -9.81_c_double
  loads(1)%link = fourlink_follower
  loads(1)%torque = 0.5_c_double
  crank%theta2 = 40 * radian
  crank%omega2 = 10.5_c_double

  status = fourlink_analyse_design(design, fourlink_open, crank, loads, 1_c_long, state, forces)
  if (status /= fourlink_ok) then
    write (*, '(a)') trim(fourlink_status_text(status))
    stop 1
  end if
  write (*, '(a, f10.6, a)') 'theta4 = ', state%link(fourlink_follower)%theta / radian, ' deg'
  write (*, '(a, f14.12, a)') 'Ts = ', forces%Ts, ' N m'

contains

  ! A link with its centre of mass at the distance r, under the angle in degrees.
  function new_link(length, mass, gyration, r, angle) result(link)
    real(c_double), intent(in) :: length, mass, gyration, r, angle
    type(fourlink_link) :: link

    link%length = length
    link%mass = mass
    link%inertia = mass * gyration**2
    link%cg = fourlink_vector(r * cos(angle * radian), r * sin(angle * radian))
  end function new_link

end program consumer
