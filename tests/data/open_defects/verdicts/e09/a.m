function dz = rhs(t,z,p)
  th = z(2); w = z(4);
  Mm = [p.M+p.m, p.m*p.l*cos(th); p.m*p.l*cos(th), p.m*p.l^2];
  f = [p.F + p.m*p.l*w^2*sin(th); -p.m*p.g*p.l*sin(th)];
  dz = zeros(4,1);
  dz(1:2) = z(3:4);
  dz(3:4) = Mm\f;
end
