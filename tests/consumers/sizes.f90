! SPDX-License-Identifier: GPL-3.0-or-later
!
! sizes.f90 - the sizes of the module's types, in bytes; sizes.c has to print the same.
program sizes
  use, intrinsic :: iso_c_binding, only: c_sizeof
  use fourlink
  implicit none

  type(fourlink_vector) :: vector_
  type(fourlink_link) :: link_
  type(fourlink_joint) :: joint_
  type(fourlink_kind_facts) :: kind_facts_
  type(fourlink_design) :: design_
  type(fourlink_mechanism) :: mechanism_
  type(fourlink_crank) :: crank_
  type(fourlink_link_state) :: link_state_
  type(fourlink_state) :: state_
  type(fourlink_load) :: load_
  type(fourlink_forces) :: forces_
  type(fourlink_friction) :: friction_
  type(fourlink_losses) :: losses_
  type(fourlink_spring) :: spring_
  type(fourlink_spring_state) :: spring_state_
  type(fourlink_balance) :: balance_
  type(fourlink_motor) :: motor_
  type(fourlink_reach) :: reach_
  type(fourlink_limits) :: limits_
  type(fourlink_series) :: series_
  type(fourlink_rod) :: rod_
  type(fourlink_engine) :: engine_
  type(fourlink_klein) :: klein_
  type(fourlink_motion) :: motion_
  type(fourlink_range) :: range_
  type(fourlink_row) :: row_
  type(fourlink_mistake) :: mistake_
  type(fourlink_load_info) :: load_info_
  type(fourlink_problem) :: problem_
  type(fourlink_unit) :: unit_
  type(fourlink_change) :: change_
  type(fourlink_source) :: source_
  type(fourlink_value) :: value_
  type(fourlink_instant) :: instant_
  type(fourlink_area) :: area_
  type(fourlink_turning) :: turning_
  type(fourlink_check) :: check_
  type(fourlink_precision) :: precision_
  type(fourlink_solution) :: solution_
  type(fourlink_function_task) :: function_task_
  type(fourlink_dyad) :: dyad_
  type(fourlink_motion_task) :: motion_task_
  type(fourlink_path_task) :: path_task_
  type(fourlink_quick_return_task) :: quick_return_task_
  type(fourlink_cognate_task) :: cognate_task_

  write (*, '(a, 1x, i0)') 'fourlink_vector', c_sizeof(vector_)
  write (*, '(a, 1x, i0)') 'fourlink_link', c_sizeof(link_)
  write (*, '(a, 1x, i0)') 'fourlink_joint', c_sizeof(joint_)
  write (*, '(a, 1x, i0)') 'fourlink_kind_facts', c_sizeof(kind_facts_)
  write (*, '(a, 1x, i0)') 'fourlink_design', c_sizeof(design_)
  write (*, '(a, 1x, i0)') 'fourlink_mechanism', c_sizeof(mechanism_)
  write (*, '(a, 1x, i0)') 'fourlink_crank', c_sizeof(crank_)
  write (*, '(a, 1x, i0)') 'fourlink_link_state', c_sizeof(link_state_)
  write (*, '(a, 1x, i0)') 'fourlink_state', c_sizeof(state_)
  write (*, '(a, 1x, i0)') 'fourlink_load', c_sizeof(load_)
  write (*, '(a, 1x, i0)') 'fourlink_forces', c_sizeof(forces_)
  write (*, '(a, 1x, i0)') 'fourlink_friction', c_sizeof(friction_)
  write (*, '(a, 1x, i0)') 'fourlink_losses', c_sizeof(losses_)
  write (*, '(a, 1x, i0)') 'fourlink_spring', c_sizeof(spring_)
  write (*, '(a, 1x, i0)') 'fourlink_spring_state', c_sizeof(spring_state_)
  write (*, '(a, 1x, i0)') 'fourlink_balance', c_sizeof(balance_)
  write (*, '(a, 1x, i0)') 'fourlink_motor', c_sizeof(motor_)
  write (*, '(a, 1x, i0)') 'fourlink_reach', c_sizeof(reach_)
  write (*, '(a, 1x, i0)') 'fourlink_limits', c_sizeof(limits_)
  write (*, '(a, 1x, i0)') 'fourlink_series', c_sizeof(series_)
  write (*, '(a, 1x, i0)') 'fourlink_rod', c_sizeof(rod_)
  write (*, '(a, 1x, i0)') 'fourlink_engine', c_sizeof(engine_)
  write (*, '(a, 1x, i0)') 'fourlink_klein', c_sizeof(klein_)
  write (*, '(a, 1x, i0)') 'fourlink_motion', c_sizeof(motion_)
  write (*, '(a, 1x, i0)') 'fourlink_range', c_sizeof(range_)
  write (*, '(a, 1x, i0)') 'fourlink_row', c_sizeof(row_)
  write (*, '(a, 1x, i0)') 'fourlink_mistake', c_sizeof(mistake_)
  write (*, '(a, 1x, i0)') 'fourlink_load_info', c_sizeof(load_info_)
  write (*, '(a, 1x, i0)') 'fourlink_problem', c_sizeof(problem_)
  write (*, '(a, 1x, i0)') 'fourlink_unit', c_sizeof(unit_)
  write (*, '(a, 1x, i0)') 'fourlink_change', c_sizeof(change_)
  write (*, '(a, 1x, i0)') 'fourlink_source', c_sizeof(source_)
  write (*, '(a, 1x, i0)') 'fourlink_value', c_sizeof(value_)
  write (*, '(a, 1x, i0)') 'fourlink_instant', c_sizeof(instant_)
  write (*, '(a, 1x, i0)') 'fourlink_area', c_sizeof(area_)
  write (*, '(a, 1x, i0)') 'fourlink_turning', c_sizeof(turning_)
  write (*, '(a, 1x, i0)') 'fourlink_check', c_sizeof(check_)
  write (*, '(a, 1x, i0)') 'fourlink_precision', c_sizeof(precision_)
  write (*, '(a, 1x, i0)') 'fourlink_solution', c_sizeof(solution_)
  write (*, '(a, 1x, i0)') 'fourlink_function_task', c_sizeof(function_task_)
  write (*, '(a, 1x, i0)') 'fourlink_dyad', c_sizeof(dyad_)
  write (*, '(a, 1x, i0)') 'fourlink_motion_task', c_sizeof(motion_task_)
  write (*, '(a, 1x, i0)') 'fourlink_path_task', c_sizeof(path_task_)
  write (*, '(a, 1x, i0)') 'fourlink_quick_return_task', c_sizeof(quick_return_task_)
  write (*, '(a, 1x, i0)') 'fourlink_cognate_task', c_sizeof(cognate_task_)
end program sizes
