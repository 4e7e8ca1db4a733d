! SPDX-License-Identifier: BSD-3-Clause
!> The program of bench/languages.py in Fortran: see there.
program rows
  use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int8_t, c_size_t
  use, intrinsic :: iso_fortran_env, only: int64
  use pw85
  implicit none

  integer, parameter :: num_pairs = 1000, most_rows = 16 * num_pairs
  character(*), parameter :: names(4) = [character(14) :: 'overlap', 'contact', 'distance', &
    'overlap_volume']
  integer, parameter :: num_numbers(4) = [1, 2, 1, 1], num_points(4) = [0, 0, 2, 0]
  integer, parameter :: copies(4) = [16, 16, 4, 1] ! of the pairs, that are computed as rows
  real(c_double) :: r12(3, most_rows), q1(6, most_rows), q2(6, most_rows)
  real(c_double) :: numbers(most_rows, 2), points(3, most_rows, 2)
  integer(c_int8_t) :: bytes(most_rows)
  character(1000) :: word
  integer :: file, given, k, rounds

  call get_command_argument(1, word)
  open (newunit=given, file=trim(word), access='stream', form='unformatted', status='old')
  read (given) r12(:, :num_pairs), q1(:, :num_pairs), q2(:, :num_pairs)
  do k = num_pairs, most_rows - num_pairs, num_pairs
    r12(:, k + 1:k + num_pairs) = r12(:, :num_pairs)
    q1(:, k + 1:k + num_pairs) = q1(:, :num_pairs)
    q2(:, k + 1:k + num_pairs) = q2(:, :num_pairs)
  end do
  call get_command_argument(2, word)
  open (newunit=file, file=trim(word), access='stream', form='unformatted', status='replace')
  call get_command_argument(3, word)
  read (word, *) rounds
  do k = 1, 4
    call run(k)
  end do
  close (file)

contains

  subroutine run(f)
    integer, intent(in) :: f
    integer(int64) :: start, middle, end, rate
    real(c_double) :: per_call, per_row
    integer :: round
    per_call = huge(per_call)
    per_row = huge(per_row)
    do round = 1, rounds
      call system_clock(start, rate)
      call call_each(f, round - 1)
      call system_clock(middle)
      call call_rows(f)
      call system_clock(end)
      ! The rounding sets the flag of inexact results, as in C.
      per_call = min(per_call, 1e9_c_double * (real(middle - start, c_double) / rate / num_pairs))
      per_row = min(per_row, 1e9_c_double * (real(end - middle, c_double) / rate / &
        (copies(f) * num_pairs)))
    end do
    if (f == 1) numbers(:, 1) = bytes
    call write_results(f)
    call call_each(f, 0)
    call write_results(f)
    print '(2a, es24.16, a, es24.16)', trim(names(f)), ',', per_call, ',', per_row
  end subroutine run

  subroutine write_results(f)
    integer, intent(in) :: f
    write (file) numbers(:num_pairs, :num_numbers(f)), points(:, :num_pairs, :num_points(f))
  end subroutine write_results

  !> Calls the function for each pair, with the first form of the pair `shift` places behind.
  subroutine call_each(f, shift)
    integer, intent(in) :: f, shift
    real(c_double) :: out(2)
    integer(c_int) :: overlaps
    integer :: i, j
    do i = 1, num_pairs
      j = i + shift
      select case (f)
      case (1)
        call check(pw85_overlap(r12(:, i), q1(:, j), q2(:, i), overlaps))
        numbers(i, 1) = overlaps
      case (2)
        call check(pw85_contact(r12(:, i), q1(:, j), q2(:, i), out))
        numbers(i, :) = out
      case (3)
        call check(pw85_distance(r12(:, i), q1(:, j), q2(:, i), numbers(i, 1), points(:, i, 1), &
          points(:, i, 2)))
      case (4)
        call check(pw85_overlap_volume(r12(:, i), q1(:, j), q2(:, i), numbers(i, 1)))
      end select
    end do
  end subroutine call_each

  subroutine call_rows(f)
    integer, intent(in) :: f
    integer(c_size_t) :: n
    n = copies(f) * num_pairs
    select case (f)
    case (1)
      call check(pw85_overlap_batch(n, r12, q1, q2, bytes))
    case (2)
      call check(pw85_contact_batch(n, r12, q1, q2, numbers(:, 1), numbers(:, 2)))
    case (3)
      call check(pw85_distance_batch(n, r12, q1, q2, numbers(:, 1), points(:, :, 1), &
        points(:, :, 2)))
    case (4)
      call check(pw85_overlap_volume_batch(n, r12, q1, q2, numbers(:, 1)))
    end select
  end subroutine call_rows

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status == pw85_success) return
    print '(a)', pw85_strerror(status)
    error stop
  end subroutine check

end program rows
