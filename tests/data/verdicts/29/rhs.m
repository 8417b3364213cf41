function dz = rhs(t, z)
e = [e0; e1; e2; e3]; p = z(5); q = z(6); r = z(7);
Om = [0 -p -q -r; p 0 r -q; q -r 0 p; r q -p 0];
dz = zeros(7,1);
dz(1:4) = 0.5*Om*e;
dz(5) = (Mx - (Jz - Jy)*q*r)/Jx;
dz(6) = (My - (Jx - Jz)*p*r)/Jy;
dz(7) = (Mz - (Jy - Jx)*p*q)/Jz;
end
