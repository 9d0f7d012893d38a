! Answers the cases of `beamgap export` with your own element.
!
!     beamgap export --family segment -o vectors.jsonl
!     gfortran -O2 adapter.f90 -o adapter
!     beamgap verify vectors.jsonl --run ./adapter
!
! This program is for two straight beams, the family `segment`. For yours, change the module `contact_element`:
! 1. family and beam_dofs, the name of the family and its dofs a beam,
! 2. `element`,
! 3. head: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
module contact_element
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   character(*), parameter :: family = 'segment'
   character(*), parameter :: head = '{"schema":"beamgap-answers/1","program":"adapter.f90",'// &
                              '"matrix":"column-major","only":["d","xi:first","xi_bar:first"]}'
   integer, parameter :: beam_dofs = 6, dofs = 2*beam_dofs

contains

   ! YOUR ELEMENT. Here: two straight beams, 12 dofs, by the equations of Zavarise (2007).
   ! q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1].
   ! held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.
   subroutine element(q, xi, xi_bar, held, d, gradient, hessian, g, g_bar)
      real(real64), intent(in) :: q(dofs), xi, xi_bar
      character(*), intent(in) :: held
      real(real64), intent(out) :: d, gradient(dofs), hessian(dofs, dofs), g(dofs), g_bar(dofs)
      real(real64) :: shapes(4), slopes(4), slopes_bar(4), points(3, 4), dv(3), t(3), t_bar(3)
      real(real64), dimension(dofs) :: A1d, B1d, Gt, Gt_bar, r, r_bar
      real(real64) :: a, b, a_bar, det, moved, turned, GG
      integer :: i, j
      ! Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar.
      shapes = [1 - xi, 1 + xi, -(1 - xi_bar), -(1 + xi_bar)]/2
      slopes = [-0.5_real64, 0.5_real64, 0.0_real64, 0.0_real64]
      slopes_bar = [0.0_real64, 0.0_real64, -0.5_real64, 0.5_real64]
      points = reshape(q, [3, 4])
      dv = matmul(points, shapes)
      t = matmul(points, slopes)
      t_bar = matmul(points, slopes_bar)
      d = sqrt(dot_product(dv, dv))
      A1d = along(slopes, dv)
      B1d = along(slopes_bar, dv)
      Gt = along(shapes, t)
      Gt_bar = along(shapes, t_bar)
      gradient = along(shapes, dv/d)   ! eq. (37)
      ! Eq. (50) and (52), reduced to one equation or none if parameters are held at an end.
      r = -Gt - A1d
      r_bar = -Gt_bar - B1d
      a = dot_product(t, t)
      b = dot_product(t, t_bar)
      a_bar = -dot_product(t_bar, t_bar)
      det = a*a_bar + b*b
      g = 0
      g_bar = 0
      select case (held)
      case ('none')
         g = (a_bar*r + b*r_bar)/det
         g_bar = (-b*r + a*r_bar)/det
      case ('xi')
         g_bar = r_bar/a_bar
      case ('xi_bar')
         g = r/a
      end select
      do j = 1, dofs
         do i = 1, dofs
            ! Eq. (40).
            GG = 0
            if (mod(i, 3) == mod(j, 3)) GG = shapes((i + 2)/3)*shapes((j + 2)/3)
            moved = Gt(i)*g(j) - Gt_bar(i)*g_bar(j)
            turned = A1d(i)*g(j) - B1d(i)*g_bar(j)
            hessian(i, j) = (GG + moved + turned - gradient(i)*gradient(j))/d
         end do
      end do
   end subroutine

   ! The gradient of w . delta u for a vector w.
   function along(of, w) result(row)
      real(real64), intent(in) :: of(4), w(3)
      real(real64) :: row(dofs)
      integer :: i
      row = [(of((i + 2)/3)*w(mod(i - 1, 3) + 1), i=1, dofs)]
   end function
end module

program adapter
   use, intrinsic :: iso_fortran_env, only: real64, iostat_end, error_unit
   use contact_element, only: family, head, beam_dofs, dofs, element
   implicit none
   character(:), allocatable :: line
   real(real64) :: q(dofs), xi(1), xi_bar(1), d, gradient(dofs), hessian(dofs, dofs), g(dofs), g_bar(dofs)
   integer :: beam, bar, point, held

   if (.not. next(line)) stop 1   ! the head of the cases
   print '(a)', head
   do while (next(line))
      write (*, '(3a)', advance='no') '{"id":"', word(after('"id":"', 1)), '"'
      beam = after('"beam":{"family":"', 1)
      bar = after('"bar":{"family":"', beam)
      point = after('"point":{', bar)
      held = after('"held":"', point)
      if (word(beam) /= family .or. word(bar) /= family) then
         write (error_unit, '(5a)') 'adapter.f90 is for the family ', family, '; a case is of ', word(beam), &
            '. Change the module contact_element.'
         stop 1
      end if
      if (held > 0) then
         call numbers(after('"q":[', beam), q(1:beam_dofs))
         call numbers(after('"q":[', bar), q(beam_dofs + 1:))
         call numbers(after('"xi":', point), xi)
         call numbers(after('"xi_bar":', point), xi_bar)
         call element(q, xi(1), xi_bar(1), word(held), d, gradient, hessian, g, g_bar)
         write (*, '(a, es24.16, a)', advance='no') ',"d":{"value":', d, ',"gradient":['
         call write_row(gradient)
         write (*, '(a)', advance='no') '],"hessian":['
         call write_row(reshape(hessian, [dofs*dofs]))   ! column by column, as the head declares
         write (*, '(a)', advance='no') ']},"xi":{"gradient":['
         call write_row(g)
         write (*, '(a)', advance='no') ']},"xi_bar":{"gradient":['
         call write_row(g_bar)
         write (*, '(a)') ']}}'
         flush (6)
         cycle
      end if
      write (*, '(a)') ',"result":"degenerate"}'   ! the case has no regular closest point
      flush (6)
   end do

contains

   ! Reads the next line, of any length.
   logical function next(line)
      character(:), allocatable, intent(out) :: line
      character(4096) :: part
      integer :: length, status
      line = ''
      do
         read (*, '(a)', advance='no', iostat=status, size=length) part
         if (status == iostat_end) exit
         line = line//part(:length)
         if (status /= 0) exit
      end do
      next = len(line) > 0
   end function

   ! The index after a key, which is searched from an index; 0 if there is none.
   integer function after(key, from)
      character(*), intent(in) :: key
      integer, intent(in) :: from
      after = 0
      if (from < 1) return
      after = index(line(from:), key)
      if (after > 0) after = from + after - 1 + len(key)
   end function

   function word(at)
      integer, intent(in) :: at
      character(:), allocatable :: word
      word = line(at:at + index(line(at:), '"') - 2)
   end function

   subroutine numbers(at, to)
      integer, intent(in) :: at
      real(real64), intent(out) :: to(:)
      integer :: end
      end = scan(line(at:), ']}')
      if (size(to) == 1) end = scan(line(at:), ',}')
      read (line(at:at + end - 2), *) to
   end subroutine

   subroutine write_row(row)
      real(real64), intent(in) :: row(:)
      write (*, '(*(es24.16, :, ","))', advance='no') row
   end subroutine
end program
