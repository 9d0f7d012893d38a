! Answers the cases of `beamgap export --element` with your own contact element with friction.
!
!     beamgap export --element --family segment -o vectors.jsonl
!     gfortran -O2 contact.f90 -o contact
!     beamgap verify vectors.jsonl --run ./contact
!
! This program is for two straight beams, the family `segment`. For yours, change the module `contact_element`:
! 1. family and beam_dofs, the name of the family and its dofs a beam,
! 2. `element`,
! 3. head: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
!
! Equation numbers are those of Zavarise (2007). The other formulas are in docs/contact-element.md.
module contact_element
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   character(*), parameter :: family = 'segment'
   character(*), parameter :: head = '{"schema":"beamgap-answers/1","program":"contact.f90",'// &
                              '"matrix":"column-major","only":["residual","tangent"]}'
   integer, parameter :: beam_dofs = 6, dofs = 2*beam_dofs
   real(real64), parameter :: slopes(4) = [-0.5_real64, 0.5_real64, 0.0_real64, 0.0_real64]
   real(real64), parameter :: slopes_bar(4) = [0.0_real64, 0.0_real64, -0.5_real64, 0.5_real64]
   real(real64), parameter :: zero = 0

   ! Parameters and history. Numbers that a case does not have are zero. xi to held are the slips and what was held.
   type :: element_data
      character(16) :: law, work, held
      real(real64) :: eps_N, g_0, lambda, eps_T, mu, normal(3), xi, xi_bar, e, e_bar, cosine
      logical :: has_normal, has_slips
   end type

contains

   ! YOUR ELEMENT. Here: two straight beams, 12 dofs; t,xi and all that has it is zero.
   ! q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1].
   ! held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.
   ! radii: r + r_bar. forces: F_N, F, F_bar.
   subroutine element(q, xi, xi_bar, held, radii, of, state, forces, residual, tangent)
      real(real64), intent(in) :: q(dofs), xi, xi_bar, radii
      character(*), intent(in) :: held
      type(element_data), intent(in) :: of
      character(16), intent(out) :: state
      real(real64), intent(out) :: forces(3), residual(dofs), tangent(dofs, dofs)
      real(real64) :: shapes(4), points(3, 4), inverse(2, 2), free, free_bar, tt, tb, bb, d_s, k, F_N, F, F_bar
      real(real64) :: abs_t, abs_t_bar, c, u, u_bar, slips(2), e, e_bar, gamma, l, l_bar, rho
      real(real64), dimension(3) :: d, t, t_bar, n, tau, tau_bar, s
      real(real64), dimension(dofs) :: Gt, Gt_bar, r, r_bar, g, g_bar, grad_gap, A1n, B1n, grad_tb
      real(real64), dimension(dofs) :: grad_t, grad_t_bar, grad_e, grad_e_bar, grad_c, grad_l, grad_l_bar
      real(real64), dimension(dofs) :: grad_gamma, grad_rho, grad_F, grad_F_bar, A, A_bar
      real(real64), dimension(dofs, dofs) :: H_gap, H_r, H_r_bar, H_xi, H_xi_bar, H_A, H_A_bar
      shapes = [1 - xi, 1 + xi, -(1 - xi_bar), -(1 + xi_bar)]/2   ! of d = x - x_bar
      points = reshape(q, [3, 4])
      d = matmul(points, shapes)
      t = matmul(points, slopes)
      t_bar = matmul(points, slopes_bar)

      ! Geometry. Eq. (50) and (52), reduced to one equation or none if parameters are held at an end.
      free = merge(0, 1, held == 'xi' .or. held == 'both')
      free_bar = merge(0, 1, held == 'xi_bar' .or. held == 'both')
      tt = dot_product(t, t)   ! a, b and -a_bar
      tb = dot_product(t, t_bar)
      bb = dot_product(t_bar, t_bar)
      inverse = reshape([free/tt, zero, zero, -free_bar/bb], [2, 2])
      if (held == 'none') inverse = reshape([bb, tb, -tb, -tt], [2, 2])/(tt*bb - tb**2)
      Gt = along(shapes, t)
      Gt_bar = along(shapes, t_bar)
      r = -Gt - along(slopes, d)
      r_bar = -Gt_bar - along(slopes_bar, d)
      g = inverse(1, 1)*r + inverse(1, 2)*r_bar
      g_bar = inverse(2, 1)*r + inverse(2, 2)*r_bar
      ! n = d/|d|; t x t_bar has the same direction, also where the beams cross. It keeps the side of the last step.
      n = d
      if (held == 'none') n = [t(2)*t_bar(3) - t(3)*t_bar(2), t(3)*t_bar(1) - t(1)*t_bar(3), t(1)*t_bar(2) - t(2)*t_bar(1)]
      n = n/norm2(n)
      if (dot_product(n, merge(of%normal, d, of%has_normal)) < 0) n = -n
      d_s = dot_product(n, d)
      grad_gap = along(shapes, n)   ! eq. (37)
      A1n = along(slopes, n)
      B1n = along(slopes_bar, n)
      ! The Hessian of the gap: eq. (40), or if both parameters are free a form that also holds at d = 0.
      if (held == 'none') then
         H_gap = both(A1n, g) - both(B1n, g_bar) + d_s*(inverse(1, 1)*outer(A1n, A1n) + inverse(1, 2)*both(A1n, B1n) &
                                                        - inverse(2, 2)*outer(B1n, B1n))
      else
         H_gap = (blocks(shapes, shapes) + outer(Gt, g) - outer(Gt_bar, g_bar) - outer(grad_gap, grad_gap))/d_s &
                 + outer(A1n, g) - outer(B1n, g_bar)
      end if

      ! Normal.
      call normal_law(of, d_s - radii, F_N, k)
      residual = -F_N*grad_gap
      tangent = k*outer(grad_gap, grad_gap) - F_N*H_gap
      forces = [F_N, zero, zero]
      state = merge('open        ', 'frictionless', F_N <= 0)
      if (F_N <= 0 .or. of%mu <= 0 .or. .not. of%has_slips .or. held == 'both') return

      ! Slip, eq. (15) and (20), and trial. A parameter that becomes held loses its part of the elastic slip.
      abs_t = norm2(t)
      abs_t_bar = norm2(t_bar)
      tau = t/abs_t
      tau_bar = t_bar/abs_t_bar
      c = dot_product(tau, tau_bar)
      u = free*(xi - of%xi)
      u_bar = free_bar*(xi_bar - of%xi_bar)
      slips = [of%e, of%e_bar]
      if (held /= of%held .and. held /= 'none') then
         slips = [free*(of%e - of%cosine*of%e_bar), free_bar*(of%e_bar - of%cosine*of%e)]
         if (of%held /= 'none') slips = 0
      end if
      e = slips(1) + abs_t*u
      e_bar = slips(2) + abs_t_bar*u_bar
      s = e*tau - e_bar*tau_bar
      gamma = norm2(s)
      l = free*dot_product(s, tau)   ! e - c e_bar
      l_bar = -free_bar*dot_product(s, tau_bar)   ! e_bar - c e
      grad_t = along(slopes, tau)
      grad_t_bar = along(slopes_bar, tau_bar)
      grad_e = abs_t*g + u*grad_t
      grad_e_bar = abs_t_bar*g_bar + u_bar*grad_t_bar
      grad_c = along(slopes, tau_bar - c*tau)/abs_t + along(slopes_bar, tau - c*tau_bar)/abs_t_bar
      grad_l = grad_e - c*grad_e_bar - e_bar*grad_c
      grad_l_bar = grad_e_bar - c*grad_e - e*grad_c

      ! Return to the cone.
      state = 'stick'
      rho = 1
      grad_rho = 0
      if (of%eps_T*gamma > of%mu*F_N) then
         state = 'slip'
         rho = of%mu*F_N/(of%eps_T*gamma)
         grad_gamma = (l*grad_e + l_bar*grad_e_bar - e*e_bar*grad_c)/gamma
         grad_rho = -of%mu/(of%eps_T*gamma)*k*grad_gap - rho/gamma*grad_gamma
      end if
      F = of%eps_T*rho*l
      F_bar = of%eps_T*rho*l_bar
      grad_F = of%eps_T*(rho*grad_l + l*grad_rho)
      grad_F_bar = of%eps_T*(rho*grad_l_bar + l_bar*grad_rho)
      forces = [F_N, F, F_bar]

      ! Work. The derivatives of eq. (50), solved as eq. (52).
      grad_tb = along(slopes, t_bar) + along(slopes_bar, t)
      H_r = -blocks(shapes, slopes) - blocks(slopes, shapes) - both(2*along(slopes, t), g) + both(grad_tb, g_bar)
      H_r_bar = -blocks(shapes, slopes_bar) - blocks(slopes_bar, shapes) - both(grad_tb, g) &
                + both(2*along(slopes_bar, t_bar), g_bar)
      H_xi = inverse(1, 1)*H_r + inverse(1, 2)*H_r_bar
      H_xi_bar = inverse(2, 1)*H_r + inverse(2, 2)*H_r_bar
      A = abs_t*g
      A_bar = abs_t_bar*g_bar
      H_A = outer(g, grad_t) + abs_t*H_xi
      H_A_bar = outer(g_bar, grad_t_bar) + abs_t_bar*H_xi_bar
      if (of%work == 'paper') then   ! A = grad g_T
         A = A + u*grad_t
         A_bar = A_bar + u_bar*grad_t_bar
         H_A = H_A + outer(grad_t, g) + u/abs_t*(blocks(slopes, slopes) - outer(grad_t, grad_t))
         H_A_bar = H_A_bar + outer(grad_t_bar, g_bar) &
                   + u_bar/abs_t_bar*(blocks(slopes_bar, slopes_bar) - outer(grad_t_bar, grad_t_bar))
      end if
      residual = residual + F*A + F_bar*A_bar
      tangent = tangent + outer(A, grad_F) + outer(A_bar, grad_F_bar) + F*H_A + F_bar*H_A_bar
   end subroutine

   ! Laws: F_N, and k = -dF_N/dg_N.
   subroutine normal_law(of, gap, F_N, k)
      type(element_data), intent(in) :: of
      real(real64), intent(in) :: gap
      real(real64), intent(out) :: F_N, k
      k = of%eps_N
      if (of%law == 'lpqp' .and. gap > 0) k = max(k*(of%g_0 - gap)/of%g_0, zero)
      F_N = max(of%lambda + k*of%g_0/2 - k*gap, zero)
      if (of%law == 'lpqp' .and. gap > 0) F_N = k*(of%g_0 - gap)/2
      if (F_N <= 0) k = 0
   end subroutine

   ! The gradient of w . delta u for a vector w. That of d is along G, those of t and t_bar are along A1 and B1.
   pure function along(of, w) result(row)
      real(real64), intent(in) :: of(4), w(3)
      real(real64) :: row(dofs)
      row = reshape(outer(w, of), [dofs])
   end function

   ! v w^T.
   pure function outer(v, w)
      real(real64), intent(in) :: v(:), w(:)
      real(real64) :: outer(size(v), size(w))
      outer = spread(v, 2, size(w))*spread(w, 1, size(v))
   end function

   ! v w^T + w v^T.
   pure function both(v, w)
      real(real64), intent(in) :: v(dofs), w(dofs)
      real(real64) :: both(dofs, dofs)
      both = outer(v, w) + outer(w, v)
   end function

   ! The matrix of delta u . Delta u for two lists of shape functions.
   pure function blocks(of, with)
      real(real64), intent(in) :: of(4), with(4)
      real(real64) :: blocks(dofs, dofs)
      integer :: c
      blocks = 0
      do c = 1, 3
         blocks(c::3, c::3) = outer(of, with)
      end do
   end function
end module

program contact
   use, intrinsic :: iso_fortran_env, only: real64, iostat_end, error_unit
   use contact_element, only: family, head, beam_dofs, dofs, element, element_data
   implicit none
   character(:), allocatable :: line
   character(16) :: state
   type(element_data) :: of
   real(real64) :: q(dofs), forces(3), residual(dofs), tangent(dofs, dofs)
   integer :: beam, bar, point, held, at

   if (.not. next(line)) stop 1   ! the head of the cases
   print '(a)', head
   do while (next(line))
      beam = after('"beam":{"family":"', 1)
      bar = after('"bar":{"family":"', beam)
      at = after('"element":{', bar)
      point = after('"point":{', bar)
      held = after('"held":"', point)
      if (word(beam) /= family .or. word(bar) /= family) then
         write (error_unit, '(5a)') 'contact.f90 is for the family ', family, '; a case is of ', trim(word(beam)), &
            '. Change the module contact_element.'
         stop 1
      end if
      if (held > 0 .and. at == 0) then
         write (error_unit, '(a)') 'contact.f90: a case has no element. Write the cases with `beamgap export --element`.'
         stop 1
      end if
      write (*, '(3a)', advance='no') '{"id":"', trim(word(after('"id":"', 1))), '"'
      if (held > 0) then
         q = [numbers(after('"q":[', beam), beam_dofs), numbers(after('"q":[', bar), beam_dofs)]
         call read_element(at, of)
         call element(q, number('xi', point), number('xi_bar', point), word(held), &
                      number('radius', bar) + number('radius_bar', bar), of, state, forces, residual, tangent)
         write (*, '(2a, 3(a, es24.16e3))', advance='no') ',"state":"', trim(state), '","F_N":', forces(1), &
            ',"F":', forces(2), ',"F_bar":', forces(3)
         write (*, '(a, *(es24.16e3, :, ","))', advance='no') ',"residual":[', residual
         write (*, '(a, *(es24.16e3, :, ","))', advance='no') '],"tangent":[', tangent   ! column by column
         write (*, '(a)') ']}'
      else
         write (*, '(a)') ',"result":"degenerate"}'   ! the case has no regular closest point
      end if
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
      character(32) :: word
      word = line(at:at + index(line(at:), '"') - 2)
   end function

   function numbers(at, count)
      integer, intent(in) :: at, count
      real(real64) :: numbers(count)
      read (line(at:at + scan(line(at:), ']') - 2), *) numbers
   end function

   ! The number after a key; zero if there is none.
   real(real64) function number(key, from)
      character(*), intent(in) :: key
      integer, intent(in) :: from
      integer :: at
      number = 0
      at = after('"'//key//'":', from)
      if (at > 0) read (line(at:at + scan(line(at:), ',}') - 2), *) number
   end function

   ! Parameters and history of the element that starts at an index.
   subroutine read_element(at, of)
      integer, intent(in) :: at
      type(element_data), intent(out) :: of
      integer :: normal, slips
      normal = after('"normal":[', at)
      slips = after('"slips":{', at)
      of = element_data(word(after('"law":"', at)), word(after('"work":"', at)), word(after('"held":"', max(slips, at))), &
                        number('eps_N', at), number('g_0', at), number('lambda', at), number('eps_T', at), number('mu', at), &
                        0.0_real64, number('xi', slips), number('xi_bar', slips), number('e', slips), &
                        number('e_bar', slips), number('cosine', slips), normal > 0, slips > 0)
      if (of%has_normal) of%normal = numbers(normal, 3)
   end subroutine
end program
