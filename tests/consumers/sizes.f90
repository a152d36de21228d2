! SPDX-License-Identifier: GPL-3.0-or-later
!
! sizes.f90 - the sizes of the module's types, in bytes; sizes.c has to print the same.
program sizes
  use, intrinsic :: iso_c_binding, only: c_sizeof
  use fourlink
  implicit none

  type(fourlink_vector) :: vector_
  type(fourlink_link) :: link_
  type(fourlink_design) :: design_
  type(fourlink_mechanism) :: mechanism_
  type(fourlink_crank) :: crank_
  type(fourlink_link_state) :: link_state_
  type(fourlink_state) :: state_
  type(fourlink_load) :: load_
  type(fourlink_forces) :: forces_
  type(fourlink_motion) :: motion_
  type(fourlink_mistake) :: mistake_
  type(fourlink_change) :: change_
  type(fourlink_source) :: source_
  type(fourlink_value) :: value_

  write (*, '(a, 1x, i0)') 'fourlink_vector', c_sizeof(vector_)
  write (*, '(a, 1x, i0)') 'fourlink_link', c_sizeof(link_)
  write (*, '(a, 1x, i0)') 'fourlink_design', c_sizeof(design_)
  write (*, '(a, 1x, i0)') 'fourlink_mechanism', c_sizeof(mechanism_)
  write (*, '(a, 1x, i0)') 'fourlink_crank', c_sizeof(crank_)
  write (*, '(a, 1x, i0)') 'fourlink_link_state', c_sizeof(link_state_)
  write (*, '(a, 1x, i0)') 'fourlink_state', c_sizeof(state_)
  write (*, '(a, 1x, i0)') 'fourlink_load', c_sizeof(load_)
  write (*, '(a, 1x, i0)') 'fourlink_forces', c_sizeof(forces_)
  write (*, '(a, 1x, i0)') 'fourlink_motion', c_sizeof(motion_)
  write (*, '(a, 1x, i0)') 'fourlink_mistake', c_sizeof(mistake_)
  write (*, '(a, 1x, i0)') 'fourlink_change', c_sizeof(change_)
  write (*, '(a, 1x, i0)') 'fourlink_source', c_sizeof(source_)
  write (*, '(a, 1x, i0)') 'fourlink_value', c_sizeof(value_)
end program sizes
